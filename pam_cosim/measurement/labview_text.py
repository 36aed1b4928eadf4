"""The block above the rows of a text that LabVIEW (.lvm) or an oscilloscope writes: units of the channels."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.measurement.cell_kinds import NUMBER
from pam_cosim.measurement.table import is_unit
from pam_cosim.measurement.text_rows import Line, Row

TIME = "x_value"
"""How LabVIEW heads its times, in small letters, again before each channel that has times of its own."""
_FIRST = "LabVIEW Measurement"
_END = "***End_of_Header***"
_UNITS, _ALONG, _HORIZONTAL = ("Y_Unit_Label", "Vertical Units"), "X_Dimension", "Horizontal Units"
_START, _STEP = "X0", "Delta_X"
_COMMENT = "Comment"


def end_of_header(lines: Sequence[Line]) -> int:
    """The number of the line that ends the block of the first channels; 0 where LabVIEW did not write the text.

    The block has rows such as ``Samples 500 500``, which look like rows of numbers.
    """
    if not lines or not lines[0][1].startswith(_FIRST):
        return 0
    ends = [number for number, line in lines if line.startswith(_END)]
    return ends[:2][-1] if ends else 0


def units_above(above: Sequence[Row], count: int) -> list[str] | None:
    """The units in the block above the names, "" where it has no unit; None where there is no such line.

    A channel's label may be a text of the programmer's; one that names no unit is passed over.
    """
    cells_by_key = {row.cells[0]: row.cells for row in above if row.cells}
    key = next((key for key in _UNITS if key in cells_by_key), None)
    if key is None:
        return None
    along = "s" if "Time" in cells_by_key.get(_ALONG, ()) else ""
    along = along or (cells_by_key.get(_HORIZONTAL, ["", ""])[1:] or [""])[0]
    units = [cell if is_unit(cell) else "" for cell in [along, *cells_by_key[key][1:]]]
    return [*units, *[""] * count][:count]


def completed(lines: list[Line]) -> list[Line]:
    """The lines, of whose rows none lacks a cell that LabVIEW leaves out.

    Rows without a comment have no cell below ``Comment``, and where the file has no times (``X_Columns No``) they
    follow from ``X0`` and ``Delta_X``. A text that LabVIEW did not write stays as it is.
    """
    end = end_of_header(lines)
    below = [i for i, (number, _) in enumerate(lines) if number > end] if end else []
    heading = lines[below[0]][1] if below else ""
    if not heading.casefold().startswith(TIME):
        return lines
    separator, rows = heading[len(TIME) : len(TIME) + 1], lines[below[0] + 1 :]
    if separator and heading.split(separator)[-1].strip() == _COMMENT:
        lacking = heading.count(separator) - 1  # separators of a row without a comment
        rows = [(n, row + separator * (row.count(separator) == lacking)) for n, row in rows]
    if separator and all(row.startswith(separator) for _, row in rows):
        times = _times(lines[: below[0]], separator, len(rows))
        rows = [(n, time + row) for time, (n, row) in zip(times, rows, strict=True)]
    return [*lines[: below[0] + 1], *rows]


def _times(above: Sequence[Line], separator: str, count: int) -> list[str]:
    """The times of so many rows as LabVIEW writes them; empty where the channels' times differ or are not stated."""
    cells_by_key = {key: set(cells) for _, line in above for key, *cells in [line.split(separator)]}
    starts, step = (sorted(cells_by_key.get(key, set()) - {""}) for key in (_START, _STEP))
    numbers = [*starts, *step]
    if len(starts) != 1 or len(step) != 1 or not all(map(NUMBER.fullmatch, numbers)):
        return [""] * count
    begin, interval = (float(number.replace(",", ".")) for number in numbers)
    times = [f"{begin + k * interval:.12g}" for k in range(count)]
    return [number.replace(".", ",") for number in times] if "," in "".join(numbers) else times
