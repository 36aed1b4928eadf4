"""Doubts about the data, or about the stated rig, before any effect is searched for.

A wrong unit, a zero, a sign, a column of another run: each leaves a large error that no physics explains, and that
physics bends to explain all the same.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from pam_cosim.arrays import Array
from pam_cosim.comparison.conventions import has_usual_units, mistake_in_reading
from pam_cosim.comparison.residuals import RunComparison, warnings_of
from pam_cosim.measurement import Run, Signal
from pam_cosim.measurement.markers import FEWEST_SAMPLES, input_marker_of, marker_of
from pam_cosim.units import format_quantity
from pam_cosim.units.grammar import STANDARD_ATMOSPHERE
from pam_cosim.wording import listed

_LARGE_ERROR = 0.5  # of what a signal moves: rms error of a model that explains little
_STUCK = 0.25  # of the samples of a run, that one number is repeated in at least by a sensor that is stuck
_NOISE_LIMIT = 5.0  # sd of the noise, that a doubtful error exceeds
_QUIET = 0.1  # sd of the noise, within which samples never lie
# of a signal's span, beyond zero or a limit of the model, that counts as passed
BEYOND_LIMIT = 0.03
_OPPOSITE_CHANGE = 0.02  # of a signal's span, by which runs differ in the data and in the model
_SAME_INPUTS = 0.02  # of the spans of the inputs, between samples at the same inputs
_MOST_SAMPLES = 2000  # of a run that are compared with another

_LEAST = {"Pa": (-STANDARD_ATMOSPHERE, "a vacuum, gauge"), "K": (0.0, "absolute zero")}
"""What no reading of an instrument is below, by its unit."""


@dataclass(frozen=True)
class Doubt:
    """One thing that a person should look at first.

    Attributes:
        kind: "warning": the model itself warns; "undriven": an input has the model's default; "convention": what was
            recorded fits much better if it is meant otherwise; "copy": two runs have the same samples; "marker": a
            value that is no reading, as for missing samples; "unusual": outside what is usual in the field; "still": a
            signal never moves, where the model does; "stuck": for a part of a run; "too_quiet": the samples differ by
            less than their noise; "impossible": no such reading exists; "far_off": the model explains little of it;
            "one_sided": the measurement never passes zero where the model does; "contradiction": runs differ the other
            way than in the model.
        signal: which it is seen in; "": none.
        text: a sentence.
    """

    kind: str
    signal: str
    text: str


def doubts(
    runs: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    units: Mapping[str, str],
    fitted: bool = True,
    convention: str = "",
    ranges: Sequence[tuple[str, str, str]] = (),
) -> tuple[Doubt, ...]:
    """What a person should look at before effects are added.

    Args:
        runs: every run, simulated.
        signals: what was measured.
        units: SI units of the parameters and inputs of the runs, by name.
        fitted: whether free parameters have had their chance; if not, a large error is doubted only where a simple
            mistake explains it.
        convention: what fits much better, in words.
        ranges: what is usual, as ``Domain`` has it.
    """
    found_doubts: list[Doubt] = []
    for name, signal in signals.items():
        measured, modelled = _samples(runs, name)
        if len(measured):
            found_doubts += [
                *_markers(runs, signal, measured),
                *_still(signal, measured, modelled),
                *_stuck(runs, signal),
                *_too_quiet(signal, measured),
                *_impossible(runs, signal, measured, modelled),
                *_far_off(signal, measured, modelled, fitted, lambda: _reach(runs, units)),
                *_one_sided(signal, measured, modelled),
            ]
            found_doubts += _contradictions(runs, signal, float(np.ptp(measured)), units)
    warnings = (Doubt("warning", "", text) for text in warnings_of(runs))
    convention_doubts = [Doubt("convention", "", convention)] if convention else []
    return (
        *warnings,
        *_undriven(runs),
        *convention_doubts,
        *_copies(runs),
        *_unusual(
            runs, {**units, **{n: s.unit for n, s in signals.items()}, "duration": "s"}, ranges
        ),
        *_markers_of_inputs(runs, units),
        *found_doubts,
    )


def _undriven(runs: Sequence[RunComparison]) -> Iterator[Doubt]:
    """Inputs that nothing drives: neither a column nor a stated value."""
    by_inputs: dict[tuple[str, ...], list[str]] = {}
    for r in runs:
        by_inputs.setdefault(r.run.default_inputs, []).append(r.run.name)
    for names, run_names in by_inputs.items():
        if names:
            verb, pronoun = ("is", "it") if len(names) == 1 else ("are", "them")
            yield Doubt(
                "undriven",
                "",
                f"{listed(run_names)}: {listed(names)} {verb} neither a column nor stated, and the model's default "
                f"is used; record {pronoun}, or state a value under [parameters]",
            )


def _copies(runs: Sequence[RunComparison]) -> Iterator[Doubt]:
    """Runs of the same samples, noise and all: one file under two names checks nothing and counts twice."""
    first_runs: dict[tuple[str, bytes], str] = {}
    for r in runs:
        for name, values in r.run.measurements.items():
            samples = values[np.isfinite(values)]
            if len(samples) < FEWEST_SAMPLES or not np.ptp(samples):
                continue
            earlier_run = first_runs.setdefault((name, samples.tobytes()), r.run.name)
            if earlier_run != r.run.name:
                yield Doubt(
                    "copy",
                    name,
                    f"{earlier_run} and {r.run.name} have the same samples of {name}, noise and all: "
                    "is one a copy of the other?",
                )
                break


def _unusual(
    runs: Sequence[RunComparison], units: Mapping[str, str], ranges: Sequence[tuple[str, str, str]]
) -> Iterator[Doubt]:
    """Inputs, signals and durations that leave in every run what is usual in the field."""
    limits = {unit: (float(low), float(high)) for unit, low, high in ranges}
    farthest: dict[str, list[tuple[float, str]]] = {}
    for run in (r.run for r in runs if not r.run.is_static):
        duration = np.array([np.ptp(run.time)])
        for name, values in {"duration": duration, **run.inputs, **run.measurements}.items():
            finite_values = values[np.isfinite(values)]
            if len(finite_values) and units.get(name) in limits:
                low, high = limits[units[name]]
                far = finite_values[
                    np.argmax(np.maximum(low - finite_values, finite_values - high))
                ]
                farthest.setdefault(name, []).append((float(far), run.name))
    for name, ends in farthest.items():
        low, high = limits[units[name]]
        if not any(low <= end <= high for end, _ in ends):
            end, run_name = ends[0]
            number, least, most = (format_quantity(v, units[name]) for v in (end, low, high))
            yield Doubt(
                "unusual",
                name if name != "duration" else "",
                f"{name}: {number} in {run_name}, and outside {least} to {most} in every run, which is usual: "
                "is it the unit, the zero, or the column?",
            )


def _samples(runs: Sequence[RunComparison], name: str) -> tuple[Array, Array]:
    """All samples of a signal, and the model's values at them."""
    pairs = [(r.run.measurements[name], r.model[name]) for r in runs if r.run.sample_count(name)]
    is_measured = [np.isfinite(measured) for measured, _ in pairs]
    columns = [
        np.concatenate([p[i][k] for p, k in zip(pairs, is_measured, strict=True)] or [np.zeros(0)])
        for i in (0, 1)
    ]
    return columns[0], columns[1]


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _markers_of_inputs(runs: Sequence[RunComparison], units: Mapping[str, str]) -> Iterator[Doubt]:
    driven = [r.run for r in runs if not r.run.is_static]
    for name in dict.fromkeys(name for run in driven for name in run.inputs):
        values_by_run = [(run, run.inputs[name]) for run in driven if name in run.inputs]
        value = input_marker_of(np.concatenate([values for _, values in values_by_run]))
        if value is not None:
            yield _marker(name, units.get(name, ""), value, values_by_run)


