"""Which way a muscle went at each point at rest: by a column that says so, or by the order of the rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.column_statistics import LEAST_CORRELATION
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.vocabulary import direction_word, split_words
from pam_cosim.measurement.curves import ROWS_PER_CURVE, directions
from pam_cosim.measurement.points import CONTRACTS

# What a contracting muscle does to a quantity, most telling first: what is imposed as a rule comes first.
_TELLING = (
    ("pressure", 1.0),
    ("contraction", 1.0),
    ("ratio", 1.0),
    ("length", -1.0),
    ("force", -1.0),
)
SENSES = {1: "up", -1: "down", 0: "none"}
"""Directions as ``experiment.toml`` has them."""


def with_directions(columns: Sequence[RecordedColumn]) -> list[RecordedColumn]:
    """The columns, of which those of a direction say which of their values is which way."""
    return [_with_directions(c, columns) if c.of("direction") else c for c in columns]


def _with_directions(column: RecordedColumn, columns: Sequence[RecordedColumn]) -> RecordedColumn:
    """A column of directions with the way that each of its values means; none, where it has more than three."""
    values = [float(v) for v in np.unique(column.every[np.isfinite(column.every)])]
    if len(values) > 3:
        return replace(column, meaning=None)
    for kind, sign in _TELLING:
        other = next((c for c in columns if c.of(kind)), None)
        if other is None:
            continue
        senses = {v: _sign(sign * _trend(column, other, v)) for v in values}
        if {1, -1} <= set(senses.values()):
            verb = "rises" if sign > 0 else "falls"
            up = next(v for v, sense in senses.items() if sense == 1)
            return replace(
                column,
                senses=senses,
                why=(f"'{other.name}' {verb} where it is {column.text_of(up)}",),
            )
    if column.words:
        said = {v: direction_word(column.words[int(v)]) for v in values}
        return replace(column, senses=said, why=("its words say so",))
    return replace(column, senses=_by_size(values), why=("the larger is taken for up",))


def _trend(column: RecordedColumn, other: RecordedColumn, value: float) -> float:
    """Share of the change of another column that is a rise, less that of falls, between rows of one value."""
    steps = [np.empty(0)]
    for i, own in column.values.items():
        if i in other.values:
            both = (own[1:] == value) & (own[:-1] == value)
            steps.append(np.diff(other.values[i])[both])
    change = np.concatenate(steps)
    change = change[np.isfinite(change)]
    whole = float(np.sum(np.abs(change)))
    return float(np.sum(change)) / whole if whole else 0.0


def _sign(trend: float) -> int:
    return 0 if abs(trend) < LEAST_CORRELATION else 1 if trend > 0 else -1


def _by_size(values: Sequence[float]) -> dict[float, int]:
    if len(values) < 2:
        return {v: int(np.sign(v)) for v in values}
    return {v: 1 if v == values[-1] else -1 if v == values[0] else 0 for v in values}


def words_of(column: RecordedColumn) -> dict[str, str]:
    """up, down or none by the words of a column, as ``experiment.toml`` has them."""
    return {word: SENSES[column.senses.get(float(i), 0)] for i, word in enumerate(column.words)}


def goes_up_and_down(inputs: Mapping[str, Array], units: Mapping[str, str]) -> bool:
    """Whether the rows go up and come back: then their order tells the direction of each."""
    ways, fewest = _directions_of_rows(inputs, units), ROWS_PER_CURVE
    return int(np.sum(ways > 0)) >= fewest and int(np.sum(ways < 0)) >= fewest


def order_tells_direction(inputs: Mapping[str, Array], units: Mapping[str, str]) -> bool:
    """Whether the order of the rows tells any direction."""
    return bool(_directions_of_rows(inputs, units).any())


def common_direction(inputs: Mapping[str, Array], units: Mapping[str, str]) -> int:
    """1 where all rows go one way, -1 the other way; 0: neither."""
    ways = _directions_of_rows(inputs, units)
    return 1 if bool((ways > 0).all()) else -1 if bool((ways < 0).all()) else 0


def directions_in_names(files: Sequence[Path]) -> list[str]:
    """up or down for each file, where every name says one of them, and both are said; none where they do not."""
    said = [_directions_said(file.stem) for file in files]
    if not all(len(own) == 1 for own in said) or len(set.union(*said)) != 2:
        return []
    return [SENSES[own.pop()] for own in said]


def _directions_said(stem: str) -> set[int]:
    words = [word for word in split_words(stem) if len(word) > 1]
    return {said for said in map(direction_word, words) if said}


def _directions_of_rows(inputs: Mapping[str, Array], units: Mapping[str, str]) -> Array:
    first = [name for unit in CONTRACTS for name in inputs if units[name] == unit]
    return directions(inputs, first)[0] if first else np.zeros(1)
