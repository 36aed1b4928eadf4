"""Inputs of a coupled system over time."""

from __future__ import annotations

import numpy as np

from pam_cosim.simulation import Inputs
from pam_cosim.simulation.inputs import Pieces, pieces

_ROUNDING = 1e-12  # of the largest time: times that are closer are one
_BEGUN = 1e-9  # of a step, after whose begin an input is on the line that it follows over the step


class InputLines:
    """The lines that inputs follow, by component and variable.

    Args:
        inputs: by ``component.variable``, or None.
    """

    def __init__(self, inputs: Inputs | None) -> None:
        self._lines: dict[str, dict[str, Pieces]] = {}
        self._near = 0.0
        if inputs is None:
            return
        self._near = _ROUNDING * max(1.0, float(np.max(np.abs(inputs.time))))
        for name, values in inputs.values.items():
            component, _, variable = name.partition(".")
            lines = self._lines.setdefault(component, {})
            lines[variable] = pieces(inputs.time, values, inputs.interpolation)

    def at(self, component: str, time: float, after: bool) -> dict[str, float]:
        """Values of a component's inputs; at a jump, those before it or those ``after``."""
        when = np.array([time + self._near if after else time - self._near])
        return {
            name: float(line.at(when)[0][0])
            for name, line in self._lines.get(component, {}).items()
        }

    def over_step(
        self, component: str, time: float, duration: float
    ) -> tuple[dict[str, float], dict[str, float]]:
        """Values of a component's inputs at the start of a step, and how fast they change in it."""
        values, slopes = {}, {}
        for name, line in self._lines.get(component, {}).items():
            value, slope = line.at(np.array([time + _BEGUN * duration]))
            values[name], slopes[name] = float(value[0]), float(slope[0])
        return values, slopes

    def every(self, time: float, after: bool) -> dict[str, float]:
        """All values, by ``component.variable``."""
        return {
            f"{c}.{name}": v for c in self._lines for name, v in self.at(c, time, after).items()
        }

    def turn(self, time: float) -> bool:
        """Whether an input jumps or bends at this time [s]."""
        return any(bool(np.any(np.abs(times - time) <= self._near)) for times in self._times())

    def turns(self, start: float, stop: float) -> list[float]:
        """Times between these at which an input jumps or bends [s]."""
        return sorted({float(t) for times in self._times() for t in times if start < t < stop})

    def _times(self) -> list[np.ndarray]:
        return [line.time for lines in self._lines.values() for line in lines.values()]
