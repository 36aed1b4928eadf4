"""The files of a lab as tables: numbers, words for directions, remarks, and one table for each experiment."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import ValidationError

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.headings import LENGTHS, Headings, folded, split_words
from pam_cosim.drafting.texts import said_in
from pam_cosim.errors import InputError
from pam_cosim.measurement.cell_kinds import are_switch_words, says_time_of_day
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.formats import is_text, read_table
from pam_cosim.measurement.matlab_table import scalars_of
from pam_cosim.measurement.pieces import going_on, usual_step
from pam_cosim.measurement.run_names import matches
from pam_cosim.measurement.table import Column, Layout, Table, split_heading
from pam_cosim.measurement.text_file import read_any_text
from pam_cosim.measurement.text_table import text_columns
from pam_cosim.measurement.wrapped_clocks import with_clocks_going_on
from pam_cosim.units import convert
from pam_cosim.wording import did_you_mean, shown

MISSING = ("nan", "na", "n/a", "#n/a", "null", "none", "missing", "-", "--", "---")
"""Words that stand where a sample is missing, in small letters."""
_STATED = re.compile(r'\b(?!names)(\w+) = (?:\[?"([^"]+)"|(\d+))')
_MOST_WORDS = 3  # up, down, and neither
_MOST_REMARKS = 40  # lines above the rows that are looked at
_TOP_NAMES = {"pressure": "p", "force": "F", "contraction": "x", "ratio": "eps", "length": "L"}


@dataclass(frozen=True)
class Part:
    """One of several experiments in a file: its number, from one on, and the times [s] between which it lies."""

    number: int
    begin: float | None
    end: float | None


@dataclass(frozen=True)
class Source:
    """One recording.

    Attributes:
        texts: headings of columns of text, which are left out.
        labels: the cells of those that hold the same in every row.
        part: which one of its file, where that holds several experiments.
        clocks: headings of columns of text whose cells hold times of day in a way that is not read.
        words: of the columns whose cells are words for directions: the words by heading. Their numbers in the table are
            places in that list.
        remarks: lines above the rows, and numbers of a file that are no columns, as texts.
    """

    file: Path
    table: Table
    texts: tuple[str, ...] = ()
    words: dict[str, tuple[str, ...]] = field(default_factory=dict)
    labels: tuple[str, ...] = ()
    clocks: tuple[str, ...] = ()
    part: Part | None = None
    remarks: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Of the run that it becomes, as far as files are not renamed."""
        return self.file.stem if self.part is None else f"{self.file.stem} part {self.part.number}"


def places_of(name: str, sources: Sequence[Source], option: str = "") -> list[int]:
    """The places of the recordings of a name, that of one or of a file of which they are parts.

    Raises:
        InputError: there is none; it begins with the ``option``.
    """
    called = [
        i
        for i, one in enumerate(sources)
        if any(matches(own, name) for own in (one.name, one.file.stem, one.file.name))
    ]
    if not called:
        known = [one.name for one in sources]
        raise InputError(
            f"{option}there is no recording {shown(name)}; {did_you_mean(name, known)}"
        )
    return called


def recording_table(settings: Mapping[str, object]) -> RecordingTable:
    """What the user says of ``[recording]``.

    Raises:
        InputError: there is no such key, or its value cannot be used.
    """
    known = [name for name in RecordingTable.model_fields if name != "resample"]
    for name in settings:
        if name not in known:
            raise InputError(
                f"there is no key {shown(name)} of [recording]; {did_you_mean(name, known)}"
            )
    try:
        return RecordingTable.model_validate(
            {n: _setting(n, value) for n, value in settings.items()}
        )
    except ValidationError as error:
        one = error.errors(include_url=False)[0]
        raise InputError(
            f"[recording] {one['loc'][0]}: {shown(one['input'])} cannot be used: {one['msg']}"
        ) from None


def _setting(name: str, value: object) -> object:
    """A number of a line; a list as it is written with commas, or as ``experiment.toml`` has it."""
    if name.endswith("_line") and str(value).isdecimal():
        return int(str(value))
    if name not in ("names", "ignore", "missing") or not isinstance(value, str):
        return value
    if value.strip().startswith("["):
        with suppress(tomllib.TOMLDecodeError):
            return tomllib.loads(f"list = {value}")["list"]
    return [one.strip() for one in value.split(",")]


def read_sources(files: Sequence[Path], stated: RecordingTable, headings: Headings) -> list[Source]:
    """Reads every file; columns of text are left out, but for those of a direction or a switch.

    Raises:
        InputError: as the readers, with file, line and column.
    """
    layout = stated.layout()
    layout = replace(layout, missing=layout.missing.union(MISSING))
    texts = [_texts(file, layout) for file in files]
    words = _directions(texts, headings)
    return [_source(f, layout, own, words, headings) for f, own in zip(files, texts, strict=True)]


