"""Cells that hold a number and its unit, ``0.01 sec``, as tables of measured quantities are exported."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

from pam_cosim.measurement.table import is_unit
from pam_cosim.measurement.text_rows import NUMBER, is_number

_MEASURED = re.compile(rf"(?:{NUMBER.pattern})\s*(?P<unit>[A-Za-zµμ%°][^\s\d]*)", re.ASCII)


def unit_behind(cell: str) -> str:
    """The unit behind the number in a cell; "" where it is no number with a unit."""
    match = _MEASURED.fullmatch(cell)
    return match["unit"] if match and _is_known(match["unit"]) else ""


def unit_of(cells: Sequence[str]) -> str:
    """The one unit behind the number in each of the cells; "" where there is none, or are several."""
    first = unit_behind(cells[0]) if cells else ""
    return first if first and all(unit_behind(cell) == first for cell in cells) else ""


def is_measured(cell: str) -> bool:
    """Whether a cell holds a number, be it with a unit."""
    return is_number(cell) or bool(unit_behind(cell))


def is_measured_row(cells: list[str]) -> bool:
    """A row that begins with a number and its unit, and holds nothing else than such and numbers."""
    filled = [cell for cell in cells if cell]
    return len(cells) > 1 and bool(unit_behind(cells[0])) and all(map(is_measured, filled))


@lru_cache(maxsize=256)
def _is_known(unit: str) -> bool:
    return is_unit(unit)
