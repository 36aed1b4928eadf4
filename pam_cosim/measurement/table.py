"""A CSV file as columns of numbers, in the file's own units, with the line of every row."""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.measurement.text_file import read_text
from pam_cosim.wording import shown

_HEADING = re.compile(r"([^\[\]]+?)\s*(?:\[([^\[\]]*)\])?")
_NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
_DECIMAL_COMMA = re.compile(r"[+-]?\d+,\d+", re.ASCII)
_NOT_FINITE = ("nan", "inf", "infinity")


@dataclass(frozen=True)
class Column:
    """One column: values (n,) in ``unit``, as written in the header; NaN is an empty cell."""

    name: str
    unit: str
    values: NDArray[np.float64]


@dataclass(frozen=True)
class Table:
    """A CSV file. ``lines`` (n,) are the lines of the rows; errors can name them."""

    file: Path
    header_line: int
    lines: NDArray[np.int64]
    columns: dict[str, Column]

    def error(self, message: str, column: str, row: int | None = None) -> InputError:
        """An error about a column: its header, or one of its rows."""
        line = self.header_line if row is None else int(self.lines[row])
        return InputError(message, self.file, line, column)


def read_table(file: Path) -> Table:
    """Reads ``name [unit],name [unit],...`` and rows of decimal numbers.

    Blank lines, lines that begin with ``#``, a byte order mark and Windows line ends are fine.

    Raises:
        InputError: not readable, empty, not comma separated, a heading twice, a row of the wrong length,
            a cell that is no finite number; with line and column.
    """
    rows = list(_rows(read_text(file), file))
    if not rows:
        raise InputError("the file is empty; begin with a header such as 'time [s],p [kPa]'", file)
    (header_line, cells), *rows = rows
    headings = _headings(cells, file, header_line)
    if not rows:
        raise InputError("there are no rows below the header", file, header_line)
    for line, cells in rows:
        if len(cells) != len(headings):
            raise InputError(_ragged(cells, len(headings)), file, line)
    lines = np.array([line for line, _ in rows], dtype=np.int64)
    columns = {
        name: Column(name, unit, _numbers(name, [cells[index] for _, cells in rows], file, lines))
        for index, (name, unit) in enumerate(headings.items())
    }
    return Table(file, header_line, lines, columns)


def _rows(text: str, file: Path) -> Iterator[tuple[int, list[str]]]:
    """Line number and stripped cells of every line that is neither blank nor a comment."""
    first_line = 0  # Of the current row: a quoted cell can hold line ends.

    def kept() -> Iterator[str]:
        nonlocal first_line
        for number, line in enumerate(re.split(r"\r\n|\n|\r", text), start=1):
            if line.strip() and not line.lstrip().startswith("#"):
                first_line = first_line or number
                yield line

    try:
        for cells in csv.reader(kept(), strict=True, skipinitialspace=True):
            yield first_line, [cell.strip() for cell in cells]
            first_line = 0
    except csv.Error as error:
        raise InputError(f"this line is not comma-separated text: {error}", file, first_line) from None


def _headings(cells: list[str], file: Path, line: int) -> dict[str, str]:
    """Units by column name."""
    if len(cells) == 1:
        for separator, word in ((";", "semicolons"), ("\t", "tabs")):
            if separator in cells[0]:
                message = f"the columns are separated by {word}; separate them by commas, with decimal points"
                raise InputError(message, file, line)
    if all(_NUMBER.fullmatch(cell) for cell in cells):
        raise InputError("the header is missing; begin with a line such as 'time [s],p [kPa]'", file, line)
    units: dict[str, str] = {}
    for number, cell in enumerate(cells, start=1):
        match = _HEADING.fullmatch(cell)
        if match is None or not cell.isprintable():
            message = f"the heading {shown(cell)} of column {number} must be 'name [unit]'"
            raise InputError(message, file, line, cell[:60] if cell.isprintable() and cell else None)
        name, unit = match[1], (match[2] or "").strip()
        if name in units:
            raise InputError("this column stands twice in the header", file, line, name)
        units[name] = unit
    return units


def _ragged(cells: list[str], expected: int) -> str:
    if len(cells) == 1 and ";" in cells[0]:
        return "the cells are separated by semicolons; separate them by commas, with decimal points"
    hint = "; write decimal points, not commas" if len(cells) == 2 * expected else ""
    return f"this row has {len(cells)} cells, the header has {expected}{hint}"


def _numbers(name: str, cells: list[str], file: Path, lines: NDArray[np.int64]) -> NDArray[np.float64]:
    """(n,) values; NaN where the cell is empty."""
    values = np.full(len(cells), math.nan)
    for row, cell in enumerate(cells):
        if not cell:
            continue
        if not _NUMBER.fullmatch(cell):
            raise InputError(_not_a_number(cell), file, int(lines[row]), name)
        values[row] = float(cell)
        if math.isinf(values[row]):
            raise InputError(f"{shown(cell)} is too large", file, int(lines[row]), name)
    return values


def _not_a_number(cell: str) -> str:
    if cell.lower().lstrip("+-") in _NOT_FINITE:
        return f"{shown(cell)} is not a finite number; leave the cell empty where a sample is missing"
    if _DECIMAL_COMMA.fullmatch(cell):
        return f"{shown(cell)} has a decimal comma; write a decimal point"
    return f"{shown(cell)} is not a number"
