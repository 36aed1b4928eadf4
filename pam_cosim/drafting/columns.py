"""The columns of all recordings, and the evidence of what each is: its words, its unit, what its numbers look like."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.headings import (
    AT_REST,
    Headings,
    Meaning,
    is_count,
    known_unit,
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
from pam_cosim.wording import shown

# of the range of all runs: a column that moves less within a run is constant there
IMPOSED_RANGE = 0.2
NO_UNIT = "no unit is written"
UNNAMED = re.compile(r"column \d+|unnamed:.*", re.IGNORECASE)
_SUPPLY_RANGE = 0.3  # of its mean, by which a supply pressure varies at most
_LARGEST_COMMAND = 120.0  # [%]; more is in steps of a converter
_LEAST_SIGNED = 0.3  # correlation of a command of two valves with the change of the pressure
_MOST = 400  # columns; each is held against each
_REFERABLE = re.compile(r"[^'\\\n]+")
_NAME = re.compile(r"'([^']*)'|([A-Za-z_]\w*)", re.ASCII)
_SCALES = {"force": ("F", "0.1 N"), "pressure": ("p", "0.1 kPa"), "command": ("u_in", "0.004")}
"""By kind, how a column in counts may be scaled: a name and the size of a count."""


@dataclass(frozen=True)
class RecordedColumn:
    """A column of that name in every recording that has it.

    Attributes:
        unit: as the registry of units has it; stated in the file, or guessed.
        stated: the file states it so that it can be read.
        unknown: the unit that the file states, where it is unknown; else "".
        meaning: None: unknown.
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
    meaning: Meaning | None
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
        return self.meaning.kind if self.meaning else ""

    @property
    def readable(self) -> bool:
        """Whether a formula can contain the column: by its name, and by its unit in the files, if there is one."""
        written = any(column.unit.strip() for column in self.places.values())
        return bool(_REFERABLE.fullmatch(self.name)) and (self.stated or not written)

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

    def because(self, why: str, **changes: object) -> RecordedColumn:
        """The column with changes, and why."""
        return replace(self, why=(*self.why, why), **changes)  # type: ignore[arg-type]


def names_in(formula: str) -> set[str]:
    """The columns that a formula reads: quantities stand in double quotes, names bare or in single ones."""
    return {quoted or bare for quoted, bare in _NAME.findall(re.sub(r'"[^"]*"', "", formula))}


