"""A wall that stores heat."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import T_ATM


@law
class WarmWall(Effect):
    """The wall has a heat capacity and passes heat on to ambient: C T_w' = heat from gas - G_out (T_w - T_atm).

    The base model's coefficient then acts between gas and wall.
    """

    form = "lumped"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((-now.heat_to_gas - self.g_out * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class StorageWall(Effect):
    """Heat is stored in the middle of the wall, between a film inside (h_film) and one outside (r h_film)."""

    form = "storage"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 1.0  # J/K
    r: float = 1.0
    h_film: float = 20.0  # W/(m2 K)
    half_wall: float = 9e-4  # m2 K/W, t/(2 k)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    fibre_area: float = 0.0133  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return 1 / (1 / self.h_film + self.half_wall)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length = self.length - now.x
        girth = sqrt(self.fibre_squared - length * length) / self.turns
        outside = max(0.0, girth * length - self.fibre_area) / (
            1 / (self.r * self.h_film) + self.half_wall
        )
        return ((-now.heat_to_gas - outside * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]
