"""The columns of all recordings, and the evidence of what each is: its words, its unit, what its numbers look like."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import permutations

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.headings import (
    AT_REST,
    PRESSURE,
    SET_PRESSURE,
    UNKNOWN,
    Headings,
    Meaning,
    meant,
)
from pam_cosim.drafting.recordings import Source
from pam_cosim.drafting.shapes import (
    LEAST_CORRELATION,
    correlation,
    is_constant,
    is_held,
    is_repeated,
    is_switch,
    span,
)
from pam_cosim.errors import InputError
from pam_cosim.measurement.curves import levels
from pam_cosim.measurement.recording import EMPTY_SHARE, filled_forward
from pam_cosim.measurement.table import Column
from pam_cosim.units import convert
from pam_cosim.wording import shown

# of the range of all runs: a column that moves less within a run is constant there
IMPOSED_RANGE = 0.2
NO_UNIT = "no unit is written"
UNNAMED = re.compile(r"column \d+|unnamed:.*", re.IGNORECASE)
_SUPPLY_RANGE = 0.3  # of its mean, by which a supply pressure varies at most
_LEAST_SIGNED = 0.3  # correlation of a command of two valves with the change of the pressure
_MOST = 400  # columns; each is held against each
_REFERABLE = re.compile(r"[^'\\\n]+")
_NAME = re.compile(r"'([^']*)'|([A-Za-z_]\w*)", re.ASCII)
_HALVES = (("inlet", 1, "+", "rises", "above"), ("exhaust", -1, "-", "falls", "below"))
_SCALES = {"force": ("F", "0.1 N"), "pressure": ("p", "0.1 kPa"), "command": ("u_in", "0.004")}
"""By kind, how a column in counts may be scaled: a name and the size of a count."""


@dataclass(frozen=True)
class RecordedColumn:
    """A column of that name in every recording that has it.

    Attributes:
        unit: as the registry of units has it; stated in the file, or guessed.
        stated: the file states it so that it can be read.
        unknown: the unit that the file states, where it is unknown; else "".
        why: what ``meaning`` and ``unit`` were guessed from, in sentences without a subject.
        known_share: share of its words that are known.
        values: numbers in its unit by the number of the recording.
        points: the recordings are points at rest, whose rows have no pace.
        words: of a direction that is written in words: the words that its numbers are places of.
        senses: of a direction: 1 up, -1 down, 0 neither, by its numbers.
        logged_on_change: its cells are empty in the files while it keeps its value.
        formula: of a column of the files that this one is made from; "": it is one itself.
    """

    name: str
    unit: str
    stated: bool
    meaning: Meaning
    values: dict[int, Array]
    why: tuple[str, ...] = ()
    unknown: str = ""
    absolute: bool = False
    known_share: float = 0.0
    places: dict[int, Column] = field(default_factory=dict)
    points: bool = False
    words: tuple[str, ...] = ()
    senses: dict[float, int] = field(default_factory=dict)
    logged_on_change: bool = False
    formula: str = ""

    @property
    def kind(self) -> str:
        """Of its meaning; "" where that is unknown."""
        return self.meaning.kind

    @property
    def written_unit(self) -> str:
        """As the files state it; "" where they state none."""
        return next((text for c in self.places.values() if (text := c.unit.strip())), "")

    @property
    def readable(self) -> bool:
        """Whether a formula can contain the column: by its name, and by its unit in the files, if there is one."""
        return bool(_REFERABLE.fullmatch(self.name)) and (self.stated or not self.written_unit)

    @property
    def term(self) -> str:
        """The column in a formula, with the unit that is guessed."""
        return f"'{self.name}'" + (f' * "1 {self.unit}"' if self.unit and not self.stated else "")

    @property
    def since(self) -> str:
        """The first of its dates with times of day, from which its numbers count; "" where it holds none."""
        return next((column.since for column in self.places.values()), "")

    @cached_property
    def samples(self) -> Array:
        """All its numbers."""
        return np.concatenate([*self.values.values(), np.empty(0)])

    def converted(self, unit: str) -> dict[int, Array]:
        """Its numbers in another unit."""
        return {i: convert(values, self.unit, unit) for i, values in self.values.items()}

    @cached_property
    def largest(self) -> float:
        """Largest magnitude of its numbers."""
        return float(np.nanmax(np.abs(self.samples))) if np.isfinite(self.samples).any() else 0.0

    @cached_property
    def held(self) -> bool:
        """Whether it varies little within runs, compared with its range over all runs, or moves in steps.

        For points at rest: whether it has few different values.
        """
        if self.points:
            return all(levels(v[np.isfinite(v)]) is not None for v in self.values.values())
        total_span = span(self.samples)
        run_span = max(map(span, self.values.values()))
        if total_span == 0.0 or run_span <= IMPOSED_RANGE * total_span:
            return True
        return all(is_held(v) or is_constant(v) for v in self.values.values())

    @cached_property
    def moves(self) -> bool:
        """Whether it is more than noise about one value."""
        if self.points:
            return span(self.samples) > 0.0
        return not all(is_constant(v) for v in self.values.values())

    @cached_property
    def is_complete(self) -> bool:
        """Whether it has almost all samples, as an input must have."""
        return self.logged_on_change or float(np.mean(np.isnan(self.samples))) <= EMPTY_SHARE

    def of(self, kind: str, *roles: str) -> bool:
        """Whether it is of a kind, with just these roles."""
        return self.meaning == meant(kind, *roles)

    def taken_as(self, unit: str) -> RecordedColumn:
        """The column with a unit that its numbers suggest; "": they are shares of one."""
        taken = unit or "shares of one"
        why = f"{NO_UNIT}; numbers up to {self.largest:.4g} are taken as {taken}"
        return self.because(why, unit=unit)

    def because(self, why: str, **changes: object) -> RecordedColumn:
        """The column with changes, and why."""
        return replace(self, why=(*self.why, why), **changes)  # type: ignore[arg-type]


def names_in(formula: str) -> set[str]:
    """The columns that a formula reads: quantities stand in double quotes, names bare or in single ones."""
    return {quoted or bare for quoted, bare in _NAME.findall(re.sub(r'"[^"]*"', "", formula))}


def find_columns(
    sources: Sequence[Source], stated: Collection[str], formulas: Iterable[str], headings: Headings
) -> list[RecordedColumn]:
    """Every column of numbers with its meaning.

    Args:
        sources: recordings.
        stated: names of columns that the user assigns, whatever their words are.
        formulas: texts that the user states; columns in them may have any unit.
        headings: by which they are read.

    Raises:
        InputError: an unknown unit, or one that contradicts the name; too many columns.
    """
    names = dict.fromkeys(name for source in sources for name in source.table.columns)
    if len(names) > _MOST:
        message = f"{len(names)} columns are too many to recognise"
        hint = f"leave out those that are not needed, down to {_MOST}"
        raise InputError(f"{message}; {hint}", sources[-1].file)
    in_formulas = {name for formula in formulas for name in names_in(formula)}
    columns = _valves(_supply([_found(name, sources, headings) for name in names]), stated)
    if any(c.of("time") for c in columns):
        columns = [_kept(c) for c in columns]
    _check_alike([c for c in columns if c.name not in stated], sources)
    return [_checked(c, sources, stated, in_formulas, headings) for c in columns]


def _checked(
    column: RecordedColumn,
    sources: Sequence[Source],
    stated: Collection[str],
    in_formulas: Collection[str],
    headings: Headings,
) -> RecordedColumn:
    """The column, without a meaning where its unit lacks or contradicts it and a formula of the user reads it.

    Raises:
        InputError: no formula reads it.
    """
    wrong = _lacking_unit(column, headings)
    if not wrong and (column.name in in_formulas or column.name not in stated):
        wrong = _contradiction(column, headings)
    if wrong and column.name not in in_formulas:
        source = sources[min(column.places)]
        raise InputError(wrong, source.file, source.table.header_line, column.name)
    return replace(column, meaning=UNKNOWN) if wrong else column


def _found(name: str, sources: Sequence[Source], headings: Headings) -> RecordedColumn:
    places = {i: s.table.columns[name] for i, s in enumerate(sources) if name in s.table.columns}
    first = next(iter(places.values()))
    for i, other in places.items():
        if other.unit != first.unit:
            there = f"{shown(first.unit)} in {sources[min(places)].file.name}"
            message = (
                f"its unit is {there} and {shown(other.unit)} here; draft data sets of their own"
            )
            raise InputError(message, sources[i].file, None, name)
    reading = headings.read(name, first.unit)
    recorded = RecordedColumn(
        name,
        reading.unit,
        reading.written,
        reading.meaning,
        {i: column.values for i, column in places.items() if np.isfinite(column.values).any()},
        unknown=reading.unknown,
        absolute=reading.absolute,
        known_share=reading.known_share,
        places=places,
    )
    if not recorded.values:
        rows = sum(len(column.values) for column in places.values())
        return recorded.because(f"it has no value in any of {rows} rows", meaning=UNKNOWN)
    if UNNAMED.fullmatch(name):
        return recorded.because("it has no name, as an index of rows", meaning=UNKNOWN)
    words = next((w for s in sources if (w := s.words.get(name) or s.words.get(first.heading))), ())
    if words:
        return replace(recorded, meaning=Meaning("direction"), words=words, unit="", stated=True)
    if not recorded.meaning:
        return recorded
    if reading.known_share == 0.0:
        recorded = recorded.because(f"its unit is {reading.unit}")
    if recorded.unknown and recorded.kind not in ("command", "ratio"):
        return recorded
    if not reading.unit:
        return with_usual_unit(recorded, headings)
    return recorded if recorded.stated else recorded.because(f"unit {reading.unit} by its name")


def with_usual_unit(column: RecordedColumn, headings: Headings) -> RecordedColumn:
    """A column without a unit, which its numbers suggest."""
    two_values = is_switch(column.samples)
    is_share = headings.usual_unit("command", column.largest) is not None
    if column.kind == "current" and two_values and is_share:
        meaning = Meaning("command", column.meaning.roles)
        column = column.because("it has two values", meaning=meaning)
    if column.kind == "time":
        return column
    if column.kind in ("voltage", "angle"):
        return replace(column, meaning=UNKNOWN)
    if column.meaning == PRESSURE and two_values:
        return column.because("it has two values, as a switch has", meaning=UNKNOWN)
    unit = headings.usual_unit(str(column.meaning), column.largest)
    if unit is None:
        return replace(column, unknown="counts") if column.kind == "command" else column
    if not unit and two_values and column.largest == 1.0:
        return column  # nothing to guess
    return column.taken_as(unit)


def _lacking_unit(column: RecordedColumn, headings: Headings) -> str:
    """The message on a column whose unit is unknown and whose numbers need one; "" where they do not.

    A command that is on or off needs none, nor do counts and directions.
    """
    is_share = column.kind in ("command", "ratio")
    counts = headings.is_count(column.unknown)
    if (
        not column.unknown
        or column.unit
        or column.kind in ("", "count", "direction")
        or (is_share and not counts)
    ):
        return ""
    left_out = f"or leave it out: --recording 'ignore={column.name}'"
    signal, step = _SCALES.get(column.kind, ("x", "0.02 mm"))
    signal = "u_out" if "exhaust" in column.meaning.roles else signal
    scaled = f"scale it, as in --column {scaling(signal, column.name, step)}"
    if counts:
        return f"the size of its {column.unknown} is not stated; {scaled}, {left_out}"
    correct = "correct it in the file"
    if headings.scaled_unit(column.name) != column.unknown:
        return f"unit {shown(column.unknown)} is unknown; {correct}, {left_out}"
    more = "" if column.kind == "time" else f"{scaled}, "
    return f"its unit {shown(column.unknown)} has a factor, which is not read; {correct}, {more}{left_out}"


def scaling(signal: str, name: str, step: str, less: str = "") -> str:
    """A formula that scales a column, as a word of a command."""
    term = name if name.isidentifier() else f"'{name}'"
    formula = f'{signal}={f"({term}{less})" if less else term} * "{step}"'
    return f"'{formula}'" if term == name else '"' + formula.replace('"', '\\"') + '"'


def _contradiction(column: RecordedColumn, headings: Headings) -> str:
    """The message on a column whose unit contradicts its name; "" where they agree."""
    unit = headings.known_unit(column.written_unit)
    contradiction = headings.contradiction(column.name, unit) if unit and column.values else ""
    if not contradiction:
        return ""
    scaled = scaling("p", column.name, "0.5 bar/mA", ' - "4 mA"')
    scale = f"scale the signal, as in --column {scaled}, " if headings.fits(unit, "current") else ""
    hint = f"--recording 'ignore={column.name}', or state what it is: --column NAME={shown(column.name)}"
    return f"{contradiction}; correct the heading, {scale}leave it out: {hint}"


def _check_alike(columns: Sequence[RecordedColumn], sources: Sequence[Source]) -> None:
    """Raises InputError where recordings call the same quantity by different names: one would be lost."""
    for first, second in permutations(columns, 2):
        alike = first.kind not in ("", "time") and first.meaning == second.meaning
        if alike and first.values.keys().isdisjoint(second.values):
            there, here = (sources[min(c.values)].file for c in (first, second))
            message = f"{there.name} calls the {first.meaning} {shown(first.name)}"
            raise InputError(
                f"{message}; files of one kind are drafted together", here, None, second.name
            )


def _supply(columns: list[RecordedColumn]) -> list[RecordedColumn]:
    """Which pressure is the supply's, where words leave it open.

    Of two that are called so and no other, as of a tank and a source, the one that moves more is what is filled; one
    alone is, where it is not steady. Of two of which none is called so, the one that stays above the other supplies it,
    and one that steps and is followed by the other is its set point.
    """
    supplies = [c for c in columns if c.of("pressure", "supply")]
    plain = [c for c in columns if c.of("pressure")]
    if supplies and not plain and not any(c.meaning == SET_PRESSURE for c in columns):
        largest = max(supplies, key=lambda c: span(c.samples))
        if len(supplies) > 1 or not _varies_little(largest.samples):
            return _with_meaning(
                columns, largest, PRESSURE, "no other pressure was recorded that moves so"
            )
    if len(plain) != 2 or supplies or plain[0].values.keys() != plain[1].values.keys():
        return columns
    for first, second in permutations(plain):
        if not first.unit or first.unit != second.unit:
            continue
        if _feeds(first.samples, second.samples):
            why = f"it stays above '{second.name}' and varies little"
            return _with_meaning(columns, first, meant("pressure", "supply"), why)
        if _leads(first, second):
            why = f"it steps and stays, and '{second.name}' follows it"
            return _with_meaning(columns, first, SET_PRESSURE, why)
    return columns


def _with_meaning(
    columns: Sequence[RecordedColumn], column: RecordedColumn, meaning: Meaning, why: str
) -> list[RecordedColumn]:
    """The columns, of which one means something else."""
    return [c.because(why, meaning=meaning) if c is column else c for c in columns]


def _leads(first: RecordedColumn, second: RecordedColumn) -> bool:
    """Whether a pressure without noise moves in steps, and another one with noise follows it."""
    steps = all(is_held(v) and is_repeated(v) for v in first.values.values())
    follows = correlation(first.values, second.values) > LEAST_CORRELATION
    return steps and follows and not all(map(is_repeated, second.values.values()))


def _feeds(first: Array, second: Array) -> bool:
    """Whether one pressure stays above another and varies little."""
    steady = float(np.nanmin(first)) > 0.0 and _varies_little(first)
    mostly_above = float(np.mean(first >= second)) > CRITERIA.noise.stepwise
    return steady and mostly_above and span(second) > span(first)


def _varies_little(values: Array) -> bool:
    """Whether values span a small part of their mean; those of an empty column do."""
    present = values[np.isfinite(values)]
    return not present.size or span(present) < _SUPPLY_RANGE * float(np.mean(present))


def _valves(columns: list[RecordedColumn], stated: Collection[str]) -> list[RecordedColumn]:
    """Of two unnamed signals of valves, the first is the inlet's; a single one is too."""
    columns = _signed(columns, stated)
    for kind in ("current", "command"):
        of_kind = [c for c in columns if c.kind == kind]
        taken = frozenset[str]().union(*(c.meaning.roles for c in of_kind))
        free = [role for role in ("inlet", "exhaust") if role not in taken]
        plain = [c for c in of_kind if not c.meaning.roles] if len(of_kind) <= 2 else []
        for column, role in zip(plain, free, strict=False):
            which = "the first of two" if role == "inlet" else "the other one is not"
            why = f"the {role} valve's, as {which}"
            if len(of_kind) == 1:
                why = "the only one: the inlet valve's"
            columns = _with_meaning(columns, column, meant(kind, role), why)
    return columns


