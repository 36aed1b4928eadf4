"""A delimited text as a table: CSV and its kin, as loggers and spreadsheets write them."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Container, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement import labview_text
from pam_cosim.measurement.cell_kinds import (
    are_switch_words,
    date_time,
    is_date,
    is_date_time,
    unit_of,
)
from pam_cosim.measurement.table import (
    LEFT_OUT,
    Column,
    Layout,
    Table,
    check_count,
    split_heading,
)
from pam_cosim.measurement.text_cells import Reader
from pam_cosim.measurement.text_file import WESTERN, read_any_text
from pam_cosim.measurement.text_header import other_line
from pam_cosim.measurement.text_layout import WORDS, TextLayout, decimal_sign, find_layout
from pam_cosim.measurement.text_rows import LOOKED_AT, Line, is_comment, split_cells
from pam_cosim.measurement.workbook import WORKBOOKS
from pam_cosim.model.interface import SWITCH_WORDS
from pam_cosim.wording import shown

_MOST_LINES = 5_000_000  # Each takes some 200 bytes while it is read.
_TALLEST = 8  # Lines of one quoted cell.
_MEANT = re.compile(
    r"[+-]?[\d.,]+([eE][+-]?\d+)?|[+-]?(nan|inf|infinity)", re.ASCII | re.IGNORECASE
)  # as a number
_PLAIN = frozenset("0123456789-+.,;")  # No comment begins so.


def read_text_table(file: Path, stated: Layout) -> Table:
    """Reads columns of decimal numbers below a header of names with units.

    Blank lines, comment lines (``#``, ``%``, ``//``), lines above the header, a row of units, a byte order mark and
    any line ends are fine. A column of words for a switch (ON, OFF) becomes one of 1 and 0. What is not stated is
    recognised where it is unambiguous (``text_layout``).

    Raises:
        InputError: not readable, empty, ambiguous, a heading twice, a row of the wrong length, a cell that is no
            finite number; with line and column.
    """
    text, encoding, stated = _opened(file, stated)
    lines = _filled_lines(text, file)
    is_ended = _is_ended(text)
    del text
    if not lines:
        raise InputError("the file is empty; begin with a header such as 'time [s],p [kPa]'", file)
    layout = _layout(lines, is_ended, stated, file)
    names = _names(layout, file)
    keep = [i for i, (name, _) in enumerate(names) if stated.keeps(layout.headings[i][0], name)]
    body = [
        line for line in lines[layout.start :] if line[1][0] in _PLAIN or not is_comment(line[1])
    ]
    cut = None if is_ended else _cut_short(body, layout)
    body = body[:-1] if cut else body
    check_count(len(body) * len(keep), file)
    reader = Reader(layout, [name for name, _ in names], keep, file, ".")
    reader.missing = stated.missing
    called = [(name, layout.headings[i][0]) for i, (name, _) in enumerate(names)]
    reader.words = [stated.words.get(n, stated.words.get(heading, {})) for n, heading in called]
    if stated.clock is not None:
        clock = stated.clock
        reader.clock = frozenset(
            i
            for i, heading_names in enumerate(called)
            if not clock.isdisjoint((*heading_names, i + 1))
        )
    beginning = _rows(body[:LOOKED_AT], layout.separator)
    reader.dates = _dates(beginning, keep)
    for i in (i for i in keep if not reader.words[i]):
        cells = _present(beginning, i, stated.missing)
        unit = "" if i in reader.dates else unit_of(cells)
        if are_switch_words(cells[:1]):
            reader.words[i] = SWITCH_WORDS
        elif unit:
            reader.units[i] = unit
            if names[i][1] not in ("", unit):
                message = f"the unit is {shown(names[i][1])} in its heading, but {shown(unit)} in its cells"
                raise InputError(message, file, layout.header_line or None, names[i][0])
    reader.decimal = stated.decimal or decimal_sign(reader.cells(body), layout.separator, file)
    columns = {}
    for i, values in zip(keep, reader.columns(body), strict=True):
        name, heading = called[i]
        since = reader.dates.get(i, "")
        unit = "s" if since else reader.units.get(i, names[i][1])
        columns[name] = Column(name, unit, values, heading, i + 1, since)
    numbers = np.array([number for number, _ in body], dtype=np.int64)
    notes = tuple(_notes(layout, encoding, reader.decimal, cut))
    return Table(file, columns, layout.header_line or None, numbers, notes, tuple(reader.met))


def _opened(file: Path, stated: Layout) -> tuple[str, str, Layout]:
    """The text, its encoding and what is stated of it; of a workbook, numbers are written in one way."""
    text, encoding = read_any_text(file, stated.encoding, stated.table)
    if file.suffix.lower() in WORKBOOKS:
        stated = replace(stated, separator=",", decimal=".")
    return text, encoding, stated


def _is_ended(text: str) -> bool:
    """Whether the last line has an end."""
    return text.endswith(("\n", "\r"))


def _layout(lines: list[Line], is_ended: bool, stated: Layout, file: Path) -> TextLayout:
    """How the lines are written; a last one without an end may be cut short, and the others tell if they can."""
    if not is_ended and len(lines) > 1:
        with suppress(InputError):
            layout = find_layout(lines[:-1], stated, file)
            if layout.consistent:
                return layout
    return find_layout(lines, stated, file)


def _cut_short(body: Sequence[Line], layout: TextLayout) -> int | None:
    """The number of the last line, which has no end, where it lacks cells: it was cut as the recording stopped."""
    last = _rows(body[-1:], layout.separator)
    cut = len(body) > 1 and last and len(last[0]) < len(layout.headings)
    return body[-1][0] if cut else None


def _filled_lines(text: str, file: Path) -> list[Line]:
    """The lines that are not blank, with their numbers.

    Raises:
        InputError: there are too many.
    """
    count = text.count("\n") + text.count("\r")
    if count > _MOST_LINES:
        raise InputError(
            f"it has {count} lines, and {_MOST_LINES} of a text can be taken: split it, or save it as Parquet",
            file,
        )
    filled = [(number, line) for number, line in _lines(text) if line and not line.isspace()]
    return labview_text.completed(filled)


def _dates(rows: Sequence[Sequence[str]], keep: Sequence[int]) -> dict[int, str]:
    """Places of columns of dates with times of day, and the first of each."""
    examples = {i: next(iter(_filled(rows, i)), "") for i in keep}
    return {i: cell for i, cell in examples.items() if date_time(cell) is not None}


def text_columns(file: Path, stated: Layout) -> dict[str, tuple[str, ...]]:
    """The columns in which no row has a number or a date, such as remarks: the different cells of each, by heading.

    Raises:
        InputError: as ``read_text_table``, where the file has no rows or its separator is ambiguous.
    """
    text, _, stated = _opened(file, stated)
    lines = _filled_lines(text, file)
    if not lines:
        return {}
    layout = _layout(lines, _is_ended(text), stated, file)
    looked_at = _rows(lines[layout.start : layout.start + LOOKED_AT], layout.separator)
    cells = [_filled(looked_at, i) for i in range(len(layout.headings))]
    present = [_present(looked_at, i, stated.missing) for i in range(len(layout.headings))]
    texts = [
        i
        for i, column_cells in enumerate(cells)
        if _is_text(column_cells) and not unit_of(present[i])
    ]
    rows = _rows(lines[layout.start :], layout.separator) if texts else []
    return {layout.headings[i][0]: tuple(dict.fromkeys(_filled(rows, i))) for i in texts}


def _filled(rows: Sequence[Sequence[str]], column: int) -> list[str]:
    """The cells of a column that are not empty."""
    return [row[column] for row in rows if column < len(row) and row[column]]


def _present(rows: Sequence[Sequence[str]], column: int, missing: Container[str]) -> list[str]:
    """The cells of a column in which no sample is missing."""
    return [cell for cell in _filled(rows, column) if cell.casefold() not in missing]


def _is_text(cells: Sequence[str]) -> bool:
    """Whether there are cells, none of them is meant as a number, and not all are dates with times of day."""
    return bool(cells) and not (any(map(_is_meant, cells)) or all(map(is_date_time, cells)))


def _is_meant(cell: str) -> bool:
    """Whether a cell is meant as a number: a date such as 12.03.2024 is not."""
    return _MEANT.fullmatch(cell) is not None and not is_date(cell)


def _rows(lines: Sequence[Line], separator: str) -> list[list[str]]:
    rows = []
    for _, line in lines:
        with suppress(csv.Error):
            rows.append([] if is_comment(line) else split_cells(line, separator))
    return rows


def _lines(text: str) -> Iterator[Line]:
    """Lines with their numbers; one holds line ends where they are within quotes."""
    lines = re.split(r"\r\n|\n|\r", text) if "\r" in text else text.split("\n")
    if '"' not in text:
        return enumerate(lines, start=1)
    return _joined(lines)


def _joined(lines: list[str]) -> Iterator[Line]:
    at = 0
    while at < len(lines):
        line, line_count = lines[at], 1
        if line.count('"') % 2 and not is_comment(line):
            for more in range(2, _TALLEST + 1):
                joined_lines = "\n".join(lines[at : at + more])
                if joined_lines.count('"') % 2 == 0:
                    line, line_count = joined_lines, more
                    break
        yield at + 1, line
        at += line_count


def _names(layout: TextLayout, file: Path) -> list[tuple[str, str]]:
    """Name and unit of each column."""
    line, used_names = layout.header_line or None, set[str]()
    headings = [split_heading(heading) for heading, _ in layout.headings]
    units = Counter({(parts[0], parts[1]) for parts in headings if parts})
    name_counts = Counter(name for name, _ in units)
    names_and_units = []
    for number, (heading, below) in enumerate(layout.headings, start=1):
        parts = headings[number - 1]
        if not heading and any(headings):  # as of an index of rows
            parts = (f"column {number}", "")
        if (
            parts is not None and name_counts[parts[0]] > 1
        ):  # in two units: each is called as its heading is
            parts = (heading, parts[1])
        if parts is None:
            message = f"the heading {shown(heading)} of column {number} must be 'name [unit]'"
            raise InputError(
                message, file, line, heading[:60] if heading.isprintable() and heading else None
            )
        name, unit = parts
        if name.casefold() == labview_text.TIME and name in used_names:
            name = f"{name} {1 + sum(seen_name.startswith(name) for seen_name in used_names)}"
        if name in used_names:
            hint = f"; or, {other_line(line - 1)}" if line is not None and line > 1 else ""
            message = f"this column occurs twice in the header; rename one{hint}"
            raise InputError(message, file, line, name)
        if unit and below and unit != below:
            raise InputError(
                f"the unit is {shown(unit)} in its heading, but {shown(below)} in the row of units",
                file,
                line,
                name,
            )
        used_names.add(name)
        names_and_units.append((name, unit or below))
    return names_and_units


def _notes(layout: TextLayout, encoding: str, decimal: str, cut: int | None) -> Iterator[str]:
    """How the text was read, and which rows are not."""
    notes = []
    if layout.separator != ",":
        notes.append(f"columns separated by {WORDS[layout.separator]}")
    if decimal == ",":
        notes.append("decimal commas")
    if encoding == WESTERN:
        notes.append("Western European letters")
    if notes:
        yield f"read with {', '.join(notes)}"
    if layout.passed_over:
        rows = "the row" if layout.passed_over == 1 else f"{layout.passed_over} rows"
        yield f"{LEFT_OUT} {rows} above the header, which is on line {layout.header_line}"
    if cut is not None:
        yield f"{LEFT_OUT} the last line, {cut}, which was cut short as the recording stopped"
