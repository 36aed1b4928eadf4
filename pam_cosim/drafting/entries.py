"""From columns of the files to the bench: entries of ``[columns]`` with name, unit, sign and zero, and numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import sqrt
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.benches import NO_PRESSURE, Bench, BenchChoice
from pam_cosim.drafting.columns import RecordedColumn
from pam_cosim.drafting.data_sheets import Scale
from pam_cosim.drafting.evidence import Evidence
from pam_cosim.drafting.headings import (
    GRAVITY,
    PRESSURE,
    SET_PRESSURE,
    UNKNOWN,
    Headings,
    Meaning,
    alike,
    meant,
)
from pam_cosim.drafting.shapes import (
    FEWEST_IN_WINDOW,
    LEAST_CORRELATION,
    REST_BAND,
    Rest,
    begins_still,
    correlation,
    noise_of,
    rests,
    span,
)
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.units import UnitError, convert, format_quantity, parse_quantity
from pam_cosim.units.grammar import ATMOSPHERES, STANDARD_ATMOSPHERE
from pam_cosim.wording import shown

NONZERO_READING = 5.0  # sd of the noise: a larger reading at rest is not zero
ABSOLUTE_GAUGE = "as a gauge of absolute pressure does"
LONGEST = "the longest in any recording"
"""Where a length at rest comes from that is not stated."""
SENSES = {1: "up", -1: "down", 0: "none"}
"""Directions as ``experiment.toml`` has them."""
_FORCE = meant("force")
Numbers = Mapping[int, Array]
"""Of a signal, by recording: (n,) each."""


@dataclass(frozen=True)
class ColumnEntry:
    """One key of ``[columns]``: ``column``, ``unit``, ``formula``, ``gain``, ``offset`` as stated; ``zero`` in seconds.

    Attributes:
        zero: by recording.
        words: of a direction, up, down or none by the words of the column.
        why: what was guessed, in sentences.
        numbers: by recording, (n,) each in the bench's unit.
    """

    name: str
    column: str | None = None
    unit: str | None = None
    formula: str | None = None
    gain: str | None = None
    offset: str | None = None
    zero: dict[int, tuple[float, float]] = field(default_factory=dict)
    why: tuple[str, ...] = ()
    words: dict[str, str] = field(default_factory=dict)
    numbers: Numbers = field(default_factory=dict)

    def because(self, why: str, **changes: Any) -> ColumnEntry:
        """The entry with changes, and why."""
        return replace(self, why=(*self.why, why), **changes)


@dataclass(frozen=True)
class MappedRun:
    """One recording under the bench's names: time (n,) [s], (n,) each in the bench's units, and where nothing moves."""

    time: Array
    inputs: dict[str, Array]
    outputs: dict[str, Array]
    rests: tuple[Rest, ...] = ()

    @property
    def signals(self) -> dict[str, Array]:
        """All of them."""
        return {**self.inputs, **self.outputs}

    @property
    def first_rest(self) -> Rest | None:
        """The rest that it begins with, where it does."""
        return self.rests[0] if self.rests and self.rests[0].start == 0 else None


@dataclass(frozen=True)
class Mapped:
    """Entries by the bench's names, and the recordings under them."""

    entries: dict[str, ColumnEntry]
    runs: tuple[MappedRun, ...]


def map_columns(bench: Bench, valves: Mapping[str, Scale]) -> Mapped:
    """Entries for what is named, signed, scaled or zeroed otherwise than the bench has it.

    What the user states as a formula stays as it is; of a column that the user names, the sign too. Data sheets of
    ``valves`` scale the inputs that open them.
    """
    evidence, fed, meanings = bench.evidence, bench.choice.fed, bench.meanings
    entries = {n: _entry(n, column, bench, valves) for n, column in fed.items()}
    pressure = _first(entries, meanings, PRESSURE, SET_PRESSURE)
    by_convention = [name for name in fed if not bench.signals[name].is_foreign]
    for name in sorted(by_convention, key=lambda name: meanings[name] != _FORCE):
        pull = _first(entries, meanings, _FORCE) if name in bench.interface.inputs else None
        why = _why_reversed(entries[name].numbers, meanings[name], fed[name], pressure, pull)
        entries[name] = _turned(entries[name], fed[name], why) if why else entries[name]
    runs = _runs(entries, bench)
    if not evidence.points:
        zeroed = {n: _with_zero(entries[n], bench, runs, pressure) for n in by_convention}
        entries |= zeroed
        runs = _runs(entries, bench)
    first = {}
    if evidence.time is not None:
        time = evidence.time
        first["time"] = ColumnEntry("time", time.name, _unit_to_state(time), why=time.why)
    formulas = {n: ColumnEntry(n, formula=text) for n, text in evidence.formulas.items()}
    return Mapped({**first, **entries, **formulas}, runs)


