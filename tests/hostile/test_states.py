"""Saved states of FMUs that somebody has made up: refused, or borne, by an instance that goes on."""

from __future__ import annotations

import struct
from pathlib import Path

import pytest

from pam_cosim.simulation import IsolatedSimulator, RunFailure
from tests.fmu import models

HASH, HASHED = 64, 72  # where the hash stands (pam_snapshot.c), and what it is of begins
REFUSED = "not one of this FMU, or it is damaged"


def hashed(state: bytes) -> bytes:
    """A state with the hash that it should have: FNV-1a."""
    number = 14695981039346656037
    for byte in state[HASHED:]:
        number = (number ^ byte) * 1099511628211 % 2**64
    return state[:HASH] + struct.pack("<Q", number) + state[HASHED:]


def taken(simulator: IsolatedSimulator) -> bytes:
    """The state in the middle of a run."""
    stepper = simulator.stepper()
    stepper.begin({"T": 0.3})
    stepper.initialised()
    for k in range(5):
        stepper.advance(0.1, {"u": float(k)})
    return stepper.freeze(stepper.save())


def used(simulator: IsolatedSimulator, state: bytes) -> str:
    """What becomes of a run that goes to a state; its process stays."""
    stepper = simulator.stepper()
    stepper.begin({})
    stepper.initialised()
    try:
        stepper.restore(stepper.thaw(state, 0.5))
        for _ in range(3):
            stepper.advance(0.1, {"u": 1.0}, names=["y", "echo"])
    except RunFailure as failure:
        assert "crashed" not in str(failure) and "no progress" not in str(failure), failure
        return str(failure)
    return ""


def changed(state: bytes, at: int, number: bytes) -> bytes:
    """A state with other bytes in one place, from its end where ``at`` is negative."""
    made = bytearray(state)
    at %= len(made)
    made[at : at + len(number)] = number
    return hashed(bytes(made))


@pytest.fixture(scope="module")
def path() -> Path:
    return models.fmu(models.delayed_lag)


def test_a_history_that_cannot_be(path: Path) -> None:
    with IsolatedSimulator(path, 20.0) as simulator:
        state = taken(simulator)
        assert hashed(state) == state and used(simulator, state) == ""
        lines = 4 * 8  # bytes of a segment; a count stands before them
        counts = [
            k
            for k in range(HASHED, len(state) - 8, 8)
            if len(state) - k - 8 == lines * _count(state, k)
        ]
        assert counts
        for wrong in (
            0.0,
            -1.0,
            0.5,
            1e6,
            1e300,
            float("nan"),
            float("inf"),
            _count(state, counts[0]) + 1,
        ):
            assert REFUSED in used(
                simulator, changed(state, counts[0], struct.pack("<d", wrong))
            ), wrong
        for time in (float("nan"), 1e300):
            assert REFUSED in used(
                simulator, changed(state, counts[0] + 8, struct.pack("<d", time))
            ), time
        for cut in (state[:-8], state[:200], b"", state + b"\0" * 8, state[:HASHED]):
            assert REFUSED in used(simulator, hashed(cut) if len(cut) > HASHED else cut)
        assert used(simulator, state) == ""


def _count(state: bytes, at: int) -> float:
    return float(struct.unpack("<d", state[at : at + 8])[0])
