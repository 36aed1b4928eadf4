"""``sweep`` as a person uses it: killed and started again, random runs, every format, what cannot be used."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pandas
import pytest

from tests.cli.test_bad_input import refused

PROGRAM = (sys.executable, "-m", "pam_cosim")
WORDS = [
    "sweep",
    "Isotonic",
    "--vary",
    "u_in=0.25:0.45:30",
    "--vary",
    "p_supply=150 kPa:300 kPa:50",
]
WORDS += ["--scalar", "filling time=time_to(p, 90 %)", "--scalar", "steady(x)", "--stop-time", "10"]


def _started(place: Path, *more: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [*PROGRAM, *WORDS, "-o", "s.csv", *more],
        cwd=place,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def _kept(place: Path) -> int:
    return sum(file.stat().st_size for file in place.glob("s.csv.partial*"))


@pytest.mark.full
@pytest.mark.parametrize(("number", "workers"), [(signal.SIGKILL, "1"), (signal.SIGINT, "2")])
def test_a_sweep_that_is_stopped_goes_on(
    number: int, workers: str, place: Path, command: Callable[..., object]
) -> None:
    running = _started(place, "--workers", workers)
    end = time.monotonic() + 120
    while _kept(place) < 100_000:
        assert running.poll() is None and time.monotonic() < end, running.communicate()
        time.sleep(0.01)
    os.kill(running.pid, number)
    _, said = running.communicate(timeout=60)
    if number == signal.SIGINT:
        assert running.returncode == 130
        assert said.splitlines()[-1].endswith("kept in s.csv.partial: the same command continues")
    assert _kept(place) and not (place / "s.csv").exists()
    again = _started(place)
    out, said = again.communicate(timeout=300)
    assert again.returncode == 0, said
    assert out.startswith("1500 of 1500 runs done") and [p.name for p in place.iterdir()] == [
        "s.csv"
    ]
    whole = pandas.read_csv(place / "s.csv")
    done = subprocess.run(
        [*PROGRAM, *WORDS, "-o", "t.csv", "--workers", "1"],
        cwd=place,
        capture_output=True,
        timeout=300,
        check=True,
    )
    assert done.returncode == 0
    pandas.testing.assert_frame_equal(whole, pandas.read_csv(place / "t.csv"), check_exact=True)


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (["--design", "random"], ["u_in=0.2:0.3:3", "FROM:TO"]),
        (["--runs", "3"], ["leave out the number of runs"]),
        (["--scalar", "max(q)"], ["no variable 'q'"]),
        (["--no-trajectories"], ["needs a scalar"]),
        (["--keep", "valve.inlet.mflow"], ["no variable 'valve.inlet.mflow'", "did you mean"]),
        (["--stop-time", "3 kg"], ["the stop time", "'kg'"]),
    ],
    ids=lambda value: " ".join(value),
)
def test_what_cannot_be_used(
    more: list[str], words: list[str], command: Callable[..., object], place: Path
) -> None:
    refused(command("sweep TankFilling --vary u_in=0.2:0.3:3 -o s.csv", *more), words)  # type: ignore[arg-type]
    assert not list(place.iterdir())