def longest_of(choice: BenchChoice) -> float | None:
    """The longest length [m] in any recording of a column that is one; None: there is none."""
    lengths = [c.converted("m") for c in choice.fed.values() if c.of("length")]
    return max((float(np.nanmax(v)) for numbers in lengths for v in numbers.values()), default=None)


def length_parameter(interface: Interface) -> str | None:
    """The parameter that is a muscle's length at rest, by its description."""
    for name, variable in interface.parameters.items():
        text = variable.description.casefold()
        if variable.unit == "m" and "length" in text and ("rest" in text or "initial" in text):
            return name
    return None


def _time(i: int, evidence: Evidence) -> Array:
    """(n,) [s]; of points at rest, their numbers."""
    if evidence.time is not None:
        return convert(evidence.time.values[i], evidence.time.unit, "s")
    interval = evidence.recording.interval
    step = 1.0 if interval is None else parse_quantity(interval.value, "s")
    return np.arange(evidence.sources[i].count, dtype=np.float64) * step


def _first(
    entries: Mapping[str, ColumnEntry], meanings: Mapping[str, Meaning], *wanted: Meaning
) -> Numbers | None:
    """The numbers of the first column with one of these meanings, in their order."""
    named = (e.numbers for meaning in wanted for n, e in entries.items() if meanings[n] == meaning)
    return next(named, None)


def _runs(entries: Mapping[str, ColumnEntry], bench: Bench) -> tuple[MappedRun, ...]:
    """The recordings; those of points at rest have no rests."""
    interface, evidence, runs = bench.interface, bench.evidence, []
    for i in range(len(evidence.sources)):
        inputs, outputs = (
            {n: e.numbers[i] for n, e in entries.items() if n in side and i in e.numbers}
            for side in (interface.inputs, interface.outputs)
        )
        time, at_rest = _time(i, evidence), list[Rest]()
        if not evidence.points:
            fits = bench.headings.fits
            slow = {n for n in outputs if fits(interface.outputs[n].unit, "temperature")}
            quick = [v for n, v in outputs.items() if n not in slow]
            at_rest = rests(time, [*inputs.values(), *quick])
        runs.append(MappedRun(time, inputs, outputs, tuple(at_rest)))
    return tuple(runs)


# ---- name and scale --------------------------------------------------------------------------------------------------


def _unit_to_state(column: RecordedColumn) -> str | None:
    """The unit that the entry of a column states; None where its heading does."""
    return None if column.stated else column.unit or None


def _entry(
    name: str, column: RecordedColumn, bench: Bench, valves: Mapping[str, Scale]
) -> ColumnEntry:
    """The entry that renames a column or makes it what the bench calls so."""
    variable = bench.signals[name]
    entry = ColumnEntry(name, column.name, _unit_to_state(column), why=column.why)
    if name in valves:
        formula, numbers = valves[name].entry(column)
        return replace(entry, column=None, unit=None, formula=formula, numbers=numbers)
    if column.kind == "direction" and not variable.is_foreign:
        return _direction(entry, column)
    is_contraction = not variable.is_foreign and bench.meanings[name].kind == "contraction"
    if is_contraction and column.kind in ("length", "ratio"):
        return _contraction(entry, column, bench)
    if column.kind == "force" and column.unit and alike(column.unit, "kg"):
        gravity = parse_quantity(GRAVITY, "m/s2")
        numbers = {i: v * gravity for i, v in _converted(name, column, "kg").items()}
        entry = entry.because(f"a force in {column.unit}, times gravity", numbers=numbers)
        return scaled(entry, column, GRAVITY, None)
    entry = replace(entry, numbers=_converted(name, column, variable.unit))
    if column.absolute and column.kind == "pressure":
        if not variable.is_foreign:
            return _gauge_pressure(entry, column, bench)
        why = f"its heading states an absolute pressure: state an offset if {name} is gauge"
        return entry.because(why, unit=column.unit or None)
    if column.formula:
        return replace(entry, column=None, unit=None, formula=column.formula)
    return entry


