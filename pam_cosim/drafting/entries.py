"""From columns of the files to the bench: entries of ``[columns]`` with name, unit, sign and zero, and numbers."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.benches import NO_PRESSURE, BenchChoice
from pam_cosim.drafting.columns import RecordedColumn
from pam_cosim.drafting.data_sheets import Scale
from pam_cosim.drafting.evidence import Evidence
from pam_cosim.drafting.headings import GRAVITY, Headings, Meaning, alike, meant
from pam_cosim.drafting.shapes import (
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
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, convert, format_quantity, parse_quantity
from pam_cosim.units.grammar import ATMOSPHERES, STANDARD_ATMOSPHERE
from pam_cosim.wording import shown

NONZERO_READING = 5.0  # sd of the noise: a larger reading at rest is not zero
ABSOLUTE_GAUGE = "as a gauge of absolute pressure does"
LONGEST = "the longest in any recording"
"""Where a length at rest comes from that is not stated."""
SENSES = {1: "up", -1: "down", 0: "none"}
"""Directions as ``experiment.toml`` has them."""
_FORCE, _PRESSURE, _SET = Meaning("force"), Meaning("pressure"), meant("pressure", "set")


@dataclass(frozen=True)
class ColumnEntry:
    """One key of ``[columns]``: ``column``, ``unit``, ``formula``, ``gain``, ``offset`` as stated; ``zero`` in seconds.

    Attributes:
        zero: by recording.
        words: of a direction, up, down or none by the words of the column.
        why: what was guessed, in sentences.
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


def map_columns(
    choice: BenchChoice, interface: Interface, evidence: Evidence, valves: Mapping[str, Scale]
) -> Mapped:
    """Entries for what is named, signed, scaled or zeroed otherwise than the bench has it.

    What the user states as a formula stays as it is; of a column that the user names, the sign too. Data sheets of
    ``valves`` scale the inputs that open them.
    """
    headings, variables = evidence.headings, {**interface.inputs, **interface.outputs}
    meanings = {name: headings.variable(variable) for name, variable in variables.items()}
    entries: dict[str, ColumnEntry] = {}
    if evidence.time is not None:
        time = evidence.time
        entries["time"] = ColumnEntry("time", time.name, _unit_to_state(time), why=time.why)
    values: dict[str, dict[int, Array]] = {}
    for name, column in choice.fed.items():
        if name in valves:
            formula, values[name] = valves[name].entry(column)
            entries[name] = ColumnEntry(name, formula=formula, why=column.why)
            continue
        entries[name], values[name] = _named(name, column, variables[name], interface, evidence)
    for name, formula in evidence.formulas.items():
        entries[name] = ColumnEntry(name, formula=formula)
    times = {i: _time(i, evidence) for i in range(len(evidence.sources))}
    pressure = _first(values, meanings, _PRESSURE, _SET)
    by_convention = [name for name in values if not variables[name].is_foreign]
    for name in sorted(by_convention, key=lambda name: meanings[name] != _FORCE):
        pull = _first(values, meanings, _FORCE) if name in interface.inputs else None
        why = _why_reversed(values[name], meanings[name], choice.fed[name], pressure, pull)
        if why:
            entries[name] = _turned(entries[name], choice.fed[name], why)
            values[name] = {i: -samples for i, samples in values[name].items()}
    runs = _runs(interface, times, values, headings, moving=not evidence.points)
    if evidence.points:
        return Mapped(entries, runs)
    for name in by_convention:
        entry, zeros = _with_zero(
            entries[name], name, choice, meanings, runs, pressure, variables[name]
        )
        entries[name] = entry
        values[name] = {i: samples - zeros.get(i, 0.0) for i, samples in values[name].items()}
    return Mapped(entries, _runs(interface, times, values, headings))


def longest_of(choice: BenchChoice) -> float | None:
    """The longest length [m] in any recording of a column that is one; None: there is none."""
    lengths = [c for c in choice.fed.values() if c.of("length")]
    return max((float(np.nanmax(convert(c.samples, c.unit, "m"))) for c in lengths), default=None)


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
    count = len(next(iter(evidence.sources[i].table.columns.values())).values)
    interval = evidence.recording.interval
    step = 1.0 if interval is None else parse_quantity(interval.value, "s")
    return np.arange(count, dtype=np.float64) * step


