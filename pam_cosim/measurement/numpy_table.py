"""NumPy's .npz files: each array of one dimension is a column."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from zipfile import BadZipFile, ZipFile

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement.table import Layout, Table, check_count, reading, table_of


def read_numpy(file: Path, stated: Layout) -> Table:
    """Reads the arrays of numbers of one dimension; pickled objects, texts and single numbers are left out.

    Raises:
        InputError: not such a file, no array of numbers, arrays of unlike length.
    """
    vectors = []
    with reading(file, "NumPy's", OSError, ValueError, EOFError, BadZipFile):
        with ZipFile(file) as archive:
            check_count(0, file, sum(entry.file_size for entry in archive.infolist()))
        with np.load(file, allow_pickle=False) as arrays:
            for name in arrays.files:
                with suppress(ValueError):  # a pickled object
                    values = arrays[name]
                    if values.ndim == 1 and values.dtype.kind in "fiumM":
                        vectors.append((name, "", values))
    if not vectors:
        raise InputError("there is no array of numbers of one dimension", file)
    return table_of(vectors, stated, file)
