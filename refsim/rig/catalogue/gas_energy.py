"""The gas's temperature from the balances of mass and energy, and the films at the wall."""

from __future__ import annotations

from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import R


@law
class GasEnergy(Effect):
    """Gas temperature from mass and energy, T = p V/(m R), with heat exchange through the wall area."""

    form = "film"
    energy_balance = True
    atol: ClassVar[tuple[float, ...]] = (1e-14,)
    h: float = 20.0  # W/(m2 K)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.net_mass_flow,)

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self.h

    def temperature(self, q: State, pressure_volume: float, polytropic: float) -> float:
        return pressure_volume / (q[0] * R)


@law
class EnergyGas(Effect):
    """Gas temperature from mass and energy; state: mass. Films inside and outside the wall grow alike."""

    energy_balance = True
    atol: ClassVar[tuple[float, ...]] = (1e-14,)
    h: float = 20.0  # W/(m2 K)
    wall: float = 1.8e-3  # m2 K/W, t/k

    def _through(self, film: float) -> float:
        return 1 / (2 / film + self.wall)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.net_mass_flow,)

    def temperature(self, q: State, pressure_volume: float, polytropic: float) -> float:
        return pressure_volume / (q[0] * R)


@law
class StirredGas(EnergyGas):
    """The film grows with the flow: h + h_1 (|m_jet|/0.1 g/s)^0.8, where the jet dies away in tau."""

    form = "stirred"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h_1: float = 30.0  # W/(m2 K)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.net_mass_flow - q[1]) / self.tau

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h + self.h_1 * ((q[1] ** 2 + 1e-14) / 1e-8) ** 0.4)
