"""The block above the rows of a text that LabVIEW writes (.lvm): units of the channels, one below the other's place."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.measurement.table import is_unit
from pam_cosim.measurement.text_rows import Line, Row

TIME = "x_value"
"""How LabVIEW heads its times, in small letters, again before each channel that has times of its own."""
_FIRST = "LabVIEW Measurement"
_END = "***End_of_Header***"
_UNITS, _ALONG = "Y_Unit_Label", "X_Dimension"


def end_of_header(lines: Sequence[Line]) -> int:
    """The number of the line that ends the block of the first channels; 0 where LabVIEW did not write the text.

    The block has rows such as ``Samples 500 500``, which look like rows of numbers.
    """
    if not lines or not lines[0][1].startswith(_FIRST):
        return 0
    ends = [number for number, line in lines if line.startswith(_END)]
    return ends[:2][-1] if ends else 0


def units_above(above: Sequence[Row], count: int) -> list[str] | None:
    """What the block above so many names says of their units, "" where it is no unit; None where it says nothing.

    A channel's label may be a text of the programmer's; one that names no unit is passed over.
    """
    said = {row.cells[0]: row.cells for row in above if row.cells}
    if _UNITS not in said:
        return None
    along = "s" if "Time" in said.get(_ALONG, ()) else ""
    units = [along, *(cell if is_unit(cell) else "" for cell in said[_UNITS][1:])]
    return [*units, *[""] * count][:count]
