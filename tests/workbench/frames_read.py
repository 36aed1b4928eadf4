"""Reads frames of curves as the page does."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

from pam_cosim.arrays import Array


def read_frame(message: bytes) -> tuple[dict[str, Any], dict[tuple[str, str, str], Array]]:
    """Header of a frame, and its arrays by run, signal and what they are; times as they were recorded.

    Raises:
        ValueError: not a frame.
    """
    try:
        (length,) = struct.unpack_from("<I", message)
        header: dict[str, Any] = json.loads(message[4 : 4 + length])
    except struct.error as problem:
        raise ValueError("not a frame of curves") from problem
    floats = np.frombuffer(message[4 + length :], "<f4").astype(float)
    arrays = {}
    for run in header["runs"]:
        for signal in run["signals"]:
            for key, at in signal.items():
                if key.endswith("_at"):
                    what, values = key.removesuffix("_at"), floats[at : at + signal["n"]]
                    begin = run["from"] if what == "time" else 0.0
                    arrays[run["name"], signal["name"], what] = values + begin
    return header, arrays
