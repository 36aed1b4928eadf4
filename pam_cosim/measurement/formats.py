"""Which format a file has, by its ending, and the one reader of it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement.hdf5_table import read_hdf5
from pam_cosim.measurement.matlab_table import read_matlab
from pam_cosim.measurement.numpy_table import read_numpy
from pam_cosim.measurement.parquet_table import read_parquet
from pam_cosim.measurement.table import Layout, Table, without_empty_end
from pam_cosim.measurement.tdms_table import read_tdms
from pam_cosim.measurement.text_table import read_text_table
from pam_cosim.measurement.workbook import WORKBOOKS

_READERS: dict[str, Callable[[Path, Layout], Table]] = {
    ".mat": read_matlab,
    ".npz": read_numpy,
    ".h5": read_hdf5,
    ".hdf5": read_hdf5,
    ".hdf": read_hdf5,
    ".tdms": read_tdms,
    ".parquet": read_parquet,
    ".pq": read_parquet,
}
_OF_SEVERAL_TABLES = (".mat", ".h5", ".hdf5", ".hdf", ".tdms", *WORKBOOKS)


def read_table(file: Path, stated: Layout | None = None) -> Table:
    """Reads a file of any format, up to the last row with a value; what has no ending of a binary one is a text.

    Raises:
        InputError: see the reader of the format; no column is read.
    """
    table = _READERS.get(file.suffix.lower(), read_text_table)(file, stated or Layout())
    if not table.columns:
        message = (
            "no column is read: no column holds numbers, or [recording] ignore leaves them out"
        )
        raise InputError(message, file)
    return without_empty_end(table)


def may_hold_tables(file: Path) -> bool:
    """Whether a file can hold several tables, of which one is chosen."""
    return file.suffix.lower() in _OF_SEVERAL_TABLES


def is_text(file: Path) -> bool:
    """Whether a file is read as a text."""
    return file.suffix.lower() not in _READERS
