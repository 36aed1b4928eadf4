"""Products as files: JSON of plain data, and tables of comma-separated values."""

from __future__ import annotations

import io
import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pam_cosim.files import TABLE, Plain, check_ending, write_json, write_text
from pam_cosim.libraries import library

if TYPE_CHECKING:
    import pandas
    import xarray

_HEADING = re.compile(r"(?P<name>.*?)(?: \[(?P<unit>[^\[\]]*)\])?")
Table = tuple[Sequence[str], Iterable[Sequence[object]]]
"""Headings, and rows of as many cells."""

TABLES = {".csv": (), ".nc": ("h5netcdf", "xarray"), ".parquet": ("pyarrow.parquet",)}
"""The endings of tables over time, and which libraries write them."""


def check_table_ending(path: Path) -> None:
    """A trajectory or a sweep is written as one of ``TABLES``; without an ending it is CSV.

    Raises:
        InputError: the name ends otherwise, or what writes such a file is not installed.
    """
    check_ending(path, "the result is written as CSV, NetCDF or Parquet", tuple(TABLES))
    for name in TABLES.get(path.suffix.lower(), ()):
        library(name, path)


def headed(name: str, unit: str) -> str:
    """The heading of a column; a number without a unit has none."""
    return f"{name} [{unit}]" if unit else name


def table_text(table: Table) -> str:
    """A table as comma-separated values; every number reads back as it is, and one of whether is 0 or 1."""
    import csv

    heads, rows = table
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows([_cell(value) for value in row] for row in rows)
    return text.getvalue()


def write_table(path: Path, table: Table) -> None:
    """Writes ``table_text``, whole or not at all.

    Raises:
        InputError: the name ends otherwise than in ``.csv``, or the file cannot be written.
    """
    check_ending(path, "this is written as CSV", TABLE)
    write_text(path, table_text(table))


def _cell(value: object) -> str:
    if type(value) is float:  # as nearly all are
        return repr(value)
    if isinstance(value, str):
        return value
    plain = value.item() if hasattr(value, "item") else value
    return repr(int(plain) if isinstance(plain, bool) else plain)


Columns = Mapping[str, tuple[Any, str | None]]
"""Values and unit by name, the index first; no unit for texts, or where another column has it."""


class Tabular(Plain, ABC):
    """A product with rows."""

    @abstractmethod
    def frame_columns(self) -> Columns:
        """Columns of ``to_frame``; SI units."""

    def to_frame(self) -> pandas.DataFrame:
        """The rows as a frame of pandas; ``attrs["units"]`` has the units.

        Raises:
            InputError: pandas is not installed.
        """
        columns = self.frame_columns()
        values = {name: column for name, (column, _) in columns.items()}
        frame = library("pandas").DataFrame(values).set_index(next(iter(columns)))
        frame.attrs["units"] = {
            name: unit for name, (_, unit) in columns.items() if unit is not None
        }
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """The rows as a data set of xarray, the unit of each variable in its ``attrs``.

        Raises:
            InputError: xarray is not installed.
        """
        columns = self.frame_columns()
        index = next(iter(columns))
        variables = {
            name: (index, np.asarray(column), {} if unit is None else {"units": unit or "1"})
            for name, (column, unit) in columns.items()
        }
        return library("xarray").Dataset(variables)  # type: ignore[no-any-return]


class Exported(Tabular):
    """A product that is written as JSON and as a table."""

    @abstractmethod
    def table(self) -> Table:
        """Headings and rows; SI units."""

    def frame_columns(self) -> Columns:
        """Columns of ``table``."""
        heads, rows = self.table()
        parts = [_HEADING.fullmatch(head) for head in heads]
        columns = zip(*rows, strict=True)
        return {
            part["name"] or "row": (
                column,
                None if isinstance(column[0], str) else part["unit"] or "",
            )
            for part, column in zip(parts, columns, strict=True)
            if part
        }

    def to_json(self, path: Path | str) -> Path:
        """Writes ``as_dict``."""
        write_json(Path(path), self.as_dict())
        return Path(path)

    def to_csv(self, path: Path | str) -> Path:
        """Writes ``table``."""
        write_table(Path(path), self.table())
        return Path(path)
