"""The examples run as they stand and print what the pages quote."""

from __future__ import annotations

import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.cli.app import main
from tests.documentation.pages import absent, other_pictures

ROOT = Path(__file__).parents[2]


def run(script: str, folder: Path) -> str:
    command = [sys.executable, str(ROOT / "examples" / script), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_overshoot_of_the_slides_step() -> None:
    """Quick: the middle of the example's numbers."""
    linear = pam.linearise("LumpedLinear", {"C_1": 5.7239e-4})
    force = linear.step(np.linspace(0, 1.2, 1201))[:, 2, 0] * 2e5
    assert force.max() == pytest.approx(17.0, abs=0.1) and force[-1] == pytest.approx(6.7, abs=0.05)
    assert force[::100].max() < 6.75


@pytest.mark.full
def test_observer(tmp_path: Path) -> None:
    said = run("observer/observer.py", tmp_path)
    for number in ("F against the truth: rms 1.2 N, at most 5.16 N", "F against the truth: rms 1.04 N, at most 4.98 N",
                   "innovations squared by measurement: 0.957", "the readings themselves: rms 8.22 N",
                   "F against the truth: rms 3.45 N"):  # fmt: skip
        assert number in said
    assert other_pictures(tmp_path) == []


@pytest.mark.full
def test_tracking(tmp_path: Path) -> None:
    said = run("tracking/tracking.py", tmp_path)
    assert "0.563 m/s by an ampere of the inlet, 0.232 m/s of the exhaust" in said
    rows = [line for line in said.splitlines() if line.startswith("| ")]
    assert len(rows) == 3 and absent(rows, "runs.md") == []
    assert other_pictures(tmp_path) == []


@pytest.mark.full
def test_slides(tmp_path: Path) -> None:
    said = run("linear-analysis/slides.py", tmp_path)
    for number in ("F = 205.67 N, C_1 = 5.7239e-04 m2, C_2 = 8061.8 N/m", "84.8 N", "114.5 N", "85.6 N", "11.4 N",
                   "if the step falls on a sample",
                   "10.41 Hz, damping ratio 0.229; pull up to 17.0 N (6.7 at 10 Hz, 16.9 at 80 Hz",
                   "2 bar: 2.29 % per bar at 0.1 Hz (linear model 1.45), -6° (-48°), distortion 8.0%"):  # fmt: skip
        assert number in said
    assert len(list(tmp_path.glob("*.png"))) == 3
    assert other_pictures(tmp_path) == []
    assert (
        absent(
            [line for line in said.splitlines() if line.startswith("the loop")],
            "runs.md",
        )
        == []
    )


@pytest.mark.full
def test_frequency_response_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The picture is the one that the command beside it draws."""
    monkeypatch.chdir(tmp_path)
    page = (ROOT / "docs" / "runs.md").read_text(encoding="utf-8").replace("\\\n", " ")
    [line] = [line for line in page.splitlines() if line.startswith("pam-cosim bode")]
    assert main(shlex.split(line)[1:]) == 0
    assert other_pictures(tmp_path) == []