def _first(
    values: Mapping[str, dict[int, Array]], meanings: Mapping[str, Meaning | None], *wanted: Meaning
) -> dict[int, Array] | None:
    """The numbers of the first column with one of these meanings, in their order."""
    names = [name for meaning in wanted for name in values if meanings[name] == meaning]
    return values[names[0]] if names else None


def _runs(
    interface: Interface,
    times: Mapping[int, Array],
    values: Mapping[str, Mapping[int, Array]],
    headings: Headings,
    moving: bool = True,
) -> tuple[MappedRun, ...]:
    """The recordings; ``moving``: over time, so that they may rest."""
    result = []
    for i, time in times.items():
        inputs = {n: v[i] for n, v in values.items() if n in interface.inputs and i in v}
        outputs = {n: v[i] for n, v in values.items() if n in interface.outputs and i in v}
        warm = [n for n in outputs if headings.fits(interface.outputs[n].unit, "temperature")]
        quick = [v for n, v in outputs.items() if n not in warm]
        at_rest = rests(time, [*inputs.values(), *quick]) if moving else []
        result.append(MappedRun(time, inputs, outputs, tuple(at_rest)))
    return tuple(result)


# ---- name and scale --------------------------------------------------------------------------------------------------


def _unit_to_state(column: RecordedColumn) -> str | None:
    """The unit that the entry of a column states; None where its heading does."""
    return None if column.stated else column.unit or None


def _named(
    name: str, column: RecordedColumn, variable: Variable, interface: Interface, evidence: Evidence
) -> tuple[ColumnEntry, dict[int, Array]]:
    """The entry that renames a column or makes it what the bench calls so, and its numbers."""
    if column.kind == "direction" and not variable.is_foreign:
        return _direction(name, column, evidence)
    wanted = None if variable.is_foreign else evidence.headings.variable(variable)
    if wanted and wanted.kind == "contraction" and column.kind in ("length", "ratio"):
        return _contraction(name, column, interface, evidence.stated)
    if column.kind == "force" and column.unit and alike(column.unit, "kg"):
        gravity = parse_quantity(GRAVITY, "m/s2")
        numbers = {i: v * gravity for i, v in _converted(name, column, "kg").items()}
        why = (*column.why, f"a force in {column.unit}, times gravity")
        return scaled(name, column, GRAVITY, None, why), numbers
    numbers = _converted(name, column, variable.unit)
    if column.absolute and column.kind == "pressure" and variable.is_foreign:
        why = (
            *column.why,
            f"its heading states an absolute pressure: state an offset if {name} is gauge",
        )
        return ColumnEntry(name, column.name, column.unit or None, why=why), numbers
    if column.absolute and column.kind == "pressure":
        return _gauge_pressure(name, column, numbers, evidence.ambient_pressure)
    if column.formula:
        return ColumnEntry(name, formula=column.formula, why=column.why), numbers
    return ColumnEntry(name, column.name, _unit_to_state(column), why=column.why), numbers


def _converted(name: str, column: RecordedColumn, unit: str) -> dict[int, Array]:
    """The numbers of a column in a unit.

    Raises:
        InputError: its own is of another kind.
    """
    try:
        return {i: convert(v, column.unit, unit) for i, v in column.values.items()}
    except UnitError as problem:
        formula = f"--column {name}='{shown(column.name)} * \"1 {unit}\"'".replace("''", "'")
        hint = f"name another column, or scale it, as in {formula}"
        raise InputError(
            f"column '{column.name}' cannot be taken for {name}: {problem}; {hint}"
        ) from None


