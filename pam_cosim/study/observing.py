"""A study's step that estimates what is not measured from what is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.analysis.isolated import work_on
from pam_cosim.analysis.kalman import Belief, RecordedSamples, observe_samples
from pam_cosim.analysis.observation import Observation
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.measurement import read_recording
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu
from pam_cosim.model.settings import Setting, resolve, size_of
from pam_cosim.simulation import Trajectory, models
from pam_cosim.simulation.inputs import Interpolation
from pam_cosim.study.dynamics import conditions_of, exchange, state_names
from pam_cosim.study.recorded_start import recorded_start
from pam_cosim.wording import did_you_mean

_NOTHING = 1e-100  # of which the square still is a number


def observe(
    model: str,
    recording: Trajectory | Path | str,
    parameters: Mapping[str, Setting] | None = None,
    *,
    noise: Mapping[str, Setting],
    outputs: Sequence[str] | None = None,
    unknown: Mapping[str, tuple[Setting, Setting]] | None = None,
    drift: Mapping[str, Setting] | None = None,
    spread: Mapping[str, Setting] | None = None,
    start: Mapping[str, Setting] | None = None,
    interpolation: Interpolation = "linear",
    files: models.Paths = (),
    timeout: float | None = None,
) -> Observation:
    """What is not measured, estimated from what is, by an extended Kalman filter on the FMU.

    Args:
        model: as in ``linearise``.
        parameters: as in ``linearise``.
        files: as in ``linearise``.
        timeout: as in ``linearise``.
        recording: inputs and measurements: a CSV file with columns ``name [unit]``, or a trajectory in SI units.
        noise: standard deviation of each signal that is to be taken as measured.
        outputs: what is wanted: outputs or any other variables; default: every output.
        unknown: unmeasured inputs, such as a load: standard deviation at the start, and of the change within
            a second.
        drift: standard deviation of what the model does not know of a state, within a second; default: none.
        spread: standard deviation of a state at the start; default: a hundredth of its nominal size.
        start: values at the start by name, as a state of ``linearise``; default: the model's, or what the first samples
            show of a Modelica model where the recording begins elsewhere.
        interpolation: of inputs between rows: "linear", or "previous", held.

    Raises:
        InputError: an unknown name, a value that cannot be used; nothing measured.
        SimulationFailure: the model cannot be carried on from an estimate.
    """
    exchange_model = exchange(model, files)
    face = exchange_model.interface
    read = _recorded(recording, face, noise)
    unmeasured = dict(unknown or {})
    for name in unmeasured:
        if name not in face.inputs:
            raise InputError(
                f"{face.model} has no input '{name}'; {did_you_mean(name, face.inputs)}"
            )
        if name in read[1]:
            raise InputError(f"'{name}' is recorded and unknown; keep one of them")
    random_walks = {
        name: (_deviation(name, at_start, face), _deviation(name, change, face))
        for name, (at_start, change) in unmeasured.items()
    }
    belief = Belief(
        _deviations(noise, face),
        random_walks,
        _deviations(drift or {}, face, state_names(exchange_model.path)),
        _deviations(spread or {}, face, state_names(exchange_model.path)),
        conditions_of(start or {}, face),
    )
    _check_noise(belief.noise, read[2], face)
    samples = RecordedSamples(*read, held=interpolation == "previous")
    settings = resolve(parameters or {}, face)
    begins = ""
    if not start and not is_fmu(model):
        states, begins = recorded_start(
            model, read, belief.noise, settings, interpolation, files, timeout
        )
        belief = replace(belief, start=states)
    chosen = list(face.outputs if outputs is None else outputs)
    observation = work_on(
        exchange_model.path,
        exchange_model.trusted,
        timeout,
        observe_samples,
        settings,
        samples,
        belief,
        chosen,
    )
    return replace(observation, begins=begins)


def _recorded(
    recording: Trajectory | Path | str, face: Interface, noise: Mapping[str, Setting]
) -> tuple[Array, dict[str, Array], dict[str, Array]]:
    """Times, inputs, and the signals whose noise is known."""
    if isinstance(recording, Trajectory):
        time, columns = recording.time, dict(recording.values)
    else:
        rows = read_recording(Path(recording), face)
        time, columns = rows.time, {**rows.inputs, **rows.measurements}
    if not noise:
        raise InputError(
            "no signal is measured: state the noise of each measured signal, such as p: 0.5 kPa"
        )
    inputs = {name: np.asarray(v) for name, v in columns.items() if name in face.inputs}
    readings = {name: np.asarray(v) for name, v in columns.items() if name not in inputs}
    for name in noise:
        if name in inputs:
            raise InputError(f"'{name}' is an input, which is taken as recorded: it has no noise")
        if name not in readings:
            raise InputError(
                f"the recording has no column '{name}'; {did_you_mean(name, readings)}"
            )
        if not np.any(np.isfinite(readings[name])):
            raise InputError(f"the recording has no sample of '{name}'")
    return time, inputs, {name: readings[name] for name in noise}


def _check_noise(noise: Mapping[str, float], read: Mapping[str, Array], face: Interface) -> None:
    """Noise below the last digit of a sample is none; the filter would divide by nothing."""
    for name, deviation in noise.items():
        largest = float(np.nanmax(np.abs(read[name])))
        if deviation < max(np.finfo(float).eps * largest, _NOTHING):
            unit = (face.outputs | face.locals)[name].unit
            raise InputError(
                f"{name}: a standard deviation of {deviation:g} {unit} is below the last digit of its samples"
            )


def _deviations(
    values: Mapping[str, Setting], face: Interface, states: Sequence[str] | None = None
) -> dict[str, float]:
    for name in values:
        if states is not None and name not in states:
            raise InputError(f"{face.model} has no state '{name}'; {did_you_mean(name, states)}")
    return {name: _deviation(name, value, face) for name, value in values.items()}


def _deviation(name: str, value: Setting, face: Interface) -> float:
    """A standard deviation [SI], above zero.

    Raises:
        InputError: an unknown name, or no such number.
    """
    groups = face.inputs | face.outputs | face.locals
    if name not in groups:
        raise InputError(f"{face.model} has no variable '{name}'; {did_you_mean(name, groups)}")
    return size_of(f"{name}: a standard deviation", value, groups[name])
