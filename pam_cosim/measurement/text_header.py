"""The header of a text table: names and units of its columns."""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass

from pam_cosim.measurement import labview_text
from pam_cosim.measurement.table import Layout, is_unit, names_unit
from pam_cosim.measurement.text_rows import (
    COMMENT,
    Line,
    Row,
    split_cells,
)


@dataclass(frozen=True)
class _Header:
    line: int
    names: list[str]
    units: list[str] | None = None

    def headings(self) -> tuple[tuple[str, str], ...]:
        """Heading as written and unit from a row of units."""
        units = (self.units or [])[: len(self.names)]
        return tuple(zip(self.names, [*units, *[""] * (len(self.names) - len(units))], strict=True))


def _ends(count: int, row: list[str]) -> bool:
    """Whether so many names are those of a row: separators at the end of a line make no column."""
    return 0 < count <= len(row) and not any(row[count:])


def header_of(
    separator: str, above: list[Row], ends: list[str], comments: list[Line], stated: Layout
) -> _Header | str:
    """The header of rows such as ``ends``, or why there is none."""
    count = len(ends)
    if stated.names is not None:
        return _Header(0, list(stated.names))
    if stated.header_line is not None or stated.units_line is not None:
        return _stated_header(separator, above, count, stated)
    if not above:
        return _header_in_comment(separator, comments, count) or _NO_HEADER
    above = _without_labels(above, count)
    last = above[-1]
    if len(above) > 1 and _are_units(last.cells):
        names = _names(separator, above[-2].text, count)
        if _ends(len(names), ends) and _ends(len(names), last.cells) and all(names):
            return _Header(above[-2].number, names, _bare(last.cells))
    names = _names(separator, last.text, count)
    if _ends(len(names), ends):
        return _Header(last.number, names, labview_text.units_above(above[:-1], len(names)))
    decimal = (
        "; write decimal points, not commas" if separator == "," and count == 2 * len(names) else ""
    )
    reason = f"this row has {count} cells, the header has {len(names)}{decimal}"
    fits = [row for row in above[:-1] if len(_names(separator, row.text, count)) == count]
    return f"{reason}; {other_line(fits[-1].number)}" if fits and not decimal else reason


def other_line(number: int) -> str:
    """What to state where names stand elsewhere, such as on this line."""
    return f"where another line holds the names, state it under [recording]: header_line = {number}"


def _without_labels(above: list[Row], count: int) -> list[Row]:
    """The rows without those just above the numbers that repeat one word for all columns, such as their type."""
    while len(above) > 1 and len(above[-2].cells) >= count > 1 and _ends(count, above[-1].cells):
        if len({cell for cell in above[-1].cells if cell}) != 1:
            break
        above = above[:-1]
    return above


_NO_HEADER = (
    "the header is missing; begin with a line such as 'time [s],p [kPa]', or state it under [recording]: "
    'names = ["time [s]", "p [kPa]"]'
)


_BESIDE = "where units stand next to the names, such as 'p [kPa]', leave units_line out"


def _header_in_comment(separator: str, comments: list[Line], count: int) -> _Header | None:
    """The last comment above the rows, where it has as many names as they have cells."""
    if not comments:
        return None
    number, text = comments[-1]
    bare = re.sub(r"^\s*\w+:\s+", "", COMMENT.sub("", text, count=1))  # "columns: t/s  p/kPa"
    cells = _names(separator, bare, count)
    return _Header(number, cells) if len(cells) == count else None


def _stated_header(separator: str, above: list[Row], count: int, stated: Layout) -> _Header | str:
    if stated.header_line is not None and stated.header_line == stated.units_line:
        return f"header_line and units_line are both {stated.units_line}; {_BESIDE}"
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
    if names is None and stated.header_line is None:
        below = [row.number for row in above if row.number > (stated.units_line or 0)]
        hint = f"state theirs too, such as header_line = {below[0]}" if below else _BESIDE
        return f"units_line = {stated.units_line}, but no line above it holds names; {hint}"
    if names is None:
        return f"header_line = {stated.header_line}, but there is no such line above this first row"
    cells = _names(separator, names.text, count)
    if len(cells) not in (count, count - 1) or (
        units is not None and len(units.cells) < len(cells)
    ):
        return f"this row has {count} cells, the header has {len(cells)}"
    return _Header(names.number, cells, None if units is None else _bare(units.cells))


def _bare(units: list[str]) -> list[str]:
    """Units without brackets around them, and without the capital that their names never have."""
    bare = [re.sub(r"[\[(](.*)[\])]", r"\1", unit).strip() for unit in units]
    return [unit.lower() if _is_capitalised(unit) else unit for unit in bare]


def _is_capitalised(cell: str) -> bool:
    """Whether a cell is the name of a unit but for its capital, as in ``Volt``."""
    return cell.istitle() and not is_unit(cell) and is_unit(cell.lower())


_UNIT = ("unit", "units", "einheit", "einheiten", "unité", "unités")
"""Words at the beginning of a row of units."""


def _are_units(cells: list[str]) -> bool:
    if cells and cells[0].casefold() in _UNIT:
        cells = cells[1:]
    bracketed = all(not cell or (cell[0] + cell[-1] in ("[]", "()")) for cell in cells)
    return any(cells) and (
        bracketed or all(names_unit(cell) or _is_capitalised(cell) for cell in cells)
    )


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
