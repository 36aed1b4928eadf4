"""MATLAB's .mat files: vectors, the fields of a structure, or the columns of a matrix."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Container, Iterator, Mapping, Sequence
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement.hdf5_table import is_hdf5, read_hdf5
from pam_cosim.measurement.table import (
    Layout,
    Table,
    check_count,
    check_names,
    is_unit,
    reading,
    table_of,
)
from pam_cosim.wording import did_you_mean, listed, shown

_LABELS = ("label", "name")
_COMPRESSED = 15  # the type of an element in version 5
_BEGINNING = 200  # bytes that unpack to its head


def read_matlab(file: Path, stated: Layout) -> Table:
    """The vectors of the file, or of the structure that is stated or alone; since version 7.3 such a file is HDF5.

    Raises:
        InputError: not such a file, nothing that is a column, vectors of unlike length.
    """
    import scipy.io

    if file.is_file() and is_hdf5(file):
        return read_hdf5(file, stated)
    # The reader lets out whatever a broken file makes of it.
    with reading(file, "MATLAB's", Exception):
        check_count(_declared(file), file, _unpacked(file))
        content = scipy.io.loadmat(
            str(file), squeeze_me=True, struct_as_record=True, chars_as_strings=True
        )
    variables = {name: value for name, value in content.items() if not name.startswith("__")}
    chosen = _chosen(variables, stated.table, file)
    vectors = [(n, "", v) for n, v in _columns(chosen, stated, file) if _is_vector(np.asarray(v))]
    if not vectors and not stated.ignore:
        raise InputError(f"there is no vector of numbers; the file holds {_held(variables)}", file)
    return table_of(vectors, stated, file)


def scalars_of(file: Path) -> dict[str, float]:
    """The single numbers of a file of MATLAB before version 7.3, by name, also within structures."""
    import scipy.io

    if is_hdf5(file):
        return {}
    content = scipy.io.loadmat(str(file), squeeze_me=True, chars_as_strings=True)
    places = [(p.rpartition("/")[2], v) for p, v in _places(content) if not p.startswith("__")]
    return {name: float(v) for name, v in places if np.ndim(v) == 0 and isinstance(v, int | float)}


def _declared(file: Path) -> int:
    """How many values the variables have."""
    import scipy.io

    return sum(prod(map(int, shape)) for _, shape, _ in scipy.io.whosmat(str(file)))


def _unpacked(file: Path) -> int:
    """Bytes of all elements of a file of version 5, as each says at its beginning; 0 of an earlier one."""
    at, size = 128, 0
    with file.open("rb") as content:
        order = {b"IM": "<", b"MI": ">"}.get(content.read(at)[126:])
        while order and len(tag := content.read(8)) == 8:
            kind, length = struct.unpack(order + "II", tag)
            if kind == _COMPRESSED:
                inner = zlib.decompressobj().decompress(content.read(_BEGINNING), 8)
                size += struct.unpack(order + "II", inner)[1]
            else:
                size += length
            at += 8 + length
            content.seek(at)
    return size


def _chosen(variables: Mapping[str, Any], name: str | None, file: Path) -> Any:
    """What is stated, as ``log/signals`` within a structure; else all, where it has a vector, or the structure."""
    if name is not None:
        places = dict(_places(variables))
        if name.strip("/") not in places:
            raise InputError(
                f"there is no variable {shown(name)}; {did_you_mean(name, places)}", file
            )
        return places[name.strip("/")]
    if any(_is_vector(value) for value in variables.values()):
        return variables
    structures = [variable for variable, value in variables.items() if _structures(value)]
    matrices = [value for value in variables.values() if _is_matrix(value)]
    if len(matrices) == 1 and not structures:
        return matrices[0]
    if len(structures) != 1:
        message = f"there is no vector of numbers among {_held(variables)}"
        raise InputError(
            f"{message}; state a structure or a matrix under [recording], as table = ...", file
        )
    return variables[structures[0]]


def _places(fields: Mapping[str, Any], above: str = "") -> Iterator[tuple[str, Any]]:
    """Everything in a file by its path."""
    for name, value in fields.items():
        yield above + name, value
        inner = _structures(value)
        if len(inner) == 1:
            yield from _places(inner[0], f"{above}{name}/")


def _structures(value: Any) -> list[dict[str, Any]]:
    """The fields of a structure, or of each of a row of them or of cells."""
    if isinstance(value, np.ndarray) and value.dtype == object and not value.dtype.names:
        return [fields for element in value.flat for fields in _structures(element)]
    if not isinstance(value, np.ndarray | np.void) or not value.dtype.names or _is_object(value):
        return []
    return [
        {name: element[name] for name in value.dtype.names} for element in np.atleast_1d(value).flat
    ]


def _is_object(value: Any) -> bool:
    """Whether it is of a class of MATLAB's, such as a table or a timeseries, whose layout is not public."""
    from scipy.io.matlab import MatlabFunction, MatlabOpaque

    return isinstance(value, MatlabFunction | MatlabOpaque)