def _converted(name: str, column: RecordedColumn, unit: str) -> dict[int, Array]:
    """The numbers of a column in a unit.

    Raises:
        InputError: its own is of another kind.
    """
    try:
        return column.converted(unit)
    except UnitError as problem:
        formula = f"--column {name}='{shown(column.name)} * \"1 {unit}\"'".replace("''", "'")
        hint = f"name another column, or scale it, as in {formula}"
        message = f"column '{column.name}' cannot be taken for {name}: {problem}; {hint}"
        raise InputError(message) from None


def _gauge_pressure(entry: ColumnEntry, column: RecordedColumn, bench: Bench) -> ColumnEntry:
    """A gauge pressure that was recorded as an absolute one [Pa]."""
    ambient, known = bench.evidence.ambient_pressure, bench.evidence.stated
    named = [n for n in bench.parameters_of(meant("pressure", "ambient")) if n in known]
    outside, source = STANDARD_ATMOSPHERE, ""
    if named:
        outside, source = parse_quantity(known[named[0]], "Pa"), f", {named[0]}"
    elif ambient is not None:
        outside = float(np.nanmean(convert(ambient.samples, ambient.unit, "Pa")))
        source = f", the mean of {ambient.name}"
    text = f"{outside / 1e3:.6g} kPa"
    why = f"its heading states an absolute pressure; the ambient is taken as {text}{source}"
    numbers = {i: v - outside for i, v in entry.numbers.items()}
    return scaled(entry.because(why, numbers=numbers), column, None, f"-{text}")


def scaled(
    entry: ColumnEntry, column: RecordedColumn, gain: str | None, offset: str | None
) -> ColumnEntry:
    """The entry as the column times a gain, plus an offset: as a formula, where one can hold the column."""
    if not column.readable:
        return replace(entry, unit=column.unit, gain=gain or "1", offset=offset)
    term = column.term
    if gain == "-1":
        formula = f'"{offset}" - {term}' if offset else f"-{term}"
    else:
        formula = term + (f' * "{gain}"' if gain else "")
        formula += f' - "{offset.removeprefix("-")}"' if offset else ""
    return replace(entry, column=None, unit=None, formula=formula)


def _contraction(entry: ColumnEntry, column: RecordedColumn, bench: Bench) -> ColumnEntry:
    """A contraction made of a length or of a ratio."""
    parameter, stated = length_parameter(bench.interface) or "", bench.evidence.stated
    is_ratio = column.kind == "ratio"
    numbers = column.converted("1" if is_ratio else "m")
    if parameter in stated:
        value, source = stated[parameter], "stated"
    elif not is_ratio:
        value, source = f"{max(float(np.nanmax(v)) for v in numbers.values()):.6g} m", LONGEST
    elif parameter:
        value = f"{bench.interface.parameters[parameter].start:g} m"
        source = f"the bench's default of {parameter}, state yours and change it here"
    else:
        value, source = "1 m", ""
    length = parse_quantity(value, "m")
    if is_ratio:
        why = f"it is a ratio, times the length at rest, {value}: {source}"
        numbers = {i: v * length for i, v in numbers.items()}
        return scaled(entry.because(why, numbers=numbers), column, value, None)
    why = f"it is a length: the contraction is what is missing to {value}, {source}"
    numbers = {i: length - v for i, v in numbers.items()}
    return scaled(entry.because(why, numbers=numbers), column, "-1", value)


# ---- the direction of points at rest ---------------------------------------------------------------------------------


def with_directions(columns: Sequence[RecordedColumn], headings: Headings) -> list[RecordedColumn]:
    """The columns, with the direction of each value of those that are directions."""
    return [_with_senses(c, headings) if c.of("direction") else c for c in columns]


