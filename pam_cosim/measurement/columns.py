"""The columns of a file under the names of the bench: renamed, derived by formulas, with their zero taken."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.compiler.elementwise import evaluate, with_place
from pam_cosim.errors import InputError, ModelError
from pam_cosim.measurement.experiment_tables import ColumnTable
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


@dataclass(frozen=True)
class ColumnMapping:
    """``[columns]`` of a file."""

    tables: Mapping[str, ColumnTable]

    @property
    def sources(self) -> frozenset[str]:
        """Names of columns of the file that are read for others; further names in formulas do no harm."""
        names = set[str]()
        for name, table in self.tables.items():
            if table.formula is not None:
                names.update(_names_in(table.formula))
            elif not isinstance(table.column, int):
                names.add(table.column or name)
        return frozenset(names)

    @property
    def clock(self) -> frozenset[str | int]:
        """Names or places of the columns of the file that times are read from."""
        time = self.tables.get(TIME)
        if time is not None and time.formula is not None:
            return frozenset(_names_in(time.formula))
        return frozenset([TIME if time is None or time.column is None else time.column])

    def error(self, message: str, name: str, key: str) -> InputError:
        """An error about a key of the entry of a column."""
        return self.tables[name].error(f"column {shown(name)}: {message}", key)


def _names_in(formula: str) -> list[str]:
    return [quoted or bare for quoted, bare in _NAME.findall(formula)]


def with_columns(table: Table, renaming: ColumnMapping, needed: Collection[str] = ()) -> Table:
    """The table with the columns that ``[columns]`` describes; those they are made of are left out.

    A column of time that is ``needed`` stays, also where a formula reads it.

    Args:
        table: as the file has it.
        renaming: what ``[columns]`` states.
        needed: names of columns that must not lack a sample.

    Raises:
        InputError: a column that is not in the file, a formula that cannot be read or whose units do not fit, or that
            gives no number where one is needed; with the place.
    """
    made: dict[str, Column] = {}
    used: set[str] = set()
    notes: list[str] = []
    time = table.columns.get(TIME)
    staying = {time.heading} if time is not None and TIME in needed else set()
    for name, one in renaming.tables.items():
        if one.formula is not None:
            made[name], sources = _derived(table, made, renaming, name, one.formula)
            undefined = _undefined(made[name], sources)
            if undefined.any():
                if name in needed:
                    raise _no_number(table, name, one.formula, undefined)
                made[name] = _without(made[name], undefined)
                notes.append(_missing_rows(renaming, made[name], undefined))
            used |= sources.keys() - staying
        else:
            made[name] = _mapped(_renamed(table, renaming, name), renaming, name)
            used.add(made[name].heading)
    rest = {
        name: c for name, c in table.columns.items() if name not in made and c.heading not in used
    }
    return replace(table, columns={**rest, **made}, notes=(*table.notes, *notes))


def with_zeros(table: Table, renaming: ColumnMapping) -> Table:
    """The table with the zero of each column that has a rest interval taken off.

    Raises:
        InputError: a rest interval without samples, with the place.
    """
    for name, one in renaming.tables.items():
        if one.zero is not None:
            table = _zeroed(table, renaming, name)
    return table


def _renamed(table: Table, renaming: ColumnMapping, name: str) -> Column:
    one = renaming.tables[name]
    wanted = name if one.column is None else one.column
    columns = list(table.columns.values())
    if isinstance(wanted, int):
        places = {column.place or number: column for number, column in enumerate(columns, start=1)}
        if wanted not in places:
            known = ", ".join(map(str, sorted(places)))
            message = f"{table.file.name} has no column {wanted} that is read, only {known}"
            raise renaming.error(message, name, "column")
        source = places[wanted]
    else:
        alike = [column for column in columns if wanted in (column.name, column.heading)]
        if not alike:
            hint = did_you_mean(wanted, [column.name for column in columns])
            raise renaming.error(
                f"{table.file.name} has no column {shown(wanted)}; {hint}", name, "column"
            )
        source = alike[0]
    unit = source.unit if source.since else one.unit or source.unit
    return Column(name, unit, source.values, source.heading or source.name)


def _mapped(column: Column, renaming: ColumnMapping, name: str) -> Column:
    """The column by its stated gain and offset; a fitted map is one of the model (``input_maps``)."""
    one = renaming.tables[name]
    if one.gain is None and one.offset is None:
        return column
    key = "gain"
    try:
        result = quantity(column.values, column.unit) * quantity(
            one.gain.value if one.gain else 1.0
        )
        if one.offset is not None:
            key = "offset"
            result = result + _shift(one.offset, column.unit)
        values, unit = with_unit(result)
    except registry_errors(UnitError) as error:
        raise renaming.error(f"{key}: {error}", name, key) from None
    return replace(column, unit=unit, values=np.array(values))


def _shift(offset: Stated, unit: str) -> Any:
    """The offset of a column in ``unit``: of temperatures a difference; of what a gain makes one, a temperature."""
    if isinstance(offset.value, str) and quantity(0.0, unit).check("[temperature]"):
        return quantity(parse_quantity(offset.value, "K", difference=True), "K")
    return quantity(offset.value)


def _derived(
    table: Table, made: Mapping[str, Column], renaming: ColumnMapping, name: str, formula: str
) -> tuple[Column, dict[str, Array]]:
    """The column of a formula, and the values of what it is made of, by heading."""
    one = renaming.tables[name]
    for key in ("column", "unit", "gain", "offset"):
        if getattr(one, key) is not None:
            raise renaming.error(f"it has a formula and a {key}; keep one of them", name, key)
    known = _Quantities(
        {**{c.heading: c for c in table.columns.values() if c.heading}, **table.columns, **made}
    )
    try:
        with np.errstate(all="ignore"):
            result = evaluate(formula, known, quantity)
            values, unit = with_unit(result)
    except UnitError as error:
        raise renaming.error(str(error), name, "formula") from None
    except ModelError as error:
        raise renaming.error(with_place(error), name, "formula") from None
    except registry_errors() as error:
        raise renaming.error(
            f"the units of the formula do not fit: {error}", name, "formula"
        ) from None
    except (ArithmeticError, RecursionError, TypeError, ValueError) as error:
        raise renaming.error(f"the formula cannot be evaluated: {error}", name, "formula") from None
    count = len(next(iter(table.columns.values())).values)
    return Column(name, unit, np.array(np.broadcast_to(values, count))), known.used


def _undefined(column: Column, sources: Mapping[str, Array]) -> NDArray[np.bool_]:
    """(n,) the rows in which a formula gives no finite number, though every column that it reads has one."""
    wrong = ~np.isfinite(column.values)
    for values in sources.values():
        wrong &= np.isfinite(values)
    return wrong


def _no_number(table: Table, name: str, formula: str, undefined: NDArray[np.bool_]) -> InputError:
    """The error about the first row in which a column that may not lack samples lacks one by its formula."""
    message = f"the formula {shown(formula)} gives no finite number here; only measured outputs may lack samples"
    return table.error(message, name, int(np.flatnonzero(undefined)[0]))


def _without(column: Column, rows: NDArray[np.bool_]) -> Column:
    """The column without the samples of some rows."""
    return replace(column, values=np.where(rows, np.nan, column.values))


def _missing_rows(renaming: ColumnMapping, column: Column, undefined: NDArray[np.bool_]) -> str:
    """What a reader should know of the rows that a formula leaves without a sample."""
    if np.isnan(column.values).all():
        raise renaming.error("the formula gives a finite number in no row", column.name, "formula")
    rows = f"{int(undefined.sum())} of {len(undefined)} rows"
    return f"the formula of {column.name} is no finite number in {rows}, which count as missing"


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


def _zeroed(table: Table, renaming: ColumnMapping, name: str) -> Table:
    """The column less its mean in the rest interval."""
    one, column = renaming.tables[name].zero, table.columns[name]
    assert one is not None
    if TIME not in table.columns:
        raise renaming.error("a rest interval needs a column 'time'", name, "zero")
    try:
        start, stop = (parse_quantity(end.value, "s") for end in (one.start, one.to))
        time = convert(table.columns[TIME].values, table.columns[TIME].unit, "s")
        if float(quantity(0.0, column.unit).magnitude):
            raise UnitError(f"the zero of {shown(column.unit)} is no reading at rest")
    except UnitError as error:
        raise renaming.error(str(error), name, "zero") from None
    at_rest = column.values[(time >= start) & (time <= stop)]
    at_rest = at_rest[np.isfinite(at_rest)]
    if not at_rest.size:
        span = f"{time[0]:.6g} to {time[-1]:.6g} s"
        raise renaming.error(
            f"no sample in the rest interval; {table.file.name} is of {span}", name, "zero"
        )
    zero = float(np.mean(at_rest))
    note = f"the zero of {name}, {format_quantity(zero, column.unit)}, is the mean of {at_rest.size} samples at rest"
    columns = {**table.columns, name: replace(column, values=column.values - zero)}
    return replace(table, columns=columns, notes=(*table.notes, note))
