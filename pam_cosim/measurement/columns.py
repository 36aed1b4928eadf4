"""The columns of a file under the names of the bench: renamed, derived by formulas, with their zero taken."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.compiler.elementwise import evaluate, with_place
from pam_cosim.errors import InputError, ModelError
from pam_cosim.measurement.experiment_tables import ColumnTable, IntervalTable
from pam_cosim.measurement.place import Stated
from pam_cosim.measurement.table import TIME, Column, Table
from pam_cosim.units import (
    UnitError,
    convert,
    format_quantity,
    parse_quantity,
    quantity,
    registry_errors,
    with_unit,
)
from pam_cosim.wording import did_you_mean, shown

_NAME = re.compile(r"'([^']*)'|([A-Za-z_]\w*)", re.ASCII)


Columns = Mapping[str, ColumnTable]
"""``[columns]`` of a file."""


def sources_of(columns: Columns) -> frozenset[str]:
    """Names of columns of the file that are read for others; further names in formulas do no harm."""
    names = set[str]()
    for name, table in columns.items():
        if table.formula is not None:
            names.update(_names_in(table.formula))
        elif not isinstance(table.column, int):
            names.add(table.column or name)
    return frozenset(names)


def clock_of(columns: Columns) -> frozenset[str | int]:
    """Names or places of the columns of the file that times are read from."""
    time = columns.get(TIME)
    if time is not None and time.formula is not None:
        return frozenset(_names_in(time.formula))
    return frozenset([TIME if time is None or time.column is None else time.column])


def _error(name: str, entry: ColumnTable, message: str, key: str) -> InputError:
    return entry.error(f"column {shown(name)}: {message}", key)


def _names_in(formula: str) -> list[str]:
    return [quoted or bare for quoted, bare in _NAME.findall(formula)]


def with_columns(table: Table, columns: Columns, required: Collection[str] = ()) -> Table:
    """The table with the columns that ``[columns]`` describes; those they are made of are left out.

    A column of time that is required stays, also where a formula reads it.

    Args:
        table: as the file has it.
        columns: what ``[columns]`` states.
        required: names of columns that must have every sample.

    Raises:
        InputError: a column that is not in the file, a formula that cannot be read or whose units do not fit, or that
            gives no number where one is needed; with the place.
    """
    derived_columns: dict[str, Column] = {}
    used: set[str] = set()
    notes: list[str] = []
    time = table.columns.get(TIME)
    staying = {time.heading} if time is not None and TIME in required else set()
    for name, entry in columns.items():
        if entry.formula is not None:
            derived, sources = _derived(table, derived_columns, name, entry, entry.formula)
            derived_columns[name], remarks = _without_undefined(
                table, derived, entry, sources, required
            )
            notes += remarks
            used |= sources.keys() - staying
        else:
            derived_columns[name] = _mapped(_renamed(table, name, entry), entry)
            used.add(derived_columns[name].heading)
    unused_columns = {
        name: c
        for name, c in table.columns.items()
        if name not in derived_columns and c.heading not in used
    }
    return replace(
        table, columns={**unused_columns, **derived_columns}, notes=(*table.notes, *notes)
    )


def with_zeros(table: Table, columns: Columns) -> Table:
    """The table with the zero of each column that has a rest interval taken off.

    Raises:
        InputError: a rest interval without samples, with the place.
    """
    for name, entry in columns.items():
        if entry.zero is not None:
            table = _zeroed(table, name, entry, entry.zero)
    return table


def _renamed(table: Table, name: str, entry: ColumnTable) -> Column:
    source_name = name if entry.column is None else entry.column
    columns = list(table.columns.values())
    if isinstance(source_name, int):
        places = {column.place or number: column for number, column in enumerate(columns, start=1)}
        if source_name not in places:
            names = ", ".join(map(str, sorted(places)))
            message = (
                f"{table.file.name} has no column {source_name}; the columns that are read: {names}"
            )
            raise _error(name, entry, message, "column")
        source = places[source_name]
    else:
        alike = [column for column in columns if source_name in (column.name, column.heading)]
        if not alike:
            hint = did_you_mean(source_name, [column.name for column in columns])
            raise _error(
                name,
                entry,
                f"{table.file.name} has no column {shown(source_name)}; {hint}",
                "column",
            )
        source = alike[0]
    unit = source.unit if source.since else entry.unit or source.unit
    return Column(name, unit, source.values, source.heading or source.name)


def _mapped(column: Column, entry: ColumnTable) -> Column:
    """The column by its stated gain and offset; a fitted map is one of the model (``input_maps``)."""
    if entry.gain is None and entry.offset is None:
        return column
    key = "gain"
    try:
        result = quantity(column.values, column.unit) * quantity(
            entry.gain.value if entry.gain else 1.0
        )
        if entry.offset is not None:
            key = "offset"
            result = result + _shift(entry.offset, column.unit)
        values, unit = with_unit(result)
    except registry_errors(UnitError) as error:
        raise _error(column.name, entry, f"{key}: {error}", key) from None
    return replace(column, unit=unit, values=np.array(values))


def _shift(offset: Stated, unit: str) -> Any:
    """The offset of a column in ``unit``: of temperatures a difference; of what a gain makes one, a temperature."""
    if isinstance(offset.value, str) and quantity(0.0, unit).check("[temperature]"):
        return quantity(parse_quantity(offset.value, "K", difference=True), "K")
    return quantity(offset.value)


def _derived(
    table: Table, derived_columns: Mapping[str, Column], name: str, entry: ColumnTable, formula: str
) -> tuple[Column, dict[str, Array]]:
    """The column of a formula, and the values of what it is made of, by heading."""
    for key in ("column", "unit", "gain", "offset"):
        if getattr(entry, key) is not None:
            raise _error(name, entry, f"it has a formula and a {key}; keep one of them", key)
    quantities = _Quantities(
        {
            **{c.heading: c for c in table.columns.values() if c.heading},
            **table.columns,
            **derived_columns,
        }
    )
    try:
        with np.errstate(all="ignore"):
            result = evaluate(formula, quantities, quantity)
            values, unit = with_unit(result)
    except UnitError as error:
        raise _error(name, entry, str(error), "formula") from None
    except ModelError as error:
        raise _error(name, entry, with_place(error), "formula") from None
    except registry_errors() as error:
        raise _error(
            name, entry, f"the units of the formula do not fit: {error}", "formula"
        ) from None
    except (ArithmeticError, RecursionError, TypeError, ValueError) as error:
        raise _error(name, entry, f"the formula cannot be evaluated: {error}", "formula") from None
    count = len(next(iter(table.columns.values())).values)
    return Column(name, unit, np.array(np.broadcast_to(values, count))), quantities.used


def _without_undefined(
    table: Table,
    column: Column,
    entry: ColumnTable,
    sources: Mapping[str, Array],
    required: Collection[str],
) -> tuple[Column, list[str]]:
    """The column without the rows in which its formula gives no finite number of finite ones, and a note on them."""
    name, undefined = column.name, ~np.isfinite(column.values)
    for values in sources.values():
        undefined &= np.isfinite(values)
    if not undefined.any():
        return column, []
    if name in required:
        message = f"the formula {shown(entry.formula)} gives no finite number here"
        message = f"{message}; only measured outputs may lack samples"
        raise table.error(message, name, int(np.flatnonzero(undefined)[0]))
    column = replace(column, values=np.where(undefined, np.nan, column.values))
    if np.isnan(column.values).all():
        raise _error(name, entry, "the formula has no finite value in any row", "formula")
    rows = f"{int(undefined.sum())} of {len(undefined)} rows"
    return column, [f"the formula of {name} is no finite number in {rows}, which count as missing"]


class _Quantities(dict[str, Any]):
    """Columns by name, bare or in single quotes, as quantities of pint; made when a formula asks for them."""

    def __init__(self, columns: Mapping[str, Column]) -> None:
        super().__init__({**columns, **{f"'{name}'": column for name, column in columns.items()}})
        self.used: dict[str, Array] = {}

    def __getitem__(self, name: str) -> Any:
        column: Column = super().__getitem__(name)
        self.used[column.heading or column.name] = column.values
        try:
            return quantity(column.values, column.unit)
        except UnitError as error:
            raise UnitError(f"{column.name}: {error}") from None


def _zeroed(table: Table, name: str, entry: ColumnTable, rest_interval: IntervalTable) -> Table:
    """The column less its mean in the rest interval."""
    column = table.columns[name]
    if TIME not in table.columns:
        raise _error(name, entry, "a rest interval needs a column 'time'", "zero")
    try:
        start, stop = (
            parse_quantity(end.value, "s") for end in (rest_interval.start, rest_interval.to)
        )
        time = convert(table.columns[TIME].values, table.columns[TIME].unit, "s")
        if float(quantity(0.0, column.unit).magnitude):
            raise UnitError(f"the zero of {shown(column.unit)} is no reading at rest")
    except UnitError as error:
        raise _error(name, entry, str(error), "zero") from None
    at_rest = column.values[(time >= start) & (time <= stop)]
    at_rest = at_rest[np.isfinite(at_rest)]
    if not at_rest.size:
        span = f"{time[0]:.6g} to {time[-1]:.6g} s"
        raise _error(
            name, entry, f"no sample in the rest interval; {table.file.name} is of {span}", "zero"
        )
    zero = float(np.mean(at_rest))
    note = f"the zero of {name}, {format_quantity(zero, column.unit)}, is the mean of {at_rest.size} samples at rest"
    columns = {**table.columns, name: replace(column, values=column.values - zero)}
    return replace(table, columns=columns, notes=(*table.notes, note))
