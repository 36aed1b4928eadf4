"""A CSV file against a bench: which columns are inputs and measurements, converted to the bench's units."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.errors import InputError
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.signal import Averaged
from pam_cosim.measurement.table import LEFT_OUT, TIME, Layout, Table, Words
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import LARGEST, UnitError, convert, pressure_reference
from pam_cosim.wording import did_you_mean, listed, shown

EMPTY_SHARE = 0.1  # of the rows: a column with more keeps its value, or is a slower measurement


@dataclass(frozen=True)
class Recording:
    """Columns of one file, in the bench's units; all arrays are read-only.

    Attributes:
        time: (n,) [s], not decreasing, at most two rows at one time.
        inputs: (n,) each, without gaps.
        measurements: (n,) each, NaN where a sample is missing.
        notes: what a reader should know of how the file was read.
        averaged: of signals whose samples are means.
    """

    time: NDArray[np.float64]
    inputs: dict[str, NDArray[np.float64]]
    measurements: dict[str, NDArray[np.float64]]
    notes: tuple[str, ...] = ()
    averaged: dict[str, Averaged] = field(default_factory=dict)


def read_recording(file: Path, interface: Interface) -> Recording:
    """Reads inputs and measured outputs of a bench from a file whose columns are named as they are.

    Raises:
        InputError: see ``read_table`` and ``recording_of``.
    """
    table = read_table(file, Layout(words=words_of(interface)))
    for name in _unknown(table, interface):
        raise table.error(interface.unknown(name, "input or output", _headings(interface)), name)
    return recording_of(table, interface)


def recording_of(table: Table, interface: Interface) -> Recording:
    """Inputs and measured outputs of a bench.

    Raises:
        InputError: an unknown column, a unit that does not fit, a gap in time or an input, time that goes back,
            fewer than two rows.
    """
    for name in _unknown(table, interface):
        raise table.error(unknown_column(name, interface), name)
    table = only_whole_rows(table, [TIME, *interface.inputs])
    time = _time(table)
    inputs, measurements = {}, {}
    for name in table.columns:
        if name in interface.inputs:
            inputs[name] = without_gaps(table, name, interface.inputs[name])
        elif name in interface.outputs:
            measurements[name] = converted(table, name, interface.outputs[name])
    return Recording(time, inputs, measurements, table.notes)


def only_whole_rows(table: Table, needed: Iterable[str]) -> Table:
    """The table without the rows in which a needed column lacks a sample; only where words for missing ones are stated.

    Without such words an empty cell is an error.
    """
    needed = [name for name in needed if name in table.columns]
    columns = [table.columns[name].values for name in needed]
    if not table.missing or not columns:
        return table
    is_complete = np.asarray(~np.isnan(np.array(columns)).any(axis=0))
    if is_complete.all():
        return table
    if not is_complete.any():
        raise InputError(f"no row has values in all required columns: {listed(needed)}", table.file)
    count, words = int((~is_complete).sum()), listed(map(shown, table.missing))
    note = f"{LEFT_OUT} {count} of {len(is_complete)} rows, in which a value that is needed is missing ({words})"
    return replace(table.rows(is_complete), notes=(*table.notes, note))


def with_held_values(table: Table, held: Iterable[str]) -> Table:
    """The table in which an empty cell of a ``held`` column has the last value above it, where it is logged on change.

    Where few cells are empty, they are slips, and stay so.

    Raises:
        InputError: nothing stands above an empty cell.
    """
    columns = dict(table.columns)
    notes = []
    for name in held:
        empty = np.isnan(columns[name].values) if name in columns else np.zeros(1, dtype=bool)
        if np.mean(empty) <= EMPTY_SHARE:
            continue
        if empty[0]:
            message = (
                "the cell is empty, and no row above has a value; write the value at that time"
            )
            raise table.error(message, name, 0)
        columns[name] = replace(columns[name], values=filled_forward(columns[name].values))
        notes.append(f"{name} keeps its value over {int(empty.sum())} empty cells of {len(empty)}")
    return replace(table, columns=columns, notes=(*table.notes, *notes)) if notes else table


def filled_forward(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n,) the values, where one is missing the last one before it; NaN where there is none."""
    last = np.maximum.accumulate(np.where(np.isnan(values), 0, np.arange(len(values))))
    return values[last]


def unknown_column(name: str, interface: Interface, time: bool = True) -> str:
    """The message on a column that the bench does not know; ``time``: one of time is expected."""
    if name in interface.parameters:
        return f"{shown(name)} is a parameter of {interface.model}; set it under [runs.parameters]"
    headings = _headings(interface, time)
    hint = "state what it is under [columns], or leave it out: [recording] ignore = [...]"
    return f"{interface.unknown(name, 'input or output', headings)}; {hint}"


