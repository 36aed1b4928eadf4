"""Products as files: JSON of plain data, and tables of comma-separated values."""

from __future__ import annotations

import csv
import io
from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from pathlib import Path

from pam_cosim.files import TABLE, Plain, check_ending, write_json, write_text

Table = tuple[Sequence[str], Iterable[Sequence[object]]]
"""Headings, and rows of as many cells."""

TABLES = (".csv", ".nc", ".parquet")  # endings of tables over time


def check_table_ending(path: Path) -> None:
    """A trajectory or a sweep is written as one of ``TABLES``; without an ending it is CSV.

    Raises:
        InputError: the name ends otherwise.
    """
    check_ending(path, "the result is written as CSV, NetCDF or Parquet", TABLES)


def headed(name: str, unit: str) -> str:
    """The heading of a column; a number without a unit has none."""
    return f"{name} [{unit}]" if unit else name


def table_text(table: Table) -> str:
    """A table as comma-separated values; every number reads back as it is, and one of whether is 0 or 1."""
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


class Exported(Plain, ABC):
    """A product that is written as JSON and as a table."""

    @abstractmethod
    def table(self) -> Table:
        """Headings and rows; SI units."""

    def to_json(self, path: Path | str) -> Path:
        """Writes ``as_dict``."""
        write_json(Path(path), self.as_dict())
        return Path(path)

    def to_csv(self, path: Path | str) -> Path:
        """Writes ``table``."""
        write_table(Path(path), self.table())
        return Path(path)
