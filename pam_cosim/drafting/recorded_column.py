"""A column of the recordings, and what is known of it."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.column_statistics import is_constant, is_held, is_switch, span
from pam_cosim.drafting.vocabulary import Meaning, usual_unit
from pam_cosim.drafting.words import USUAL_UNITS
from pam_cosim.measurement.curves import levels
from pam_cosim.measurement.recording import EMPTY_SHARE
from pam_cosim.measurement.table import Column
from pam_cosim.wording import shown

# of the range of all runs: a column that moves less within a run is constant there
IMPOSED_RANGE = 0.2

_LARGEST_COMMAND = USUAL_UNITS["command"][-1][0]
_REFERABLE = re.compile(r"[^'\\\n]+")


@dataclass(frozen=True)
class RecordedColumn:
    """A column of that name in every recording that has it.

    Attributes:
        unit: as the registry of units has it; stated in the file, or guessed.
        stated: the file states it so that it can be read.
        unknown: the unit that the file states, where nobody knows it; else "".
        meaning: None: nobody knows.
        why: what ``meaning`` and ``unit`` were guessed from, in sentences without a subject.
        known: share of its words that are known.
        values: numbers in its unit by the number of the recording.
        points: the recordings are points at rest, whose rows have no pace.
        in_names: it stands in the names of the files, one value for each.
        words: of a direction that is told in words: what its numbers are places of.
        senses: of a direction: 1 up, -1 down, 0 neither, by its numbers.
        logged_on_change: its cells are empty in the files while it keeps its value.
    """

    name: str
    unit: str
    stated: bool
    meaning: Meaning | None
    values: dict[int, Array]
    why: tuple[str, ...] = ()
    unknown: str = ""
    absolute: bool = False
    known: float = 0.0
    places: dict[int, Column] = field(default_factory=dict)
    points: bool = False
    in_names: bool = False
    words: tuple[str, ...] = ()
    senses: dict[float, int] = field(default_factory=dict)
    logged_on_change: bool = False

    @property
    def readable(self) -> bool:
        """Whether a formula can hold it: by its name, and by the unit beside it in the files, if there is one."""
        written = any(column.unit.strip() for column in self.places.values())
        return bool(_REFERABLE.fullmatch(self.name)) and (self.stated or not written)

    @property
    def since(self) -> str:
        """The first of its dates with times of day, from which its numbers count; "" where it holds none."""
        return next((column.since for column in self.places.values()), "")

    @property
    def every(self) -> Array:
        """All its numbers."""
        return np.concatenate([*self.values.values(), np.empty(0)])

    @cached_property
    def held(self) -> bool:
        """It hardly moves within runs beside what it does between them, or steps from one value to another.

        Of points at rest, it takes few values.
        """
        if self.points:
            return all(levels(one[np.isfinite(one)]) is not None for one in self.values.values())
        whole = span(self.every)
        own = max(span(one) for one in self.values.values())
        if whole == 0.0 or own <= IMPOSED_RANGE * whole:
            return True
        return all(is_held(one) or is_constant(one) for one in self.values.values())

    @cached_property
    def moves(self) -> bool:
        """It is more than noise about one value."""
        if self.points:
            return span(self.every) > 0.0
        return not all(is_constant(one) for one in self.values.values())

    @cached_property
    def whole(self) -> bool:
        """It lacks so few samples that it may be meant as an input."""
        return self.logged_on_change or float(np.mean(np.isnan(self.every))) <= EMPTY_SHARE

    def text_of(self, value: float) -> str:
        """One of its numbers, or the word that it stands for."""
        return shown(self.words[int(value)]) if self.words else f"{value:g}"

    def of(self, kind: str, *roles: str) -> bool:
        """Whether it is of a kind, with just these roles."""
        return self.meaning == Meaning(kind, frozenset(roles))


def with_usual_unit(one: RecordedColumn) -> RecordedColumn:
    """A column without a unit, which its numbers suggest."""
    assert one.meaning is not None
    kind = one.meaning.kind
    largest = float(np.nanmax(np.abs(one.every))) if np.isfinite(one.every).any() else 0.0
    if kind == "current" and is_switch(one.every) and largest <= _LARGEST_COMMAND:
        one = replace(
            one, meaning=Meaning("command", one.meaning.roles), why=(*one.why, "it has two values")
        )
        kind = "command"
    if kind == "time":
        return one
    if kind == "voltage":
        return replace(one, meaning=None)
    if kind == "command" and largest > _LARGEST_COMMAND:
        return replace(one, unknown="counts")
    unit = usual_unit(str(one.meaning), largest) or usual_unit(kind, largest)
    if not unit and (kind not in USUAL_UNITS or (is_switch(one.every) and largest == 1.0)):
        return one  # nothing to guess
    why = f"no unit is written; numbers up to {largest:.4g} are taken as {unit or 'shares of one'}"
    return replace(one, unit=unit, why=(*one.why, why))
