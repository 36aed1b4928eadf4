"""The gas's temperature from the balances of mass and energy, and the films at the wall."""

from __future__ import annotations

from typing import ClassVar

from rig.catalogue.gas_energy import EnergyGas
from rig.effect import Now, Rest, State, law


@law
class PipeFlow(EnergyGas):
    """The muscle as a pipe, laminar or turbulent, whichever carries more: (h^3 + (h_1 (|m|/0.1 g/s)^0.8)^3)^(1/3).

    Second state: the flow behind 20 ms. Source: F. W. Dittus, L. M. K. Boelter, Univ. Calif. Publ. Eng. 2 (1930) 443;
    joined as S. W. Churchill, R. Usagi, AIChE J. 18 (1972) 1121, join two limits.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h_1: float = 30.0  # W/(m2 K)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.net_mass_flow - q[1]) / 0.02

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        turbulent = self.h_1 * ((q[1] ** 2 + 1e-16) / 1e-8) ** 0.4
        return self._through(float((self.h**3 + turbulent**3) ** (1 / 3)))


@law
class Swirl(EnergyGas):
    """What flows in turns and makes all the gas turn: w' = (1 - w) m_in/m - w/tau; film h (1 + c w^0.8).

    Second state: w, the swirl by that of the inlet. Fresh gas shares it with what is there, friction at the wall slows
    it down, and venting takes it along without a change. Source: balance of angular momentum as for the swirl of an
    engine's charge (J. B. Heywood, Internal Combustion Engine Fundamentals, 1988, section 8.3).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    c: float = 5.0
    tau: float = 0.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        renewed = max(now.net_mass_flow, 0.0) / max(q[0], 1e-9)
        return now.net_mass_flow, (1 - q[1]) * renewed - q[1] / self.tau

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h * (1 + self.c * (q[1] ** 2 + 1e-8) ** 0.4))
