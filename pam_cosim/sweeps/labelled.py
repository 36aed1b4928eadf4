"""A sweep for xarray and pandas."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas
import xarray

from pam_cosim.sweeps.names import FAILURE, RUN, TIME

if TYPE_CHECKING:
    from pam_cosim.sweeps.result import Sweep


def axis_name(sweep: Sweep, name: str) -> str:
    """Of what is varied; a start value has the name of the variable that it starts, which may be there as well."""
    return f"start of {name}" if name in sweep.outputs else name


def frame(sweep: Sweep) -> pandas.DataFrame:
    """A row for each run."""
    design = sweep.design
    columns: dict[str, Any] = {
        axis_name(sweep, n): design.labels(n, design.points[:, i])
        for i, n in enumerate(design.names)
    }
    columns |= {scalar.name: sweep.column(scalar.name) for scalar in sweep.scalars}
    columns[FAILURE] = sweep.table.failures()
    table = pandas.DataFrame(columns, index=pandas.RangeIndex(len(sweep), name=RUN))
    table.attrs["units"] = {
        axis_name(sweep, name) if name in sweep.design.units else name: unit
        for name, unit in sweep.units.items()
    }
    return table


def dataset(sweep: Sweep) -> xarray.Dataset:
    """Everything, in memory."""
    whole = skeleton(sweep)
    for name in sweep.outputs:
        whole[name] = output(sweep, name)
    return whole


def skeleton(sweep: Sweep) -> xarray.Dataset:
    """Everything but the values over time."""
    dims, shape, coordinates = _axes(sweep)
    variables = {
        s.name: (dims, sweep.column(s.name).reshape(shape), {"units": s.unit, "long_name": s.name})
        for s in sweep.scalars
    }
    failures = np.array(sweep.table.failures(), dtype=object).reshape(shape)
    if sweep.outputs:
        coordinates[TIME] = (TIME, sweep.time, {"units": "s"})
    made = xarray.Dataset({**variables, FAILURE: (dims, failures)}, coordinates)
    made.attrs = {
        "model": sweep.interface.model,
        "settings": json.dumps(sweep.fixed),
        "design": sweep.design.kind,
    }
    return made


def output(sweep: Sweep, name: str) -> xarray.DataArray:
    """One variable of all runs over time."""
    dims, shape, _ = _axes(sweep)
    variable = sweep.interface.variables[name]
    values = sweep.table.output(sweep.outputs.index(name)).reshape(*shape, sweep.time.size)
    attributes = {"units": variable.unit or "1", "long_name": variable.description or name}
    return xarray.DataArray(values, dims=(*dims, TIME), attrs=attributes, name=name)


def _axes(sweep: Sweep) -> tuple[tuple[str, ...], tuple[int, ...], dict[str, Any]]:
    """Dimensions, their lengths, and coordinates."""
    design, known = sweep.design, sweep.interface.settable
    told = {n: known[n].description if n in known else "" for n in design.names}
    described = {
        n: {"units": design.units[n] or "1", "long_name": told[n] or n} for n in design.names
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
