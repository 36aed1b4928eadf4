"""What is known of a run that broke down."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from pam_cosim.errors import SimulationFailure

if TYPE_CHECKING:
    from pam_cosim.simulation.trajectory import Trajectory


class RunFailure(SimulationFailure):
    """A run that did not reach its end.

    Attributes:
        reason: the FMU's own words, or what went wrong with it.
        time: reached [s]; None: not known.
        parameters: values that differ from the model's defaults.
        run: the trajectory so far of a simulation that the FMU has ended itself; None: the FMU failed.
    """

    run: Trajectory | None = None

    def __init__(
        self, reason: str, time: float | None = None, parameters: Mapping[str, float] | None = None
    ):
        self.reason, self.time, self.parameters = reason, time, dict(parameters or {})
        super().__init__(reason, time, self.parameters)

    def __str__(self) -> str:
        text = self.reason.rstrip(". \n")
        if self.time is not None:
            text += f" (simulated up to {self.time:.6g} s)"
        if self.parameters:
            text += "; with " + ", ".join(
                f"{name} = {value:.6g}" for name, value in self.parameters.items()
            )
        return text


class ProcessFailure(RunFailure):
    """The FMU's process was ended, or ended itself, before it answered."""
