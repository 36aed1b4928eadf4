"""A delimited text as a table: CSV and its kin, as loggers and spreadsheets write them."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import chain
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.measurement.table import Column, Layout, Table, split_heading
from pam_cosim.measurement.text_file import WESTERN, read_any_text
from pam_cosim.measurement.text_layout import (
    LOOKED_AT,
    WORDS,
    Line,
    TextLayout,
    decimal_sign,
    find_layout,
    is_comment,
    split_cells,
)
from pam_cosim.wording import shown

_BLOCK = 20_000  # Lines that are turned into numbers at once.
_LONGEST = 1000  # letters of a cell that is looked at as a number
_TALLEST = 8  # Lines of one quoted cell.
_NUMBER = re.compile(r"[+-]?(\d+(?:\.\d*)?|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_MEANT = re.compile(
    r"[+-]?[\d.,]+([eE][+-]?\d+)?|[+-]?(nan|inf|infinity)", re.ASCII | re.IGNORECASE
)  # as a number
_NO_NUMBER = re.compile(r"[^0-9eE+\-.]")
_PLAIN = frozenset("0123456789-+.,;")  # No comment begins so.
_NOT_FINITE = ("nan", "inf", "infinity")


def read_text_table(file: Path, stated: Layout) -> Table:
    """Reads columns of decimal numbers below a header of names with units.

    Blank lines, comment lines (``#``, ``%``, ``//``), lines above the header, a row of units, a byte order mark and
    any line ends are fine. What is not stated is recognised where it is unambiguous (``text_layout``).

    Raises:
        InputError: not readable, empty, ambiguous, a heading twice, a row of the wrong length, a cell that is no
            finite number; with line and column.
    """
    text, encoding = read_any_text(file, stated.encoding)
    lines = _filled_lines(text)
    del text
    if not lines:
        raise InputError("the file is empty; begin with a header such as 'time [s],p [kPa]'", file)
    layout = find_layout(lines, stated, file)
    names = _names(layout, file)
    keep = [i for i, (name, _) in enumerate(names) if stated.keeps(layout.headings[i][0], name)]
    body = [
        line for line in lines[layout.start :] if line[1][0] in _PLAIN or not is_comment(line[1])
    ]
    reader = _Reader(layout, [name for name, _ in names], keep, file, ".")
    reader.words = _words_of_columns(layout, names, stated)
    reader.missing = stated.missing
    reader.decimal = stated.decimal or decimal_sign(reader.cells(body), layout.separator, file)
    columns = {
        names[i][0]: Column(*names[i], values, layout.headings[i][0], i + 1)
        for i, values in zip(keep, reader.columns(body), strict=True)
    }
    numbers = np.array([number for number, _ in body], dtype=np.int64)
    notes, met = _notes(layout, encoding, reader.decimal), tuple(reader.met)
    return Table(file, columns, layout.header_line or None, numbers, notes, met)


def _filled_lines(text: str) -> list[Line]:
    """The lines that are not blank, with their numbers."""
    return [(number, line) for number, line in _lines(text) if line and not line.isspace()]


def _words_of_columns(
    layout: TextLayout, names: Sequence[tuple[str, str]], stated: Layout
) -> list[Mapping[str, float]]:
    """For each column, what words in it mean, which is stated by its name or by its whole heading."""
    words = []
    for (name, _), (heading, _) in zip(names, layout.headings, strict=True):
        of_heading = stated.words.get(heading, {})
        words.append(stated.words.get(name, of_heading))
    return words


def text_columns(file: Path, stated: Layout) -> dict[str, tuple[str, ...]]:
    """The columns in which no row has a number, such as remarks and dates: the different cells of each, by heading.

    Raises:
        InputError: as ``read_text_table``, where the file has no rows or its separator is ambiguous.
    """
    text, _ = read_any_text(file, stated.encoding)
    lines = _filled_lines(text)
    if not lines:
        return {}
    layout = find_layout(lines, stated, file)
    looked_at = _rows(lines[layout.start : layout.start + LOOKED_AT], layout.separator)
    texts = [i for i in range(len(layout.headings)) if _is_text(_filled(looked_at, i))]
    rows = _rows(lines[layout.start :], layout.separator) if texts else []
    return {layout.headings[i][0]: tuple(dict.fromkeys(_filled(rows, i))) for i in texts}


def _filled(rows: Sequence[Sequence[str]], column: int) -> list[str]:
    """The cells of a column that are not empty."""
    return [row[column] for row in rows if column < len(row) and row[column]]


def _is_text(cells: Sequence[str]) -> bool:
    """Whether there are cells, and none of them is meant as a number."""
    return bool(cells) and not any(map(_MEANT.fullmatch, cells))


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
        line, taken = lines[at], 1
        if line.count('"') % 2 and not is_comment(line):
            for more in range(2, _TALLEST + 1):
                several = "\n".join(lines[at : at + more])
                if several.count('"') % 2 == 0:
                    line, taken = several, more
                    break
        yield at + 1, line
        at += taken


def _names(layout: TextLayout, file: Path) -> list[tuple[str, str]]:
    """Name and unit of each column."""
    line, seen = layout.header_line or None, set()
    named = []
    for number, (heading, below) in enumerate(layout.headings, start=1):
        parts = split_heading(heading)
        if parts is None:
            message = f"the heading {shown(heading)} of column {number} must be 'name [unit]'"
            raise InputError(
                message, file, line, heading[:60] if heading.isprintable() and heading else None
            )
        name, unit = parts
        if name in seen:
            raise InputError("this column stands twice in the header", file, line, name)
        if unit and below and unit != below:
            raise InputError(
                f"its heading says {shown(unit)}, the row of units {shown(below)}", file, line, name
            )
        seen.add(name)
        named.append((name, unit or below))
    return named


def _notes(layout: TextLayout, encoding: str, decimal: str) -> tuple[str, ...]:
    said = []
    if layout.separator != ",":
        said.append(f"columns separated by {WORDS[layout.separator]}")
    if decimal == ",":
        said.append("decimal commas")
    if encoding == WESTERN:
        said.append("Western European letters")
    return (f"read with {', '.join(said)}",) if said else ()


class _Reader:
    """Rows of text to columns of numbers: quickly where they are plain, else cell by cell."""

    def __init__(
        self, layout: TextLayout, names: list[str], keep: list[int], file: Path, decimal: str
    ) -> None:
        self.separator, self.names, self.keep, self.file = layout.separator, names, keep, file
        self.decimal = decimal
        self.words: list[Mapping[str, float]] = [{} for _ in names]
        self.missing: frozenset[str] = frozenset()
        self.met: dict[str, None] = {}

    def cells(self, lines: list[Line]) -> Iterator[Line]:
        """Line and text of every cell that holds a sign for decimals."""
        for number, line in lines:
            if "." in line or "," in line:
                cells = self._split(number, line)
                for i in self.keep:
                    yield number, cells[i] if i < len(cells) else ""

    def columns(self, lines: list[Line]) -> list[NDArray[np.float64]]:
        """(n,) of each column that is kept; NaN where a cell is empty."""
        blocks = [self._block(lines[at : at + _BLOCK]) for at in range(0, len(lines), _BLOCK)]
        return [np.concatenate([block[k] for block in blocks]) for k in range(len(self.keep))]

    def _block(self, lines: list[Line]) -> list[NDArray[np.float64]]:
        plain = self._plain(lines)
        if plain is not None:
            return plain
        rows = [(number, self._row(number, line)) for number, line in lines]
        return [
            np.array([self._number(number, cells[i], i) for number, cells in rows])
            for i in self.keep
        ]

    def _plain(self, lines: list[Line]) -> list[NDArray[np.float64]] | None:
        """The block, when every row has as many cells and every cell is a number or empty."""
        texts = [line for _, line in lines]
        count, ends = len(self.names), len(self.names) - 1
        if self.separator == " ":
            split = [line.split() for line in texts]
            if any(len(cells) != count for cells in split):
                return None
            cells = list(chain.from_iterable(split))
        else:
            if any(line.count(self.separator) != ends for line in texts):
                return None
            joined = self.separator.join(texts)
            if '"' in joined:
                return None
            cells = joined.split(self.separator)
        columns = [_floats(cells[i::count], self.decimal) for i in self.keep]
        return (
            None
            if any(column is None for column in columns)
            else [c for c in columns if c is not None]
        )

    def _split(self, number: int, line: str) -> list[str]:
        try:
            return split_cells(line, self.separator)
        except csv.Error as error:
            message = f"this line is not text separated by {WORDS[self.separator]}: {error}"
            raise InputError(message, self.file, number) from None

    def _row(self, number: int, line: str) -> list[str]:
        cells = self._split(number, line)
        count = len(self.names)
        if len(cells) >= count and not any(cells[count:]):
            return cells[:count]
        hint = "; write decimal points, not commas" if len(cells) == 2 * len(self.names) else ""
        raise InputError(
            f"this row has {len(cells)} cells, the header has {len(self.names)}{hint}",
            self.file,
            number,
        )

    def _number(self, line: int, cell: str, column: int) -> float:
        if not cell:
            return math.nan
        if len(cell) > _LONGEST:
            raise InputError(
                f"{shown(cell)} has {len(cell)} letters: that is no number",
                self.file,
                line,
                self.names[column],
            )
        if cell.casefold() in self.missing:
            self.met[cell] = None
            return math.nan
        words = self.words[column]
        if cell.casefold() in words:
            return words[cell.casefold()]
        number = cell.replace(",", ".") if self.decimal == "," and "." not in cell else cell
        name = self.names[column]
        if not _NUMBER.fullmatch(number) or (self.decimal == "," and "." in cell):
            wrong = (
                f"{shown(cell)} is none of {', '.join(words)}"
                if words
                else self._not_a_number(cell)
            )
            raise InputError(wrong, self.file, line, name)
        value = float(number)
        if math.isinf(value):
            raise InputError(f"{shown(cell)} is too large", self.file, line, name)
        return value

    def _not_a_number(self, cell: str) -> str:
        if cell.lower().lstrip("+-") in _NOT_FINITE:
            where = (
                f', or state the word under [recording]: missing = ["{cell}"]'
                if "nan" in cell.lower()
                else ""
            )
            return f"{shown(cell)} is not a finite number; leave the cell empty where a sample is missing{where}"
        if re.fullmatch(r"[+-]?\d+[.,]\d+", cell, re.ASCII):
            if self.decimal == ".":
                stated = 'state decimal = "," under [recording]'
                return f"{shown(cell)} has a decimal comma; write a decimal point, or {stated} where all numbers do"
            return f"{shown(cell)} has a decimal point, other numbers have decimal commas"
        if re.fullmatch(r"[+-]?\d+(?:[.,]\d+)+", cell, re.ASCII):
            return f"{shown(cell)} is grouped by thousands; write it without"
        return f"{shown(cell)} is not a number"


def _floats(cells: list[str], decimal: str) -> NDArray[np.float64] | None:
    """(n,) numbers; None where one is not plainly a number."""
    joined = "".join(cells)
    if decimal == ",":
        if "." in joined:
            return None
        joined = joined.replace(",", ".")
        cells = [cell.replace(",", ".") for cell in cells]
    if _NO_NUMBER.search(joined.replace(" ", "")):
        return None
    try:
        values = np.fromiter(map(float, cells), float, len(cells))
    except ValueError:
        try:
            values = np.array(
                [float(cell) if cell and not cell.isspace() else math.nan for cell in cells]
            )
        except ValueError:
            return None
    return None if np.isinf(values).any() else values