def _with_senses(column: RecordedColumn, headings: Headings) -> RecordedColumn:
    """A column of directions with the way that each of its values means; none, where it has more than three."""
    values = np.unique(column.samples[np.isfinite(column.samples)]).tolist()
    if len(values) > 3:
        return replace(column, meaning=UNKNOWN)
    if column.words:
        senses = {v: headings.direction_word(column.words[int(v)]) for v in values}
        return replace(column, senses=senses, why=("its words say so",))
    ends = dict(zip((values[0], values[-1]), (-1, 1), strict=True)) if len(values) > 1 else {}
    senses = {v: ends.get(v, 0) for v in values} if ends else {v: int(np.sign(v)) for v in values}
    return replace(column, senses=senses, why=("the larger is taken for up",))


def _direction(entry: ColumnEntry, column: RecordedColumn) -> ColumnEntry:
    """Words for directions, or a formula that gives 1 and -1."""
    senses = column.senses
    numbers = {
        i: np.array([float(senses.get(v, 0)) for v in samples.tolist()])
        for i, samples in column.values.items()
    }
    entry = replace(entry, unit=None, numbers=numbers)
    if column.words:
        words = {word: SENSES[senses.get(float(i), 0)] for i, word in enumerate(column.words)}
        return replace(entry, words=words)
    if all(number == sense for number, sense in senses.items()):
        return entry
    values = {sense: number for number, sense in reversed(senses.items())}
    if not {1, -1} <= values.keys() or len(senses) > 2:
        hint = f"leave it out: --recording 'ignore={column.name}'"
        raise InputError(f"the values of {column.name} are no directions; {hint}")
    middle, half = (values[1] + values[-1]) / 2.0, (values[1] - values[-1]) / 2.0
    return replace(entry, gain=f"{1.0 / half:g}", offset=f"{-middle / half:g}")


# ---- the sign of a contraction or a force, by the numbers that were recorded -----------------------------------------


def _why_reversed(
    values: Numbers,
    meaning: Meaning,
    column: RecordedColumn,
    pressure: Numbers | None,
    pull: Numbers | None,
) -> str:
    """Why a signal counts the other way; "" where it does not.

    A contraction that falls while the pressure rises does, as does a pull below zero. One that is imposed, and that no
    pressure moves, counts the other way where the pull, at equal pressure, rises with it: a muscle that is shorter
    pulls less, but against a spring more. A length has a sign by itself.
    """
    if meaning.kind == "force":
        samples = np.concatenate(list(values.values()))
        low, high = float(np.nanmin(samples)), float(np.nanmax(samples))
        negative = float(np.nanmean(samples)) < 0.0 and abs(low) > abs(high)
        why = "it is below zero: its sign is turned round, so that a pull is positive"
        return why if negative else ""
    if meaning.kind != "contraction" or pressure is None or column.of("length"):
        return ""
    together = correlation(pressure, values)
    if together < -LEAST_CORRELATION:
        return "it falls where the pressure rises: its sign is turned round"
    is_moved = together > LEAST_CORRELATION
    if pull is None or is_moved or _at_equal(pressure, pull, values) <= LEAST_CORRELATION:
        return ""
    return "the pull rises with it at equal pressure: its sign is turned round"


def _at_equal(third: Numbers, first: Numbers, second: Numbers) -> float:
    """Partial correlation of two signals, without what each has in common with a third."""
    simple = correlation(first, second)
    with_first, with_second = correlation(third, first), correlation(third, second)
    unexplained = (1.0 - with_first**2) * (1.0 - with_second**2)
    return (simple - with_first * with_second) / sqrt(unexplained) if unexplained > 0.0 else 0.0


def _turned(entry: ColumnEntry, column: RecordedColumn, why: str) -> ColumnEntry:
    """The entry with the other sign."""
    entry = entry.because(why, numbers={i: -v for i, v in entry.numbers.items()})
    if entry.formula is not None:
        return replace(entry, formula=f"-({entry.formula})")
    if entry.gain is not None:
        offset = entry.offset and _negated(entry.offset)
        return replace(entry, gain=_negated(entry.gain), offset=offset)
    return scaled(entry, column, "-1", None)


def _negated(quantity: str) -> str:
    return quantity.removeprefix("-") if quantity.startswith("-") else f"-{quantity}"


# ---- the zero of an instrument, once for all recordings of a logger --------------------------------------------------


