"""Valves, lines, side volumes and leaks by other laws than `gas`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import GAMMA, P_ATM, R_CRITICAL, T_ATM, R, flow_function
from rig.schedule import Currents
from rig.seen.gas import CP, Tube

State = Sequence[float]


@dataclass(frozen=True)
class EddyValve(Effect):
    """A part of the magnetic force comes at once, the rest when eddy currents in the iron have died away.

    Reasoned from the diffusion of flux into a solid core: its skin follows the coil, its inside comes late.
    """

    family = "valve_dynamics"
    form = "eddy_currents"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.1  # s
    at_once: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.command[0] - q[0]) / self.tau, (now.command[1] - q[1]) / self.tau

    def current(self, q: State, command: Currents) -> Currents:
        a, b = (self.at_once * u + (1 - self.at_once) * late for u, late in zip(command, q, strict=True))
        return a, b


@dataclass(frozen=True)
class CriticalRatio(Effect):
    """Flow chokes at a lower ratio b of pressures than in a nozzle: sqrt(1 - ((r - b)/(1 - b))^2) above it.

    Source: ISO 6358-1:2013, whose b of real valves is 0.1 to 0.5 and of the ideal nozzle 0.528.
    """

    family = "valve_area"
    form = "critical_ratio"
    less: float = 0.05  # 0.528 - b

    def valve_factor(self, p_up: float, p_down: float) -> float:
        ratio = min(p_down / p_up, 0.999)
        b = max(R_CRITICAL - self.less, 0.0)
        over = max(ratio - b, 0.0) / (1 - b)
        return sqrt(1 - over * over) / flow_function(ratio)


@dataclass(frozen=True)
class BlasiusTube(Tube):
    """Turbulent flow through a smooth tube: c (p_a^2 - p_b^2)^(4/7), linear below a drop of 0.1 % of the pressure.

    Blasius' friction factor goes as Re^(-1/4), so the drop goes as the flow to the power 7/4.
    Source: H. Blasius, VDI-Forschungsheft 131 (1913).
    """

    form = "blasius"
    c: float = 2e-10  # kg/(s Pa^(8/7))

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        drop = p_a * p_a - p_b * p_b
        edge = 2e-3 * max(p_a, p_b) ** 2
        return float(self.c * drop * (drop * drop + edge * edge) ** (-3 / 14))


@dataclass(frozen=True)
class OneWayTube(Tube):
    """A line with a speed controller (check valve beside a throttle): laminar, G filling, share G venting."""

    form = "one_way"
    conductance: float = 4e-9  # kg/(s Pa)
    share: float = 0.4

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        flow = self.conductance * (p_a * p_a - p_b * p_b) / (2 * P_ATM)
        return flow if flow > 0 else self.share * flow


@dataclass(frozen=True)
class Hose(Effect):
    """A soft hose as side volume, V (1 + e (p - p_atm)), behind a wide opening, without heat exchange.

    States: mass; energy of the gas and what the hose took up as elastic work, E = p V/(gamma - 1) + V_0 e p^2/2, which
    only flow changes. Hoses are sold with their expansion per pressure (SAE J1401 for those of brakes).
    """

    family = "dead_volume"
    form = "hose"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3, at ambient pressure
    expansion: float = 5e-6  # 1/Pa
    conductance: float = 1e-8  # kg/(s Pa)

    @property
    def _soft(self) -> float:
        return self.volume * self.expansion  # m3/Pa

    def initial(self, rest: Rest) -> tuple[float, ...]:
        energy = P_ATM * self.volume / (GAMMA - 1) + self._soft * P_ATM**2 / 2
        return (P_ATM * self.volume / (R * T_ATM), energy)

    def _gas(self, q: State) -> tuple[float, float]:
        """Pressure and temperature: E = p (V_0 - soft p_atm)/(gamma - 1) + soft p^2 (1/(gamma - 1) + 1/2)."""
        square = self._soft * (1 / (GAMMA - 1) + 0.5)
        linear = self.volume * (1 - self.expansion * P_ATM) / (GAMMA - 1)
        p = 2 * q[1] / (linear + sqrt(linear * linear + 4 * square * q[1]))
        return p, p * self.volume * (1 + self.expansion * (p - P_ATM)) / (R * q[0])

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        p_side, t_side = self._gas(q)
        flow = self.conductance * (p - p_side)
        return flow, CP * flow * (temperature if flow > 0 else t_side)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@dataclass(frozen=True)
class LipSeal(Effect):
    """A lip that pressure presses shut: G p_gauge exp(-p_gauge/p_0), so that most is lost at middling pressure.

    Reasoned from self-energised seals, whose contact pressure rises with the pressure that they hold.
    """

    family = "leak"
    form = "lip_seal"
    conductance: float = 6e-11  # kg/(s Pa)
    p_0: float = 6e4  # Pa

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.conductance * gauge * exp(-max(gauge, 0.0) / self.p_0)


@dataclass(frozen=True)
class StretchedLeak(Effect):
    """A leak that depends on the contraction, its state; left to define: the flow."""

    family = "leak"
    atol: ClassVar[tuple[float, ...]] = (1e-8,)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.v,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.flow(q[0], p - P_ATM)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)

    def flow(self, x: float, gauge: float) -> float:
        """Mass flow [kg/s] to the surroundings, by contraction [m] and gauge pressure [Pa]."""
        raise NotImplementedError


@dataclass(frozen=True)
class StretchedPores(StretchedLeak):
    """Pores of the bladder that open as it is stretched: laminar, G p_gauge exp(x/x_0). State: the contraction.

    A pore's conductance goes as the fourth power of its width (Poiseuille), and contraction stretches the hoops.
    """

    form = "stretched_pores"
    conductance: float = 6e-12  # kg/(s Pa)
    x_0: float = 0.02  # m

    def flow(self, x: float, gauge: float) -> float:
        return self.conductance * gauge * exp(min(x / self.x_0, 8.0))