def _unknown(table: Table, interface: Interface) -> Iterator[str]:
    headings = _headings(interface)
    return (name for name in table.columns if name not in headings)


def _headings(interface: Interface, time: bool = True) -> dict[str, None]:
    return dict.fromkeys([*([TIME] if time else []), *interface.inputs, *interface.outputs])


def words_of(interface: Interface, columns: Mapping[str, str] | None = None) -> Words:
    """Words that columns of inputs and outputs may hold: of Booleans on and off, the items of enumerations.

    Args:
        interface: of the model.
        columns: by name, the heading in the file, where it is another one.
    """
    variables = {**interface.inputs, **interface.outputs}
    headings = columns or {}
    return {headings.get(n, n): dict(v.words) for n, v in variables.items() if v.words}


def converted(table: Table, name: str, variable: Variable) -> NDArray[np.float64]:
    """(n,) values of a column in the unit of a variable of the bench.

    Raises:
        InputError: the units do not fit, a value is too large, or none that the variable may have.
    """
    column = table.columns[name]
    unit, reference = pressure_reference(column.unit)
    if reference and variable.pressures != "gauge":
        _check_pressure(table, name, reference, variable.pressures)
    else:
        unit = column.unit
    try:
        values = convert(column.values, unit, variable.unit)
    except UnitError as error:
        raise table.error(f"{error}; the heading is '{name} [unit]'", name) from None
    too_large = np.flatnonzero(np.abs(values) > LARGEST)
    if too_large.size:
        raise table.error("the value is too large", name, int(too_large[0]))
    if variable.kind != "Real":
        for value in np.unique(values[np.isfinite(values)]):
            if not variable.allows(float(value)):
                row = int(np.flatnonzero(values == value)[0])
                message = f"{value:g} is no value of {name}, which must be {variable.values}"
                raise table.error(message, name, row)
    return locked(values)


def _check_pressure(table: Table, name: str, reference: str, of_model: str) -> None:
    """Raises InputError where a column states "absolute" or "gauge", and the model's pressures are unknown."""
    if reference == of_model:
        return
    unit = table.columns[name].unit
    statement = f"unit {shown(unit)} means that the pressure is {reference}"
    if of_model:
        plain = pressure_reference(unit)[0]
        hint = f'state unit = "{plain}", offset = "101.325 kPa" under [columns]'
        raise table.error(f"{statement}, those of the model are {of_model}; {hint}", name)
    hint = 'pressures = "absolute" or pressures = "gauge" at the top of experiment.toml, above all tables'
    raise table.error(
        f"{statement}, but the kind of the pressures of the model is not stated; state {hint}", name
    )


def locked(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same array of any shape, read-only."""
    values.setflags(write=False)
    return values


def without_gaps(
    table: Table,
    name: str,
    variable: Variable,
    rule: str = "only measured outputs may lack samples, time and inputs may not",
) -> NDArray[np.float64]:
    """Values (n,) of a column without empty cells, in the unit of a variable of the bench.

    Args:
        table: the file.
        name: the column.
        variable: has the unit.
        rule: end of the message about an empty cell.

    Raises:
        InputError: a cell is empty, or as for ``converted``; with the line.
    """
    values = converted(table, name, variable)
    gaps = np.flatnonzero(np.isnan(values))
    if gaps.size:
        raise table.error(f"the cell is empty; {rule}", name, int(gaps[0]))
    return values


def _time(table: Table) -> NDArray[np.float64]:
    """(n,) [s]."""
    if TIME not in table.columns:
        message = f"there is no column 'time [s]'; {did_you_mean(TIME, table.columns)}"
        raise InputError(message, table.file, table.header_line)
    time = without_gaps(table, TIME, Variable(TIME, "s"))
    if len(time) < 2:
        raise table.error("there is only one row; a recording needs two at least", TIME, 0)
    with np.errstate(over="ignore"):
        steps = np.diff(time)
    back = np.flatnonzero(steps < 0.0)
    if back.size:
        row = int(back[0]) + 1
        went = f"time goes back, from {time[row - 1]:.9g} s to {time[row]:.9g} s"
        meant = 'in a data set state what that means: gaps = "split" or "through"'
        raise table.error(f"{went}; {meant}", TIME, row)
    third = np.flatnonzero((steps[1:] == 0.0) & (steps[:-1] == 0.0))
    if third.size:
        row = int(third[0]) + 2
        raise table.error(
            f"a third row at {time[row]:.9g} s; a step is two rows at one time. If the clock is too coarse, state how "
            "far rows are apart: [recording] interval",
            TIME,
            row,
        )
    if time[-1] == time[0]:
        raise table.error("the recording has no duration", TIME, 0)
    return time
