"""Tables with one quantity along the top, such as a column of forces for each pressure, with a row for each point."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.drafting.file_names import said_in
from pam_cosim.drafting.sources import read_sources
from pam_cosim.drafting.vocabulary import (
    direction_word,
    folded,
    kinds_of,
    read_heading,
    split_words,
)
from pam_cosim.drafting.words import LENGTHS
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.table import Column, Table

_NAMES = {"pressure": "p", "force": "F", "contraction": "x", "ratio": "eps", "length": "L"}
_KEYS = ("pressure", "force", "contraction", "ratio")


@dataclass(frozen=True)
class _Top:
    """A column of one value of what stands along the top: a direction, or a number with a unit.

    Attributes:
        said: what else its name says, of the numbers below.
    """

    column: Column
    key: str
    unit: str
    text: str
    said: str
    kind: str | None
    value_unit: str


def tidied(file: Path, folder: Path, stated: RecordingTable) -> Path:
    """The file; of a table with a quantity along the top, another one in ``folder`` with a row for each point.

    What cannot be read is left as it is: the fault is told where the file is read.
    """
    try:
        (source,) = read_sources([file], stated)
    except InputError:
        return file
    table = source.table
    found = {
        name: top for name, column in table.columns.items() if (top := _top(column)) is not None
    }
    rest = [column for name, column in table.columns.items() if name not in found]
    kinds = [
        meaning.kind for c in rest if (meaning := read_heading(c.name, c.unit).meaning) is not None
    ]
    tops = _filled(list(found.values()))
    if "time" in kinds or not rest or source.words or not _alike(tops):
        return file
    kind = tops[0].kind or _missing(tops[0].key, kinds)
    if kind not in _NAMES or kind == tops[0].key:
        return file
    made = folder / f"{file.stem}.csv"
    made.write_text(_long(table, rest, tops, kind), encoding="utf-8", newline="\n")
    return made


def _top(column: Column) -> _Top | None:
    """What a column is along the top by its name: "F@100kPa", "2 bar", "x up [mm]"; None: it says neither."""
    said = [one for one in said_in(column.heading.partition("[")[0]) if one.kind in _KEYS]
    ways = [word for word in split_words(column.name) if len(word) > 1 and _is_way(word)]
    if len(said) == 1:
        text, key, unit = said[0].text, said[0].kind, said[0].unit
        value = f"{said[0].value:.9g}"
    elif len(ways) == 1:
        text, key, unit, value = (
            ways[0],
            "direction",
            "",
            "up" if direction_word(ways[0]) > 0 else "down",
        )
    else:
        return None
    left = column.heading.partition("[")[0].replace(text, " ").strip(" @_-=,;:")
    reading = read_heading(left, column.unit if column.unit != unit else "")
    kind = reading.meaning.kind if reading.meaning else None
    return _Top(column, key, unit, value, left, kind, reading.unit or reading.unknown)


def _filled(tops: Sequence[_Top]) -> list[_Top]:
    """The columns, of which those that say nothing but their value are of what the one before says."""
    made: list[_Top] = []
    for top in tops:
        before = made[-1] if made and not (top.said or top.value_unit) else top
        made.append(replace(top, kind=before.kind, value_unit=before.value_unit))
    return made


def _is_way(word: str) -> bool:
    """Whether a word says a direction and no quantity, as "contraction" and "load" do."""
    return bool(direction_word(word)) and not {*kinds_of(folded(word))} - {"direction"}


def _alike(tops: Sequence[_Top]) -> bool:
    """Whether there are several, of one quantity each along the top and below, and no value twice."""
    return (
        len(tops) > 1
        and len({(t.key, t.unit, t.kind, t.value_unit) for t in tops}) == 1
        and len({t.text for t in tops}) == len(tops)
    )


def _missing(key: str, kinds: Sequence[str]) -> str | None:
    """What the numbers are, of a pressure, a contraction and a force, where the other two are known."""
    known = {"contraction" if kind in LENGTHS else kind for kind in (key, *kinds)}
    left = [kind for kind in ("pressure", "contraction", "force") if kind not in known]
    return left[0] if len(left) == 1 else None


def _long(table: Table, rest: Sequence[Column], tops: Sequence[_Top], kind: str) -> str:
    """The table as text: the other columns, what stood along the top, and the numbers below it, in the unit written."""
    unit = f" [{tops[0].value_unit}]" if tops[0].value_unit else ""
    key = "direction" if tops[0].key == "direction" else f"{_NAMES[tops[0].key]} [{tops[0].unit}]"
    heads = [_quoted(c.heading or c.name) for c in rest]
    lines = [",".join([*heads, key, f"{_NAMES[kind]}{unit}"])]
    for top in tops:
        for row, value in enumerate(top.column.values):
            cells = [_cell(c.values[row]) for c in rest]
            lines.append(",".join([*cells, top.text, _cell(value)]))
    return "\n".join(lines) + "\n"


def _cell(value: float) -> str:
    return "" if np.isnan(value) else f"{value:.9g}"


def _quoted(heading: str) -> str:
    return '"' + heading.replace('"', '""') + '"'
