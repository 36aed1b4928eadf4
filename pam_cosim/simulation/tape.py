"""Gives a library of ``fmu/pam_tape.c`` the model that it shall be."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pam_cosim.fmu.generate import DOUBLES, FUNCTIONS, INTEGERS, SIZES
from pam_cosim.fmu.tape import Tape, in_order, read_tapes

_KEPT = 256  # models; a library reads them in place, as long as any simulator uses it


class _Statement(ctypes.Structure):
    _fields_ = [
        ("is_error", ctypes.c_int),
        ("at_start", ctypes.c_int),
        ("values", ctypes.c_int),
        ("texts", ctypes.POINTER(ctypes.c_char_p)),
        ("digits", ctypes.c_void_p),
    ]


class _Variable(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("unit", ctypes.c_char_p),
        ("kind", ctypes.c_int),
        ("index", ctypes.c_int),
        ("tunable", ctypes.c_int),
        ("min", ctypes.c_double),
        ("max", ctypes.c_double),
    ]


class _Model(ctypes.Structure):
    """``pam_model``; its functions are the library's own."""

    _fields_ = [
        ("guid", ctypes.c_char_p),
        *((name, ctypes.c_int) for name in SIZES),
        ("tolerance", ctypes.c_double),
        ("max_step", ctypes.c_double),
        ("state_names", ctypes.POINTER(ctypes.c_char_p)),
        *((name, ctypes.c_void_p) for name in (*DOUBLES, *INTEGERS, *FUNCTIONS)),
        ("statements", ctypes.POINTER(_Statement)),
        ("variables", ctypes.POINTER(_Variable)),
    ]


class _Tape(ctypes.Structure):
    _fields_ = [
        ("count", ctypes.c_longlong),
        ("batches", ctypes.c_void_p),
        ("operands", ctypes.c_void_p),
        ("constants", ctypes.c_void_p),
        ("constant_count", ctypes.c_int),
        ("argument_count", ctypes.c_int),
        ("argument_sizes", ctypes.c_void_p),
    ]


class _Given:
    """A model and its tapes in memory that C reads."""

    def __init__(self, tables: Mapping[str, Any], tapes: Sequence[Tape | None]) -> None:
        self._kept: list[object] = []
        self.model = _Model(
            guid=tables["guid"].encode(),
            **{name: tables[name] for name in SIZES},
            tolerance=tables["tolerance"],
            max_step=tables["max_step"],
            state_names=self._texts(tables["state_names"]),
            **{n: self._array(tables[n], float) for n in DOUBLES},
            **{n: self._array(tables[n], np.intc) for n in INTEGERS},
            statements=self._statements(tables["statements"]),
            variables=self._variables(tables["variables"]),
        )
        self.tapes = (_Tape * len(tapes))(*map(self._tape, tapes))

    def _texts(self, texts: Sequence[str]) -> Any:
        array = (ctypes.c_char_p * max(len(texts), 1))(
            *(text.encode("utf-8", "replace") for text in texts)
        )
        self._kept.append(array)
        return ctypes.cast(array, ctypes.POINTER(ctypes.c_char_p))

    def _array(self, values: Sequence[float], kind: type) -> int:
        array: NDArray[Any] = np.array([*values] or [0], dtype=kind)
        self._kept.append(array)
        return int(array.ctypes.data)

    def _statements(self, statements: Sequence[Mapping[str, Any]]) -> Any:
        array = (_Statement * max(len(statements), 1))()
        for at, statement in zip(array, statements, strict=False):
            at.is_error, at.at_start, at.values = (
                statement["is_error"],
                statement["at_start"],
                len(statement["digits"]),
            )
            at.texts, at.digits = (
                self._texts(statement["texts"]),
                self._array(statement["digits"], np.intc),
            )
        self._kept.append(array)
        return ctypes.cast(array, ctypes.POINTER(_Statement))

    def _variables(self, rows: Sequence[Sequence[Any]]) -> Any:
        array = (_Variable * max(len(rows), 1))()
        for i, (name, unit, kind, index, tunable, low, high) in enumerate(rows):
            texts = (text.encode("utf-8", "replace") for text in (name, unit))
            limits = -math.inf if low is None else low, math.inf if high is None else high
            array[i] = _Variable(*texts, kind, index, tunable, *limits)
        self._kept.append(array)
        return ctypes.cast(array, ctypes.POINTER(_Variable))

    def _tape(self, tape: Tape | None) -> _Tape:
        if tape is None:
            return _Tape(-1)
        self._kept.append(tape)
        return _Tape(
            len(tape.batches),
            tape.batches.ctypes.data,
            tape.operands.ctypes.data,
            tape.constants.ctypes.data,
            len(tape.constants),
            len(tape.arguments),
            self._array(tape.arguments, np.intc),
        )


def use_tapes(library: ctypes.CDLL, folder: Path) -> None:
    """Makes the library, which has no instance yet, the model that a folder holds."""
    given = _given(folder)
    library.pam_use_tapes(ctypes.byref(given.model), given.tapes)


@lru_cache(maxsize=_KEPT)
def _given(folder: Path) -> _Given:
    tables, tapes = read_tapes(folder)
    return _Given(tables, in_order(tapes))
