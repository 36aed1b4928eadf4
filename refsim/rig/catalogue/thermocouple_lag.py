"""Thermometers that come late."""

from __future__ import annotations

from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class ThermocoupleLag(Effect):
    """The temperature reading follows the gas through a first-order lag."""

    form = "first_order"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@law
class Sheath(Effect):
    """The thermometer: a sheath with tau, a junction in it with r tau."""

    form = "sheath"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.15  # s
    r: float = 0.3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.temperature - q[0]) / self.tau, (q[0] - q[1]) / (self.r * self.tau)

    def reading(self, q: State, temperature: float) -> float:
        return q[1]
