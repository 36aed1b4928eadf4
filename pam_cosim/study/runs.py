"""One run of a model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from shlex import quote

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.model.settings import Setting, resolve
from pam_cosim.simulation import Inputs, Trajectory
from pam_cosim.simulation.failure import RunFailure
from pam_cosim.simulation.models import Paths, opened
from pam_cosim.study.input_sources import Source, inputs_of
from pam_cosim.units import UnitError, seconds
from pam_cosim.wording import did_you_mean

MOST_STEPS = 10_000_000  # of one run, whose outputs are kept in memory: 80 MB each


def simulate(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    inputs: Source | None = None,
    *,
    outputs: Sequence[str] = (),
    stop_time: Setting | None = None,
    interval: Setting | None = None,
    files: Paths = (),
    timeout: float | None = None,
) -> Trajectory:
    """One run of a model.

    ```python
    run = pam.simulate("Isotonic", {"u_in": 0.35, "load.m": "5 kg"}, outputs=["valve.inlet.m_flow"])
    wave = pam.simulate("Isotonic", inputs={"u_in": lambda t: 0.3 + 0.05 * np.sin(t)}, stop_time="20 s")
    ```

    Args:
        model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.
        parameters: by name, what differs from the model's defaults: parameters, inputs that are held constant, start
            values; a number [SI] or a text with a unit such as "207 kPa".
        inputs: over time: ``Inputs``, a CSV file, a mapping of names to arrays or functions of time, a pandas frame
            (``input_sources.inputs_of``).
        outputs: further variables to record.
        stop_time: [s]; default: the last time of ``inputs``, or the model's own.
        interval: [s] between outputs; default: the model's own.
        files: further Modelica files.
        timeout: [s] of processor time, after which a run of a Modelica model fails; default:
            ``LONGEST_RUN``. An FMU that makes no progress for so long is ended; default: a minute.

    Returns:
        The trajectory; of an FMU that ends the simulation itself the part up to there, with a warning.

    Raises:
        InputError: an unknown model or name, a value that cannot be used, an input given both ways.
        SimulationFailure: the run did not reach its end.
    """
    with opened(model, files, timeout=timeout) as simulator:
        interface = simulator.interface
        input_series, times = _input_series(interface, inputs, stop_time, interval)
        values = resolve(parameters or {}, interface)
        output_names = kept_variables(interface, outputs)
        try:
            return simulator.run(
                times, parameters=values, inputs=input_series, outputs=output_names
            )
        except RunFailure as failure:
            if failure.run is None:
                raise
            return replace(failure.run, warnings=(str(failure), *failure.run.warnings))


def _input_series(
    interface: Interface, source: Source | None, stop_time: Setting | None, interval: Setting | None
) -> tuple[Inputs | None, np.ndarray]:
    """Inputs over time, and the times of the outputs."""
    stop, step = (
        _seconds(setting, setting_name)
        for setting, setting_name in ((stop_time, "stop time"), (interval, "interval"))
    )
    inputs = inputs_of(source, interface, lambda: output_times(interface, None, stop, step))
    return inputs, output_times(interface, inputs, stop, step)


def _seconds(setting: Setting | None, setting_name: str) -> float | None:
    try:
        return None if setting is None else seconds(setting)
    except UnitError as problem:
        raise InputError(f"the {setting_name}: {problem}") from None


def kept_variables(interface: Interface, outputs: Sequence[str]) -> list[str]:
    """The model's own outputs and the further variables that are requested.

    Raises:
        InputError: there is no such variable; names the nearest one.
    """
    if isinstance(outputs, str):
        raise InputError(f"outputs are a list of names: write ['{outputs}']")
    interface_variables = interface.variables
    if not outputs and not interface.outputs and interface.locals:
        first = next(iter(interface.locals))
        raise InputError(
            f"{interface.model} has no outputs: name what to record, as --keep {quote(first)}"
        )
    for name in outputs:
        if name not in interface_variables:
            raise InputError(
                f"{interface.model} has no variable '{name}'; {did_you_mean(name, interface_variables)}"
            )
    return list(dict.fromkeys([*interface.outputs, *interface.sensitivities, *outputs]))


def output_times(
    interface: Interface,
    inputs: Inputs | None,
    stop_time: float | None = None,
    interval: float | None = None,
) -> np.ndarray:
    """Times (n,) of the outputs [s], evenly spaced.

    Args:
        interface: has the default start, duration and interval.
        inputs: their first sample is the start, their last the default stop time.
        stop_time: [s]; default: that of the inputs, or the model's duration after its start.
        interval: [s]; default: that of the model.

    Raises:
        InputError: the run does not end after its start, or has too many rows.
    """
    start = interface.start_time if inputs is None else float(inputs.time[0])
    end = start + interface.stop_time if inputs is None else float(inputs.time[-1])
    end = end if stop_time is None else stop_time
    step = interface.interval if interval is None else interval
    if not end > start or not step > 0:
        raise InputError(
            f"the run must end after its start: from {start:g} s to {end:g} s in steps of {step:g} s"
        )
    steps = (end - start) / step
    if not steps <= MOST_STEPS:
        span = f"from {start:g} s to {end:g} s in steps of {step:g} s"
        raise InputError(f"{span} are {steps:.3g} rows; {MOST_STEPS} at most can be kept")
    return start + (end - start) * np.linspace(0, 1, max(2, round(steps) + 1))
