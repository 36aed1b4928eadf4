"""Valves that follow their command late."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.schedule import Currents


@law
class SquaredFlux(Effect):
    """The flux comes late and the magnet's force goes with its square: y' = (sqrt(command) - y)/tau, felt is y^2.

    Rising starts slowly and falling ends slowly. States: y of both valves [A^(1/2)]. Source: D. Cheng, Field and Wave
    Electromagnetics (1989), section 6.12, on the force of an electromagnet; the lag is that of eddy currents and coil.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        a, b = ((sqrt(max(u, 0.0)) - y) / self.tau for u, y in zip(now.command, q, strict=True))
        return a, b

    def current(self, q: State, command: Currents) -> Currents:
        return q[0] * q[0], q[1] * q[1]


@law
class PlungerTravel(Effect):
    """The opening itself lags, not the current: a' = (area by the current - a)/tau, in closing (1 + a/(a + a_r)) tau.

    A plunger that is further open takes longer to come back, as its spring is nearly spent against the damping gas that
    it must press out. States: both openings [m2]. Source: E. E. Topcu, I. Yuksel, Z. Kamis, Development of
    electro-pneumatic fast switching valve, Mechatronics 16 (2006) 365, on times of opening and closing; the law is
    reasoned.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-14)
    tau: float = 0.04  # s
    a_r: float = 3e-7  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, target: float, a: float) -> float:
        slower = 1 + max(a, 0.0) / (max(a, 0.0) + self.a_r) if a > target else 1.0
        return (target - a) / (self.tau * slower)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.areas[0], q[0]), self._rate(now.areas[1], q[1])

    def opening(self, q: State, areas: tuple[float, float]) -> tuple[float, float]:
        return max(q[0], 0.0), max(q[1], 0.0)
