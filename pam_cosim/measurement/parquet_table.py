"""Parquet: columns of numbers or of times."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pam_cosim.libraries import library
from pam_cosim.measurement.table import Layout, Table, check_count, reading, table_of


def read_parquet(file: Path, stated: Layout) -> Table:
    """Columns of numbers; those of times are seconds since the first. Units stand in names or as ``unit`` of a field.

    Raises:
        InputError: not such a file, or a column of something else that is not left out.
    """
    arrow, parquet = library("pyarrow", file), library("pyarrow.parquet", file)
    with reading(file, "Parquet", arrow.ArrowException, OSError):
        opened = parquet.ParquetFile(file)
        _check_declared(opened.metadata, file)
        table = opened.read()
    return table_of(_vectors(table), stated, file)


def _check_declared(metadata: Any, file: Path) -> None:
    groups = [metadata.row_group(i) for i in range(metadata.num_row_groups)]
    rows = max(metadata.num_rows, sum(group.num_rows for group in groups))
    unpacked = sum(group.total_byte_size for group in groups)
    check_count(rows * metadata.num_columns, file, unpacked)


def _vectors(table: Any) -> Iterator[tuple[str, str, Any]]:
    from pyarrow import types

    for field, column in zip(table.schema, table.columns, strict=True):
        unit = ((field.metadata or {}).get(b"unit") or b"").decode("utf-8", "replace")
        is_time = types.is_timestamp(field.type) or types.is_duration(field.type)
        if is_time or types.is_integer(field.type) or types.is_floating(field.type):
            yield field.name, "s" if is_time else unit, column.to_numpy()
        else:
            yield field.name, unit, str(field.type)
