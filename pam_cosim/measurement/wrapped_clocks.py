"""Clocks that are counters of so many bits, which restart at zero when they are full."""

from __future__ import annotations

from collections.abc import Set as AbstractSet
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.measurement.table import Column, Table

LONGEST_STEP = 3.0  # median steps: a clock has no longer step

WRAPPED = "a counter was full"
"""The first words of a note on a clock that restarted."""
_BITS = (16, 32)


def with_clocks_going_on(table: Table, clocks: AbstractSet[str | int] | None = None) -> Table:
    """The table with clocks that go on where their counter was full, and a note on each.

    Args:
        table: as the file has it.
        clocks: names, headings or places of the columns of times; None: every column may be one.
    """
    for name, column in table.columns.items():
        if clocks is not None and clocks.isdisjoint((name, column.heading, column.place)):
            continue
        bits = _bits_of(column.values)
        if bits is not None:
            table = _going_on(table, name, column, bits)
    return table


def _going_on(table: Table, name: str, column: Column, bits: int) -> Table:
    falls = np.diff(column.values) < 0.0
    turns = np.concatenate([[0.0], np.cumsum(falls)])
    times = "once" if falls.sum() == 1 else f"{falls.sum()} times"
    note = f"{WRAPPED} {times}, that of {name}, which has {bits} bits: the time is continued"
    columns = {**table.columns, name: replace(column, values=column.values + 2.0**bits * turns)}
    return replace(table, columns=columns, notes=(*table.notes, note))


def _bits_of(values: Array) -> int | None:
    """Of how many bits a counter is that runs evenly but for falling by what these can count; None: it is none."""
    if not np.isfinite(values).all() or (values != np.round(values)).any():
        return None
    steps = np.diff(values)
    falls, rises = steps[steps < 0.0], steps[steps >= 0.0]
    usual = float(np.median(rises)) if rises.size else 0.0
    if not falls.size or not 0.0 < rises.max(initial=0.0) <= LONGEST_STEP * usual:
        return None
    spread = float(np.ptp(rises))
    fits = (bits for bits in _BITS if np.all(np.abs(falls + 2.0**bits - usual) <= spread))
    return next(fits, None)
