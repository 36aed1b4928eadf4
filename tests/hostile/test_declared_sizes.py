"""Recordings that declare more values than can be taken, in files of some kilobytes: refused before they are read."""

from __future__ import annotations

import tracemalloc
from collections.abc import Callable
from pathlib import Path

import h5py
import numpy as np
import pyarrow
import pytest
from pyarrow import parquet

from pam_cosim.errors import InputError
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.table import Layout

MOST = 2_000_000  # bytes of Python's own memory to find out
NAMES = ("time [s]", "p [kPa]")


def sparse_hdf5(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        for name in ("time", "p"):
            out.create_dataset(name, (10**12,), "f8", chunks=(1000,))
    return Layout()


def sparse_matrix(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        out.create_dataset("run", (10**11, 2), "f8", chunks=(1000, 2))
    return Layout(table="run", names=NAMES)


def fields_hdf5(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        kinds = np.dtype([("time", float), ("p", float)])
        out.create_dataset("run", (10**9,), kinds, chunks=(1000,))
    return Layout()


def one_large_chunk(file: Path) -> Layout:
    with h5py.File(file, "w") as out:
        for name in ("time", "p"):
            out.create_dataset(name, (10,), "f8", maxshape=(None,), chunks=(10**8,))
    return Layout()


def repeated_parquet(file: Path) -> Layout:
    with parquet.ParquetWriter(file, pyarrow.schema([(n, "f4") for n in NAMES])) as writer:
        part = pyarrow.table({n: np.zeros(3_000_000, np.float32) for n in NAMES})
        for _ in range(9):
            writer.write_table(part)
    return Layout()


WRITERS = [
    ("run.h5", sparse_hdf5),
    ("run.mat", sparse_hdf5),
    ("run.h5", sparse_matrix),
    ("run.h5", fields_hdf5),
    ("run.h5", one_large_chunk),
    ("run.parquet", repeated_parquet),
]


@pytest.mark.parametrize(("name", "write"), WRITERS, ids=[f"{w.__name__} {n}" for n, w in WRITERS])
def test_more_values_than_can_be_taken(
    tmp_path: Path, name: str, write: Callable[[Path], Layout]
) -> None:
    stated, file = write(tmp_path / name), tmp_path / name
    assert file.stat().st_size < 1_000_000
    tracemalloc.start()
    with pytest.raises(InputError, match="values, and 50 million can be taken") as caught:
        read_table(file, stated)
    assert caught.value.file == file and tracemalloc.get_traced_memory()[1] < MOST
    tracemalloc.stop()
