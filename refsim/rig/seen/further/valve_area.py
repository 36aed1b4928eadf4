"""Openings of the valves by another law than the calibration's."""

from __future__ import annotations

from rig.effect import Effect, law
from rig.flow import R_CRITICAL, flow_function


@law
class SubsonicIndex(Effect):
    """Below choking the flow is (1 - ((r - b)/(1 - b))^2)^m of the choked one, m not a nozzle's 1/2.

    b is the nozzle's 0.528, r the ratio of pressures. Source: ISO 6358-1:2013, whose subsonic index m is 0.4 to 0.65
    for valves and more for what has several restrictions in a row.
    """

    more: float = 0.06  # m - 1/2

    def valve_factor(self, p_up: float, p_down: float) -> float:
        ratio = min(p_down / p_up, 0.999)
        over = max(ratio - R_CRITICAL, 0.0) / (1 - R_CRITICAL)
        return float((1 - over * over) ** (0.5 + self.more) / flow_function(ratio))


@law
class ServoAssisted(Effect):
    """Valves that the medium opens: a drop of pressure must lift the diaphragm, area times dp/(dp + p_m).

    Source: data sheets of servo-assisted solenoid valves, which state a least differential pressure of 0.1 to 0.5 bar
    for the full opening; the law, a diaphragm on a spring, is reasoned.
    """

    p_m: float = 5e3  # Pa

    def valve_factor(self, p_up: float, p_down: float) -> float:
        drop = max(p_up - p_down, 0.0)
        return (drop + 1.0) / (drop + 1.0 + self.p_m)
