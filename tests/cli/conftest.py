"""The real command, run in this process or another, and a small valid data set to damage."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest

from pam_cosim.cli.app import main
from tests.fitting.models import discharge

ROOT = Path(__file__).parents[2]

EXPERIMENT = """\
title = "a vessel that empties"
model = "PneumaticMuscle.Benches.VesselOrifice"
[signals.p]
sigma = "1 kPa"
[parameters]
"tank.V" = "16.2 l"
"tank.p_start" = "690 kPa"
"orifice.d" = "2.71 mm"
[fit]
"orifice.C_d" = { min = 0.5, max = 1.1 }
"tank.n" = { min = 1.0, max = 1.4 }
[[runs]]
file = "one.csv"
role = "fit"
"""


def table() -> str:
    """The independent vessel's pressure, one row a second, with an alternating error of 1 kPa."""
    p, _ = discharge()
    rows = [f"{t},{p[t] / 1e3 + (-1) ** t:.6f}" for t in range(0, 61)]
    return "\n".join(["time [s],p [kPa]", *rows, ""])


@dataclass(frozen=True)
class Outcome:
    status: int
    out: str
    err: str


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty working directory."""
    folder = tmp_path / "work"
    folder.mkdir()
    monkeypatch.chdir(folder)
    return folder


@pytest.fixture
def data(place: Path) -> Path:
    """The valid data set, in the working directory."""
    folder = place / "data"
    folder.mkdir()
    (folder / "experiment.toml").write_text(EXPERIMENT)
    (folder / "one.csv").write_text(table())
    return folder


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str]) -> Callable[..., Outcome]:
    """Runs ``pam-cosim`` with a line of words, and further ones, in this process."""

    def call(line: object, *words: object) -> Outcome:
        capsys.readouterr()
        status = main([*shlex.split(str(line)), *map(str, words)])
        return Outcome(status, *capsys.readouterr())

    return call


@pytest.fixture
def process() -> Callable[..., Outcome]:
    """Runs ``python -m pam_cosim`` with a line of words, and further ones."""

    def call(line: str, *words: object) -> Outcome:
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        completed = subprocess.run(
            [sys.executable, "-m", "pam_cosim", *shlex.split(line), *map(str, words)],
            capture_output=True,
            text=True,
            env=environment,
        )
        return Outcome(completed.returncode, completed.stdout, completed.stderr)

    return call


def everything(folder: Path) -> list[tuple[str, bytes]]:
    """All files below a folder with their content."""
    return sorted(
        (str(p.relative_to(folder)), p.read_bytes()) for p in folder.rglob("*") if p.is_file()
    )