def _markers(runs: Sequence[RunComparison], signal: Signal, measured: Array) -> Iterator[Doubt]:
    value = marker_of(measured)
    if value is not None:
        read = [r.run for r in runs if r.run.sample_count(signal.name)]
        values_by_run = [(run, run.measurements[signal.name]) for run in read]
        yield _marker(signal.name, signal.unit, value, values_by_run)


def _marker(
    name: str, unit: str, value: float, values_by_run: Sequence[tuple[Run, Array]]
) -> Doubt:
    """One value farther from all others than these are apart, as loggers write where there is no reading."""
    all_values = np.concatenate([values[np.isfinite(values)] for _, values in values_by_run])
    other_values = all_values[all_values != value]
    run, values = next((run, values) for run, values in values_by_run if value in values)
    place = place_in(run, int(np.argmax(values == value)))
    count = len(all_values) - len(other_values)
    marker_text, low, high = (
        format_quantity(float(v), unit) for v in (value, other_values.min(), other_values.max())
    )
    return Doubt(
        "marker",
        name,
        f"{name}: {count} of {len(all_values)} samples {_is(count)} {marker_text}, first {place}; "
        f"all others lie between {low} and {high}. Where that number marks "
        'a missing sample, write it as the file has it, as in missing = ["-999"] under [recording]',
    )


