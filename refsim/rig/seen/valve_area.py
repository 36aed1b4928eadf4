"""Openings of the valves by another law than the calibration's."""

from __future__ import annotations

from math import acos, exp, pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import GAMMA, P_ATM, R_CRITICAL, flow_function
from rig.schedule import Currents

_POWER = (GAMMA - 1) / GAMMA

_OPEN = 3.69e-7  # m2, by (62) at 0.35 A
_PERRY = (-0.1002, 0.8415, -3.9, 4.6001, -1.6827)  # coefficients of r to r^5
_PERRY_AT_VACUUM = 0.8414


@law
class CurvedArea(Effect):
    """The area is a curved function of the current: A (1 + c (A/A_ref - 1/2))."""

    c: float = 0.3

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        a, b = (max(0.0, area * (1 + self.c * (area / _OPEN - 0.5))) for area in areas)
        return a, b


@law
class PressedArea(Effect):
    """The pressure drop pushes the plunger shut: A exp(-beta (p_up - p_down)/1e5 Pa)."""

    beta: float = 0.1

    def valve_factor(self, p_up: float, p_down: float) -> float:
        return exp(-self.beta * (p_up - p_down) / 1e5)


@law
class PumpedArea(Effect):
    """The pressure in front lifts the seat: A (1 + beta (p_up/p_atm - 2))."""

    beta: float = 0.08

    def valve_factor(self, p_up: float, p_down: float) -> float:
        return max(0.05, 1 + self.beta * (p_up / P_ATM - 2))


@law
class CriticalRatio(Effect):
    """Flow chokes at a lower ratio b of pressures than in a nozzle: sqrt(1 - ((r - b)/(1 - b))^2) above it.

    Source: ISO 6358-1:2013, whose b of real valves is 0.1 to 0.5 and of the ideal nozzle 0.528.
    """

    less: float = 0.05  # 0.528 - b

    def valve_factor(self, p_up: float, p_down: float) -> float:
        ratio = min(p_down / p_up, 0.999)
        b = max(R_CRITICAL - self.less, 0.0)
        over = max(ratio - b, 0.0) / (1 - b)
        return sqrt(1 - over * over) / flow_function(ratio)


@law
class SharpEdge(Effect):
    """The jet of a sharp edge contracts the more, the less it is choked: area times 1 - s (1 - C_d(r)/C_d(0)).

    r is the ratio of pressures, C_d falls from 0.84 to 0.60; s = 1 is Perry's orifice.
    Source: J. A. Perry, Critical flow through sharp-edged orifices, Trans. ASME 71 (1949) 757, with the polynomial of
    D. McCloy, H. R. Martin, Control of Fluid Power (1980).
    """

    s: float = 0.5

    def valve_factor(self, p_up: float, p_down: float) -> float:
        r = min(p_down / p_up, 1.0)
        change = sum(c * r ** (k + 1) for k, c in enumerate(_PERRY))
        return 1 + self.s * change / _PERRY_AT_VACUUM


@law
class CloggedSilencer(Effect):
    """A silencer of area A_s in series behind the exhaust valve: A/sqrt(1 + (A/A_s)^2), the inlet valve as it was.

    Restrictions in series add by their inverse squares (P. Beater, Pneumatic Drives, 2007, section 5.3).
    """

    area: float = 5e-7  # m2, A_s

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return areas[0], areas[1] / sqrt(1 + (areas[1] / self.area) ** 2)


@law
class RoundPort(Effect):
    """A spool that uncovers round holes in its sleeve: the area is a circle's segment over the stroke, by a share.

    The rest of the holes are the slots of the linear law, and both are fully open at the same stroke. Source: J. F.
    Blackburn, G. Reethof, J. L. Shearer, Fluid Power Control (1960), chapter 7, on round ports.
    """

    share: float = 0.3
    full: float = 9e-7  # m2, of the linear law where the holes are fully open

    def _area(self, linear: float) -> float:
        h = min(linear / self.full, 1.0)
        segment = (acos(1 - 2 * h) - 2 * (1 - 2 * h) * sqrt(h * (1 - h))) / pi
        return (1 - self.share) * linear + self.share * self.full * segment

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return self._area(areas[0]), self._area(areas[1])


@law
class NarrowSlot(Effect):
    """Where the opening is narrow, its walls slow the flow down: A A/(A + A_t).

    The discharge coefficient rises from nothing with the opening and levels off, as flow turns from laminar to
    turbulent. Source: H. E. Merritt, Hydraulic Control Systems (1967), section 3.3; the transition is reasoned.
    """

    transition: float = 3e-8  # m2, A_t

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        a, b = (area * area / (area + self.transition) for area in areas)
        return a, b


@law
class JetForce(Effect):
    """The jet's momentum pulls the plunger shut: area/(1 + beta p_up/p_atm N(r) w(r)), 1 for a choked jet from ambient.

    N(r) is the flow and w(r) the jet's speed, each by that of a choked jet; the spring gives way in proportion.
    Source: H. E. Merritt, Hydraulic Control Systems (1967), section 5.6, on flow forces; w by Saint-Venant and Wantzel.
    """

    beta: float = 0.06

    def valve_factor(self, p_up: float, p_down: float) -> float:
        ratio = min(p_down / p_up, 0.99999)
        speed = sqrt((1 - max(ratio, R_CRITICAL) ** _POWER) / (1 - R_CRITICAL**_POWER))
        return 1 / max(1 + self.beta * p_up / P_ATM * flow_function(ratio) * speed, 0.2)


@law
class PushedExhaust(Effect):
    """The muscle's pressure lifts the plunger of the exhaust valve alone: area times 1 + beta p/1 bar.

    It sits against the flow, the inlet's with it. State: the gauge pressure behind 2 ms. Reasoned: the pressure on the
    seat's area moves a plunger on its spring (P. Beater, Pneumatic Drives, 2007).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-1,)
    beta: float = 0.1

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.p_gauge - q[0]) / 2e-3,)

    def opening(self, q: State, areas: tuple[float, float]) -> tuple[float, float]:
        return areas[0], areas[1] * max(1 + self.beta * q[0] / 1e5, 0.05)


@law
class ShortStroke(Effect):
    """The plungers meet their stops, soft ones, before they are fully open: A/(1 + (A/A_m)^4)^(1/4).

    Source: data sheets of proportional valves, whose flow levels off near the rated current; the power is reasoned.
    """

    most: float = 3e-7  # m2, A_m

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        a, b = (area / sqrt(sqrt(1 + (area / self.most) ** 4)) for area in areas)
        return a, b
