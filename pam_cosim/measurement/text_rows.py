"""Lines of a text table as cells, and which of them are rows of numbers."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from dataclasses import dataclass

from pam_cosim.measurement.cell_kinds import NUMBER, is_number

LOOKED_AT = 400  # Rows that are looked at; all are checked when they are read.
_DEEPEST = 400  # Lines above the first row, below what is stated.
COMMENT = re.compile(r"\s*(#|//|%(?!\s*[;,\t]))\s*")
Line = tuple[int, str]


@dataclass(frozen=True)
class Row:
    """A line and its cells; ``index`` among the lines."""

    index: int
    number: int
    text: str
    cells: list[str]


def is_comment(line: str) -> bool:
    """Whether a line is a comment."""
    return COMMENT.match(line) is not None


def split_cells(line: str, separator: str) -> list[str]:
    """Stripped cells.

    Raises:
        csv.Error: a quote is not closed.
    """
    if '"' in line:
        if separator != " ":
            line = re.sub(rf'(?<!")" +(?={re.escape(separator)})', '"', line)
        cells = next(
            csv.reader([line.strip(" ")], delimiter=separator, strict=True, skipinitialspace=True)
        )
        return [cell.strip() for cell in cells]
    return line.split() if separator == " " else [cell.strip() for cell in line.split(separator)]


def first_row(rows: list[Row], start: int) -> int:
    """The first row of numbers: a faulty one is no header, a number is among its cells, and a header stands above."""
    count = len(rows[start].cells)
    while start > 1 and count == len(rows[start - 1].cells) == len(rows[start - 2].cells):
        if not any(map(is_number, rows[start - 1].cells)):
            break
        start -= 1
    return start


def rows_of(
    separator: str, lines: list[Line], after: int, is_row: Callable[[list[str]], bool]
) -> tuple[list[Row], int | None]:
    """The header's lines and some rows, and which is the first row below the line ``after``."""
    rows: list[Row] = []
    start = None
    for index, (number, line) in enumerate(lines):
        if is_comment(line):
            continue
        try:
            cells = split_cells(line, separator)
        except csv.Error:
            cells = []
        if start is None and number > after and is_row(cells):
            start = len(rows)
        rows.append(Row(index, number, line, cells))
        if len(rows) - start > LOOKED_AT if start is not None else number > after + _DEEPEST:
            break
    return rows, start


def is_row(cells: list[str], missing: frozenset[str] = frozenset()) -> bool:
    """A row begins with a number; half of its cells at least are numbers or empty, or words for ``missing`` samples."""
    if len(cells) < 2 or not is_number(cells[0]):
        return False
    if not NUMBER.fullmatch(cells[0]) and not any(map(NUMBER.fullmatch, cells)):
        return False  # a date above the table
    count = sum(1 for cell in cells if not cell or is_number(cell) or cell.casefold() in missing)
    return 2 * count >= len(cells)


def is_dated_row(cells: list[str]) -> bool:
    """A row that begins with a text, such as a date, has more numbers than texts."""
    return len(cells) > 2 and 2 * sum(map(is_number, cells)) > len(cells)