def _still(signal: Signal, measured: Array, modelled: Array) -> Iterator[Doubt]:
    """A signal that is one number in every sample, as of a sensor that is not connected, where the model moves."""
    moves = float(np.ptp(modelled))
    if len(measured) < FEWEST_SAMPLES or np.ptp(measured) or moves < signal.sigma:
        return
    value, span = (
        format_quantity(float(measured[0]), signal.unit),
        format_quantity(moves, signal.unit),
    )
    yield Doubt(
        "still",
        signal.name,
        f"{signal.name}: every sample is {value}, where the model moves by {span}: the sensor is not connected, or "
        "it is another column; leave it out, or fits follow it alone, for it shows no noise",
    )


def _stuck(runs: Sequence[RunComparison], signal: Signal) -> Iterator[Doubt]:
    """A signal that repeats one number for much of a run, and shows noise before or after it, where the model moves."""
    for r in runs:
        is_measured, _, measured = (
            r.at_samples(signal.name) if r.run.sample_count(signal.name) else ((), (), ())
        )
        if len(measured) < FEWEST_SAMPLES or r.run.is_static:
            continue
        changes = np.flatnonzero(np.diff(measured) != 0.0)
        edges = np.concatenate([[-1], changes, [len(measured) - 1]])
        longest = int(np.argmax(np.diff(edges)))
        first, last = int(edges[longest]) + 1, int(edges[longest + 1])
        moves = float(np.ptp(r.model[signal.name][is_measured][first : last + 1]))
        stays = last - first + 1 > _STUCK * len(measured) and moves > _NOISE_LIMIT * signal.sigma
        if stays and 2 * len(changes) > len(measured) - (last - first + 1):
            times = r.run.time[is_measured]
            yield Doubt(
                "stuck",
                signal.name,
                f"{signal.name}: {format_quantity(float(measured[first]), signal.unit)} in every sample from "
                f"{times[first]:.4g} to {times[last]:.4g} s of {r.run.name}, where the model moves by "
                f"{format_quantity(moves, signal.unit)}: is the sensor stuck? Leave it out, by from or to of the run",
            )


def _too_quiet(signal: Signal, measured: Array) -> Iterator[Doubt]:
    """Samples that differ by far less than their noise: their unit is another one, or the noise level is."""
    span = float(np.ptp(measured))
    if len(measured) >= FEWEST_SAMPLES and 0 < span < _QUIET * signal.sigma:
        moves, noise = (format_quantity(v, signal.unit) for v in (span, signal.sigma))
        text = f"{signal.name}: all samples lie within {moves}, but their noise is {noise}: a wrong unit?"
        yield Doubt("too_quiet", signal.name, text)


