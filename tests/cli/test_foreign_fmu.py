"""The command with an FMU that never returns: it says so, goes on, and leaves nothing behind when it is ended."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim.simulation.isolated import TIME_LIMIT
from tests.cli.conftest import ROOT, Outcome
from tests.simulation.misbehaving import hanging, processes_of

Command = Callable[..., Outcome]
PROMPT = (
    TIME_LIMIT / 2
)  # [s]: long before the limit would have ended it, also on a machine that does other things

needs_proc = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")


def test_run_that_hangs_is_reported(
    command: Command, place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HANG", "fmi2DoStep")
    outcome = command("simulate", hanging(place), "--timeout", "2", "-o", "run.csv")
    assert (outcome.status, outcome.out) == (1, "")
    assert (
        "pam-cosim: the simulation failed: Hanging.fmu was ended: no progress for 2 s, fmi2DoStep"
        in outcome.err
    )
    assert "Traceback" not in outcome.err and not (place / "run.csv").exists()


@pytest.mark.full
@needs_proc
@pytest.mark.parametrize(
    "how", [signal.SIGKILL, pytest.param(signal.SIGINT, marks=pytest.mark.full)]
)
@pytest.mark.parametrize("where", ["load", "fmi2DoStep"])
def test_nothing_spins_on(
    place: Path, monkeypatch: pytest.MonkeyPatch, where: str, how: signal.Signals
) -> None:
    """However the command ends; the FMU holds the interpreter's lock while it is loaded, and not in a step."""
    temporary = place / "temporary"
    temporary.mkdir()
    path = hanging(place)
    environment = {
        **os.environ,
        "PYTHONPATH": str(ROOT),
        "HANG": where,
        "SPIN": "",
        "TMPDIR": str(temporary),
    }
    command = subprocess.Popen(
        [sys.executable, "-m", "pam_cosim", "simulate", str(path)],
        env=environment,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )
    try:
        worker = _spinning(path)
        begin = time.monotonic()
        os.killpg(command.pid, how)  # as a terminal does
        command.communicate(timeout=PROMPT)
        while processes_of(path) and time.monotonic() - begin < PROMPT:
            time.sleep(0.02)
        assert worker not in processes_of(path) and processes_of(path) == []
        assert os.listdir(temporary) == []
    finally:
        command.kill()


def _spinning(path: Path) -> int:
    """The process that has spent a while in the FMU."""
    end = time.monotonic() + 60
    while time.monotonic() < end:
        for pid in processes_of(path):
            maps = Path(f"/proc/{pid}/maps")
            if maps.exists() and "Test_Lag.so" in maps.read_text():
                time.sleep(0.3)
                return pid
        time.sleep(0.05)
    raise AssertionError("the FMU was not loaded")
