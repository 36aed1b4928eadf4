"""How a text of columns is written: separator, decimal sign, and which lines hold names and units.

A separator is taken when by it every row has as many cells as the header has names, all of them numbers. A decimal
sign is taken when a number shows it that cannot be grouped thousands: "1,234" can, "0,5" cannot. Where nothing
decides, nothing is guessed.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement.table import Layout, is_unit, split_heading
from pam_cosim.wording import shown

SEPARATORS = {";": ";", "tab": "\t", ",": ",", "blank": " "}
WORDS = {";": "semicolons", "\t": "tabs", ",": "commas", " ": "blanks"}
LOOKED_AT = 400  # Rows that are looked at; all are checked when they are read.
_DEEPEST = 400  # Lines above the first row, below what is stated.
_NUMBER = re.compile(r"[+-]?(\d+(?:[.,]\d*)?|[.,]\d+)([eE][+-]?\d+)?", re.ASCII)
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2}(?:,\d{3})+|[+-]?[1-9]\d{0,2}(?:\.\d{3})+", re.ASCII)
_COMMENT = re.compile(r"\s*(#|//|%(?!\s*[;,\t]))\s*")
_SAID = re.compile(r'\s*"?sep=(.)"?\s*', re.IGNORECASE)

Line = tuple[int, str]


@dataclass(frozen=True)
class TextLayout:
    """What the lines of a text mean.

    Attributes:
        separator: one character; a blank stands for any number of blanks.
        headings: of every column, a unit from a row of units included.
        header_line: of the names.
        start: index of the first row among the lines.
        consistent: every line looked at is a row of numbers.
        complaint: the line at fault and why, where there is no header for the rows.
    """

    separator: str
    headings: tuple[tuple[str, str], ...]
    header_line: int
    start: int
    consistent: bool = True
    complaint: tuple[int, str] | None = None


@dataclass(frozen=True)
class _Row:
    """A line and its cells; ``index`` among the lines."""

    index: int
    number: int
    text: str
    cells: list[str]


@dataclass(frozen=True)
class _Header:
    line: int
    names: list[str]
    units: list[str] | None = None

    def headings(self) -> tuple[tuple[str, str], ...]:
        """Heading as written and unit from a row of units."""
        units = (self.units or [])[: len(self.names)]
        return tuple(zip(self.names, [*units, *[""] * (len(self.names) - len(units))], strict=True))


def is_comment(line: str) -> bool:
    """Whether a line says nothing but to people."""
    return _COMMENT.match(line) is not None


def split_cells(line: str, separator: str) -> list[str]:
    """Stripped cells.

    Raises:
        csv.Error: a quote is not closed.
    """
    if '"' in line:
        cells = next(
            csv.reader([line.strip(" ")], delimiter=separator, strict=True, skipinitialspace=True)
        )
        return [cell.strip() for cell in cells]
    return line.split() if separator == " " else [cell.strip() for cell in line.split(separator)]


def find_layout(lines: list[Line], stated: Layout, file: Path) -> TextLayout:
    """The one layout by which the ``lines`` (number and text, without blank ones) are a table.

    Raises:
        InputError: there is none, or several; says what to state.
    """
    said = _SAID.fullmatch(lines[0][1])
    if said and said[1] in WORDS:
        stated = stated if stated.separator else replace(stated, separator=_key(said[1]))
        lines = [(0, "#"), *lines[1:]]
    tried = [stated.separator] if stated.separator else list(SEPARATORS)
    layouts = [_layout_by(SEPARATORS[one], lines, stated) for one in tried]
    read = [layout for layout in layouts if layout is not None]
    if not read:
        raise _no_rows(lines, file)
    best = _only_consistent(read, file) or max(read, key=_completeness)
    if best.complaint:
        raise InputError(best.complaint[1], file, best.complaint[0])
    return best


def _completeness(layout: TextLayout) -> tuple[bool, int]:
    """Of layouts that are not consistent, the best has no complaint, and most columns."""
    return layout.complaint is None, len(layout.headings)


def _only_consistent(layouts: list[TextLayout], file: Path) -> TextLayout | None:
    """The layout that all rows agree with; None: there is none.

    Raises:
        InputError: there are several.
    """
    fits = [layout for layout in layouts if layout.consistent]
    if len(fits) > 1 and fits[-1].separator == " ":  # Tabs are blanks too.
        fits.pop()
    if len(fits) > 1:
        words = " or ".join(WORDS[layout.separator] for layout in fits)
        message = (
            f"the columns may be separated by {words}; state it under [recording], as separator = "
        )
        raise InputError(f'{message}"{_key(fits[0].separator)}"', file, fits[0].header_line)
    return fits[0] if fits else None


def _key(separator: str) -> str:
    return next(key for key, one in SEPARATORS.items() if one == separator)


def _no_rows(lines: list[Line], file: Path) -> InputError:
    held = [number for number, line in lines if not is_comment(line)]
    if not held:
        return InputError("the file is empty; begin with a header such as 'time [s],p [kPa]'", file)
    return InputError(
        "there are no rows below the header: no line begins with a number and has several cells, "
        "separated by commas, semicolons, tabs or blanks",
        file,
        held[-1],
    )


def _layout_by(separator: str, lines: list[Line], stated: Layout) -> TextLayout | None:
    """The layout by this separator; None when there are no rows."""
    after = max(stated.header_line or 0, stated.units_line or 0)
    rows, start = _cells(separator, lines, after, _is_row)
    if start is None:
        rows, start = _cells(separator, lines, after, _is_dated_row)
    if start is None:
        return None
    start = _first_row(rows, start)
    comments = [(number, line) for number, line in lines[: rows[start].index] if is_comment(line)]
    header = _header(separator, rows[:start], rows[start].cells, comments, stated)
    if isinstance(header, str):
        return TextLayout(separator, (), 0, rows[start].index, False, (rows[start].number, header))
    headings = header.headings()
    kept = [
        i for i, (heading, _) in enumerate(headings) if stated.keeps(heading, _name_in(heading))
    ]
    fits = all(_fits(row.cells, len(headings), kept, stated.missing) for row in rows[start:])
    return TextLayout(separator, headings, header.line, rows[start].index, fits)


def _first_row(rows: list[_Row], start: int) -> int:
    """The first row of numbers: a faulty one is no header, a number is among its cells, and a header stands above."""
    count = len(rows[start].cells)
    while (
        start > 1 and _holds_number(rows[start - 1], count) and len(rows[start - 2].cells) == count
    ):
        start -= 1
    return start


def _name_in(heading: str) -> str:
    """The name in a heading, without its unit; "" where it holds none."""
    parts = split_heading(heading)
    return parts[0] if parts else ""


def _cells(
    separator: str, lines: list[Line], after: int, is_row: Callable[[list[str]], bool]
) -> tuple[list[_Row], int | None]:
    """The header's lines and some rows, and which is the first row below the line ``after``."""
    rows: list[_Row] = []
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
        rows.append(_Row(index, number, line, cells))
        if len(rows) - start > LOOKED_AT if start is not None else number > after + _DEEPEST:
            break
    return rows, start


