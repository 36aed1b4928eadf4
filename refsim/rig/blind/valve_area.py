"""Openings of the valves by another law than the calibration's."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.flow import GAMMA, P_ATM, R_CRITICAL, flow_function
from rig.schedule import Currents

_POWER = (GAMMA - 1) / GAMMA


@dataclass(frozen=True)
class JetForce(Effect):
    """The jet's momentum pulls the plunger shut: area/(1 + beta p_up/p_atm N(r) w(r)), 1 for a choked jet from ambient.

    N(r) is the flow and w(r) the jet's speed, each by that of a choked jet; the spring gives way in proportion.
    Source: H. E. Merritt, Hydraulic Control Systems (1967), section 5.6, on flow forces; w by Saint-Venant and Wantzel.
    """

    family = "valve_area"
    form = "jet_force"
    beta: float = 0.06

    def valve_factor(self, p_up: float, p_down: float) -> float:
        ratio = min(p_down / p_up, 0.99999)
        speed = sqrt((1 - max(ratio, R_CRITICAL) ** _POWER) / (1 - R_CRITICAL**_POWER))
        return 1 / max(1 + self.beta * p_up / P_ATM * flow_function(ratio) * speed, 0.2)


@dataclass(frozen=True)
class PushedExhaust(Effect):
    """The muscle's pressure lifts the plunger of the exhaust valve alone: area times 1 + beta p/1 bar.

    It sits against the flow, the inlet's with it. State: the gauge pressure behind 2 ms. Reasoned: the pressure on the
    seat's area moves a plunger on its spring (P. Beater, Pneumatic Drives, 2007).
    """

    family = "valve_area"
    form = "pushed_exhaust"
    atol: ClassVar[tuple[float, ...]] = (1e-1,)
    beta: float = 0.1

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.p_gauge - q[0]) / 2e-3,)

    def opening(self, q: State, areas: tuple[float, float]) -> tuple[float, float]:
        return areas[0], areas[1] * max(1 + self.beta * q[0] / 1e5, 0.05)


@dataclass(frozen=True)
class ShortStroke(Effect):
    """The plungers meet their stops, soft ones, before they are fully open: A/(1 + (A/A_m)^4)^(1/4).

    Source: data sheets of proportional valves, whose flow levels off near the rated current; the power is reasoned.
    """

    family = "valve_area"
    form = "short_stroke"
    most: float = 3e-7  # m2, A_m

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        a, b = (area / sqrt(sqrt(1 + (area / self.most) ** 4)) for area in areas)
        return a, b
