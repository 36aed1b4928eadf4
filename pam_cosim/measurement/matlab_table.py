"""MATLAB's .mat files: vectors, the fields of a structure, or the columns of a matrix with stated names."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator, Mapping
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.files import read_file
from pam_cosim.measurement.hdf5_table import is_hdf5, read_hdf5
from pam_cosim.measurement.table import (
    Column,
    Layout,
    Table,
    check_count,
    check_names,
    headed,
    same_length,
)
from pam_cosim.wording import did_you_mean, listed, shown

_COMPRESSED = 15  # the type of an element in version 5
_BEGINNING, _BYTES = 200, 8  # bytes that unpack to its head; of a number


def read_matlab(file: Path, stated: Layout) -> Table:
    """The vectors of the file, or of the structure that is stated or alone; since version 7.3 such a file is HDF5.

    Raises:
        InputError: not such a file, nothing that is a column, vectors of unlike length.
    """
    import scipy.io

    if file.is_file() and is_hdf5(file):
        return read_hdf5(file, stated)
    try:
        check_count(_declared(file), file)
        content = scipy.io.loadmat(
            str(file), squeeze_me=True, struct_as_record=True, chars_as_strings=True
        )
    except FileNotFoundError:
        raise InputError("the file does not exist", file) from None
    except InputError:
        raise
    except Exception as error:  # The reader lets out whatever a broken file makes of it.
        raise InputError(f"this file cannot be read as MATLAB's: {error}", file) from None
    variables = {name: value for name, value in content.items() if not name.startswith("__")}
    columns = list(_columns(_chosen(variables, stated.table, file), stated, file))
    return Table(file, same_length(columns, file))


def _declared(file: Path) -> int:
    """How many values the variables have, or would if all that is compressed were numbers."""
    import scipy.io

    shapes = [shape for _, shape, _ in scipy.io.whosmat(str(file))]
    return max(sum(prod(map(int, shape)) for shape in shapes), _unpacked(file) // _BYTES)


def _unpacked(file: Path) -> int:
    """Bytes of all elements of a file of version 5, as each says at its beginning; 0 of an earlier one."""
    content = read_file(file)
    order = {b"IM": "<", b"MI": ">"}.get(content[126:128])
    at, size = 128, 0
    while order and at + 8 <= len(content):
        kind, length = struct.unpack(order + "II", content[at : at + 8])
        begin = content[at + 8 : at + 8 + _BEGINNING]
        if kind == _COMPRESSED:
            inner = zlib.decompressobj().decompress(begin, 8)
            size += struct.unpack(order + "II", inner)[1]
        else:
            size += length
        at += 8 + length
    return size


def _chosen(variables: Mapping[str, Any], name: str | None, file: Path) -> Any:
    if name is not None:
        if name not in variables:
            raise InputError(
                f"there is no variable {shown(name)}; {did_you_mean(name, variables)}", file
            )
        return variables[name]
    if any(_is_vector(value) for value in variables.values()):
        return variables
    structures = [one for one, value in variables.items() if _fields(value)]
    if len(structures) != 1:
        message = f"there is no vector of numbers among {listed(variables)}"
        raise InputError(
            f"{message}; state a structure or a matrix under [recording], as table = ...", file
        )
    return variables[structures[0]]


def _fields(value: Any) -> dict[str, Any]:
    """Fields of a structure."""
    if isinstance(value, np.ndarray | np.void) and value.dtype.names and value.size == 1:
        one = value.reshape(-1)[0] if isinstance(value, np.ndarray) else value
        return {name: one[name] for name in value.dtype.names}
    return {}


def _is_vector(value: Any) -> bool:
    return (
        isinstance(value, np.ndarray)
        and value.ndim == 1
        and value.dtype.kind in "fiu"
        and value.size > 1
    )


def _columns(chosen: Any, stated: Layout, file: Path) -> Iterator[Column]:
    if (
        isinstance(chosen, np.ndarray)
        and chosen.ndim == 2
        and chosen.dtype.kind in "fiu"
        and stated.names
    ):
        check_names(stated.names, chosen.shape[1], file)
        vectors = dict(zip(stated.names, chosen.T, strict=True))
    elif isinstance(chosen, np.ndarray) and chosen.ndim == 2:
        raise InputError(
            'the columns of a matrix need names under [recording]: names = ["time [s]", ...]', file
        )
    else:
        vectors = dict(chosen) if isinstance(chosen, Mapping) else _fields(chosen)
    for heading, values in vectors.items():
        name, unit = headed(heading, "", file)
        if _is_vector(np.asarray(values)) and stated.keeps(heading, name):
            yield Column(name, unit, np.array(values, dtype=float), heading)
