"""The C function that runs an FMU of our own."""

from __future__ import annotations

import ctypes
from functools import cache
from pathlib import Path
from typing import Any

from pam_cosim.fmu.platforms import native_platform

SLOTS = (
    "reset",
    "setup",
    "enter",
    "leave",
    "set_values",
    "get_values",
    "set_slopes",
    "do_step",
    "terminate",
    "settle",
    "real_status",
    "boolean_status",
)


class DriverVariables(ctypes.Structure):
    """Variables that are set or read together."""

    _fields_ = [("n", ctypes.c_size_t), ("groups", ctypes.c_void_p), ("n_values", ctypes.c_size_t)]


class MessageLog(ctypes.Structure):
    """Where the messages of a run are gathered."""

    _fields_ = [("used", ctypes.c_size_t), ("text", ctypes.c_char * 8192)]


class CallbackFunctions(ctypes.Structure):
    """fmi2CallbackFunctions."""

    _fields_ = [
        (name, ctypes.c_void_p)
        for name in ("logger", "allocateMemory", "freeMemory", "stepFinished", "environment")
    ]


class DriverRun(ctypes.Structure):
    """What the C function reads and writes, as ``pam_driver.c`` has it."""

    _fields_ = [
        *((name, ctypes.c_void_p) for name in SLOTS),
        ("instance", ctypes.c_void_p),
        ("version", ctypes.c_int32),
        ("must_reset", ctypes.c_int32),
        ("tolerance_defined", ctypes.c_int32),
        ("tolerance", ctypes.c_double),
        ("max_seconds", ctypes.c_double),
        ("follow", ctypes.c_void_p),
        ("keep_starts", ctypes.c_void_p),
        ("plain", ctypes.c_int32),
        ("settle_start", ctypes.c_int32),
        ("settle_at", ctypes.c_void_p),
        ("statistics", ctypes.c_void_p),
        ("max_steps", ctypes.c_int64),
        ("at_rest", ctypes.c_int32),
        ("parameters", DriverVariables),
        ("parameter_values", ctypes.c_void_p),
        ("texts", ctypes.c_void_p),
        ("inputs", DriverVariables),
        ("input_values", ctypes.c_void_p),
        ("input_slopes", ctypes.c_void_p),
        ("n_slopes", ctypes.c_size_t),
        ("orders", ctypes.c_void_p),
        ("outputs", DriverVariables),
        ("output_values", ctypes.c_void_p),
        ("buffer", ctypes.c_void_p),
        ("n_points", ctypes.c_size_t),
        ("times", ctypes.c_void_p),
        ("knots", ctypes.c_void_p),
        ("means", ctypes.c_void_p),
        ("rows_before", ctypes.c_void_p),
        ("rows_after", ctypes.c_void_p),
        ("time_reached", ctypes.c_double),
        ("calls", ctypes.c_uint64),
        ("active", ctypes.c_int32),
        ("stage", ctypes.c_int32),
        ("status", ctypes.c_int32),
        ("group", ctypes.c_void_p),
        ("ended", ctypes.c_int32),
    ]


def prepare_driver() -> Path:
    """Compiles the loop, where that was not done before; the library."""
    from pam_cosim.fmu.compile import compile_library

    return compile_library(("pam_driver.c",), {}, native_platform())


@cache
def driver_library() -> ctypes.CDLL:
    """The compiled C function, loaded."""
    library = ctypes.CDLL(str(prepare_driver()))
    library.pam_driver_run.argtypes = [ctypes.POINTER(DriverRun)]
    library.pam_driver_run.restype = None
    return library


def address(library: Any, name: str | None) -> int | None:
    """Of a function; None: the library does not have it."""
    if name is None or not hasattr(library, name):
        return None
    return ctypes.cast(getattr(library, name), ctypes.c_void_p).value