def _gauge_pressure(
    name: str, column: RecordedColumn, numbers: dict[int, Array], ambient: RecordedColumn | None
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A gauge pressure that was recorded as an absolute one [Pa]."""
    outside, source = STANDARD_ATMOSPHERE, ""
    if ambient is not None:
        outside = float(np.nanmean(convert(ambient.samples, ambient.unit, "Pa")))
        source = f", the mean of {ambient.name}"
    text = f"{outside / 1e3:.6g} kPa"
    why = (
        *column.why,
        f"its heading states an absolute pressure; the ambient is taken as {text}{source}",
    )
    entry = scaled(name, column, None, f"-{text}", why)
    return entry, {i: v - outside for i, v in numbers.items()}


def scaled(
    name: str, column: RecordedColumn, gain: str | None, offset: str | None, why: tuple[str, ...]
) -> ColumnEntry:
    """The entry of a column times a gain, plus an offset: as a formula, where one can hold the column."""
    if not column.readable:
        return ColumnEntry(name, column.name, column.unit, gain=gain or "1", offset=offset, why=why)
    term = column.term
    if gain == "-1":
        formula = f'"{offset}" - {term}' if offset else f"-{term}"
    else:
        formula = term + (f' * "{gain}"' if gain else "")
        formula += f' - "{offset.removeprefix("-")}"' if offset else ""
    return ColumnEntry(name, formula=formula, why=why)


def _contraction(
    name: str, column: RecordedColumn, interface: Interface, stated: Mapping[str, str]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction made of a length or of a ratio."""
    parameter = length_parameter(interface)
    if column.kind == "ratio":
        value, source = "1 m", ""
        if parameter is not None:
            usual = f"{interface.parameters[parameter].start:g} m"
            default = f"the bench's default of {parameter}, state yours and change it here"
            value, source = (
                stated.get(parameter, usual),
                "stated" if parameter in stated else default,
            )
        length = parse_quantity(value, "m")
        numbers = {i: convert(v, column.unit, "1") * length for i, v in column.values.items()}
        why = f"it is a ratio, times the length at rest, {value}: {source}"
        return scaled(name, column, value, None, (*column.why, why)), numbers
    lengths = {i: convert(v, column.unit, "m") for i, v in column.values.items()}
    value, source = f"{max(float(np.nanmax(v)) for v in lengths.values()):.6g} m", LONGEST
    if parameter in stated:
        value, source = stated[str(parameter)], "stated"
    length = parse_quantity(value, "m")
    why = f"it is a length: the contraction is what is missing to {value}, {source}"
    entry = scaled(name, column, "-1", value, (*column.why, why))
    return entry, {i: length - v for i, v in lengths.items()}


# ---- the direction of points at rest ---------------------------------------------------------------------------------


def with_directions(columns: Sequence[RecordedColumn], headings: Headings) -> list[RecordedColumn]:
    """The columns, with the direction of each value of those that are directions."""
    return [_with_senses(c, headings) if c.of("direction") else c for c in columns]


def _with_senses(column: RecordedColumn, headings: Headings) -> RecordedColumn:
    """A column of directions with the way that each of its values means; none, where it has more than three."""
    values = [float(v) for v in np.unique(column.samples[np.isfinite(column.samples)])]
    if len(values) > 3:
        return replace(column, meaning=None)
    if column.words:
        senses_of_words = {v: headings.direction_word(column.words[int(v)]) for v in values}
        return replace(column, senses=senses_of_words, why=("its words say so",))
    senses = {v: 1 if v == values[-1] else -1 if v == values[0] else 0 for v in values}
    if len(values) < 2:
        senses = {v: int(np.sign(v)) for v in values}
    return replace(column, senses=senses, why=("the larger is taken for up",))


def _direction(
    name: str, column: RecordedColumn, evidence: Evidence
) -> tuple[ColumnEntry, dict[int, Array]]:
    """Words for directions, or a formula that gives 1 and -1."""
    values = {
        i: np.array([float(column.senses.get(v, 0)) for v in samples.tolist()])
        for i, samples in column.values.items()
    }
    if column.words:
        ways = {w: SENSES[column.senses.get(float(i), 0)] for i, w in enumerate(column.words)}
        return ColumnEntry(name, column.name, why=column.why, words=ways), values
    if all(number == sense for number, sense in column.senses.items()):
        return ColumnEntry(name, column.name, why=column.why), values
    numbers = {sense: number for number, sense in reversed(column.senses.items())}
    up, down = numbers.get(1), numbers.get(-1)
    if up is None or down is None or len(column.senses) > 2:
        hint = f"leave it out: --recording 'ignore={column.name}'"
        raise InputError(f"the values of {column.name} are no directions; {hint}")
    scale, offset = 2.0 / (up - down), -(up + down) / (up - down)
    return ColumnEntry(
        name, column.name, gain=f"{scale:g}", offset=f"{offset:g}", why=column.why
    ), values


# ---- the sign of a contraction or a force, by the numbers that were recorded -----------------------------------------


def _why_reversed(
    values: Mapping[int, Array],
    meaning: Meaning | None,
    column: RecordedColumn,
    pressure: Mapping[int, Array] | None,
    pull: Mapping[int, Array] | None,
) -> str:
    """Why a signal counts the other way; "" where it does not.

    A contraction that falls while the pressure rises does, as does a pull below zero. One that is imposed, and that no
    pressure moves, counts the other way where the pull, at equal pressure, rises with it: a muscle that is shorter
    pulls less, but against a spring more. A length has a sign by itself.
    """
    if meaning is None or column.of("length"):
        return ""
    if meaning.kind == "force":
        samples = np.concatenate(list(values.values()))
        low, high = float(np.nanmin(samples)), float(np.nanmax(samples))
        negative = float(np.nanmean(samples)) < 0.0 and abs(low) > abs(high)
        return (
            "it is below zero: its sign is turned round, so that a pull is positive"
            if negative
            else ""
        )
    if meaning.kind != "contraction" or pressure is None:
        return ""
    together = correlation(pressure, values)
    if together < -LEAST_CORRELATION:
        return "it falls where the pressure rises: its sign is turned round"
    is_moved = together > LEAST_CORRELATION
    if pull is None or is_moved or _at_equal(pressure, pull, values) <= LEAST_CORRELATION:
        return ""
    return "the pull rises with it at equal pressure: its sign is turned round"


def _at_equal(
    third: Mapping[int, Array], first: Mapping[int, Array], second: Mapping[int, Array]
) -> float:
    """Partial correlation of two signals, without what each has in common with a third."""
    simple = correlation(first, second)
    with_first, with_second = correlation(third, first), correlation(third, second)
    unexplained = (1.0 - with_first**2) * (1.0 - with_second**2)
    return (simple - with_first * with_second) / sqrt(unexplained) if unexplained > 0.0 else 0.0


def _turned(entry: ColumnEntry, column: RecordedColumn, why: str) -> ColumnEntry:
    """The entry that gives the same numbers with the other sign."""
    whys = (*entry.why, why)
    if entry.formula is not None:
        return replace(entry, formula=f"-({entry.formula})", why=whys)
    if entry.gain is not None:
        offset = entry.offset and _negated(entry.offset)
        return replace(entry, gain=_negated(entry.gain), offset=offset, why=whys)
    return scaled(entry.name, column, "-1", None, whys)


def _negated(quantity: str) -> str:
    return quantity.removeprefix("-") if quantity.startswith("-") else f"-{quantity}"


# ---- the zero of an instrument, once for all recordings of a logger --------------------------------------------------


@dataclass(frozen=True)
class _Begin:
    """What a signal reads where recordings begin.

    Attributes:
        readings: by recording, the mean of its first rest, or of first samples that are still; ``errors`` of these.
        resting: recordings that rest long enough for an interval.
        moved: the largest span of the signal in a recording.
        lowest: value in any recording; ``largest`` magnitude.
    """

    readings: dict[int, float]
    errors: dict[int, float]
    resting: frozenset[int]
    moved: float
    lowest: float
    largest: float

    @property
    def reading(self) -> float:
        """The one farthest from zero."""
        return max(self.readings.values(), key=abs)

    @property
    def far(self) -> bool:
        """Whether it is away from zero by more than its error, in some recording."""
        return any(
            abs(reading) > NONZERO_READING * self.errors[i] for i, reading in self.readings.items()
        )

    @property
    def slight(self) -> bool:
        """Whether it is away by a small part of what the signal moves, in all."""
        return all(
            abs(reading) <= CRITERIA.starts.offset * self.moved
            for reading in self.readings.values()
        )

    @property
    def absolute(self) -> bool:
        """Whether it is that of the atmosphere in all, and the signal moves."""
        low, high = ATMOSPHERES
        return self.moved > 0.0 and all(
            low <= reading <= high for reading in self.readings.values()
        )

    @property
    def same(self) -> bool:
        """Whether all recordings begin with the same reading."""
        tolerances = {i: NONZERO_READING * error for i, error in self.errors.items()}
        middle = float(np.median([*self.readings.values()]))
        return all(abs(reading - middle) <= tolerances[i] for i, reading in self.readings.items())

    @property
    def common(self) -> bool:
        """Whether that is the lowest that the signal comes to, as of a machine that begins where it was mounted."""
        low = self.reading - self.lowest <= CRITERIA.starts.offset * self.moved
        return self.moved > 0.0 and low and self.same


def _begin(name: str, runs: Mapping[int, MappedRun]) -> _Begin:
    readings, errors = {}, {}
    for i, run in runs.items():
        values, count = run.signals[name], 0
        if run.first_rest is not None:
            count = run.first_rest.stop
        elif begins_still(run.time, [v for v in run.signals.values() if np.isfinite(v).any()]):
            count = int(np.sum(_still(run.time, values)))
        part = values[:count][np.isfinite(values[:count])]
        if part.size:
            least = REST_BAND * span(values) / NONZERO_READING
            readings[i] = float(np.mean(part))
            errors[i] = max(noise_of(run.time, values) / sqrt(part.size), least)
    signals = [run.signals[name] for run in runs.values()]
    return _Begin(
        readings,
        errors,
        frozenset(i for i, run in runs.items() if run.first_rest is not None and i in readings),
        moved=max(map(span, signals), default=0.0),
        lowest=min(float(np.nanmin(v)) for v in signals),
        largest=max(float(np.nanmax(np.abs(v))) for v in signals),
    )


def _still(time: Array, values: Array) -> np.ndarray:
    """(n,) the first samples, as long as they stay where the first five are."""
    first = float(np.nanmean(values[:5]))
    is_near = np.abs(values - first) <= max(
        NONZERO_READING * noise_of(time, values), REST_BAND * span(values)
    )
    return np.cumprod(is_near | ~np.isfinite(values)).astype(bool)


def _with_zero(
    entry: ColumnEntry,
    name: str,
    choice: BenchChoice,
    meanings: Mapping[str, Meaning | None],
    runs: Sequence[MappedRun],
    pressure: dict[int, Array] | None,
    variable: Variable,
) -> tuple[ColumnEntry, dict[int, float]]:
    """The entry with a zero from where recordings begin, if it is away from zero there; and the zero by recording.

    Where each rests long enough, it is the mean of an interval. Else it is one number for all: a zero belongs to the
    instrument, so that recordings at rest determine it for the others.
    """
    meaning = meanings[name]
    having = {i: run for i, run in enumerate(runs) if name in run.signals}
    begin = _begin(name, having) if having and meaning is not None else None
    if begin is None or meaning is None or not begin.readings:
        return entry, {}
    reason = ""
    if meaning == _PRESSURE or (
        meaning == _SET and begin.absolute and _reads_absolute(meanings, runs)
    ):
        reason = _reason_of_gauge(begin)
    elif begin.far and _unloaded(having, pressure, begin):
        is_clear = name in choice.outputs or begin.common
        reason = _reason_of_unloaded(meaning, begin) if is_clear else ""
    complete = begin.resting == having.keys()
    if not reason or not (complete or begin.same):
        return entry, {}
    reading = format_quantity(begin.reading, variable.unit)
    why = f"{reason.format(reading=reading)}: its zero"
    if complete:
        zero = _intervals(having)
        return replace(entry, zero=zero, why=(*entry.why, why)), _means(having, name, zero)
    value = float(np.median([*begin.readings.values()]))
    count = f"{len(begin.readings)} of {len(having)} recordings"
    shifted = _less(entry, choice.fed[name], value, variable.unit)
    return replace(
        shifted, why=(*entry.why, f"{why}, of the {count} that begin at rest")
    ), dict.fromkeys(having, value)


def _less(entry: ColumnEntry, column: RecordedColumn, value: float, unit: str) -> ColumnEntry:
    """The entry less a number [unit]."""
    text = f"{-value:.6g} {unit}".strip()
    if entry.formula is None and entry.gain is None:
        return (
            scaled(entry.name, column, None, f"{-value:.6g} {unit}".strip(), entry.why)
            if column.readable and value > 0
            else (replace(entry, gain="1", offset=text))
        )
    if entry.formula is not None:
        return replace(entry, formula=f'{entry.formula} + "{text}"')
    return replace(entry, offset=text) if entry.offset is None else entry


def _reads_absolute(meanings: Mapping[str, Meaning | None], runs: Sequence[MappedRun]) -> bool:
    """Whether the pressure of a muscle begins with that of the atmosphere in all recordings that have it."""
    for name in (n for n, meaning in meanings.items() if meaning == _PRESSURE):
        having = {i: run for i, run in enumerate(runs) if name in run.signals}
        if having and (begin := _begin(name, having)).readings and begin.absolute:
            return True
    return False


def _reason_of_gauge(begin: _Begin) -> str:
    """Why a pressure gets a zero; "" where it needs none."""
    if begin.absolute:
        return f"it begins with {{reading}}, {ABSOLUTE_GAUGE}"
    return "it begins at rest with {reading}" if begin.far and begin.slight else ""


def _reason_of_unloaded(meaning: Meaning, begin: _Begin) -> str:
    """Why what is read of a muscle without pressure gets a zero; "" where it needs none."""
    small_force = (
        meaning.kind == "force" and abs(begin.reading) <= CRITERIA.starts.offset * begin.largest
    )
    if meaning.kind == "contraction" or small_force:
        return "it begins at rest, without pressure, with {reading}"
    return ""


def _unloaded(
    runs: Mapping[int, MappedRun], pressure: dict[int, Array] | None, begin: _Begin
) -> bool:
    """Whether there is no pressure at the start of any of them, but for an offset."""
    if pressure is None:
        return False
    measured = [i for i in begin.readings if i in pressure]
    largest = max((span(pressure[i]) for i in measured), default=0.0)
    first = {i: runs[i].first_rest.stop if i in begin.resting else 5 for i in measured}  # type: ignore[union-attr]
    offsets = [
        float(np.nanmean(pressure[i][: first[i]] - np.nanmin(pressure[i]))) for i in measured
    ]
    return largest > 0.0 and all(offset <= NO_PRESSURE * largest for offset in offsets)


def _intervals(runs: Mapping[int, MappedRun]) -> dict[int, tuple[float, float]]:
    """One interval for all recordings, where their rests have enough samples in common."""
    each = {}
    for i, run in runs.items():
        assert run.first_rest is not None
        each[i] = float(run.time[run.first_rest.start]), float(run.time[run.first_rest.stop - 1])
    start, stop = max(begin for begin, _ in each.values()), min(end for _, end in each.values())
    inside = [int(np.sum((runs[i].time >= start) & (runs[i].time <= stop))) for i in each]
    enough = min(inside) >= CRITERIA.noise.fewest_samples
    return dict.fromkeys(each, (start, stop)) if enough else each


def _means(
    runs: Mapping[int, MappedRun], name: str, zero: Mapping[int, tuple[float, float]]
) -> dict[int, float]:
    """The mean of a signal in the interval of its zero, by recording."""
    means = {}
    for i, (start, stop) in zero.items():
        inside = runs[i].signals[name][(runs[i].time >= start) & (runs[i].time <= stop)]
        means[i] = float(np.mean(inside[np.isfinite(inside)])) if np.isfinite(inside).any() else 0.0
    return means


def readings_of(mapped: Mapped, names: Iterable[str]) -> Array:
    """Every sample of the first of these signals that was recorded; (0,) without one."""
    for name in names:
        samples = [run.signals[name] for run in mapped.runs if name in run.signals]
        if samples:
            return np.concatenate(samples)
    return np.empty(0)
