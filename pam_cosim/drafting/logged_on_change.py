"""Set points and commands that a logger writes only when they change: their cells are empty until the next value."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.measurement.recording import filled_forward


def with_values_kept(columns: Sequence[RecordedColumn]) -> list[RecordedColumn]:
    """The columns, of which those that are logged on change have their value in every row, if rows follow in time."""
    if not any(c.of("time") for c in columns):
        return list(columns)
    return [_kept(c) if _is_logged_on_change(c) else c for c in columns]


def _is_logged_on_change(column: RecordedColumn) -> bool:
    """Whether somebody sets it, and most likely no slip left the cells empty."""
    meaning = column.meaning
    if meaning is None or column.whole:
        return False
    return meaning.kind in ("command", "current") or "set" in meaning.roles


def _kept(column: RecordedColumn) -> RecordedColumn:
    empty = int(np.isnan(column.every).sum())
    why = f"{empty} of {len(column.every)} cells are empty: it keeps the value above"
    values = {i: filled_forward(one) for i, one in column.values.items()}
    return replace(column, values=values, why=(*column.why, why), logged_on_change=True)
