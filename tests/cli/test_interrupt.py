"""Ctrl-C at any moment: one line that says what was saved, status 130, no process and no temporary file left.

The command runs as a process of its own in a group of its own, and the signal goes to the whole group, as a terminal
sends it. The moment is not a time but an event: a folder or a process that the command has made.
"""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from rig import measurement
from rig.named import effect_of
from rig.plan import default_plan
from tests.tiers import quick

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")

PROGRAM = (sys.executable, "-m", "pam_cosim")
PROMPT = 30.0  # [s]: two for tasks that do not heed, on a machine that does other things; what is interrupted says so


class Running:
    """A command that runs, with everything that it starts."""

    def __init__(self, place: Path, words: list[str], **more: str) -> None:
        self.temporary = place / "temporary"
        self.temporary.mkdir()
        self.mark = f"PAM_COSIM_TEST={os.urandom(8).hex()}"
        variables = dict([self.mark.split("=")], TMPDIR=str(self.temporary), **more)
        self.process = subprocess.Popen(
            [*PROGRAM, *words],
            cwd=place,
            env=os.environ | variables,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
        )

    def family(self) -> list[str]:
        """The commands of all processes that have inherited its environment."""
        commands = []
        for folder in Path("/proc").glob("[0-9]*"):
            try:
                if self.mark.encode() in (folder / "environ").read_bytes().split(b"\0"):
                    commands.append((folder / "cmdline").read_bytes().replace(b"\0", b" ").decode())
            except OSError:
                continue
        return [command for command in commands if command]  # a zombie has none

    def wait_for(self, event: Callable[[Running], bool]) -> None:
        end = time.monotonic() + 120
        while not event(self):
            assert self.process.poll() is None, self.process.communicate()
            assert time.monotonic() < end, self.family()
            time.sleep(0.01)

    def interrupt(self) -> tuple[int, list[str]]:
        """Status, and the lines on standard error; whoever is asked and what is made ends promptly."""
        begin = time.monotonic()
        os.killpg(self.process.pid, signal.SIGINT)
        try:
            _, err = self.process.communicate(timeout=60)
        finally:
            self.process.kill()
        assert time.monotonic() - begin < PROMPT
        while self.family() and time.monotonic() - begin < PROMPT:
            time.sleep(0.02)
        assert self.family() == []
        assert list(self.temporary.rglob("*")) == []
        assert "Traceback" not in err and "Exception" not in err and "Error" not in err, err
        return self.process.returncode, err.splitlines()


def loading(running: Running) -> bool:
    return any(running.temporary.iterdir())


def simulating(running: Running) -> bool:
    return any(running.temporary.glob("*/pam-cosim-fmu-*/binaries"))


def kept(running: Running) -> bool:
    return any(
        file.stat().st_size > 100_000 for file in running.temporary.parent.glob("*.partial*")
    )


def workers(running: Running) -> bool:
    return any("LokyProcess" in command for command in running.family())


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A muscle with a rubber bladder that its model leaves out, by the independent simulator."""
    folder = tmp_path_factory.mktemp("measured")
    measurement.write_data_set(
        folder / "data",
        measurement.measure(default_plan(), [effect_of("elasticity:exponential")], seed=1),
    )
    return folder


MOMENTS = {
    "simulate": (["simulate", "Isotonic", "--stop-time", "3e4", "-o", "out"], simulating, 0.3),
    "sweep": (["sweep", "Isotonic", "--vary", "load.m=1:9:200000", "-o", "out"], kept, 0.3),
    "fit": (["fit", "data", "--method", "particle-swarm", "-o", "out"], simulating, 0.2),
    "diagnose": (["diagnose", "data", "--json", "out", "--workers", "2"], workers, 2.0),
}


@pytest.mark.parametrize("moment", quick(MOMENTS, "simulate"))
def test_nothing_is_left(place: Path, measured: Path, moment: str) -> None:
    shutil.copytree(measured, place, dirs_exist_ok=True)
    words, event, later = MOMENTS[moment]
    (place / "out").write_text("old")
    running = Running(place, words)
    running.wait_for(event)
    time.sleep(later)
    status, err = running.interrupt()
    assert status == 130
    said = [line for line in err if line.startswith("pam-cosim: ")]
    more = "; the finished runs are kept in out.partial: the same command continues" * (
        moment == "sweep"
    )
    assert said == [f"pam-cosim: interrupted; nothing was written{more}"] and err[-1] == said[0]
    assert moment.startswith("diagnose") or len(err) == 1, err
    assert (place / "out").read_text() == "old"


def test_ending_by_another_signal(place: Path) -> None:
    running = Running(place, ["simulate", "Isotonic", "--stop-time", "3e4"])
    running.wait_for(loading)
    os.kill(running.process.pid, signal.SIGTERM)
    _, err = running.process.communicate(timeout=60)
    assert (running.process.returncode, err) == (
        143,
        "pam-cosim: interrupted; nothing was written\n",
    )
    assert list(running.temporary.iterdir()) == [] and running.family() == []