def _is_row(cells: list[str]) -> bool:
    numbers = sum(1 for cell in cells if not cell or _NUMBER.fullmatch(cell))
    return len(cells) > 1 and bool(_NUMBER.fullmatch(cells[0])) and 2 * numbers >= len(cells)


def _is_dated_row(cells: list[str]) -> bool:
    """A row that begins with a text, such as a date, has more numbers than texts."""
    return len(cells) > 2 and 2 * sum(1 for cell in cells if _NUMBER.fullmatch(cell)) > len(cells)


def _holds_number(row: _Row, count: int) -> bool:
    return len(row.cells) == count and any(_NUMBER.fullmatch(cell) for cell in row.cells)


def _fits(cells: list[str], count: int, kept: list[int], missing: frozenset[str]) -> bool:
    if len(cells) < count or any(cells[count:]):
        return False
    return all(
        not cells[i] or _NUMBER.fullmatch(cells[i]) or cells[i].casefold() in missing for i in kept
    )


def _ends(count: int, row: list[str]) -> bool:
    """Whether so many names are those of a row: separators at the end of a line make no column."""
    return 0 < count <= len(row) and not any(row[count:])


def _header(
    separator: str, above: list[_Row], ends: list[str], comments: list[Line], stated: Layout
) -> _Header | str:
    """The header of rows such as ``ends``, or why there is none."""
    count = len(ends)
    if stated.names is not None:
        return _Header(0, list(stated.names))
    if stated.header_line is not None or stated.units_line is not None:
        return _stated_header(separator, above, count, stated)
    if not above:
        return _header_in_comment(separator, comments, count) or _NO_HEADER
    last = above[-1]
    if len(above) > 1 and _are_units(last.cells):
        names = _names(separator, above[-2].text, count)
        if _ends(len(names), ends) and _ends(len(names), last.cells) and all(names):
            return _Header(above[-2].number, names, _bare(last.cells))
    names = _names(separator, last.text, count)
    if _ends(len(names), ends):
        return _Header(last.number, names)
    decimal = (
        "; write decimal points, not commas" if separator == "," and count == 2 * len(names) else ""
    )
    return f"this row has {count} cells, the header has {len(names)}{decimal}"


