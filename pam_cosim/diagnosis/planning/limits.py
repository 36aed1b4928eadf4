"""The limits within which a rig can be driven."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.references import BRANCH
from pam_cosim.wording import did_you_mean

_STILL = 0.02  # of its largest value, within which an input that is held may vary
_WHITE = 1.5  # standard deviations of its noise, within which an input is nothing but noise

Range = tuple[float, float]


@dataclass(frozen=True)
class Limits:
    """Limits of a run, SI units.

    Attributes:
        inputs: lowest and highest value of each input.
        constant: inputs that keep one value through a run, such as a supply at a fixed pressure.
        rates: the steepest slope of each input [its unit per second]; infinite: it can step.
        start: value of each input when a run begins, from which an input with a finite rate departs.
        parameters: ranges of parameters that are set before a run, such as a load.
        outputs: ranges that the predicted signals must keep.
        seconds: length of a run.
        interval: time between two samples [s].
    """

    inputs: Mapping[str, Range]
    constant: frozenset[str]
    rates: Mapping[str, float]
    start: Mapping[str, float]
    parameters: Mapping[str, Range]
    outputs: Mapping[str, Range]
    seconds: float
    interval: float

    @property
    def moving(self) -> tuple[str, ...]:
        """The inputs that move within a run, in their order."""
        return tuple(name for name in self.inputs if name not in self.constant)

    @property
    def is_fixed(self) -> bool:
        """Whether every range is a single value."""
        return all(low == high for low, high in (*self.inputs.values(), *self.parameters.values()))


def limits_of(
    data: DataSet,
    stated: Mapping[str, Range] | None = None,
    seconds: float | None = None,
    held: Collection[str] = (),
) -> Limits:
    """The limits of the recordings, but for those that are stated.

    An input has the steepest slope that was recorded. An input that was constant in every run, but for its noise, stays
    constant, unless limits are stated for it: then it moves within them, and can step. A parameter that differs between
    runs can be set.

    Args:
        data: the measurement; not of points at rest.
        stated: lowest and highest value [SI] of inputs, of known parameters, and of fitted signals, by name.
        seconds: length of a run; None: as long as the recordings are, in the median.
        held: inputs that keep one value through a run, within their limits.

    Raises:
        InputError: an unknown name; a range that begins above its end; points at rest; no positive length.
    """
    runs = [run for run in data.runs if not run.is_static]
    if not runs:
        raise InputError("a static table has no trajectory over time to plan", data.folder)
    length = _usual_length(runs) if seconds is None else seconds
    if not length > 0:
        raise InputError("the duration of a run must be above 0 s")
    inputs, parameters, outputs = _ranges(data, runs, stated or {})
    constant = _constant_inputs(runs, inputs, stated or {}, held)
    inputs |= {n: _levels(runs, n) for n in constant if n not in (stated or {})}
    interval = float(np.median(np.concatenate([_steps(run) for run in runs])))
    return Limits(
        inputs,
        constant,
        {name: _rate(runs, name, span, interval) for name, span in inputs.items()},
        {name: float(runs[0].inputs[name][0]) for name in inputs},
        parameters,
        outputs,
        length,
        min(interval, length),
    )


def _ranges(
    data: DataSet, runs: Sequence[Run], stated: Mapping[str, Range]
) -> tuple[dict[str, Range], dict[str, Range], dict[str, Range]]:
    """Ranges of inputs, of parameters and of signals: as recorded, and as stated."""
    first = runs[0]
    inputs = {name: _span(runs, name) for name in first.inputs if name != BRANCH}
    parameters = _varied_parameters(runs)
    outputs: dict[str, Range] = {}
    parameter_names = sorted(name for name in first.parameters if name not in data.free_names)
    # a name of several is that of an input first, then of a parameter
    owners = dict.fromkeys(inputs, inputs)
    for names, ranges in ((parameter_names, parameters), (data.fitted_signals, outputs)):
        owners |= {name: ranges for name in names if name not in owners}
    for name, limits in stated.items():
        _check_limits(name, limits, list(owners))
        owners[name][name] = limits
    return inputs, parameters, outputs


def _constant_inputs(
    runs: Sequence[Run],
    inputs: Collection[str],
    stated: Mapping[str, Range],
    held: Collection[str],
) -> frozenset[str]:
    """Inputs that keep one value through a run: they are to, or always did and no limits let them move."""
    for name in held:
        if name not in inputs:
            raise InputError(
                f"there is no input '{name}' to hold; {did_you_mean(name, list(inputs))}"
            )
    free = {name for name, (low, high) in stated.items() if low < high}
    still = {name for name in inputs if name not in free and _is_constant(runs, name)}
    return frozenset({*held, *still})


def _check_limits(name: str, limits: Range, names: Sequence[str]) -> None:
    low, high = limits
    if not low <= high:
        raise InputError(f"the limits of '{name}' begin above their end")
    if name not in names:
        raise InputError(
            f"there is no input, parameter or signal '{name}' to limit; {did_you_mean(name, list(names))}"
        )


def _usual_length(runs: Sequence[Run]) -> float:
    """The median length of the runs [s]."""
    return float(np.median([run.time[-1] - run.time[0] for run in runs]))


def _varied_parameters(runs: Sequence[Run]) -> dict[str, Range]:
    """The range of each parameter that differs between runs."""
    ranges = {name: _set(runs, name) for name in runs[0].parameters}
    return {name: (low, high) for name, (low, high) in ranges.items() if low != high}


def _is_constant(runs: Sequence[Run], name: str) -> bool:
    """Whether an input keeps one value through every run, but for the noise of its reading."""
    return all(_is_still(run.inputs[name]) for run in runs if name in run.inputs)


def _is_still(values: Array) -> bool:
    """Whether readings are of one value: they differ little, or as neighbours do."""
    if np.ptp(values) <= _STILL * np.abs(values).max(initial=0.0):
        return True
    noise = np.sqrt(np.mean(np.diff(values) ** 2) / 2) if len(values) > 2 else 0.0
    return bool(np.std(values) <= _WHITE * noise and len(np.unique(values)) > len(values) / 2)


def _levels(runs: Sequence[Run], name: str) -> Range:
    """The lowest and the highest mean of an input in a run; one value where they are as alike as its readings."""
    means = np.array([run.inputs[name].mean() for run in runs if name in run.inputs])
    if np.ptp(means) <= _STILL * np.abs(means).max():
        means = np.array([float(f"{np.median(means):.3g}")])
    return float(means.min()), float(means.max())


def _span(runs: Sequence[Run], name: str) -> Range:
    values = [run.inputs[name] for run in runs if name in run.inputs]
    return float(min(v.min() for v in values)), float(max(v.max() for v in values))


def _set(runs: Sequence[Run], name: str) -> Range:
    values = [run.parameters[name] for run in runs if name in run.parameters]
    return min(values), max(values)


def _steps(run: Run) -> np.ndarray:
    steps = np.diff(run.time)
    return np.asarray(steps[steps > 0])


def _rate(runs: Sequence[Run], name: str, span: Range, interval: float) -> float:
    """The steepest slope that was recorded; infinite where a step was, or the whole range within a sample."""
    steepest = 0.0
    for run in runs:
        if name not in run.inputs:
            continue
        change, step = np.abs(np.diff(run.inputs[name])), np.diff(run.time)
        if run.interpolation == "previous" and change.any():
            return np.inf
        if np.any(change[step == 0] > 0):
            return np.inf
        steepest = max(steepest, float((change[step > 0] / step[step > 0]).max(initial=0.0)))
    return steepest if 0 < steepest * interval < span[1] - span[0] else np.inf