@dataclass(frozen=True)
class _Begin:
    """What a signal reads where recordings begin.

    Attributes:
        runs: recordings that have it.
        readings: by recording, the mean of its first rest, or of first samples that are still; ``errors`` of these.
        moved: the largest span of the signal in a recording.
        lowest: value in any recording; ``largest`` magnitude.
    """

    runs: Mapping[int, MappedRun]
    readings: dict[int, float]
    errors: dict[int, float]
    moved: float
    lowest: float
    largest: float

    @property
    def rests(self) -> dict[int, Rest]:
        """The first rests, of the recordings that begin with one and have readings there."""
        return {i: rest for i in self.readings if (rest := self.runs[i].first_rest) is not None}

    @property
    def reading(self) -> float:
        """The one farthest from zero."""
        return max(self.readings.values(), key=abs)

    @property
    def far(self) -> bool:
        """Whether it is away from zero by more than its error, in some recording."""
        return any(abs(r) > NONZERO_READING * self.errors[i] for i, r in self.readings.items())

    @property
    def slight(self) -> bool:
        """Whether it is away by a small part of what the signal moves, in all."""
        return abs(self.reading) <= CRITERIA.starts.offset * self.moved

    @property
    def absolute(self) -> bool:
        """Whether it is that of the atmosphere in all, and the signal moves."""
        low, high = ATMOSPHERES
        return self.moved > 0.0 and all(low <= r <= high for r in self.readings.values())

    @property
    def same(self) -> bool:
        """Whether all recordings begin with the same reading."""
        middle = float(np.median([*self.readings.values()]))
        away = {i: abs(reading - middle) for i, reading in self.readings.items()}
        return all(away[i] <= NONZERO_READING * self.errors[i] for i in away)

    @property
    def common(self) -> bool:
        """Whether that is the lowest that the signal comes to, as of a machine that begins where it was mounted."""
        low = self.reading - self.lowest <= CRITERIA.starts.offset * self.moved
        return self.moved > 0.0 and low and self.same


def _begin(name: str, runs: Sequence[MappedRun]) -> _Begin | None:
    """Where a signal begins; None: no recording has it and begins still."""
    having = {i: run for i, run in enumerate(runs) if name in run.signals}
    readings, errors = {}, {}
    for i, run in having.items():
        values, rest = run.signals[name], run.first_rest
        recorded = [v for v in run.signals.values() if np.isfinite(v).any()]
        count = rest.stop if rest else 0
        if rest is None and begins_still(run.time, recorded):
            count = int(np.sum(_still(run.time, values)))
        part = values[:count]
        part = part[np.isfinite(part)]
        if part.size:
            least = REST_BAND * span(values) / NONZERO_READING
            readings[i] = float(np.mean(part))
            errors[i] = max(noise_of(run.time, values) / sqrt(part.size), least)
    signals = [run.signals[name] for run in having.values()]
    if not readings:
        return None
    return _Begin(
        having,
        readings,
        errors,
        moved=max(map(span, signals)),
        lowest=min(float(np.nanmin(v)) for v in signals),
        largest=max(float(np.nanmax(np.abs(v))) for v in signals),
    )


def _still(time: Array, values: Array) -> np.ndarray:
    """(n,) the first samples, as long as they stay where the first five are."""
    band = max(NONZERO_READING * noise_of(time, values), REST_BAND * span(values))
    is_near = np.abs(values - float(np.nanmean(values[:FEWEST_IN_WINDOW]))) <= band
    return np.cumprod(is_near | ~np.isfinite(values)).astype(bool)


def _with_zero(
    entry: ColumnEntry, bench: Bench, runs: Sequence[MappedRun], pressure: Numbers | None
) -> ColumnEntry:
    """The entry with a zero from where recordings begin, if it is away from zero there.

    Where each rests long enough, it is the mean of an interval. Else it is one number for all: a zero belongs to the
    instrument, so that recordings at rest determine it for the others.
    """
    name, meaning = entry.name, bench.meanings[entry.name]
    begin = _begin(name, runs)
    if begin is None or not meaning:
        return entry
    reason = ""
    if meaning == PRESSURE or (
        meaning == SET_PRESSURE and begin.absolute and _reads_absolute(bench.meanings, runs)
    ):
        reason = _reason_of_gauge(begin)
    elif begin.far and (name in bench.choice.outputs or begin.common):
        reason = _reason_of_unloaded(meaning, begin) if _unloaded(begin, pressure) else ""
    complete = begin.rests.keys() == begin.runs.keys()
    if not reason or not (complete or begin.same):
        return entry
    unit = bench.signals[name].unit
    why = f"{reason.format(reading=format_quantity(begin.reading, unit))}: its zero"
    if complete:
        zero = _intervals(begin)
        means = {i: _mean(begin.runs[i], name, *interval) for i, interval in zero.items()}
        entry = entry.because(why, zero=zero)
    else:
        value = float(np.median([*begin.readings.values()]))
        means = dict.fromkeys(begin.runs, value)
        count = f"{len(begin.readings)} of {len(begin.runs)} recordings"
        entry = _less(entry, bench.choice.fed[name], f"{-value:.6g} {unit}".strip())
        entry = entry.because(f"{why}, of the {count} that begin at rest")
    return replace(entry, numbers={i: v - means.get(i, 0.0) for i, v in entry.numbers.items()})