def _is_vector(value: Any) -> bool:
    return (
        isinstance(value, np.ndarray)
        and value.ndim == 1
        and value.dtype.kind in "fiu"
        and value.size > 1
    )


def _is_matrix(value: Any) -> bool:
    return isinstance(value, np.ndarray) and value.ndim == 2 and value.dtype.kind in "fiu"


def _held(variables: Mapping[str, Any]) -> str:
    """What a file holds, for people."""
    return listed(f"{name} ({_described(value)})" for name, value in variables.items())


def _described(value: Any) -> str:
    inner = _structures(value)
    if inner:
        return f"structure of {listed(inner[0])}"
    if isinstance(value, np.ndarray) and value.dtype.kind in "fiu":
        return f"{' x '.join(map(str, value.shape))} numbers"
    return "an object, which only MATLAB reads" if _is_object(value) else "no numbers"


def _columns(chosen: Any, stated: Layout, file: Path) -> list[tuple[str, Any]]:
    if _is_matrix(chosen):
        count = len(stated.names) if stated.names else min(chosen.shape)
        wide = chosen.shape[0] == count != chosen.shape[1]  # a signal in each row
        columns = chosen if wide else chosen.T
        headings = stated.names or [f"signal {i + 1}" for i in range(len(columns))]
        check_names(headings, len(columns), file)
        return list(zip(headings, columns, strict=True))
    fields = [dict(chosen)] if isinstance(chosen, Mapping) else _structures(chosen)
    rows = {v.size for signal in fields for _, v in _places(signal) if _is_vector(v)}
    return _named([vector for structure in fields for vector in _vectors(structure, rows)])


_Path = tuple[str, ...]


def _vectors(
    fields: Mapping[str, Any], rows: Container[int], above: _Path = ()
) -> list[tuple[_Path, Any]]:
    """The vectors among some fields; where these are no two, which a table needs, those of structures within too.

    One that is alone with a text called label or name, as Simulink and dSPACE write signals, is called by that. The
    signals of a matrix with as many ``rows`` as a vector of the file are vectors, numbered from one.
    """
    for name, value in list(fields.items()):
        if _is_matrix(value) and any(count in rows for count in value.shape):
            signals = value.T if value.shape[0] in rows else value
            numbered = {f"{name} {i + 1}": signal for i, signal in enumerate(signals)}
            fields = {n: v for n, v in fields.items() if n != name} | numbered
    vector_names = [name for name, value in fields.items() if _is_vector(np.asarray(value))]
    label = next((v for n, v in fields.items() if n.casefold() in _LABELS and _is_text(v)), None)
    unit = fields.get("Unit", "")
    if label and _is_text(unit) and is_unit(unit):
        label = f"{label} [{unit}]"
    names = [label] if above and label and len(vector_names) == 1 else vector_names
    vectors = [((*above, name), fields[key]) for name, key in zip(names, vector_names, strict=True)]
    if len(vector_names) > 1:
        return vectors
    within = [(name, key) for name, value in fields.items() for key in _structures(value)]
    return [
        *vectors,
        *(pair for name, key in within for pair in _vectors(key, rows, (*above, name))),
    ]


def _is_text(value: Any) -> bool:
    return isinstance(value, str) and bool(value.strip())


def _named(vectors: Sequence[tuple[_Path, Any]]) -> list[tuple[str, Any]]:
    """Vectors by their last names, or where these are not different by their paths."""
    short = {path[-1] for path, _ in vectors}
    differ = len(short) == len(vectors)
    return [(path[-1] if differ else ".".join(path), values) for path, values in vectors]
