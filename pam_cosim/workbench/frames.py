"""Binary frames of curves, as the protocol of the page describes them."""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.workbench.protocol import Json


@dataclass(frozen=True)
class PlottedCurve:
    """Of one run and signal: its arrays by what they are, "time", "values" or "residual", all of one length.

    Attributes:
        begin: that "time" counts from.
    """

    run: str
    signal: str
    arrays: dict[str, Array]
    begin: float = 0.0


def frame(kind: str, version: int, curves: Sequence[PlottedCurve], label: str = "") -> bytes:
    """The binary message with these curves."""
    runs: dict[str, list[Json]] = {}
    begins = {c.run: c.begin for c in curves}
    parts: list[Array] = []
    places: dict[int, int] = {}
    at = 0
    for c in curves:
        told: Json = {"name": c.signal}
        for what, values in c.arrays.items():
            if id(values) not in places:
                places[id(values)] = at
                parts.append(values)
                at += len(values)
            told |= {"n": len(values), f"{what}_at": places[id(values)]}
        runs.setdefault(c.run, []).append(told)
    named = [
        {"name": run, "from": begins[run], "signals": signals} for run, signals in runs.items()
    ]
    header = json.dumps(
        {
            "event": "curves",
            "kind": kind,
            "version": version,
            "label": label,
            "runs": named,
        }
    ).encode()
    header += b" " * (-len(header) % 4)
    body = np.concatenate(parts).astype("<f4") if parts else np.zeros(0, "<f4")
    return struct.pack("<I", len(header)) + header + body.tobytes()


def is_model(message: bytes) -> bool:
    """Whether a frame is of the standing model, of which only the newest matters."""
    return b'"kind": "model"' in message[:80]


def read_frame(message: bytes) -> tuple[Json, dict[tuple[str, str, str], Array]]:
    """Header of a frame, and its arrays by run, signal and what they are; times as they were recorded.

    Raises:
        ValueError: not a frame.
    """
    try:
        (length,) = struct.unpack_from("<I", message)
        header: Json = json.loads(message[4 : 4 + length])
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