def _signed(columns: list[RecordedColumn], stated: Collection[str]) -> list[RecordedColumn]:
    """The columns, of which one that is above and below zero as the pressure rises and falls commands two valves."""
    pressure = next((c for c in columns if c.of("pressure")), None)
    driving = [c for c in columns if c.kind in ("current", "command")]
    rivals = driving or [c for c in columns if not (c.kind or c.unit or UNNAMED.fullmatch(c.name))]
    if pressure is None or len(driving) > 1 or any("set" in c.meaning.roles for c in columns):
        return columns
    change = {i: np.gradient(values) for i, values in pressure.values.items() if len(values) > 2}
    for column in (c for c in rivals if c.name not in stated):
        low, high = np.nanmin(column.samples, initial=0.0), np.nanmax(column.samples, initial=0.0)
        is_signed = -low > IMPOSED_RANGE * high > 0.0 and high > IMPOSED_RANGE * -low
        if is_signed and correlation(column.values, change) > _LEAST_SIGNED:
            halves = [_half(column, *half) for half in _HALVES]
            return [half for c in columns for half in (halves if c is column else [c])]
    return columns


def _half(
    column: RecordedColumn, role: str, sign: int, plus: str, moves: str, side: str
) -> RecordedColumn:
    """The part of a signed command that is one valve's."""
    return column.because(
        f"one command drives both valves: the pressure {moves} where it is {side} zero",
        meaning=meant(column.kind or "command", role),
        values={i: np.clip(sign * v, 0.0, None) for i, v in column.values.items()},
        formula=f"(abs('{column.name}') {plus} '{column.name}') / 2",
    )


