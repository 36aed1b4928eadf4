"""Dry friction: by the direction of motion and the way since it turned. Positive forces oppose contraction."""

from __future__ import annotations

from math import tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class Coulomb(Effect):
    """Coulomb friction F_c tanh(v/width)."""

    form = "coulomb"
    stiff = True
    f_c: float = 8.0  # N
    width: float = 1e-5  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * tanh(v / self.width)


@law
class Dahl(Effect):
    """Dahl friction: a bristle q with q' = v - |v| stiffness q/F_c and force stiffness q; at rest q = 0."""

    form = "dahl"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    f_c: float = 8.0  # N
    stiffness: float = 2.0e4  # N/m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.v - abs(now.v) * self.stiffness * q[0] / self.f_c,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.stiffness * q[0]


@law
class MaxwellSlip(Effect):
    """Four Dahl bristles in parallel with travels d/8, d/4, d/2 and d."""

    form = "maxwell_slip"
    atol: ClassVar[tuple[float, ...]] = (1e-7,) * 4
    f_c: float = 8.0  # N
    travel: float = 2e-3  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,) * 4

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        size = abs(now.v)
        return tuple((now.v - size * r) / (self.travel * 0.5 ** (3 - i)) for i, r in enumerate(q))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * sum(q) / 4
