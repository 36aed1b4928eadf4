"""Effects in the balance of energy."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import T_ATM, R


@dataclass(frozen=True)
class GasEnergy(Effect):
    """Gas temperature from mass and energy, T = p V/(m R), with heat exchange through the wall area."""

    family = "gas_energy"
    form = "film"
    energy_balance = True
    atol: ClassVar[tuple[float, ...]] = (1e-14,)
    h: float = 20.0  # W/(m2 K)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return (now.net_mass_flow,)

    def film(self, h: float) -> float:
        return self.h

    def temperature(self, q: Sequence[float], pressure_volume: float, polytropic: float) -> float:
        return pressure_volume / (q[0] * R)


@dataclass(frozen=True)
class WarmWall(Effect):
    """The wall has a heat capacity and passes heat on to ambient: C T_w' = heat from gas - G_out (T_w - T_atm).

    The base model's coefficient then acts between gas and wall.
    """

    family = "wall_heat"
    form = "lumped"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return ((-now.heat_to_gas - self.g_out * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: Sequence[float], outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class FrictionHeat(Effect):
    """A share of the power that fibre friction dissipates heats the gas."""

    family = "friction_heat"
    form = "share"
    share: float = 1.0

    def friction_heat(self, power: float) -> float:
        return self.share * power