def find_columns(
    sources: Sequence[Source], stated: Iterable[str], formulas: Iterable[str], headings: Headings
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
        message = (
            f"{len(names)} columns are too many to recognise; leave out those that are not needed"
        )
        raise InputError(f"{message}, down to {_MOST}", sources[-1].file)
    columns = [_found(name, sources, headings) for name in names]
    stated, in_formulas = {*stated}, {name for formula in formulas for name in names_in(formula)}
    columns = _valves(_supply(columns), stated)
    if any(c.of("time") for c in columns):
        columns = [_kept(c) if _is_logged_on_change(c) else c for c in columns]
    _check_alike([c for c in columns if c.name not in stated], sources)
    for column in columns:
        lacking = _lacks_unit(column) and column.name not in in_formulas
        wrong = _unknown(column, headings) if lacking else ""
        if not wrong and column.name not in {*stated, *in_formulas}:
            wrong = _contradicts(column, headings)
        if wrong:
            source = sources[min(column.places)]
            raise InputError(wrong, source.file, source.table.header_line, column.name)
    columns = [
        replace(c, meaning=None)
        if _lacks_unit(c) or (c.name in in_formulas and _contradicts(c, headings))
        else c
        for c in columns
    ]
    return columns


def _found(name: str, sources: Sequence[Source], headings: Headings) -> RecordedColumn:
    places = {i: s.table.columns[name] for i, s in enumerate(sources) if name in s.table.columns}
    first = next(iter(places.values()))
    if any(column.unit != first.unit for column in places.values()):
        raise _two_units(name, places, sources)
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
        return recorded.because(f"it has no value in any of {rows} rows", meaning=None)
    if UNNAMED.fullmatch(name):
        return recorded.because("it has no name, as an index of rows", meaning=None)
    words = next((w for s in sources if (w := s.words.get(name) or s.words.get(first.heading))), ())
    if words:
        return replace(recorded, meaning=Meaning("direction"), words=words, unit="", stated=True)
    if recorded.meaning is None:
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
    assert column.meaning is not None
    if (
        column.kind == "current"
        and is_switch(column.samples)
        and column.largest <= _LARGEST_COMMAND
    ):
        column = column.because(
            "it has two values", meaning=Meaning("command", column.meaning.roles)
        )
    if column.kind == "time":
        return column
    if column.kind in ("voltage", "angle"):
        return replace(column, meaning=None)
    if column.of("pressure") and is_switch(column.samples):
        return column.because("it has two values, as a switch has", meaning=None)
    unit = headings.usual_unit(str(column.meaning), column.largest)
    if unit is None:
        is_command = column.kind == "command" and column.largest > _LARGEST_COMMAND
        return replace(column, unknown="counts") if is_command else column
    if not unit and is_switch(column.samples) and column.largest == 1.0:
        return column  # nothing to guess
    taken = unit or "shares of one"
    return column.because(
        f"{NO_UNIT}; numbers up to {column.largest:.4g} are taken as {taken}", unit=unit
    )


def _two_units(name: str, places: Mapping[int, Column], sources: Sequence[Source]) -> InputError:
    first = min(places)
    other = next(i for i, column in places.items() if column.unit != places[first].unit)
    there, here = (shown(places[i].unit) for i in (first, other))
    message = f"its unit is {there} in {sources[first].file.name} and {here} here"
    return InputError(f"{message}; draft data sets of their own", sources[other].file, None, name)


def _lacks_unit(column: RecordedColumn) -> bool:
    """Whether the unit that is written is none, and its numbers need one: a command that is on or off needs none."""
    if not column.unknown or column.unit or column.meaning is None:
        return False
    shares = is_count(column.unknown) if column.kind in ("command", "ratio") else True
    return shares and column.kind not in ("count", "direction")


def _unknown(column: RecordedColumn, headings: Headings) -> str:
    left_out = f"or leave it out: --recording 'ignore={column.name}'"
    signal, step = _SCALES.get(column.kind, ("x", "0.02 mm"))
    if column.meaning is not None and "exhaust" in column.meaning.roles:
        signal = "u_out"
    scaled = f"scale it, as in --column {scaling(signal, column.name, step)}"
    if is_count(column.unknown):
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


def _contradicts(column: RecordedColumn, headings: Headings) -> str:
    """The message on a column whose unit contradicts its name; "" where they agree."""
    written = next((place.unit for place in column.places.values()), "")
    unit = known_unit(written)
    contradiction = headings.contradiction(column.name, unit) if unit and column.values else ""
    if not contradiction:
        return ""
    scaled = scaling("p", column.name, "0.5 bar/mA", ' - "4 mA"')
    scale = f"scale the signal, as in --column {scaled}, " if headings.fits(unit, "current") else ""
    hint = f"--recording 'ignore={column.name}', or state what it is: --column NAME={shown(column.name)}"
    return f"{contradiction}; correct the heading, {scale}leave it out: {hint}"


def _check_alike(columns: Sequence[RecordedColumn], sources: Sequence[Source]) -> None:
    """Raises InputError where recordings call the same quantity by different names: one would be lost."""
    for first in columns:
        for second in columns:
            alike = first.kind not in ("", "time") and first.meaning == second.meaning
            if alike and not first.values.keys() & second.values.keys():
                there, here = sources[min(first.values)].file.name, sources[min(second.values)].file
                message = f"{there} calls the {first.meaning} {shown(first.name)}"
                message = f"{message}; files of one kind are drafted together"
                raise InputError(message, here, None, second.name)


def _supply(columns: list[RecordedColumn]) -> list[RecordedColumn]:
    """Which pressure is the supply's, where words leave it open.

    Of two that are called so and no other, as of a tank and a source, the one that moves more is what is filled; one
    alone is, where it is not steady. Of two of which none is called so, the one that stays above the other supplies it,
    and one that steps and is followed by the other is its set point.
    """
    supplies = [c for c in columns if c.of("pressure", "supply")]
    plain = [c for c in columns if c.of("pressure")]
    if supplies and not plain and not any(c.of("pressure", "set") for c in columns):
        largest = max(supplies, key=lambda c: span(c.samples))
        if len(supplies) > 1 or not _varies_little(largest.samples):
            why = "no other pressure was recorded that moves so"
            return [
                c.because(why, meaning=meant("pressure")) if c is largest else c for c in columns
            ]
    if len(plain) != 2 or supplies or plain[0].values.keys() != plain[1].values.keys():
        return columns
    for first, second in (plain, plain[::-1]):
        role = why = ""
        if first.unit and first.unit == second.unit and _feeds(first.samples, second.samples):
            role, why = "supply", f"it stays above '{second.name}' and varies little"
        elif first.unit and first.unit == second.unit and _leads(first, second):
            role, why = "set", f"it steps and stays, and '{second.name}' follows it"
        if role:
            changed = first.because(why, meaning=meant("pressure", role))
            return [changed if c is first else c for c in columns]
    return columns


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


def _valves(columns: list[RecordedColumn], stated: set[str]) -> list[RecordedColumn]:
    """Of two unnamed signals of valves, the first is the inlet's; a single one is too."""
    columns = _signed(columns, stated)
    for kind in ("current", "command"):
        of_kind = [c for c in columns if c.kind == kind and c.meaning is not None]
        if len(of_kind) > 2:
            continue
        taken = {role for c in of_kind if c.meaning for role in c.meaning.roles}
        free_roles = [role for role in ("inlet", "exhaust") if role not in taken]
        plain = [c.name for c in of_kind if c.meaning and not c.meaning.roles]
        roles, alone = dict(zip(plain, free_roles, strict=False)), len(of_kind) == 1
        columns = [
            c.because(_why_valve(roles[c.name], alone), meaning=meant(kind, roles[c.name]))
            if c.name in roles and c.kind == kind
            else c
            for c in columns
        ]
    return columns


def _why_valve(role: str, alone: bool) -> str:
    if alone:
        return "the only one: the inlet valve's"
    return (
        f"the {role} valve's, as the first of two"
        if role == "inlet"
        else f"the {role} valve's, as the other one is not"
    )


def _signed(columns: list[RecordedColumn], stated: set[str]) -> list[RecordedColumn]:
    """The columns, of which one that is above and below zero as the pressure rises and falls commands two valves."""
    pressure = next((c for c in columns if c.of("pressure")), None)
    driving = [c for c in columns if c.kind in ("current", "command")]
    rivals = driving or [
        c for c in columns if c.meaning is None and not c.unit and not UNNAMED.fullmatch(c.name)
    ]
    if (
        pressure is None
        or len(driving) > 1
        or any("set" in c.meaning.roles for c in columns if c.meaning)
    ):
        return columns
    change = {i: np.gradient(values) for i, values in pressure.values.items() if len(values) > 2}
    for column in (c for c in rivals if c.name not in stated):
        low, high = np.nanmin(column.samples, initial=0.0), np.nanmax(column.samples, initial=0.0)
        is_signed = -low > IMPOSED_RANGE * high > 0.0 and high > IMPOSED_RANGE * -low
        if is_signed and correlation(column.values, change) > _LEAST_SIGNED:
            halves = [_half(column, role, sign) for role, sign in (("inlet", 1), ("exhaust", -1))]
            return [half for c in columns for half in (halves if c is column else [c])]
    return columns


def _half(column: RecordedColumn, role: str, sign: int) -> RecordedColumn:
    """The part of a signed command that is one valve's."""
    values = {i: np.clip(sign * v, 0.0, None) for i, v in column.values.items()}
    formula = f"(abs('{column.name}') {'+' if sign > 0 else '-'} '{column.name}') / 2"
    why = f"the pressure {'rises' if sign > 0 else 'falls'} where it is {'above' if sign > 0 else 'below'} zero"
    kind = column.kind or "command"
    return column.because(
        f"one command drives both valves: {why}",
        meaning=meant(kind, role),
        values=values,
        formula=formula,
    )


def _is_logged_on_change(column: RecordedColumn) -> bool:
    """Whether somebody sets it, and most likely no slip left the cells empty."""
    if column.meaning is None or column.is_complete:
        return False
    return column.kind in ("command", "current") or "set" in column.meaning.roles


def _kept(column: RecordedColumn) -> RecordedColumn:
    """A set point or a command that a logger writes only when it changes, with its value in every row."""
    empty = int(np.isnan(column.samples).sum())
    why = f"{empty} of {len(column.samples)} cells are empty: it keeps the value above"
    values = {i: filled_forward(samples) for i, samples in column.values.items()}
    return column.because(why, values=values, logged_on_change=True)


# ---- tables of points at rest ----------------------------------------------------------------------------------------


def as_points(columns: Sequence[RecordedColumn]) -> list[RecordedColumn]:
    """The columns of points at rest: a pressure was reached, a mass was hung on, a length that stays is at rest."""
    result = [replace(c, points=True) for c in columns]
    varying = next((c for c in result if c.kind in ("contraction", "ratio")), None)
    if varying is not None:
        why = f"it does not change, and '{varying.name}' does"
        result = [
            c.because(why, meaning=AT_REST)
            if c.of("length") and all(span(values) == 0.0 for values in c.values.values())
            else c
            for c in result
        ]
    result = _instead(
        result, meant("pressure", "set"), meant("pressure"), "a set point, taken as reached"
    )
    return _instead(result, meant("mass"), meant("force"), "the load of each row")


def _instead(
    columns: list[RecordedColumn], other: Meaning, wanted: Meaning, why: str
) -> list[RecordedColumn]:
    """The columns, of which one that means another thing serves where none means what is wanted."""
    if any(c.meaning == wanted for c in columns):
        return columns
    return [c.because(why, meaning=wanted) if c.meaning == other and c.unit else c for c in columns]
