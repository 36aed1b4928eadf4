"""What a saved product may hold, checked before any of it is used: the file may come from an untrusted source."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import Any
from unicodedata import category
from zipfile import ZipFile

import numpy as np

MOST_BYTES = 2_000_000_000  # of all arrays of a file, unpacked
_MOST_LETTERS = 60  # of a unit; its parser reads no more
_INVISIBLE = ("Cc", "Cf", "Cs", "Zl", "Zp")  # classes of characters, by Unicode
_UNITS = ("unit", "display_unit", "units")
_OVER_TIME = ("inputs", "measurements", "values", "against", "imitated", "value", "deviation")
_COMPLEX = "gain"  # of a response


def arrays_in(content: bytes) -> dict[str, Any]:
    """The arrays of numbers in an archive of NumPy.

    Raises:
        ValueError: there is something else in it, or more than is kept in memory; other errors of NumPy and zipfile.
    """
    with ZipFile(io.BytesIO(content)) as archive:
        if sum(entry.file_size for entry in archive.infolist()) > MOST_BYTES:
            raise ValueError("more than is kept in memory")
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        arrays = {name: file[name] for name in file.files}
    if not all(array.dtype.kind in "biufc" for array in arrays.values()):
        raise ValueError("an array that holds no numbers")
    return arrays


def plain_value(value: Any, kind: type[Any]) -> Any:
    """A text, a number or a truth value as it is in the file; nothing is made into another.

    Raises:
        TypeError: it is of another kind.
        ValueError: a text that would steer a terminal.
    """
    allowed_types = (float, int) if kind is float else (kind,)
    if type(value) not in allowed_types:
        raise TypeError(f"{type(value).__name__} where {kind.__name__} is needed")
    if isinstance(value, str) and not all(
        c in "\n\t" or category(c) not in _INVISIBLE for c in value
    ):
        raise ValueError("a character that cannot be seen")
    return float(value) if kind is float else value


def check_plain(content: Any, arrays: Mapping[str, Any], is_unit: bool = False) -> None:
    """Checks what types do not state: units, complex numbers, and arrays over time of the length of their times.

    Raises:
        ValueError: a text that is no unit, so that none reaches its parser; arrays that do not belong together;
            complex numbers that are no gains.
        KeyError: an array that is not there.
    """
    if isinstance(content, dict):
        _check_lengths(content, arrays)
        for key, value in content.items():
            if (
                key != _COMPLEX
                and _is_reference(value)
                and arrays[value["array"]].dtype.kind == "c"
            ):
                raise ValueError(f"complex numbers in the place of '{key}'")
            check_plain(value, arrays, is_unit or key in _UNITS)
    elif isinstance(content, list):
        for value in content:
            check_plain(value, arrays, is_unit)
    elif is_unit and isinstance(content, str) and (len(content) > _MOST_LETTERS or "\n" in content):
        raise ValueError("a text that is no unit")


def _check_lengths(content: dict[str, Any], arrays: Mapping[str, Any]) -> None:
    run = content.get("run")
    timed = [(content, key) for key in _OVER_TIME]
    if isinstance(run, dict) and "time" in run:  # a run with what a model made of it
        timed = [(content, "model")]
    holder = run if isinstance(run, dict) else content
    time = holder.get("time")
    if not isinstance(time, dict) or not _is_reference(time):
        return
    shape = arrays[time["array"]].shape
    for place, key in timed:
        value = place.get(key)
        series = (
            list(value.values())
            if isinstance(value, dict) and not _is_reference(value)
            else [value]
        )
        for array in series:
            if (
                isinstance(array, dict)
                and _is_reference(array)
                and arrays[array["array"]].shape != shape
            ):
                raise ValueError(f"'{key}' is not of the length of its times")


def _is_reference(value: Any) -> bool:
    return isinstance(value, dict) and list(value) == ["array"] and isinstance(value["array"], str)
