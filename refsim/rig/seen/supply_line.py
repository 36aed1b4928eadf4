"""Lines between valves and muscle."""

from __future__ import annotations

from math import sqrt
from typing import ClassVar

from rig.catalogue.supply_line import OrificeTube, Tube
from rig.effect import LineEffect, Rest, State, law
from rig.flow import CP, CV, GAMMA, P_ATM, RHO, T_ATM, R


@law
class TurbulentTube(Tube):
    """Rough turbulent flow: c sqrt(p_a^2 - p_b^2), linear below a drop of 0.1 % of the pressure."""

    c: float = 1e-9  # kg/(s Pa)

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        drop = p_a * p_a - p_b * p_b
        edge = 2e-3 * max(p_a, p_b) ** 2
        return self.c * drop / sqrt(sqrt(drop * drop + edge * edge))


@law
class ForchheimerTube(Tube):
    """Laminar and inertial resistance in one: p_a^2 - p_b^2 = 2 p_atm m (1 + |m|/m_0)/G."""

    conductance: float = 6e-9  # kg/(s Pa)
    m_0: float = 2e-4  # kg/s

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        laminar = self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)
        return 2 * laminar / (1 + sqrt(1 + 4 * abs(laminar) / self.m_0))


@law
class TwoLumpTube(LineEffect):
    """A laminar tube in two lumps: resistance, volume, resistance behind a volume at the valves."""

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7, 1e-12, 1e-7)
    volume: float = 8e-6  # m3, both together
    conductance: float = 4e-9  # kg/(s Pa), both in series

    def initial(self, rest: Rest) -> tuple[float, ...]:
        half = self.volume / 2
        return (P_ATM * half / (R * T_ATM), P_ATM * half / (GAMMA - 1)) * 2

    def _lump(self, q: State) -> tuple[float, float]:
        return (GAMMA - 1) * q[1] / (self.volume / 2), q[1] / (CV * q[0])

    def _pass(self, a: tuple[float, float], b: tuple[float, float]) -> tuple[float, float]:
        flow = 2 * self.conductance * (a[0] ** 2 - b[0] ** 2) / (2 * P_ATM)
        return flow, CP * flow * (a[1] if flow > 0 else b[1])

    def node(self, q: State) -> tuple[float, float]:
        return self._lump(q[:2])

    def into_muscle(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return self._pass(self._lump(q[2:]), (p, temperature))

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        first, second = self._lump(q[:2]), self._lump(q[2:])
        middle, out = self._pass(first, second), self._pass(second, (p, temperature))
        return (
            from_valves[0] - middle[0], from_valves[1] - middle[1], middle[0] - out[0], middle[1] - out[1],
        )  # fmt: skip


@law
class BlasiusTube(Tube):
    """Turbulent flow through a smooth tube: c (p_a^2 - p_b^2)^(4/7), linear below a drop of 0.1 % of the pressure.

    Blasius' friction factor goes as Re^(-1/4), so the drop goes as the flow to the power 7/4.
    Source: H. Blasius, VDI-Forschungsheft 131 (1913).
    """

    c: float = 2e-10  # kg/(s Pa^(8/7))

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        drop = p_a * p_a - p_b * p_b
        edge = 2e-3 * max(p_a, p_b) ** 2
        return float(self.c * drop * (drop * drop + edge * edge) ** (-3 / 14))


@law
class OneWayTube(Tube):
    """A line with a speed controller (check valve beside a throttle): laminar, G filling, share G venting."""

    conductance: float = 4e-9  # kg/(s Pa)
    share: float = 0.4

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        flow = self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)
        return flow if flow > 0 else self.share * flow


@law
class ChokedTube(Tube):
    """A tube by its sonic conductance C and a low critical ratio b: C rho_0 p sqrt(T_0/T (1 - ((r - b)/(1 - b))^2)).

    Linear below a drop of 0.1 % of the pressure.
    Source: ISO 6358-1:2013; long tubes have a b of 0.05 to 0.35.
    """

    conductance: float = 1e-9  # m3/(s Pa), C
    b: float = 0.2

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        if p_a < p_b:
            return -self.flow(p_b, t_b, p_a, t_a)
        over = max(p_b / p_a - self.b, 0.0) / (1 - self.b)
        head, edge = 1 - over * over, 2e-3 / (1 - self.b)
        return (
            self.conductance
            * RHO
            * p_a
            * sqrt(T_ATM / t_a)
            * head
            / sqrt(sqrt(head * head + edge * edge))
        )


@law
class KinkedHose(Tube):
    """A kink that pressure opens: laminar, G (1 + p_mean/p_0) with the mean gauge pressure in the hose.

    A kinked hose is a flattened one, whose section grows with the pressure inside; reasoned to first order.
    """

    conductance: float = 4e-9  # kg/(s Pa), at ambient pressure
    p_0: float = 1e5  # Pa

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        opened = 1 + max((p_a + p_b) / 2 - P_ATM, 0.0) / self.p_0
        return self.conductance * opened * (p_a * p_a - p_b * p_b) / (2 * P_ATM)


@law
class InertialLine(Tube):
    """A long tube whose gas must be set going: I m' = p_a - p_b - m 2 p_atm/(G (p_a + p_b)). Third state: the flow.

    The inertance I is length over section (1.6e5/m for 2 m of 4 mm tube); once flow is steady it is a laminar tube.
    Source: J. Watton, Fluid Power Systems (1989), on lumped lines.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7, 1e-10)
    conductance: float = 4e-9  # kg/(s Pa)
    inertance: float = 1.6e5  # 1/m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (*super().initial(rest), 0.0)

    def node(self, q: State) -> tuple[float, float]:
        return super().node(q[:2])

    def into_muscle(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return q[2], CP * q[2] * (self.node(q)[1] if q[2] > 0 else temperature)

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        p_a = self.node(q)[0]
        drop = q[2] * 2 * P_ATM / (self.conductance * (p_a + p))
        return (
            *super().line_rates(q, from_valves, p, temperature),
            (p_a - p - drop) / self.inertance,
        )


@law
class CooledLine(OrificeTube):
    """A line whose wall takes heat from its gas, G (T - T_atm), and an orifice: neither adiabatic nor isothermal.

    Source: first law for an open volume; E. Richer, Y. Hurmuzlu, A high performance pneumatic force actuator system, J.
    Dyn. Syst. Meas. Control 122 (2000) 416, on the two limits.
    """

    wall: float = 0.03  # W/K, G

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        gas, energy = super().line_rates(q, from_valves, p, temperature)
        return gas, energy - self.wall * (self.node(q)[1] - T_ATM)


@law
class SoftHose(OrificeTube):
    """A rubber hose that widens with pressure, V (1 + e (p - p_atm)), and an orifice at the muscle.

    States: mass; energy of the gas and what the hose took up, p V(p)/(gamma - 1) + V e p^2/2, which only flow changes.
    Source: hoses are sold with their expansion per pressure (SAE J1401); first law for gas and hose together.
    """

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


@law
class ValvedCoupling(Tube):
    """A quick coupling whose poppet the flow must hold open: laminar, times |dp|/(|dp| + p_c) of the drop dp.

    Small drops leave it nearly shut. Reasoned: the poppet's opening grows with the drop against its spring.
    """

    conductance: float = 6e-9  # kg/(s Pa)
    p_c: float = 1e4  # Pa

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        size = sqrt((p_a - p_b) ** 2 + 1e4)
        return self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM) * size / (size + self.p_c)
