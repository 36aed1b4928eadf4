"""Ends that are no cylinder: the muscle's pull by contraction and pressure."""

from __future__ import annotations

from math import exp

from rig.effect import Effect, law


@law
class TonduEnds(Effect):
    """The ends contract less: contraction counts k times in the force (Tondu and Lopez)."""

    form = "tondu"
    k: float = 1.06

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return self.k


@law
class KangEnds(Effect):
    """Contraction counts q(P) = 1 + c1 exp(-P/p0) times in the force (Kang)."""

    form = "kang"
    c1: float = 0.2
    p0: float = 1.0e5  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c1 * exp(-p_gauge / self.p0)


@law
class KerscherEnds(Effect):
    """The pull is 1 + c exp(-eps/eps_0) times the cylinder's."""

    form = "kerscher"
    c: float = 0.1
    eps_0: float = 0.1
    length: float = 0.24  # m

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * exp(-x / self.length / self.eps_0)
