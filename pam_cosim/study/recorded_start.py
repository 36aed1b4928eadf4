"""The state at which a model agrees with the first samples of a single recording."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import with_starts
from pam_cosim.measurement import DataSet, Run, Signal
from pam_cosim.simulation.inputs import Interpolation
from pam_cosim.simulation.models import Paths, opened
from pam_cosim.starts import state_trajectory


def recorded_start(
    model: str,
    recording: tuple[Array, dict[str, Array], dict[str, Array]],
    noise: Mapping[str, float],
    parameters: Mapping[str, float],
    interpolation: Interpolation,
    files: Paths = (),
    timeout: float | None = None,
) -> tuple[dict[str, float], str]:
    """All states [SI] at which a recording begins by its first samples, and that in a line.

    Both are empty where they agree with the model's own start.

    Args:
        model: by name, or a file.
        recording: times (n,) [s], inputs and measurements (n,) each by name [SI].
        noise: standard deviation of each signal [SI].
        parameters: and inputs held constant [SI].
        interpolation: of the inputs.
        files: further Modelica files.
        timeout: as in ``simulate``.

    Raises:
        InputError: the model cannot be used.
    """
    times, inputs, measurements = recording
    run = Run(
        "the recording", Path(), "fit", interpolation, dict(parameters), times, inputs, measurements
    )
    with opened(model, files, timeout=timeout) as simulator:
        interface_variables = simulator.interface.variables
        signals = {
            name: Signal(name, interface_variables[name].unit, noise[name]) for name in measurements
        }
        data = DataSet(Path(), "", model, signals, {}, {}, (run,))
        try:
            run = with_starts(simulator, data).runs[0]
            if run.start.mode != "estimated":
                return {}, ""
            at_first = replace(run, start=replace(run.start, mode="measured"))
            states = state_trajectory(simulator, data, at_first, {}, ())
            return {
                name: float(values[0]) for name, values in states.items()
            }, run.start.reason.removesuffix(": estimated")
        except SimulationFailure:  # the filter reports what it cannot do
            return {}, ""


__all__ = ["recorded_start"]
