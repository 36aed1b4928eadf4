"""Rubber that relaxes: forces that fade while the contraction is held. Positive forces oppose contraction."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class StiffeningMaxwell(Effect):
    """A Maxwell element whose spring stiffens while its dashpot is plain: force k g(e), q' = g(e)/tau, e = x - q.

    g(e) = e (1 + (e/x_0)^2), so that a large load fades quicker at first. Source: finite viscoelasticity with one
    nonlinear spring in a row with a Newtonian dashpot, as in S. Reese, S. Govindjee, A theory of finite
    viscoelasticity and numerical aspects, Int. J. Solids Struct. 35 (1998) 3455; the cubic is reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 300.0  # N/m
    tau: float = 1.5  # s
    x_0: float = 0.015  # m

    def _load(self, e: float) -> float:
        return e * (1 + (e / self.x_0) ** 2)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self._load(now.x - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * self._load(x - q[0])


@law
class Overstress(Effect):
    """A spring k e whose dashpot flows by what its load is beyond a threshold: q' = over(e)/tau, e = x - q.

    over(e) = e - y e/sqrt(y^2 + e^2), rounded: a little of the load stays for good, the rest fades. Source: P. Perzyna,
    Fundamental problems in viscoplasticity, Adv. Appl. Mech. 9 (1966) 243; for rubber with an equilibrium hysteresis
    A. Lion, Acta Mech. 123 (1997) 1.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.5  # s
    y: float = 2e-3  # m, threshold

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        e = now.x - q[0]
        return (e * (1 - self.y / sqrt(self.y * self.y + e * e)) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])