def _texts(file: Path, layout: Layout) -> dict[str, tuple[str, ...]]:
    try:
        return text_columns(file, layout) if is_text(file) else {}
    except InputError as error:
        raise _with_hint(error) from None


def _directions(
    texts: Sequence[dict[str, tuple[str, ...]]], headings: Headings
) -> dict[str, tuple[str, ...]]:
    """The different words of each column that tells a direction, in all files together."""
    words: dict[str, tuple[str, ...]] = {}
    for heading in dict.fromkeys(heading for own in texts for heading in own):
        cells = tuple(dict.fromkeys(c.casefold() for own in texts for c in own.get(heading, ())))
        meaning = headings.read(heading, "").meaning
        named = meaning is not None and meaning.kind == "direction"
        if len(cells) <= _MOST_WORDS and (named or all(map(headings.direction_word, cells))):
            words[heading] = cells
    return words


def _source(
    file: Path,
    layout: Layout,
    texts: dict[str, tuple[str, ...]],
    words: dict[str, tuple[str, ...]],
    headings: Headings,
) -> Source:
    left_out = [h for h, cells in texts.items() if h not in words and not are_switch_words(cells)]
    own = {heading: cells for heading, cells in words.items() if heading in texts}
    codes = {h: {cell: float(i) for i, cell in enumerate(cells)} for h, cells in own.items()}
    try:
        table = read_table(file, replace(layout, ignore=(*layout.ignore, *left_out), words=codes))
    except InputError as error:
        raise _with_hint(error) from None
    labels = tuple(texts[heading][0] for heading in left_out if len(texts[heading]) == 1)
    clocks = tuple(
        heading
        for heading in left_out
        if layout.keeps(heading, heading)
        and (
            all(map(says_time_of_day, texts[heading]))
            or headings.says_time(*(split_heading(heading) or (heading, "")))
        )
    )
    remarks = _remarks(file, layout, table)
    return Source(
        file, with_clocks_going_on(table), tuple(left_out), own, labels, clocks, None, remarks
    )


def _remarks(file: Path, layout: Layout, table: Table) -> tuple[str, ...]:
    """The lines above the header of a text, and the single numbers of another file, as "name: value"."""
    if file.suffix.casefold() == ".mat":
        return tuple(
            f"{name.replace('_', ' ')}: {value:g}" for name, value in scalars_of(file).items()
        )
    if not is_text(file):
        return ()
    text, _ = read_any_text(file, layout.encoding, layout.table)
    lines = text.splitlines()[:_MOST_REMARKS]
    marked = [line for line in lines if line.lstrip()[:1] in ("#", "%")]
    above = lines[: table.header_line - 1] if table.header_line else []
    return tuple(line.strip(" #%\t") for line in dict.fromkeys([*marked, *above]))


def _with_hint(error: InputError) -> InputError:
    """The error, saying what to type here: what stands under ``[recording]`` is said beforehand."""
    here = ""
    if "header is missing" in error.message:
        here = " (here: --recording 'names=time [s],p [kPa]', a name for each column)"
    elif "[recording]" in error.message:
        key = _STATED.search(error.message)
        said = shown(f"{key[1]}={key[2] or key[3]}") if key else "KEY=VALUE"
        here = f" (here: --recording {said})"
    return InputError(f"{error.message}{here}", error.file, error.line, error.column)


# ---- files in which the time begins anew: the experiments that a logger appended to one another ----------------------


def in_parts(sources: Sequence[Source], name: str, unit: str) -> list[Source]:
    """The recordings, of which those that hold several experiments are one for each.

    Args:
        sources: recordings.
        name: of the column of time.
        unit: of its numbers.
    """
    return [part for source in sources for part in _parts_of(source, name, unit)]


def _parts_of(source: Source, name: str, unit: str) -> list[Source]:
    if name not in source.table.columns:
        return [source]
    time = source.table.columns[name].values
    first = _first_rows(time)
    if len(first) < 2:
        return [source]
    goes_on = going_on(time, "split")
    middle = [float(convert(goes_on[k - 1 : k + 1].mean(), unit, "s")) for k in first[1:]]
    borders = [None, *middle, None]
    column = replace(source.table.columns[name], values=goes_on)
    table = replace(source.table, columns={**source.table.columns, name: column})
    rows = pairwise([*first, len(time)])
    return [
        replace(
            source, table=table.rows(slice(*ends)), part=Part(k + 1, borders[k], borders[k + 1])
        )
        for k, ends in enumerate(rows)
    ]


