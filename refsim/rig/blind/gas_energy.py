"""The gas's temperature from the balances of mass and energy, and the films at the wall."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.catalogue.gas_energy import EnergyGas
from rig.effect import Now, Rest, State
from rig.flow import P_ATM, T_ATM

_LATENT = 2.5e6  # J/kg
_SETTLING = 0.05  # s, in which droplets grow or vanish


@dataclass(frozen=True)
class InletJet(EnergyGas):
    """The inlet's jet stirs the gas and venting does not: h + h_1 (m_jet/0.1 g/s)^(2/3), where it dies away in tau.

    Second state: the jet. Source: H. Martin, Heat and mass transfer between impinging gas jets and solid surfaces, Adv.
    Heat Transf. 13 (1977) 1, with exponents about 2/3.
    """

    form = "inlet_jet"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h_1: float = 30.0  # W/(m2 K)
    tau: float = 0.1  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (max(now.net_mass_flow, 0.0) - q[1]) / self.tau

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h + self.h_1 * ((q[1] ** 2 + 1e-16) / 1e-8) ** (1 / 3))


@dataclass(frozen=True)
class EndPlates(EnergyGas):
    """Heat goes through the wall and, besides, into the metal end plugs, which stay at ambient temperature.

    The plugs' conductance does not change with contraction. Source: first law with two paths of heat.
    """

    form = "end_plates"
    plates: float = 0.03  # W/K

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return 0.0, self.plates * (temperature - T_ATM)


@dataclass(frozen=True)
class FoggingGas(EnergyGas):
    """Air with some water: what is beyond saturation becomes fog in 50 ms, and its latent heat warms the gas.

    Second state: the fog by mass of gas, thinned by what flows in. Saturation by Magnus (WMO-No. 8, annex 4.B); source
    of the balance: R. R. Rogers, M. K. Yau, A Short Course in Cloud Physics (1989), chapter 2.
    """

    form = "fogging"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-9)
    water: float = 3e-3  # kg by kg of gas

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h)

    def _growth(self, q: State, p: float, temperature: float) -> float:
        celsius = max(temperature - 273.15, -80.0)
        vapour = 611.2 * exp(17.62 * celsius / (243.12 + celsius))
        beyond = self.water - 0.622 * vapour / max(p - vapour, 1e3)
        fog = (beyond + sqrt(beyond * beyond + 1e-10)) / 2
        return (fog - q[1]) / _SETTLING

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return 0.0, -_LATENT * q[0] * self._growth(q, p, temperature)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        growth = self._growth(q, now.p_gauge + P_ATM, now.temperature)
        return now.net_mass_flow, growth - q[1] * max(now.net_mass_flow, 0.0) / q[0]
