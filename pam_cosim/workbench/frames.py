"""Binary frames of curves, as the protocol of the page describes them."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.workbench.protocol import Json, event, text_of_message


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
        entry: Json = {"name": c.signal}
        for array_name, values in c.arrays.items():
            if id(values) not in places:
                places[id(values)] = at
                parts.append(values)
                at += len(values)
            entry |= {"n": len(values), f"{array_name}_at": places[id(values)]}
        runs.setdefault(c.run, []).append(entry)
    run_entries = [
        {"name": run, "from": begins[run], "signals": signals} for run, signals in runs.items()
    ]
    content = event("curves", kind=kind, version=version, label=label, runs=run_entries)
    header = text_of_message(content).encode()
    header += b" " * (-len(header) % 4)
    body = np.concatenate(parts).astype("<f4") if parts else np.zeros(0, "<f4")
    return struct.pack("<I", len(header)) + header + body.tobytes()


def is_model(message: bytes) -> bool:
    """Whether a frame is of the standing model, of which only the newest matters."""
    return b'"kind": "model"' in message[:80]