def _first_rows(time: Array) -> list[int]:
    """Where each experiment begins: the time goes back to its beginning, and on; elsewhere a cell is wrong."""
    steps = np.diff(time)
    first = [0, *(np.flatnonzero(steps < 0.0) + 1).tolist()]
    lengths = np.diff([*first, len(time)])
    begins = time[first] <= time[0] + usual_step(steps)
    enough = lengths >= CRITERIA.noise.fewest_samples
    return first if bool(np.all(begins) and np.all(enough)) else [0]


# ---- tables with one quantity along the top, such as a column of forces for each pressure ----------------------------


@dataclass(frozen=True)
class _Top:
    """A column of one value of what stands along the top: a direction, or a number with a unit."""

    column: Column
    key: str
    unit: str
    text: str
    said: str
    kind: str | None
    value_unit: str


def tidied(file: Path, folder: Path, stated: RecordingTable, headings: Headings) -> Path:
    """The file; of a table with a quantity along the top, another one in ``folder`` with a row for each point.

    What cannot be read is left as it is: the fault is told where the file is read.
    """
    try:
        (source,) = read_sources([file], stated, headings)
    except InputError:
        return file
    found = {
        n: top for n, c in source.table.columns.items() if (top := _top(c, headings)) is not None
    }
    rest = [column for name, column in source.table.columns.items() if name not in found]
    meanings = [headings.read(c.name, c.unit).meaning for c in rest]
    kinds = [one.kind for one in meanings if one is not None]
    tops: list[_Top] = []
    for (
        top
    ) in found.values():  # those that say nothing but their value are of what the one before says
        before = tops[-1] if tops and not (top.said or top.value_unit) else top
        tops.append(replace(top, kind=before.kind, value_unit=before.value_unit))
    alike = len({(t.key, t.unit, t.kind, t.value_unit) for t in tops}) == 1
    different = len({t.text for t in tops}) == len(tops) > 1
    if "time" in kinds or not rest or source.words or not (alike and different):
        return file
    kind = tops[0].kind or _missing(tops[0].key, kinds)
    if kind not in _TOP_NAMES or kind == tops[0].key:
        return file
    made = folder / f"{file.stem}.csv"
    made.write_text(_long(rest, tops, kind), encoding="utf-8", newline="\n")
    return made


def _top(column: Column, headings: Headings) -> _Top | None:
    """What a column is along the top by its name: "F@100kPa", "2 bar", "x up [mm]"; None: it says neither."""
    name = column.heading.partition("[")[0]
    said = [
        one for one in said_in(name, headings) if one.kind in _TOP_NAMES and one.kind != "length"
    ]
    ways = [word for word in split_words(column.name) if len(word) > 1 and _is_way(word, headings)]
    if len(said) == 1:
        text, key, unit, value = said[0].text, said[0].kind, said[0].unit, f"{said[0].value:.9g}"
    elif len(ways) == 1:
        way = "up" if headings.direction_word(ways[0]) > 0 else "down"
        text, key, unit, value = ways[0], "direction", "", way
    else:
        return None
    left = name.replace(text, " ").strip(" @_-=,;:")
    reading = headings.read(left, column.unit if column.unit != unit else "")
    kind = reading.meaning.kind if reading.meaning else None
    return _Top(column, key, unit, value, left, kind, reading.unit or reading.unknown)


def _is_way(word: str, headings: Headings) -> bool:
    """Whether a word says a direction and no quantity, as "contraction" and "load" do."""
    quantities = {*headings.kinds_of(folded(word))} - {"direction"}
    return bool(headings.direction_word(word)) and not quantities


def _missing(key: str, kinds: Sequence[str]) -> str | None:
    """What the numbers are, of a pressure, a contraction and a force, where the other two are known."""
    known = {"contraction" if kind in LENGTHS else kind for kind in (key, *kinds)}
    left = [kind for kind in ("pressure", "contraction", "force") if kind not in known]
    return left[0] if len(left) == 1 else None


def _long(rest: Sequence[Column], tops: Sequence[_Top], kind: str) -> str:
    """The table as text: the other columns, what stood along the top, and the numbers below it, in the unit written."""
    unit = f" [{tops[0].value_unit}]" if tops[0].value_unit else ""
    is_way = tops[0].key == "direction"
    key = "direction" if is_way else f"{_TOP_NAMES[tops[0].key]} [{tops[0].unit}]"
    quoted = ['"' + (c.heading or c.name).replace('"', '""') + '"' for c in rest]
    lines = [",".join([*quoted, key, f"{_TOP_NAMES[kind]}{unit}"])]
    for top in tops:
        for row, value in enumerate(top.column.values):
            cells: list[Any] = [*(c.values[row] for c in rest), top.text, value]
            lines.append(
                ",".join(c if isinstance(c, str) else "" if c != c else f"{c:.9g}" for c in cells)
            )
    return "\n".join(lines) + "\n"
