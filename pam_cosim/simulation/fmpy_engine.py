"""Runs by FMPy instead of the compiled loop: the same model, somebody else's master."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fmu.read import read_interface
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.inputs import Inputs
from pam_cosim.simulation.trajectory import Trajectory
from pam_cosim.wording import did_you_mean


def run_with_fmpy(
    path: Path,
    times: Array,
    *,
    parameters: Mapping[str, float],
    inputs: Inputs | None,
    outputs: Sequence[str] | None = None,
) -> Trajectory:
    """One run with ``fmpy.simulate_fmu``.

    Args:
        path: the FMU.
        times: (n,) [s] evenly spaced.
        parameters: parameters, constant inputs and start values [SI].
        inputs: over time.
        outputs: names of variables; default: the outputs.

    Raises:
        InputError: an unknown output.
        SimulationFailure: FMPy or the FMU gave up.
    """
    import fmpy

    interface = read_interface(path)
    known = interface.variables
    names = list(interface.outputs if outputs is None else outputs)
    for name in names:
        if name not in known:
            raise InputError(
                f"{interface.model} has no output '{name}'; {did_you_mean(name, known)}"
            )
    held = {
        name: parameters.get(name, variable.start or 0.0)
        for name, variable in interface.inputs.items()
    }
    try:
        made = fmpy.simulate_fmu(
            str(path),
            start_time=float(times[0]),
            stop_time=float(times[-1]),
            output_interval=float(times[-1] - times[0]) / (len(times) - 1),
            start_values=dict(parameters),
            input=_signals(inputs, held),
            output=names,
            fmi_type="CoSimulation",
        )
    except Exception as problem:  # FMPy raises bare Exceptions
        raise RunFailure(f"FMPy: {problem}", None, dict(parameters)) from problem
    if not np.isfinite(made["time"]).all() or made["time"][-1] < times[-1] - 1e-9 * max(
        1.0, abs(times[-1])
    ):
        raise SimulationFailure(f"FMPy stopped at {made['time'][-1]:g} s")
    values = {name: np.ascontiguousarray(made[name]) for name in names}
    return Trajectory(
        np.ascontiguousarray(made["time"]), values, {name: known[name].unit for name in names}
    )


def _signals(inputs: Inputs | None, held: Mapping[str, float]) -> np.ndarray | None:
    """As FMPy takes them: rows of time and all inputs; where inputs are held, a step is two rows of one time."""
    if inputs is None or not inputs.values:
        return None
    time, columns = inputs.time, dict(inputs.values)
    if inputs.interpolation == "previous":
        time = np.repeat(time, 2)[1:]
        columns = {name: np.repeat(values, 2)[:-1] for name, values in columns.items()}
    columns = {name: np.full(time.shape, value) for name, value in held.items()} | columns
    kind = [("time", np.float64), *((name, np.float64) for name in columns)]
    signals = np.zeros(len(time), kind)
    signals["time"] = time
    for name, values in columns.items():
        signals[name] = values
    return signals
