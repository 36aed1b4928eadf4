"""Hoses between valves and muscle, a dead end, and where the gas gets out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import P_ATM, T_ATM, R
from rig.seen.gas import CP, CV, Tube
from rig.seen.pneumatics import StretchedLeak

State = Sequence[float]
_RHO = P_ATM / (R * T_ATM)  # kg/m3, near that of ISO 8778


@dataclass(frozen=True)
class ChokedTube(Tube):
    """A tube by its sonic conductance C and a low critical ratio b: C rho_0 p sqrt(T_0/T (1 - ((r - b)/(1 - b))^2)).

    Linear below a drop of 0.1 % of the pressure.
    Source: ISO 6358-1:2013; long tubes have a b of 0.05 to 0.35.
    """

    form = "choked"
    conductance: float = 1e-9  # m3/(s Pa), C
    b: float = 0.2

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        if p_a < p_b:
            return -self.flow(p_b, t_b, p_a, t_a)
        over = max(p_b / p_a - self.b, 0.0) / (1 - self.b)
        head, edge = 1 - over * over, 2e-3 / (1 - self.b)
        return self.conductance * _RHO * p_a * sqrt(T_ATM / t_a) * head / sqrt(sqrt(head * head + edge * edge))


@dataclass(frozen=True)
class KinkedHose(Tube):
    """A kink that pressure opens: laminar, G (1 + p_mean/p_0) with the mean gauge pressure in the hose.

    A kinked hose is a flattened one, whose section grows with the pressure inside; reasoned to first order.
    """

    form = "kinked"
    conductance: float = 4e-9  # kg/(s Pa), at ambient pressure
    p_0: float = 1e5  # Pa

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        opened = 1 + max((p_a + p_b) / 2 - P_ATM, 0.0) / self.p_0
        return self.conductance * opened * (p_a * p_a - p_b * p_b) / (2 * P_ATM)


@dataclass(frozen=True)
class DeadEnd(Effect):
    """A rigid dead end, as the tube to a gauge, whose gas takes the wall's temperature in tau (at ambient density).

    States: mass, energy. Filling warms it by compression, and the wall, at ambient temperature, cools it again, so that
    it goes on taking up gas. Source: first law for an open volume with a constant film.
    """

    family = "dead_volume"
    form = "dead_end"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 1e-5  # m3
    tau: float = 0.3  # s
    conductance: float = 1e-8  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        mass = _RHO * self.volume
        return (mass, CV * mass * T_ATM)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - R * q[1] / (CV * self.volume))
        return flow, CP * flow * (temperature if flow > 0 else q[1] / (CV * q[0]))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow, enthalpy = self.exchange(q, now.p_gauge + P_ATM, now.temperature)
        cooled = CV * _RHO * self.volume / self.tau * (q[1] / (CV * q[0]) - T_ATM)
        return flow, enthalpy - cooled


@dataclass(frozen=True)
class WideningGap(Effect):
    """A narrow gap that pressure pushes apart: G p_gauge (1 + p_gauge/p_0)^3.

    Flow through a gap goes with the cube of its width (O. Reynolds, Phil. Trans. R. Soc. 177 (1886) 157), and the width
    gives way in proportion to pressure.
    """

    family = "leak"
    form = "widening_gap"
    conductance: float = 6e-12  # kg/(s Pa)
    p_0: float = 2e5  # Pa

    def leak(self, p: float, temperature: float) -> float:
        gauge = p - P_ATM
        return self.conductance * gauge * (1 + max(gauge, 0.0) / self.p_0) ** 3


@dataclass(frozen=True)
class PulledCrimp(StretchedLeak):
    """A crimped end that leaks as the bladder is pulled out of it: G p_gauge F/F_0 with the muscle's pull F.

    State: the contraction. Reasoned: the pull takes away some of the crimp's contact pressure.
    """

    form = "pulled_crimp"
    conductance: float = 2e-11  # kg/(s Pa)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    f_0: float = 100.0  # N

    def flow(self, x: float, gauge: float) -> float:
        length = self.length - x
        pull = gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return self.conductance * gauge * max(pull, 0.0) / self.f_0
