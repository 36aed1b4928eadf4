"""A sweep for xarray and pandas."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from pam_cosim.libraries import library
from pam_cosim.sweeps.names import FAILURE, RUN, TIME

if TYPE_CHECKING:
    import pandas
    import xarray

    from pam_cosim.sweeps.result import Sweep


def axis_name(sweep: Sweep, name: str) -> str:
    """Of what is varied; a start value has the name of the variable that it starts, which may be there as well."""
    return f"start of {name}" if name in sweep.outputs else name


def columns_of(sweep: Sweep) -> dict[str, Any]:
    """What was varied, the scalars and the failures of all runs, by name."""
    design = sweep.design
    columns: dict[str, Any] = {
        axis_name(sweep, n): design.labels(n, design.points[:, i])
        for i, n in enumerate(design.names)
    }
    columns |= {scalar.name: sweep.column(scalar.name) for scalar in sweep.scalars}
    return {**columns, FAILURE: sweep.table.failures()}


def units_of(sweep: Sweep) -> dict[str, str]:
    """The units of ``columns_of``, and of the outputs."""
    return sweep.units | {axis_name(sweep, name): u for name, u in sweep.design.units.items()}


def frame(sweep: Sweep) -> pandas.DataFrame:
    """A row for each run."""
    table: pandas.DataFrame = library("pandas").DataFrame(columns_of(sweep)).rename_axis(RUN)
    table.attrs["units"] = units_of(sweep)
    return table


def dataset(sweep: Sweep) -> xarray.Dataset:
    """Everything, in memory."""
    dataset = skeleton(sweep)
    for name in sweep.outputs:
        dataset[name] = output(sweep, name)
    return dataset


def skeleton(sweep: Sweep) -> xarray.Dataset:
    """Everything but the values over time."""
    xarray = library("xarray")
    dims, shape, coordinates = _axes(sweep)
    variables = {
        s.name: (dims, sweep.column(s.name).reshape(shape), {"units": s.unit, "long_name": s.name})
        for s in sweep.scalars
    }
    failures = np.array(sweep.table.failures(), dtype=object).reshape(shape)
    if sweep.outputs:
        coordinates[TIME] = (TIME, sweep.time, {"units": "s"})
    attributes = {
        "model": sweep.interface.model,
        "settings": json.dumps(sweep.fixed),
        "design": sweep.design.kind,
    }
    variables[FAILURE] = (dims, failures, {})
    return xarray.Dataset(variables, coordinates, attributes)  # type: ignore[no-any-return]


def output(sweep: Sweep, name: str) -> xarray.DataArray:
    """One variable of all runs over time."""
    dims, shape, _ = _axes(sweep)
    variable = sweep.interface.variables[name]
    values = sweep.table.output(sweep.outputs.index(name)).reshape(*shape, sweep.time.size)
    attributes = {"units": variable.unit or "1", "long_name": variable.description or name}
    return library("xarray").DataArray(  # type: ignore[no-any-return]
        values, dims=(*dims, TIME), attrs=attributes, name=name
    )


def _axes(sweep: Sweep) -> tuple[tuple[str, ...], tuple[int, ...], dict[str, Any]]:
    """Dimensions, their lengths, and coordinates."""
    design, settable = sweep.design, sweep.interface.settable
    descriptions = {n: settable[n].description if n in settable else "" for n in design.names}
    described = {
        n: {"units": design.units[n] or "1", "long_name": descriptions[n] or n}
        for n in design.names
    }
    names = {n: axis_name(sweep, n) for n in design.names}
    if design.kind == "grid" and all(len(np.unique(v)) == len(v) for v in design.axes.values()):
        coordinates: dict[str, Any] = {
            names[n]: (names[n], design.labels(n, v), described[n]) for n, v in design.axes.items()
        }
        return tuple(names.values()), tuple(len(v) for v in design.axes.values()), coordinates
    columns = {
        names[n]: (RUN, design.labels(n, design.points[:, i]), described[n])
        for i, n in enumerate(design.names)
    }
    return (RUN,), (len(design),), {RUN: np.arange(len(design)), **columns}
