"""HDF5 and what is built on it (MATLAB 7.3, NetCDF 4): data sets of one dimension in a group, or the fields of one."""

from __future__ import annotations

from collections.abc import Iterator
from math import prod
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.libraries import library
from pam_cosim.measurement.table import Layout, Table, check_count, check_names, reading, table_of
from pam_cosim.wording import did_you_mean, shown

_UNITS = ("unit", "units", "Unit", "Units", "unit_string")


def read_hdf5(file: Path, stated: Layout) -> Table:
    """The vectors of the group that is stated, or of the only one that has any; units from their attributes.

    Raises:
        InputError: not such a file, several groups, vectors of unlike length.
    """
    h5py = library("h5py", file)
    errors = OSError, RuntimeError, KeyError, ValueError, TypeError
    with reading(file, "HDF5", *errors), h5py.File(file, "r") as opened:
        return table_of(_vectors(_place(opened, stated.table, file), stated, file), stated, file)


def is_hdf5(file: Path) -> bool:
    """Whether the file is of this format, whatever its ending: it begins so, or behind a block of 512 bytes."""
    with file.open("rb") as content:
        beginning = content.read(520)
    return b"\x89HDF\r\n\x1a\n" in (beginning[:8], beginning[512:])


def _place(opened: Any, name: str | None, file: Path) -> Any:
    places = _places(opened)
    groups = [group for group, place in places.items() if _holds_columns(place)]
    if name is not None:
        if name.strip("/") not in places:
            raise InputError(
                f"there is no group {shown(name)}; {did_you_mean(name, groups or places)}", file
            )
        return places[name.strip("/")]
    if len(groups) != 1:
        group_names = ", ".join(group or "/" for group in groups[:20])
        hint = (
            f'state one of {group_names} under [recording], as table = "{groups[0] or "/"}"'
            if groups
            else "there is none"
        )
        raise InputError(f"columns are data sets of numbers of one dimension; {hint}", file)
    return places[groups[0]]


def _places(opened: Any) -> dict[str, Any]:
    """Everything that the file itself holds: links, which may lead out of it, are not followed."""
    places = {"": opened}

    def look(name: str, item: Any) -> None:
        if not name.startswith("#") and _has_values(item):  # MATLAB's own.
            places[name] = item

    opened.visititems(look)
    return places


def _holds_columns(place: Any) -> bool:
    return (
        any(_is_vector(item) for _, item in _members(place))
        if _is_group(place)
        else bool(place.dtype.names)
    )


def _members(group: Any) -> Iterator[tuple[str, Any]]:
    import h5py

    for name in group:
        if isinstance(group.get(name, getlink=True), h5py.HardLink) and _has_values(group[name]):
            yield name, group[name]


def _has_values(item: Any) -> bool:
    """Whether it is a group or a data set that is not empty: a file may name types too."""
    return _is_group(item) or getattr(item, "shape", None) is not None


def _is_group(item: Any) -> bool:
    return hasattr(item, "values")


def _is_vector(item: Any) -> bool:
    """One dimension, or another of length one, as MATLAB writes it."""
    if _is_group(item) or item.dtype.kind not in "fiu" or item.is_virtual or item.external:
        return False
    return len(item.shape) in (1, 2) and max(item.shape) > 1 and item.size == max(item.shape)


def _vectors(place: Any, stated: Layout, file: Path) -> Iterator[tuple[str, str, Any]]:
    if _is_group(place):
        vectors = [(heading, item) for heading, item in _members(place) if _is_vector(item)]
        check_count(sum(_size(item) for _, item in vectors), file)
        for heading, item in vectors:
            unit = next((_text(item.attrs[key]) for key in _UNITS if key in item.attrs), "")
            yield heading, unit, item
    elif place.is_virtual or place.external:
        raise InputError(
            f"{shown(place.name)} is kept in other files; export the recording whole", file
        )
    elif place.dtype.names:
        check_count(_size(place) * len(place.dtype.names), file)
        for heading in place.dtype.names:
            if place.dtype[heading].kind in "fiu" and not place.dtype[heading].shape:
                yield heading, "", place[heading]
    elif stated.names is not None and len(place.shape) == 2:
        check_names(stated.names, place.shape[1], file)
        check_count(_size(place), file)
        for index, heading in enumerate(stated.names):
            yield heading, "", place[:, index]
    else:
        raise InputError(
            f"{shown(place.name)} is no group; state names = [...] for the columns of a matrix",
            file,
        )


def _size(item: Any) -> int:
    """How many values are read: of what is kept in chunks, one of them at least."""
    return int(max(item.size, prod(item.chunks or ())))


def _text(value: Any) -> str:
    value = np.asarray(value).ravel()[0] if np.size(value) else ""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
