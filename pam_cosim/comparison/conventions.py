"""Conventions of a logger as hypotheses: commands that are held, come late, count the other way or in another unit.

Each is a change of what was recorded or of what the model shows, without a free parameter. They are compared by the
likelihood of the residuals, of which neighbouring ones are alike where an effect is missing: what a model lacks over
seconds does not hide what a convention does from one sample to the next.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, Run, Signal
from pam_cosim.simulation.inputs import Interpolation
from pam_cosim.units import convert, format_quantity
from pam_cosim.units.grammar import ATMOSPHERES, STANDARD_ATMOSPHERE

_MOST_RUNS = 3  # of which conventions are tried
_LATEST = (
    8.0  # samples by which commands may be late, before it is no convention but a lag of the rig
)
_PRICE_OF_DELAY = 3.0  # log-likelihood that commands on time are ahead of late ones
_GAIN = 8.0  # log-likelihood that another convention is ahead by, so that it is named
_REMAINING = 0.9  # of chi-square far above the noise: a mistaken convention leaves less
_NEAR_NOISE = (
    1.3  # chi-square with late readings; where more is left, a lag of the rig may be missing
)
_LARGE_ERROR = 0.5  # of what a signal moves: a model that explains little of it
_REMAINING_ERROR = 0.3  # of an error, that remains at most where a simple mistake explains it
_SAME_FACTOR = 0.02  # of a factor or an offset, by which it may differ from a usual mistake
_LEAST_VARIANCE = 1e-9  # of the noise: residuals of computed numbers
_WORDS = {"previous": "held", "linear": "linear"}
_UNITS = {
    "Pa": ("kPa", "bar", "psi", "MPa", "mbar", "Pa", "hPa", "atm", "mmHg"),
    "m": ("mm", "cm", "m", "inch", "um"),
    "N": ("N", "kN", "kgf", "lbf", "mN"),
    "A": ("mA", "A"),
    "rad": ("rad", "deg"),
}
"""Units that loggers write, the usual ones first, by the base unit of what is measured."""
_ZEROS = {
    "Pa": (STANDARD_ATMOSPHERE, "absolute and gauge pressure mixed up"),
    "K": (273.15, "degrees Celsius and kelvin mixed up"),
}

_SIZES = (
    0.125,
    8.0,
)  # by which the motion of an uncalibrated model may be too large or too small
_PRICE_OF_SIZE = 0.05  # share of the variance, that the largest of these sizes costs
_MOST_UNEXPLAINED = (
    2.0  # share of a signal's variance, beyond which it is all the same how far a model is off
)
_NEGLIGIBLE = 0.02  # share of the variance that noise and small effects may leave
_EXPLAINED = 0.4  # of the share that the recording as it is read leaves: a convention leaves less

Evaluate = Callable[[DataSet], Sequence[RunComparison]]
"""Simulates the runs of a data set."""


@dataclass(frozen=True)
class Convention:
    """Another way in which a recording may be meant, that fits much better.

    Attributes:
        name: "held", "linear", "late", "sign", "factor", "absolute", "time" or "swapped".
        text: what fits better, by which figures, and what to write.
        data: the data set with what was recorded as the convention has it.
        chi2: mean square of the residuals in standard deviations with it, of the runs that were tried; ``before``.
    """

    name: str
    text: str
    data: DataSet
    chi2: float
    before: float


def likely_convention(
    data: DataSet,
    units: Mapping[str, str],
    simulate: Evaluate,
    base: Sequence[RunComparison] = (),
    fitted: Evaluate | None = None,
) -> Convention | None:
    """The convention that fits the data much better than the one that they are read with; None: there is none.

    Args:
        data: the measurement. An interpolation that it states is never doubted.
        units: SI units of the inputs, by name.
        simulate: simulates runs with values that are known.
        base: the runs as they are read, simulated already.
        fitted: likewise with free parameters fitted again, where those of ``simulate`` are fitted to the data as they
            are read; a convention that is mistaken has moved these.

    Raises:
        SimulationFailure: the runs as they are read cannot be simulated.
    """
    driven = [run for run in data.runs if run.inputs and not run.is_static and run.role == "fit"]
    open_runs = [run for run in driven if not run.interpolation_stated]
    tried = replace(data, runs=tuple((open_runs or driven)[:_MOST_RUNS]))
    signals = data.fitted_signals
    if not driven or not signals:
        return None
    names = {run.name for run in tried.runs}
    runs = [comparison for comparison in base if comparison.run.name in names] or list(
        simulate(tried)
    )
    if _explains_little(runs, signals):
        return _of_inputs(data, tried, runs, signals, units, simulate)
    return _in_time(data, tried, signals, simulate, fitted)


def _chi2(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> float:
    """Mean square of all residuals in standard deviations of the noise."""
    per_signal = [_scaled(r, signals[n]) for n in signals for r in runs if n in r.run.measurements]
    residuals = np.concatenate(per_signal or [np.zeros(1)])
    return float(np.nanmean(residuals**2))


def _scaled(run: RunComparison, signal: Signal) -> Array:
    """(n,) residuals of a signal in standard deviations."""
    return run.residual(signal.name) / (signal.sigma or 1.0)


def _explains_little(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> bool:
    """Whether a model misses some signal by much of what that moves."""
    for name in signals:
        read = [r.at_samples(name) for r in runs if r.run.sample_count(name)]
        variance = sum(len(measured) * float(np.var(measured)) for _, _, measured in read)
        if sum(float(error @ error) for _, error, _ in read) > _LARGE_ERROR**2 * variance:
            return True
    return False


def _unexplained(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> float:
    """The share of the variance of the readings that the model leaves, of whatever size its motion is.

    The valves may be uncalibrated: the motion of the model is scaled for the best fit within ``_SIZES``.
    """
    shares = [0.0]
    for name in signals:
        variance, products = 0.0, np.zeros((2, 2))  # of readings and motion
        for r in (r for r in runs if r.run.sample_count(name)):
            kept, _, measured = r.at_samples(name)
            motions = np.array([measured, r.model[name][kept]]) - r.model[name][kept][0]
            products += motions @ motions.T
            variance += len(measured) * float(np.var(measured))
        if variance:
            size = np.clip(products[0, 1] / (products[1, 1] or 1.0), *_SIZES)
            distance = (math.log(size) / math.log(_SIZES[1])) ** 2
            scales = np.array([1.0, -size])
            residual = scales @ products @ scales
            shares.append(min(residual / variance + _PRICE_OF_SIZE * distance, _MOST_UNEXPLAINED))
    return sum(shares) / max(len(shares) - 1, 1)


def _rms(values: Array) -> float:
    return float(np.sqrt(np.nanmean(values**2)))


# ---- between samples: held or linear, on time or late ----------------------------------------------------------------


def _in_time(
    data: DataSet,
    tried: DataSet,
    signals: Mapping[str, Signal],
    simulate: Evaluate,
    fitted: Evaluate | None,
) -> Convention | None:
    """Held instead of linear commands or the other way, and readings that come half a sample or one late.

    A lag that is missing in the model is better with the commands that come later: what counts is how much better the
    others are with any delay that either may have. Where a lag of many samples is best, none is a convention.
    """
    read = simulate(_refined(tried))
    scores = _by_delay(read, signals)
    (before, chi2_before), (own_best, own_late) = scores[0.0], _best(scores)
    stated = any(run.interpolation_stated for run in tried.runs)
    other = {} if stated else _of_other(tried, read, signals, simulate, fitted)
    if other:
        (after, chi2), (best, late) = other[0.0], _best(other)
        explains_all = chi2 < _NEAR_NOISE and not late and after >= own_best
        ahead = after - before if explains_all else min(after - before, best - own_best)
        excess, excess_before = chi2 - 1.0, chi2_before - 1.0
        is_less = chi2 < _REMAINING * chi2_before or (explains_all and 2.0 * excess < excess_before)
        if ahead > _GAIN and is_less:
            old_mode, new_mode = tried.runs[0].interpolation, _other(tried)
            text = (
                f"{_WORDS[new_mode]} commands fit the data much better than {_WORDS[old_mode]} ones: chi-square "
                f'{chi2:.3g} against {chi2_before:.3g}; write interpolation = "{new_mode}" in each [[runs]]'
            )
            return Convention(_WORDS[new_mode], text, _between(data, new_mode), chi2, chi2_before)
    after, chi2 = scores[own_late]
    is_usual = own_late in (0.5, 1.0)
    if not is_usual or own_best - before < _GAIN or chi2 >= min(_NEAR_NOISE, chi2_before):
        return None
    how = "half a sample" if own_late == 0.5 else "one sample"
    text = (
        f"the readings fit much better {how} later than the commands: chi-square {chi2:.3g} against "
        f"{chi2_before:.3g}; name the file again with the readings alone under [[runs.loggers]], "
        f'offset = "{-1e3 * own_late * _step(tried.runs[0]):.4g} ms"'
    )
    earlier = replace(data, runs=tuple(_advanced(run, own_late) for run in _refined(data).runs))
    return Convention("late", text, earlier, chi2, chi2_before)


_Scores = dict[float, tuple[float, float]]
"""Log-likelihood less its price, and mean square of the residuals, by how many samples late the commands are."""


def _by_delay(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> _Scores:
    scores: _Scores = {}
    for late in np.arange(0.0, _LATEST + 0.25, 0.5).tolist():
        moved = [_delayed(run, late) for run in runs]
        price = _PRICE_OF_DELAY * (late > 0.0)
        scores[late] = _likelihood(moved, signals) - price, _chi2(moved, signals)
    return scores


def _of_other(
    tried: DataSet,
    read: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    simulate: Evaluate,
    fitted: Evaluate | None,
) -> _Scores:
    """The scores of the other interpolation; none where the two differ too little in the model."""
    changed = _refined(_between(tried, _other(tried)))
    try:
        runs = simulate(changed)
        apart = [(new.model[n] - r.model[n]) / (signals[n].sigma or 1.0)
                 for new, r in zip(runs, read, strict=True) for n in signals if n in r.run.measurements]  # fmt: skip
        if sum(float(np.nansum(difference**2)) for difference in apart) < 2.0 * _GAIN:
            return {}
        return _by_delay(runs if fitted is None else fitted(changed), signals)
    except SimulationFailure:
        return {}


def _other(data: DataSet) -> Interpolation:
    return "linear" if data.runs[0].interpolation == "previous" else "previous"


def _best(scores: _Scores) -> tuple[float, float]:
    """The largest log-likelihood, and the delay that has it."""
    late = max(scores, key=lambda one: scores[one][0])
    return scores[late][0], late


def _between(data: DataSet, interpolation: Interpolation) -> DataSet:
    return replace(
        data,
        runs=tuple(
            run if run.interpolation_stated else replace(run, interpolation=interpolation)
            for run in data.runs
        ),
    )


def _step(run: Run) -> float:
    """The usual time from sample to sample [s]."""
    steps = np.diff(run.time)
    return float(np.median(steps[steps > 0.0])) if (steps > 0.0).any() else 0.0


def _refined(data: DataSet) -> DataSet:
    """The data set with a row between any two, of the same inputs and without a reading."""
    return replace(
        data, runs=tuple(run if run.is_static else _with_middles(run) for run in data.runs)
    )


def _with_middles(run: Run) -> Run:
    rows = np.flatnonzero(np.diff(run.time) > 0.0)
    time = np.insert(run.time, rows + 1, 0.5 * (run.time[rows] + run.time[rows + 1]))
    held = run.interpolation == "previous"
    inputs = {
        n: np.insert(v, rows + 1, v[rows] if held else 0.5 * (v[rows] + v[rows + 1]))
        for n, v in run.inputs.items()
    }
    measurements = {n: np.insert(v, rows + 1, np.nan) for n, v in run.measurements.items()}
    return replace(run, time=time, inputs=inputs, measurements=measurements)


def _delayed(run: RunComparison, samples: float) -> RunComparison:
    """The run at the times of its readings, as the model shows it if its commands come so late."""
    read = ~np.all([np.isnan(v) for v in run.run.measurements.values()], axis=0)
    time = run.run.time[read]
    at = time - 2.0 * samples * _step(run.run)
    model = {n: np.interp(at, run.run.time, values) for n, values in run.model.items()}
    measurements = {
        n: np.where(at < run.run.time[0], np.nan, v[read]) for n, v in run.run.measurements.items()
    }
    return replace(
        run, run=replace(run.run, time=time, inputs={}, measurements=measurements), model=model
    )


def _advanced(run: Run, samples: float) -> Run:
    """A run with middles, of which the readings are so many samples of the recording earlier."""
    rows = round(2.0 * samples)
    if run.is_static or not run.inputs:
        return run
    moved = {n: np.append(v[rows:], np.full(rows, np.nan)) for n, v in run.measurements.items()}
    return replace(run, measurements=moved)


def _likelihood(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> float:
    """Log-likelihood of residuals that are an autoregression of first order, of which scale and memory are free."""
    total = 0.0
    for name, signal in signals.items():
        pairs = [
            (residuals[:-1], residuals[1:])
            for r in runs
            if r.run.sample_count(name)
            for residuals in [_scaled(r, signal)]
        ]
        if not pairs:
            continue
        first, second = (np.concatenate([pair[k] for pair in pairs]) for k in (0, 1))
        are_finite = np.isfinite(first) & np.isfinite(second)
        first, second = first[are_finite], second[are_finite]
        power = float(first @ first)
        memory = min(max(float(first @ second) / power, 0.0), 1.0) if power else 0.0
        variance = float(np.mean((second - memory * first) ** 2)) if are_finite.any() else 1.0
        total -= 0.5 * len(first) * math.log(max(variance, _LEAST_VARIANCE))
    return total


# ---- inputs that count otherwise than they are read ------------------------------------------------------------------


def _of_inputs(
    data: DataSet,
    tried: DataSet,
    runs: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    units: Mapping[str, str],
    evaluate: Evaluate,
) -> Convention | None:
    """Of inputs that are swapped, absolute, of another sign or ten times as large, the one that explains an error.

    With it the readings follow the model, up to their size, where they do far less without it; of several such
    conventions it is the one with the smallest misfit.
    """
    chi2_before = _chi2(runs, signals)
    share = _EXPLAINED * (_unexplained(runs, signals) + _NEGLIGIBLE) - _NEGLIGIBLE
    likely: list[Convention] = []
    for name, words, change in _changes(tried.runs[0], units):
        try:
            changed = list(evaluate(_changed(tried, change)))
        except SimulationFailure:
            continue
        if _unexplained(changed, signals) < share:
            chi2 = _chi2(changed, signals)
            text = f"{words}: chi-square {chi2:.3g} against {chi2_before:.3g}; correct it under [columns]"
            likely.append(Convention(name, text, _changed(data, change), chi2, chi2_before))
    return min(likely, key=lambda one: one.chi2, default=None)


_Change = Callable[[Run], Run]


def _changed(data: DataSet, change: _Change) -> DataSet:
    return replace(data, runs=tuple(map(change, data.runs)))


def _changes(run: Run, units: Mapping[str, str]) -> Iterator[tuple[str, str, _Change]]:
    """Each mistake that is made with inputs and times: its name, in words, and what puts it right."""
    for first, second in itertools.combinations(run.inputs, 2):
        if units.get(first) == units.get(second):
            yield (
                "swapped",
                f"the model fits if {first} and {second} are exchanged",
                _exchange(first, second),
            )
    for name, values in run.inputs.items():
        for factor in (0.1, 10.0, 0.001, 1000.0):
            yield (
                "factor",
                f"the model fits if {name} is multiplied by {factor:g}",
                _scaling(name, factor, 0.0),
            )
        if units.get(name) == "Pa":
            words = (
                f"the model fits if one atmosphere is taken off {name}, as off an absolute pressure"
            )
            yield "absolute", words, _scaling(name, 1.0, -STANDARD_ATMOSPHERE)
        if np.ptp(values) > 0.0:
            yield (
                "sign",
                f"the model fits if the sign of {name} is turned",
                _scaling(name, -1.0, 0.0),
            )
    for factor in (0.001, 1000.0):
        words = (
            f"the model fits if the times are multiplied by {factor:g}, as those of another unit"
        )
        yield "time", words, lambda run, factor=factor: replace(run, time=factor * run.time)  # type: ignore[misc]


def _exchange(first: str, second: str) -> _Change:
    swap = {first: second, second: first}
    return lambda run: replace(run, inputs={n: run.inputs[swap.get(n, n)] for n in run.inputs})


def _scaling(name: str, factor: float, offset: float) -> _Change:
    return lambda run: replace(
        run, inputs={n: factor * v + offset if n == name else v for n, v in run.inputs.items()}
    )


# ---- a reading that counts otherwise than it is read -----------------------------------------------------------------


def mistake_in_reading(
    signal: Signal, measured: Array, modelled: Array, inputs: Callable[[], str]
) -> str:
    """The zero, sign or factor that explains most of the error of a reading, in words; "" where none does.

    Args:
        signal: that was measured.
        measured: (n,) its samples.
        modelled: (n,) what the model shows.
        inputs: how far the inputs go, in words.
    """
    enough = _REMAINING_ERROR * _rms(measured - modelled)
    offset = float(np.mean(measured - modelled))
    zero, why = _ZEROS.get(signal.unit, (math.inf, ""))
    if signal.unit == "Pa" and _from_atmosphere(measured, modelled):
        lowest, highest = (
            format_quantity(float(v), "Pa") for v in (measured.min(), measured.max())
        )
        return f"It goes from {lowest} to {highest}, one atmosphere off the model: {why}"
    if _rms(measured - modelled - offset) < enough:
        mixed = abs(abs(offset) - zero) < _SAME_FACTOR * zero
        likely = why if mixed else "its zero is wrong, or a start value"
        return f"It would fit if {format_quantity(offset, signal.unit)} were taken off: {likely}"
    if _rms(measured + modelled) < enough:
        return "It would fit with its sign turned"
    # A measurement much larger than the model comes near it when it is divided, one much smaller when the model is
    # multiplied: of the two errors that are left the smaller one counts, so that both are described alike.
    product = float(measured @ modelled)
    if product <= 0.0:
        return ""
    gain, inverse = product / float(modelled @ modelled), product / float(measured @ measured)
    if min(_rms(measured - gain * modelled), _rms(inverse * measured - modelled)) >= enough:
        return ""
    units = _as_units(signal.unit, gain)
    if units:
        return f"It would fit if it were divided by {gain:.4g}{units}"
    return (
        f"Relative to the model it is {gain:.3g} times as large: a size of the muscle or a load that is not the rig's "
        f"does this, and so does a wrong unit or factor of the instrument{inputs()}"
    )


def _from_atmosphere(measured: Array, modelled: Array) -> bool:
    """Whether a pressure begins at one atmosphere and ends that much above the model, or as much below.

    Where the start of the model was estimated from the same reading, no constant is what the two differ by.
    """
    low, high = ATMOSPHERES
    above = float(measured.max() - modelled.max())
    is_one_atmosphere = abs(abs(above) - STANDARD_ATMOSPHERE) < _SAME_FACTOR * STANDARD_ATMOSPHERE
    return bool(low <= math.copysign(1.0, above) * measured.min() <= high and is_one_atmosphere)


def _as_units(unit: str, gain: float) -> str:
    """Two units whose ratio a factor is, in words; "" where it is none."""
    for written, read in itertools.permutations(_UNITS.get(unit, ()), 2):
        ratio = float(convert(1.0, read, written))
        if abs(gain / ratio - 1) < _SAME_FACTOR:
            return f", as if what was written in {written} were read as {read}"
    return ""


def has_usual_units(unit: str) -> bool:
    """Whether loggers write a quantity in several units."""
    return unit in _UNITS