def _impossible(
    runs: Sequence[RunComparison], signal: Signal, measured: Array, modelled: Array
) -> Iterator[Doubt]:
    """Readings below a vacuum or absolute zero; where the model has them too, it is of a difference."""
    least, name = _LEAST.get(signal.unit, (-math.inf, ""))
    below = least - _NOISE_LIMIT * signal.sigma
    count = int(np.sum(measured < below))
    if not count or modelled.min() < least:
        return
    lowest, limit = (format_quantity(float(v), signal.unit) for v in (measured.min(), least))
    yield Doubt(
        "impossible",
        signal.name,
        f"{signal.name}: {count} of {len(measured)} samples {_is(count)} below {limit}, {name}, down to {lowest}, "
        f"first {_first_below(runs, signal.name, below)}: check the sign, the unit and the zero",
    )


def _first_below(runs: Sequence[RunComparison], signal: str, limit: float) -> str:
    """Where a signal is first below a limit, in words; it is somewhere."""
    measured = [r.run for r in runs if r.run.sample_count(signal)]
    run = next(r for r in measured if np.any(r.measurements[signal] < limit))
    return place_in(run, int(np.argmax(run.measurements[signal] < limit)))


def place_in(run: Run, row: int) -> str:
    """A row of a run, in words."""
    if run.is_static:
        return f"at point {row + 1} of {run.name}"
    return f"at {run.time[row]:.6g} s of {run.name}"


def _is(count: int) -> str:
    return "is" if count == 1 else "are"


def _far_off(
    signal: Signal,
    measured: Array,
    modelled: Array,
    fitted: bool,
    inputs: Callable[[], str],
) -> Iterator[Doubt]:
    """A model that misses a signal by much of what it moves, and what would mend it at once."""
    error, moves = _rms(measured - modelled), _rms(measured - measured.mean())
    if not np.ptp(measured) or error < _LARGE_ERROR * moves or error < _NOISE_LIMIT * signal.sigma:
        return
    span = format_quantity(float(np.ptp(measured)), signal.unit)
    text = (
        f"{signal.name}: the model explains little; it is off by {format_quantity(error, signal.unit)} where the whole "
        f"measurement spans {span}. "
    )
    mended = mistake_in_reading(signal, measured, modelled, inputs)
    usual = (
        "Before you look for a missing effect, check the unit, the zero and the column, "
        "and the stated size, load and type"
    )
    if mended or fitted:
        yield Doubt("far_off", signal.name, text + (mended or usual))


def _reach(runs: Sequence[RunComparison], units: Mapping[str, str]) -> str:
    """How far the recorded inputs go, as a wrong unit of one is seen by; "" without such an input."""
    names = dict.fromkeys(
        name for r in runs for name in r.run.inputs if has_usual_units(units.get(name, ""))
    )
    values_by_input = {
        n: np.concatenate([r.run.inputs[n] for r in runs if n in r.run.inputs]) for n in names
    }
    ends = {n: float(values[np.argmax(np.abs(values))]) for n, values in values_by_input.items()}
    words = listed(f"{n} goes to {format_quantity(end, units[n], 6)}" for n, end in ends.items())
    return f", or of an input: {words}" if ends else ""


def _one_sided(signal: Signal, measured: Array, modelled: Array) -> Iterator[Doubt]:
    """A measurement that never passes zero, where the model does by far."""
    room = max(
        BEYOND_LIMIT * float(np.ptp(measured)),
        _NOISE_LIMIT * signal.sigma,
    )
    for sign, least, beyond in ((1.0, "falls below", "down to"), (-1.0, "rises above", "up to")):
        signed, model = sign * measured, sign * modelled
        is_below = model < -room
        if (
            signed.min() < -room
            or not is_below.any()
            or np.ptp(measured) == 0
            or signed.max() <= room
        ):
            continue
        share = 100 * float(is_below.mean())
        most = format_quantity(float(sign * model.min()), signal.unit)
        yield Doubt(
            "one_sided",
            signal.name,
            f"{signal.name}: the measurement never {least} zero, where the model goes {beyond} {most} "
            f"({share:.0f} % of the samples): the rig cannot act in that direction, or the sensor does not measure it",
        )