def _less(entry: ColumnEntry, column: RecordedColumn, text: str) -> ColumnEntry:
    """The entry plus a quantity."""
    if entry.formula is not None:
        return replace(entry, formula=f'{entry.formula} + "{text}"')
    if entry.gain is None and column.readable and text.startswith("-"):
        return scaled(entry, column, None, text)
    return replace(entry, gain=entry.gain or "1", offset=entry.offset or text)


def _reads_absolute(meanings: Mapping[str, Meaning], runs: Sequence[MappedRun]) -> bool:
    """Whether the pressure of a muscle begins with that of the atmosphere in all recordings that have it."""
    begins = [_begin(name, runs) for name, meaning in meanings.items() if meaning == PRESSURE]
    return any(begin is not None and begin.absolute for begin in begins)


def _reason_of_gauge(begin: _Begin) -> str:
    """Why a pressure gets a zero; "" where it needs none."""
    if begin.absolute:
        return f"it begins with {{reading}}, {ABSOLUTE_GAUGE}"
    return "it begins at rest with {reading}" if begin.far and begin.slight else ""


def _reason_of_unloaded(meaning: Meaning, begin: _Begin) -> str:
    """Why what is read of a muscle without pressure gets a zero; "" where it needs none."""
    is_small = abs(begin.reading) <= CRITERIA.starts.offset * begin.largest
    needed = meaning.kind == "contraction" or (meaning.kind == "force" and is_small)
    return "it begins at rest, without pressure, with {reading}" if needed else ""


def _unloaded(begin: _Begin, pressure: Numbers | None) -> bool:
    """Whether there is no pressure at the start of any recording, but for an offset."""
    measured = {i: v for i, v in (pressure or {}).items() if i in begin.readings}
    largest = max(map(span, measured.values()), default=0.0)
    offsets = [
        float(np.nanmean(v[: begin.rests[i].stop if i in begin.rests else FEWEST_IN_WINDOW]))
        - float(np.nanmin(v))
        for i, v in measured.items()
    ]
    return largest > 0.0 and all(offset <= NO_PRESSURE * largest for offset in offsets)


def _intervals(begin: _Begin) -> dict[int, tuple[float, float]]:
    """One interval for all recordings, where their rests have enough samples in common."""
    times = {i: begin.runs[i].time for i in begin.rests}
    each = {
        i: (float(times[i][rest.start]), float(times[i][rest.stop - 1]))
        for i, rest in begin.rests.items()
    }
    starts, ends = zip(*each.values(), strict=True)
    start, stop = max(starts), min(ends)
    inside = [int(np.sum((time >= start) & (time <= stop))) for time in times.values()]
    enough = min(inside) >= CRITERIA.noise.fewest_samples
    return dict.fromkeys(each, (start, stop)) if enough else each


def _mean(run: MappedRun, name: str, start: float, stop: float) -> float:
    """The mean of a signal in the interval of its zero."""
    inside = run.signals[name][(run.time >= start) & (run.time <= stop)]
    return float(np.mean(inside[np.isfinite(inside)])) if np.isfinite(inside).any() else 0.0


def readings_of(mapped: Mapped, names: Iterable[str]) -> Array:
    """Every sample of the first of these signals that was recorded; (0,) without one."""
    for name in names:
        samples = [run.signals[name] for run in mapped.runs if name in run.signals]
        if samples:
            return np.concatenate(samples)
    return np.empty(0)