def _kept(column: RecordedColumn) -> RecordedColumn:
    """A set point or a command that a logger writes only when it changes, with its value in every row."""
    is_set = column.kind in ("command", "current") or "set" in column.meaning.roles
    if not is_set or column.is_complete:
        return column
    empty = int(np.isnan(column.samples).sum())
    why = f"{empty} of {len(column.samples)} cells are empty: it keeps the value above"
    values = {i: filled_forward(samples) for i, samples in column.values.items()}
    return column.because(why, values=values, logged_on_change=True)


# ---- tables of points at rest ----------------------------------------------------------------------------------------


def as_points(columns: Sequence[RecordedColumn]) -> list[RecordedColumn]:
    """The columns of points at rest: a pressure was reached, a mass was hung on, a length that stays is at rest."""
    result = [replace(c, points=True) for c in columns]
    varying = [c.name for c in result if c.kind in ("contraction", "ratio")]
    for column in result if varying else ():
        if column.of("length") and not any(map(span, column.values.values())):
            why = f"it does not change, and '{varying[0]}' does"
            result = _with_meaning(result, column, AT_REST, why)
    for other, wanted, why in (
        (SET_PRESSURE, PRESSURE, "a set point, taken as reached"),
        (meant("mass"), meant("force"), "the load of each row"),
    ):
        serving = [c for c in result if c.meaning == other and c.unit]
        for column in serving if not any(c.meaning == wanted for c in result) else ():
            result = _with_meaning(result, column, wanted, why)
    return result
