"""A sweep as a file, by its ending; written a few runs at a time, so that it need not fit into memory."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pam_cosim.exports import check_table_ending
from pam_cosim.files import written_whole
from pam_cosim.simulation.netcdf import with_netcdf_names
from pam_cosim.sweeps.labelled import axis_name, frame, output, skeleton
from pam_cosim.sweeps.names import FAILURE

if TYPE_CHECKING:
    import pandas

    from pam_cosim.sweeps.result import Sweep

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
    import pyarrow
    from pyarrow import parquet

    writer = None
    for part in _tables(sweep):
        table = pyarrow.Table.from_pandas(part, preserve_index=False)
        writer = writer or parquet.ParquetWriter(path, table.schema)
        writer.write_table(table)
    if writer is not None:
        writer.close()


def _csv(sweep: Sweep, path: Path) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        for i, part in enumerate(_tables(sweep)):
            if i == 0:
                table.writerow(part.columns)
            columns = [_cells(name, part[name].to_numpy().tolist()) for name in part.columns]
            table.writerows(zip(*columns, strict=True))


def _cells(name: str, values: list[Any]) -> list[Any]:
    return values if name == FAILURE else [_cell(value) for value in values]


def _cell(value: float | str) -> str:
    return value if isinstance(value, str) else "" if value != value else repr(value)


def _tables(sweep: Sweep) -> Iterator[pandas.DataFrame]:
    """The rows a few at a time, columns headed ``name [unit]``."""
    if sweep.scalars or not sweep.outputs:
        whole = frame(sweep)
        units = whole.attrs["units"]
        yield whole.rename(
            columns={n: f"{n} [{units[n] or '1'}]" for n in whole.columns if n != FAILURE}
        )
        return
    runs = max(1, _ROWS // sweep.time.size)
    for first in range(0, len(sweep), runs):
        yield _long(sweep, range(first, min(first + runs, len(sweep))))


def _long(sweep: Sweep, runs: range) -> pandas.DataFrame:
    """A row for each time of each run; a run that failed has one row without a time."""
    import pandas

    parts = []
    for run in runs:
        failure = sweep.table.failure(run)
        varied = {
            f"{axis_name(sweep, n)} [{u or '1'}]": sweep.design.labels(
                n, sweep.design.points[run, i : i + 1]
            )[0]
            for i, (n, u) in enumerate(sweep.design.units.items())
        }
        names = {n: f"{n} [{sweep.units[n] or '1'}]" for n in sweep.outputs}
        if failure:
            columns = {
                "time [s]": np.array([np.nan]),
                **{head: np.array([np.nan]) for head in names.values()},
            }
        else:
            values = sweep.table.values(run)
            columns = {
                "time [s]": sweep.time,
                **{head: values[i] for i, head in enumerate(names.values())},
            }
        parts.append(
            pandas.DataFrame(
                {
                    **{n: [v] * len(columns["time [s]"]) for n, v in varied.items()},
                    **columns,
                    FAILURE: failure,
                }
            )
        )
    return pandas.concat(parts, ignore_index=True)
