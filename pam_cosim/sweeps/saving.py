"""A sweep as a file, by its ending; written a few runs at a time, so that it need not fit into memory."""

from __future__ import annotations

import csv
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pam_cosim.exports import check_table_ending
from pam_cosim.files import written_whole
from pam_cosim.libraries import library
from pam_cosim.simulation.netcdf import with_netcdf_names
from pam_cosim.sweeps.labelled import axis_name, columns_of, output, skeleton, units_of
from pam_cosim.sweeps.names import FAILURE, TIME

if TYPE_CHECKING:
    from pam_cosim.sweeps.result import Sweep

Columns = Mapping[str, Any]
"""Values of some rows, by heading."""
_ROWS = 200_000  # of a table, in memory at once


def save(sweep: Sweep, path: Path) -> None:
    """Writes NetCDF, Parquet or CSV.

    Raises:
        InputError: the name ends otherwise, or the file cannot be written.
    """
    check_table_ending(path)
    write = {".nc": _netcdf, ".parquet": _parquet}.get(path.suffix.lower(), _csv)
    with written_whole(path) as name:
        write(sweep, name)


def _netcdf(sweep: Sweep, path: Path) -> None:
    with_netcdf_names(skeleton(sweep)).to_netcdf(path, engine="h5netcdf")
    for name in sweep.outputs:  # one at a time
        with_netcdf_names(output(sweep, name).to_dataset()).to_netcdf(
            path, mode="a", engine="h5netcdf"
        )


def _parquet(sweep: Sweep, path: Path) -> None:
    parquet, arrow = library("pyarrow.parquet"), library("pyarrow")
    tables = (arrow.table(dict(part)) for part in _tables(sweep))
    first = next(tables)
    with parquet.ParquetWriter(path, first.schema) as writer:
        for table in chain([first], tables):
            writer.write_table(table)


def _csv(sweep: Sweep, path: Path) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        for i, part in enumerate(_tables(sweep)):
            if i == 0:
                table.writerow(part)
            table.writerows(zip(*map(_cells, part.values()), strict=True))


def _cells(values: Sequence[Any]) -> list[str]:
    """Texts as they are, numbers so that they read back, and nothing where there is none."""
    return [
        v if isinstance(v, str) else "" if v != v else repr(v) for v in np.asarray(values).tolist()
    ]


def _tables(sweep: Sweep) -> Iterator[Columns]:
    """The rows a few at a time, columns headed ``name [unit]``: of each run, or of each time of each run."""
    units = units_of(sweep) | {TIME: "s"}
    if sweep.scalars or not sweep.outputs:
        parts: Iterable[Columns] = [columns_of(sweep)]
    else:
        runs = max(1, _ROWS // sweep.time.size)
        starts = range(0, len(sweep), runs)
        parts = (_long(sweep, range(i, min(i + runs, len(sweep)))) for i in starts)
    for part in parts:
        yield {n if n == FAILURE else f"{n} [{units[n] or '1'}]": v for n, v in part.items()}


def _long(sweep: Sweep, runs: range) -> Columns:
    parts = [_of_run(sweep, run) for run in runs]
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _of_run(sweep: Sweep, run: int) -> Columns:
    """A row for each time of a run; a run that failed has one row without a time."""
    design, failure = sweep.design, sweep.table.failure(run)
    values = (
        np.full((1 + len(sweep.outputs), 1), np.nan)
        if failure
        else np.vstack([sweep.time, *sweep.table.values(run)])
    )
    varied = {
        axis_name(sweep, n): np.repeat(
            design.labels(n, design.points[run, i : i + 1]), values.shape[1]
        )
        for i, n in enumerate(design.names)
    }
    failures = np.full(values.shape[1], failure, dtype=object)
    return {**varied, **dict(zip((TIME, *sweep.outputs), values, strict=True)), FAILURE: failures}
