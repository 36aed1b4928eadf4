"""The sign of a contraction or a force, by the numbers that were recorded."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.column_statistics import LEAST_CORRELATION, correlation
from pam_cosim.drafting.feeding import BenchChoice, meaning_of
from pam_cosim.drafting.mapped import ColumnEntry
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.scaling import scaled_entry
from pam_cosim.model.interface import Variable


def signed_entry(
    entry: ColumnEntry,
    values: dict[int, Array],
    choice: BenchChoice,
    variable: Variable,
    pressure: Mapping[int, Array] | None,
    force: Mapping[int, Array] | None,
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction that falls while the pressure rises counts the other way, as does a pull below zero.

    A contraction that is imposed, and that no pressure moves, counts the other way where the pull, at equal pressure,
    rises with it: a muscle that is shorter pulls less, but against a spring more. A length says itself which way it
    counts: what is made of one stays.
    """
    meaning = meaning_of(variable)
    column = choice.fed[entry.name]
    if meaning is None or column.of("length"):
        return entry, values
    why = ""
    if meaning.kind == "contraction" and pressure is not None:
        pull = force if variable.name in choice.inputs else None
        why = _why_reversed(values, pressure, pull)
    elif meaning.kind == "force" and _mostly_negative(np.concatenate(list(values.values()))):
        why = "it is below zero: its sign is turned round, so that a pull is positive"
    if not why:
        return entry, values
    turned = _turned(replace(entry, why=(*entry.why, why)), column)
    return turned, {i: -v for i, v in values.items()}


def _why_reversed(
    values: Mapping[int, Array], pressure: Mapping[int, Array], pull: Mapping[int, Array] | None
) -> str:
    """Why a contraction counts the other way; "" where it does not. The pull is asked where no pressure moves it."""
    together = correlation(pressure, values)
    if together < -LEAST_CORRELATION:
        return "it falls where the pressure rises: its sign is turned round"
    is_moved = together > LEAST_CORRELATION
    if pull is None or is_moved or _at_equal(pressure, pull, values) <= LEAST_CORRELATION:
        return ""
    return "the pull rises with it at equal pressure: its sign is turned round"


def _at_equal(
    third: Mapping[int, Array], one: Mapping[int, Array], other: Mapping[int, Array]
) -> float:
    """Partial correlation of two signals, without what each has in common with a third."""
    both = correlation(one, other)
    with_one, with_other = correlation(third, one), correlation(third, other)
    rest = (1.0 - with_one**2) * (1.0 - with_other**2)
    return (both - with_one * with_other) / sqrt(rest) if rest > 0.0 else 0.0


def _turned(entry: ColumnEntry, column: RecordedColumn) -> ColumnEntry:
    """The entry that gives the same numbers with the other sign."""
    if entry.held:
        return replace(entry, held={i: -value for i, value in entry.held.items()})
    if entry.formula is not None:
        return replace(entry, formula=f"-({entry.formula})")
    if entry.gain is not None:
        offset = entry.offset and _negated(entry.offset)
        return replace(entry, gain=_negated(entry.gain), offset=offset)
    return scaled_entry(entry.name, column, "-1", None, entry.why)


def _negated(quantity: str) -> str:
    return quantity.removeprefix("-") if quantity.startswith("-") else f"-{quantity}"


def _mostly_negative(values: Array) -> bool:
    """Whether values are below zero on average, and farther below than above."""
    lowest, highest = float(np.nanmin(values)), float(np.nanmax(values))
    return float(np.nanmean(values)) < 0.0 and abs(lowest) > abs(highest)
