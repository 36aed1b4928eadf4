"""The process around the command: interrupts that come where Python ignores exceptions; options given twice."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Outcome, everything

SCRIPT = """
import os, signal, time
import pam_cosim.cli.app, pam_cosim.cli.process

class Late:
    def __del__(self):
        os.kill(os.getpid(), signal.SIGINT)
        for _ in range(1000):
            pass

def main():
    late = Late()
    del late
    time.sleep(30)

pam_cosim.cli.app.main = main
pam_cosim.cli.process.run()
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_interrupt_within_a_destructor_comes_again() -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    words = [sys.executable, "-c", SCRIPT]
    completed = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=25)
    assert (completed.returncode, completed.stderr) == (
        128 + signal.SIGINT,
        "pam-cosim: interrupted; nothing was written\n",
    )


@pytest.mark.skipif(os.name != "posix", reason="/dev/full, and a shell that closes its output")
@pytest.mark.parametrize(
    ("output", "status", "said"),
    [
        (
            ">/dev/full",
            2,
            "pam-cosim: what is printed cannot be written: No space left on device\n",
        ),
        (">&-", 0, ""),
        pytest.param("| true; exit ${PIPESTATUS[0]}", None, "", marks=pytest.mark.full),
    ],
)
def test_an_output_that_takes_nothing_ends_in_words(
    output: str, status: int | None, said: str
) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    words = ["bash", "-c", f"'{sys.executable}' -m pam_cosim effects {output}"]
    completed = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=240)
    assert completed.stderr == said
    assert status is None or completed.returncode == status


SWEEP = ["sweep", "TankFilling", "--vary", "u_in=0,1", "-o", "table.csv"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (
            ["simulate", "TankFilling", "--input", "u_in = 0.1", "--input", "u_out = 0"],
            "--input is given 2 times; it takes one value",
        ),
        (["simulate", "TankFilling", "--input", " "], "the inputs are an empty text"),
        (["linearise", "TankFilling", "--at", ""], "write NAME=VALUE"),
        (["bode", "TankFilling", "--by", "u_in", "--amplitude", "1 mA", "--at", ""], "NAME=VALUE"),
        ([*SWEEP, "--scalar", "=max(p)"], "NAME=SCALAR"),
        ([*SWEEP, "--scalar", "top="], "NAME=SCALAR"),
    ],
)
def test_an_empty_word_and_one_too_many_are_refused(
    command: Callable[..., Outcome], place: Path, words: list[str], said: str
) -> None:
    """Of two values of one option the first had been passed over, and an empty state was that of the model."""
    refused = command(*words)
    assert refused.status == 2 and said in refused.err and refused.err.count("\n") == 1
    assert everything(place) == []