def _contradictions(
    runs: Sequence[RunComparison], signal: Signal, span: float, units: Mapping[str, str]
) -> Iterator[Doubt]:
    """Pairs of runs whose one difference acts the other way than in the model."""
    name, least = signal.name, _OPPOSITE_CHANGE * span
    measured = [r for r in runs if r.run.sample_count(name)]
    for a, b in itertools.combinations(measured, 2):
        parameter = _only_difference(a, b)
        if parameter is None:
            continue
        at = _alike(a, b, name)
        if at is None:
            continue
        i, j = at
        measured_change = float(
            np.nanmedian(b.run.measurements[name][j] - a.run.measurements[name][i])
        )
        expected = float(np.median(b.model[name][j] - a.model[name][i]))
        if measured_change * expected < 0 and min(abs(measured_change), abs(expected)) > least:
            unit = units.get(parameter, "")
            value_a, value_b = (format_quantity(r.run.parameters[parameter], unit) for r in (a, b))
            real, modelled = (format_quantity(v, signal.unit) for v in (measured_change, expected))
            yield Doubt(
                "contradiction",
                name,
                f"{a.run.name} and {b.run.name} differ in {parameter} alone ({value_a} and {value_b}); "
                f"at the same inputs {name} differs by {real}, in the model by {modelled}: "
                "are the files or the values exchanged?",
            )


def _only_difference(a: RunComparison, b: RunComparison) -> str | None:
    """The one parameter in which two runs differ."""
    values_a, values_b = a.run.parameters, b.run.parameters
    if set(values_a) != set(values_b) or set(a.run.inputs) != set(b.run.inputs) or not a.run.inputs:
        return None
    different = [name for name in values_a if values_a[name] != values_b[name]]
    return different[0] if len(different) == 1 else None


def _alike(
    a: RunComparison, b: RunComparison, signal: str
) -> tuple[NDArray[np.int_], NDArray[np.int_]] | None:
    """Samples of two runs at nearly the same inputs; None: too few, or the inputs do not determine the model's values.

    Inputs say what it does where samples of one run at nearly the same inputs are nearly the same in the model.
    """
    values_by_input = {
        name: np.concatenate([v, b.run.inputs[name]]) for name, v in a.run.inputs.items()
    }
    span = {name: max(float(np.ptp(v)), 1e-300) for name, v in values_by_input.items()}
    samples, places = [], []
    if min(len(a.run.time), len(b.run.time)) < FEWEST_SAMPLES:
        return None
    for r in (a, b):
        at = np.arange(0, len(r.run.time), math.ceil(len(r.run.time) / _MOST_SAMPLES))
        positions = _places(r, span)[at]
        distance, other = KDTree(positions).query(positions, k=2)
        model = r.model[signal][at]
        apart = np.abs(model - model[other[:, 1]])[distance[:, 1] < _SAME_INPUTS]
        if len(apart) < FEWEST_SAMPLES or _rms(apart) > _SAME_INPUTS * float(np.ptp(model)):
            return None
        samples.append(at)
        places.append(positions)
    distance, other = KDTree(places[1]).query(places[0])
    pairs = np.flatnonzero(
        (distance < _SAME_INPUTS) & np.isfinite(a.run.measurements[signal][samples[0]])
    )
    return (samples[0][pairs], samples[1][other[pairs]]) if len(pairs) >= FEWEST_SAMPLES else None


def _places(r: RunComparison, span: Mapping[str, float]) -> Array:
    """(n, 2 inputs) where each sample lies: inputs over their span, and whether they rise or fall."""
    columns = []
    for name, values in r.run.inputs.items():
        columns += [values / span[name], np.sign(np.gradient(values))]
    return np.column_stack(columns)
