"""What a coupled run gives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from pam_cosim.exports import Columns, Tabular
from pam_cosim.simulation import (
    Trajectory,
)
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class CoupledRun(Printed, Tabular):
    """What came of a run of a coupled system.

    Attributes:
        trajectory: the outputs of all components and the inputs of the system, as ``component.variable``, at every
            communication point; where something jumps, a time stands twice.
        method: "jacobi" or "gauss-seidel".
        steps: communication steps that stand.
        rejected: those that were taken back because their error was too large.
        component_steps: steps that each FMU has made, for error estimates and in rejected steps too.
        rollbacks: how often the system went back to a saved state.
        smallest, largest: step [s].
    """

    trajectory: Trajectory
    method: str
    steps: int
    rejected: int
    component_steps: Mapping[str, int]
    rollbacks: int
    smallest: float
    largest: float

    def frame_columns(self) -> Columns:
        """Those of the trajectory."""
        return self.trajectory.frame_columns()

    def __str__(self) -> str:
        low, high = f"{self.smallest:.3g}", f"{self.largest:.3g}"
        spread = f"{low} s" if low == high else f"{low} to {high} s"
        cost = ", ".join(f"{name} {count}" for name, count in self.component_steps.items())
        taken_back = f", {self.rejected} taken back" if self.rejected else ""
        return (
            f"{self.method} up to {self.trajectory.time[-1]:.6g} s: {self.steps} steps of {spread}{taken_back}; "
            f"steps of the components: {cost}; {self.rollbacks} rollbacks"
        )
