"""Points at rest: a table without time against a bench, and its curves as recordings."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.measurement.curves import CONSTANT_RANGE, Curve, curves, directions
from pam_cosim.measurement.experiment_tables import RunTable
from pam_cosim.measurement.recording import (
    Recording,
    converted,
    locked,
    only_whole_rows,
    unknown_column,
    without_gaps,
)
from pam_cosim.measurement.table import TIME, Table
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH
from pam_cosim.units import format_quantity
from pam_cosim.wording import listed, shown

VALUE_TOLERANCE = 0.01  # of the range: a held-out value as near to one of the file is the same

WORDS = {"up": 1.0, "down": -1.0, "none": 0.0}
"""Directions of a branch in words: contraction, extension, not known."""
CONTRACTS = {"Pa": 1.0, "m": 1.0, "N": -1.0}
"""What a muscle does where an imposed quantity of this unit rises: 1 contracts, -1 extends."""


@dataclass(frozen=True)
class Points:
    """One curve of a file.

    Attributes:
        label: what sets it apart from the file's others; empty: there are none.
        along, unit: the input that varies along it.
        recording: sorted; its "time" is that input.
        holdout: these rows are held out.
    """

    label: str
    along: str
    unit: str
    recording: Recording
    holdout: bool


def points_of(
    table: Table,
    interface: Interface,
    run: RunTable,
    held: Mapping[str, float],
) -> list[Points]:
    """The curves of a table of points at rest.

    Args:
        table: with the columns as the bench names them.
        interface: the bench.
        run: what is stated of them.
        held: inputs that are stated for all rows.

    Raises:
        InputError: a column of time, an unknown one, an imposed quantity that is missing or has gaps, a branch that
            is none, a value to hold out that no row has.
    """
    _check_columns(table, interface)
    table = only_whole_rows(table, interface.inputs)
    imposed = {
        name: without_gaps(
            table,
            name,
            interface.inputs[name],
            "every row must have a value of each imposed column",
        )
        for name in table.columns
        if name in interface.inputs
    }
    read = {
        n: converted(table, n, interface.outputs[n])
        for n in table.columns
        if n in interface.outputs
    }
    _check_imposed(table, interface, imposed, held)
    branch = _branch(table, interface, run, imposed, read)
    driving = {name: values for name, values in imposed.items() if name != BRANCH}
    apart = [_held_out(table, interface, run, driving)]
    if branch is not None:
        imposed[BRANCH] = branch
        apart.append(-branch)
    curves_found = []
    for curve in curves(driving, read, apart):
        out = bool(apart[0][curve.rows[0]])
        label = ", ".join(
            filter(None, (_label(curve, interface), _way(branch, curve), "held out" if out else ""))
        )
        inputs, outputs = (
            {name: locked(values[curve.rows]) for name, values in columns.items()}
            for columns in (imposed, read)
        )
        recording = Recording(inputs[curve.along], inputs, outputs, table.notes)
        curves_found.append(
            Points(label, curve.along, interface.inputs[curve.along].unit, recording, out)
        )
    return _distinct(curves_found)


def _check_columns(table: Table, interface: Interface) -> None:
    if TIME in table.columns:
        message = 'points of kind = "static" have no time; leave the column out: [recording] ignore = ["time"]'
        raise table.error(message, TIME)
    for name in table.columns:
        if name not in interface.inputs and name not in interface.outputs:
            raise table.error(unknown_column(name, interface, time=False), name)


def _way(branch: Array | None, curve: Curve) -> str:
    """The direction of a curve, where others go the other way."""
    if branch is None or not float(np.ptp(branch)) > 0.0:
        return ""
    return next(word for word, value in WORDS.items() if value == branch[curve.rows[0]])


def _distinct(curves_found: list[Points]) -> list[Points]:
    """Labels of curves that are alike are numbered."""
    label_counts, numbered = Counter[str](), []
    for curve in curves_found:
        label_counts[curve.label] += 1
        number = f" ({label_counts[curve.label]})" if label_counts[curve.label] > 1 else ""
        numbered.append(replace(curve, label=curve.label + number))
    return numbered


def _check_imposed(
    table: Table, interface: Interface, imposed: Mapping[str, Array], held: Mapping[str, float]
) -> None:
    required_inputs = [name for name in interface.inputs if name != BRANCH]
    missing = [name for name in required_inputs if name not in imposed and name not in held]
    if missing:
        input_names = listed(required_inputs)
        raise InputError(
            f"there is no column {shown(missing[0])}, nor a value under [parameters]: a row imposes {input_names}",
            table.file,
            table.header_line,
        )
    if not any(name in imposed for name in required_inputs):
        message = (
            f"no column varies that is imposed: {listed(required_inputs)} are the same in all rows"
        )
        raise InputError(message, table.file, table.header_line)


def _branch(
    table: Table,
    interface: Interface,
    run: RunTable,
    imposed: dict[str, Array],
    read: Mapping[str, Array],
) -> Array | None:
    """(n,) direction of each row; None: unknown."""
    stated, column = run.branch, imposed.get(BRANCH)
    if stated is not None and BRANCH not in interface.inputs:
        message = (
            f"{interface.model} has no input '{BRANCH}', which gives the direction of friction"
        )
        hint = "use a quasi-static bench, or compose a bench with pam-cosim bench --static"
        raise run.error(f"{message}; {hint}", "branch")
    if column is not None:
        if stated is not None:
            raise run.error(
                f"{BRANCH} is stated here and a column of {table.file.name}; keep one of them",
                "branch",
            )
        wrong = np.flatnonzero(~np.isin(column, list(WORDS.values())))
        if wrong.size:
            row = int(wrong[0])
            raise table.error(
                f"{column[row]:g} is no direction; write up, down or none (1, -1, 0)", BRANCH, row
            )
        return column
    if stated is None:
        return None
    count = len(next(iter(imposed.values())))
    if stated in WORDS:
        return np.full(count, WORDS[stated])
    by_unit = {unit: [n for n in imposed if interface.inputs[n].unit == unit] for unit in CONTRACTS}
    driving = [name for names in by_unit.values() for name in names]
    ways, along = directions(imposed, driving, read)
    if not ways.any():
        message = f"the rows of {table.file.name} do not determine a direction: no pressure, length or load changes"
        raise run.error(message, "branch")
    return CONTRACTS[interface.inputs[along].unit] * ways


def _held_out(
    table: Table,
    interface: Interface,
    run: RunTable,
    imposed: Mapping[str, Array],
) -> Array:
    """(n,) 1 where a row is held out."""
    aside = np.zeros(len(next(iter(imposed.values()))))
    for name, values in run.hold_out.items():
        place = run.at("hold_out") / name
        if run.role == "holdout":
            raise place.error("the whole run is held out already; leave this out")
        if name not in imposed:
            message = f"{shown(name)} is no column of {table.file.name} that is imposed; those are {listed(imposed)}"
            raise place.error(message)
        column, unit = imposed[name], interface.inputs[name].unit
        tolerance = max(
            VALUE_TOLERANCE * float(np.ptp(column)),
            CONSTANT_RANGE * float(np.abs(column).max()),
        )
        for value in values:
            held_out_value = value.quantity(unit)
            is_held_out = np.abs(column - held_out_value) <= tolerance
            if not is_held_out.any():
                nearest = format_quantity(
                    float(column[np.argmin(np.abs(column - held_out_value))]), unit
                )
                raise place.error(
                    f"no row has {name} = {shown(value.value)}; the nearest is {nearest}"
                )
            aside[is_held_out] = 1.0
    if aside.all():
        raise run.error(f"no row of {table.file.name} remains to fit", "hold_out")
    return aside


def _label(curve: Curve, interface: Interface) -> str:
    parts = (
        f"{name} = {format_quantity(value, interface.inputs[name].unit)}"
        for name, value in curve.at.items()
    )
    return ", ".join(parts).replace("/", " per ")