_NO_HEADER = (
    "the header is missing; begin with a line such as 'time [s],p [kPa]', or state it under [recording]: "
    'names = ["time [s]", "p [kPa]"]'
)


def _header_in_comment(separator: str, comments: list[Line], count: int) -> _Header | None:
    """The last comment above the rows, where it has as many names as they have cells."""
    if not comments:
        return None
    number, text = comments[-1]
    cells = _names(separator, _COMMENT.sub("", text, count=1), count)
    return _Header(number, cells) if len(cells) == count else None


def _stated_header(separator: str, above: list[_Row], count: int, stated: Layout) -> _Header | str:
    by_line = {row.number: row for row in above}
    units = by_line.get(stated.units_line or 0)
    if stated.units_line is not None and units is None:
        return f"units_line = {stated.units_line}, but there is no such line above this first row"
    earlier = [row for row in above if units is None or row.number < units.number]
    names = (
        by_line.get(stated.header_line)
        if stated.header_line is not None
        else earlier[-1]
        if earlier
        else None
    )
    if names is None:
        return f"header_line = {stated.header_line}, but there is no such line above this first row"
    cells = _names(separator, names.text, count)
    if len(cells) not in (count, count - 1) or (
        units is not None and len(units.cells) < len(cells)
    ):
        return f"this row has {count} cells, the header has {len(cells)}"
    return _Header(names.number, cells, None if units is None else _bare(units.cells))


def _bare(units: list[str]) -> list[str]:
    """Units without brackets around them."""
    return [re.sub(r"[\[(](.*)[\])]", r"\1", unit).strip() for unit in units]


def _are_units(cells: list[str]) -> bool:
    bracketed = all(not cell or (cell[0] + cell[-1] in ("[]", "()")) for cell in cells)
    return any(cells) and (bracketed or all(is_unit(cell) for cell in cells))


def _names(separator: str, text: str, count: int) -> list[str]:
    """Names apart by blanks may have a unit apart from them, or blanks in them where two separate."""
    try:
        cells = split_cells(text, separator)
    except csv.Error:
        return []
    if separator == " " and len(cells) != count:
        cells = [word.strip() for word in re.findall(r"\S+(?:\s+[\[(][^\])]*[\])])?", text)]
        if len(cells) != count:
            cells = re.split(r"\s{2,}|\t", text.strip())
    while len(cells) > 1 and not cells[-1]:
        cells = cells[:-1]
    return [" ".join(cell.split()) if "\n" in cell else cell for cell in cells]


def decimal_sign(cells: Iterable[tuple[int, str]], separator: str, file: Path) -> str:
    """The sign before the decimals.

    Args:
        cells: number of the line and text of every cell that holds a number or something like it.

    Raises:
        InputError: all numbers with a sign could be grouped thousands.
    """
    if separator == ",":
        return "."
    first: tuple[int, str] | None = None
    for line, cell in cells:
        sign = "," if "," in cell else "." if "." in cell else ""
        if sign and _NUMBER.fullmatch(cell) and not _THOUSANDS.fullmatch(cell):
            return sign
        if sign and first is None:
            first = (line, cell)
    if first is None:
        return "."
    sign = "," if "," in first[1] else "."
    message = (
        f"{shown(first[1])} may have decimals or be grouped by thousands, and no other number tells"
    )
    hint = f'state decimal = "{sign}" under [recording], or write numbers without groups'
    raise InputError(f"{message}; {hint}", file, first[0])
