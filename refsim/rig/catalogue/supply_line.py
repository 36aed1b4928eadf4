"""Lines between valves and muscle."""

from __future__ import annotations

from typing import ClassVar

from rig.effect import LineEffect, Rest, State, law
from rig.flow import CP, CV, GAMMA, P_ATM, T_ATM, R, mass_flow


@law
class Tube(LineEffect):
    """One volume at the valves (mass, energy), a resistance to the muscle."""

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 5e-6  # m3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def node(self, q: State) -> tuple[float, float]:
        return (GAMMA - 1) * q[1] / self.volume, q[1] / (CV * q[0])

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        """Gas [kg/s] through the resistance."""
        raise NotImplementedError

    def into_muscle(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        p_a, t_a = self.node(q)
        flow = self.flow(p_a, t_a, p, temperature)
        return flow, CP * flow * (t_a if flow > 0 else temperature)

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        flow, enthalpy = self.into_muscle(q, p, temperature)
        return from_valves[0] - flow, from_valves[1] - enthalpy


@law
class OrificeTube(Tube):
    """A tube whose resistance is an orifice of the given effective area."""

    form = "orifice"
    area: float = 5e-7  # m2

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        return mass_flow(self.area, p_a, t_a, p_b, t_b)


@law
class LongTube(OrificeTube):
    """A long tube: resistance and a volume that counts."""

    form = "long"


@law
class LaminarTube(Tube):
    """Isothermal laminar flow: G (p_a^2 - p_b^2)/(2 p_atm)."""

    form = "laminar"
    conductance: float = 4e-9  # kg/(s Pa)

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        return self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)
