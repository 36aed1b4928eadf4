"""Lines between valves and muscle."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

from rig.catalogue.supply_line import OrificeTube, Tube
from rig.effect import Rest, State
from rig.flow import GAMMA, P_ATM, T_ATM, R


@dataclass(frozen=True)
class CooledLine(OrificeTube):
    """A line whose wall takes heat from its gas, G (T - T_atm), and an orifice: neither adiabatic nor isothermal.

    Source: first law for an open volume; E. Richer, Y. Hurmuzlu, A high performance pneumatic force actuator system, J.
    Dyn. Syst. Meas. Control 122 (2000) 416, on the two limits.
    """

    form = "cooled_line"
    wall: float = 0.03  # W/K, G

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        gas, energy = super().line_rates(q, from_valves, p, temperature)
        return gas, energy - self.wall * (self.node(q)[1] - T_ATM)


@dataclass(frozen=True)
class SoftHose(OrificeTube):
    """A rubber hose that widens with pressure, V (1 + e (p - p_atm)), and an orifice at the muscle.

    States: mass; energy of the gas and what the hose took up, p V(p)/(gamma - 1) + V e p^2/2, which only flow changes.
    Source: hoses are sold with their expansion per pressure (SAE J1401); first law for gas and hose together.
    """

    form = "soft_hose"
    expansion: float = 4e-6  # 1/Pa

    @property
    def _soft(self) -> float:
        return self.volume * self.expansion  # m3/Pa

    def initial(self, rest: Rest) -> tuple[float, ...]:
        energy = P_ATM * self.volume / (GAMMA - 1) + self._soft * P_ATM**2 / 2
        return (P_ATM * self.volume / (R * T_ATM), energy)

    def node(self, q: State) -> tuple[float, float]:
        """From the quadratic p (V - V e p_atm)/(gamma - 1) + V e p^2 (1/(gamma - 1) + 1/2) = E."""
        square = self._soft * (1 / (GAMMA - 1) + 0.5)
        linear = (self.volume - self._soft * P_ATM) / (GAMMA - 1)
        p = 2 * q[1] / (linear + sqrt(linear * linear + 4 * square * q[1]))
        return p, p * (self.volume + self._soft * (p - P_ATM)) / (R * q[0])


@dataclass(frozen=True)
class ValvedCoupling(Tube):
    """A quick coupling whose poppet the flow must hold open: laminar, times |dp|/(|dp| + p_c) of the drop dp.

    Small drops leave it nearly shut. Reasoned: the poppet's opening grows with the drop against its spring.
    """

    form = "valved_coupling"
    conductance: float = 6e-9  # kg/(s Pa)
    p_c: float = 1e4  # Pa

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        size = sqrt((p_a - p_b) ** 2 + 1e4)
        return self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM) * size / (size + self.p_c)
