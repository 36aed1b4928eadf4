"""Libraries that only an extra of the package brings, loaded at their first use."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from typing import Any

from pam_cosim.errors import InputError

_EXTRAS = {
    "tables": ("pandas", "xarray", "h5netcdf", "pyarrow", "pyarrow.parquet", "h5py"),
    "lab": ("nptdms", "python_calamine"),
    "control": ("control",),
    "dask": ("distributed",),
    "workbench": ("pam_cosim.workbench.server",),
}
_EXTRA_BY_LIBRARY = {name: extra for extra, names in _EXTRAS.items() for name in names}


def library(name: str, file: Path | None = None) -> Any:
    """A module that comes with an extra; ``file``: what needs it.

    Raises:
        InputError: the module, or one that it needs, is not installed.
    """
    try:
        return import_module(name)
    except ImportError as problem:
        install = f"pip install 'pam-cosim[{_EXTRA_BY_LIBRARY[name]}]'"
        missing = (problem.name or name).partition(".")[0]
        raise InputError(f"{missing} is needed and is not installed: {install}", file) from None
