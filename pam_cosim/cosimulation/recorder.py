"""What happened so far, row by row."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pam_cosim.simulation import Trajectory


class Recorder:
    """Rows of a trajectory that grows; it can be cut back to what it was.

    Args:
        units: of the columns, by name.
    """

    def __init__(self, units: Mapping[str, str]) -> None:
        self.units = dict(units)
        self.rows: list[tuple[float, tuple[float, ...]]] = []

    def add(self, time: float, values: Sequence[float]) -> None:
        """One row; a second one at the same time is after a step of an input."""
        self.rows.append((time, tuple(values)))

    def trajectory(self, warnings: Sequence[str] = ()) -> Trajectory:
        """All rows so far."""
        time = np.array([time for time, _ in self.rows])
        table = np.array([values for _, values in self.rows]).reshape(
            len(self.rows), len(self.units)
        )
        columns = np.ascontiguousarray(table.T)
        return Trajectory(
            time, dict(zip(self.units, columns, strict=True)), self.units, tuple(warnings)
        )
