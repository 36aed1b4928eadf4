"""Lines, side volumes, leaks, valves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.effect import Effect, LineEffect, Now, Rest
from rig.flow import GAMMA, P_ATM, T_ATM, R, mass_flow
from rig.schedule import Currents

State = Sequence[float]
CP = GAMMA * R / (GAMMA - 1)  # J/(kg K)
CV = R / (GAMMA - 1)  # J/(kg K)


@dataclass(frozen=True)
class Tube(LineEffect):
    """One volume at the valves (mass, energy), a resistance to the muscle."""

    family = "supply_line"
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

    def line_rates(self, q: State, from_valves: tuple[float, float], p: float, temperature: float) -> tuple[float, ...]:
        flow, enthalpy = self.into_muscle(q, p, temperature)
        return from_valves[0] - flow, from_valves[1] - enthalpy


@dataclass(frozen=True)
class OrificeTube(Tube):
    """A tube whose resistance is an orifice of the given effective area."""

    form = "orifice"
    area: float = 5e-7  # m2

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        return mass_flow(self.area, p_a, t_a, p_b, t_b)


@dataclass(frozen=True)
class LongTube(OrificeTube):
    """A long tube: resistance and a volume that counts."""

    form = "long"


@dataclass(frozen=True)
class LaminarTube(Tube):
    """Isothermal laminar flow: G (p_a^2 - p_b^2)/(2 p_atm)."""

    form = "laminar"
    conductance: float = 4e-9  # kg/(s Pa)

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        return self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)


@dataclass(frozen=True)
class TurbulentTube(Tube):
    """Rough turbulent flow: c sqrt(p_a^2 - p_b^2), linear below a drop of 0.1 % of the pressure."""

    form = "turbulent"
    c: float = 1e-9  # kg/(s Pa)

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        drop = p_a * p_a - p_b * p_b
        edge = 2e-3 * max(p_a, p_b) ** 2
        return self.c * drop / sqrt(sqrt(drop * drop + edge * edge))


@dataclass(frozen=True)
class ForchheimerTube(Tube):
    """Laminar and inertial resistance in one: p_a^2 - p_b^2 = 2 p_atm m (1 + |m|/m_0)/G."""

    form = "forchheimer"
    conductance: float = 6e-9  # kg/(s Pa)
    m_0: float = 2e-4  # kg/s

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        laminar = self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)
        return 2 * laminar / (1 + sqrt(1 + 4 * abs(laminar) / self.m_0))


@dataclass(frozen=True)
class TwoLumpTube(LineEffect):
    """A laminar tube in two lumps: resistance, volume, resistance behind a volume at the valves."""

    family = "supply_line"
    form = "two_lumps"
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

    def line_rates(self, q: State, from_valves: tuple[float, float], p: float, temperature: float) -> tuple[float, ...]:
        first, second = self._lump(q[:2]), self._lump(q[2:])
        middle, out = self._pass(first, second), self._pass(second, (p, temperature))
        return (
            from_valves[0] - middle[0], from_valves[1] - middle[1], middle[0] - out[0], middle[1] - out[1],
        )  # fmt: skip


@dataclass(frozen=True)
class SideChamber(Effect):
    """A rigid side volume behind an opening, without heat exchange (states: mass, energy)."""

    family = "dead_volume"
    form = "throttled"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3
    conductance: float = 2e-9  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        p_side, t_side = (GAMMA - 1) * q[1] / self.volume, q[1] / (CV * q[0])
        flow = self.conductance * (p - p_side)
        return flow, CP * flow * (temperature if flow > 0 else t_side)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@dataclass(frozen=True)
class CoolChamber(Effect):
    """A rigid side volume behind a wide opening whose walls keep the gas at ambient temperature (state: mass)."""

    family = "dead_volume"
    form = "isothermal"
    atol: ClassVar[tuple[float, ...]] = (1e-12,)
    volume: float = 1e-5  # m3
    conductance: float = 1e-8  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM),)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - q[0] * R * T_ATM / self.volume)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self.exchange(q, now.p_gauge + P_ATM, now.temperature)[0],)


@dataclass(frozen=True)
class TurbulentLeak(Effect):
    """Gas lost through a rough crack: c sqrt(p_gauge), linear below 2 kPa."""

    family = "leak"
    form = "turbulent"
    c: float = 6e-9  # kg/(s Pa^1/2)

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.c * gauge / sqrt(sqrt(gauge * gauge + 4e6))


@dataclass(frozen=True)
class SquaredLeak(Effect):
    """Gas lost through a capillary: c (p^2 - p_atm^2)."""

    family = "leak"
    form = "squared"
    c: float = 4e-17  # kg/(s Pa2)

    def leak(self, p: float, temperature: float) -> float:
        return self.c * (p * p - P_ATM * P_ATM)


@dataclass(frozen=True)
class LiftingLeak(Effect):
    """A seal that lifts at a pressure: G (p_gauge - p_0), rounded over 5 kPa."""

    family = "leak"
    form = "lifting"
    conductance: float = 4e-11  # kg/(s Pa)
    p_0: float = 6e4  # Pa

    def leak(self, p: float, temperature: float) -> float:
        over = p - P_ATM - self.p_0
        return self.conductance * (over + sqrt(over * over + 2.5e7)) / 2


@dataclass(frozen=True)
class SlowRateValve(Effect):
    """The current that acts moves at a limited rate: u' = rate tanh((command - u)/u_0)."""

    family = "valve_dynamics"
    form = "rate_limit"
    atol: ClassVar[tuple[float, ...]] = (1e-8, 1e-8)
    time_per_amp: float = 0.3  # s/A
    u_0: float = 0.01  # A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        gap = (command - u) / self.u_0
        return gap / sqrt(1 + gap * gap) / self.time_per_amp

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@dataclass(frozen=True)
class DelayedLagValve(Effect):
    """A dead time and then a first-order lag, of equal size."""

    family = "valve_dynamics"
    form = "delayed_lag"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.03  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def delay(self) -> float:
        return self.tau

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.command[0] - q[0]) / self.tau, (now.command[1] - q[1]) / self.tau

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@dataclass(frozen=True)
class TwoSpeedValve(Effect):
    """The currents act through a lag that is `ratio` times longer when they fall than when they rise."""

    family = "valve_dynamics"
    form = "two_speeds"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.06  # s
    ratio: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        return (command - u) / (self.tau if command > u else self.ratio * self.tau)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


