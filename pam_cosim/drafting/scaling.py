"""The entry of a column that is taken times a gain, plus an offset."""

from __future__ import annotations

from pam_cosim.drafting.mapped import ColumnEntry
from pam_cosim.drafting.recorded_column import RecordedColumn

GRAVITY = "9.80665 m/s2"
"""By which a weight is a mass."""


def scaled_entry(
    name: str, column: RecordedColumn, gain: str | None, offset: str | None, why: tuple[str, ...]
) -> ColumnEntry:
    """The entry of a column times a gain, plus an offset: as a formula, where one can hold the column."""
    if not column.readable:
        return ColumnEntry(name, column.name, column.unit, gain=gain or "1", offset=offset, why=why)
    term = f"'{column.name}'"
    if not column.stated and column.unit:
        term += f' * "1 {column.unit}"'
    if gain == "-1":
        formula = f'"{offset}" - {term}' if offset else f"-{term}"
    else:
        formula = term + (f' * "{gain}"' if gain else "")
        formula += f' - "{offset.removeprefix("-")}"' if offset else ""
    return ColumnEntry(name, formula=formula, why=why)
