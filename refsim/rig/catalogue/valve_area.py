"""Openings of the valves by another law than the calibration's."""

from __future__ import annotations

from rig.effect import Effect, State, law
from rig.schedule import Currents


@law
class BackPressure(Effect):
    """Back pressure closes the valves a little: area times 1 - beta p_down/p_up."""

    form = "back_pressure"
    beta: float = 0.15

    def valve_factor(self, p_up: float, p_down: float) -> float:
        return 1 - self.beta * p_down / p_up


@law
class CurrentOffset(Effect):
    """Both valves feel u + u_0."""

    form = "current_offset"
    u_0: float = 0.01  # A

    def current(self, q: State, command: Currents) -> Currents:
        return command[0] + self.u_0, command[1] + self.u_0


@law
class UnequalAreas(Effect):
    """The exhaust valve is r times as large as the inlet valve."""

    form = "unequal"
    r: float = 0.85

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return areas[0], areas[1] * self.r