_OPEN = 3.69e-7  # m2, by (62) at 0.35 A


@dataclass(frozen=True)
class CurrentOffset(Effect):
    """Both valves feel u + u_0."""

    family = "valve_area"
    form = "current_offset"
    u_0: float = 0.01  # A

    def current(self, q: State, command: Currents) -> Currents:
        return command[0] + self.u_0, command[1] + self.u_0


@dataclass(frozen=True)
class UnequalAreas(Effect):
    """The exhaust valve is r times as large as the inlet valve."""

    family = "valve_area"
    form = "unequal"
    r: float = 0.85

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return areas[0], areas[1] * self.r


@dataclass(frozen=True)
class CurvedArea(Effect):
    """The area is a curved function of the current: A (1 + c (A/A_ref - 1/2))."""

    family = "valve_area"
    form = "curved"
    c: float = 0.3

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        a, b = (max(0.0, area * (1 + self.c * (area / _OPEN - 0.5))) for area in areas)
        return a, b


@dataclass(frozen=True)
class PressedArea(Effect):
    """The pressure drop pushes the plunger shut: A exp(-beta (p_up - p_down)/1e5 Pa)."""

    family = "valve_area"
    form = "pressed"
    beta: float = 0.1

    def valve_factor(self, p_up: float, p_down: float) -> float:
        return exp(-self.beta * (p_up - p_down) / 1e5)


@dataclass(frozen=True)
class PumpedArea(Effect):
    """The pressure in front lifts the seat: A (1 + beta (p_up/p_atm - 2))."""

    family = "valve_area"
    form = "lifted_seat"
    beta: float = 0.08

    def valve_factor(self, p_up: float, p_down: float) -> float:
        return max(0.05, 1 + self.beta * (p_up / P_ATM - 2))
