"""Names that NetCDF does not have: a slash would be a folder of the file."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray

_DIVISION = "\u2215"  # looks like a slash
ORIGINAL = "modelica_name"
"""Attribute of a variable that has another name in the file."""


def with_netcdf_names(data: xarray.Dataset) -> xarray.Dataset:
    """The same data, with a sign of division for each slash in a name; ``modelica_name`` has the slash."""
    names = {str(name) for name in (*data.variables, *data.sizes) if "/" in str(name)}
    if not names:
        return data
    for name in names & {str(variable) for variable in data.variables}:
        data[name].attrs[ORIGINAL] = name
    return data.rename({name: name.replace("/", _DIVISION) for name in sorted(names)})
