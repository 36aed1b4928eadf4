"""The command ``observe``."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from tests.cli.conftest import ROOT, Outcome
from tests.pictures import drawn

Command = Callable[..., Outcome]
MODEL = str(ROOT / "examples" / "observer" / "PulledMuscle.mo")


@pytest.fixture
def recording(place: Path) -> Path:
    """A muscle that is shut and hangs at rest, with noise."""
    chance = np.random.default_rng(1)
    rows = [f"{t:.2f},0,0,{0.5 * chance.standard_normal():.4f},{0.2 * chance.standard_normal() - 0.1113:.4f}"
            for t in np.arange(0, 1, 0.05)]  # fmt: skip
    path = place / "r.csv"
    path.write_text("\n".join(["time [s],u_in [A],u_out [A],p [kPa],x [mm]", *rows]) + "\n")
    return path


def test_files(command: Command, recording: Path, place: Path) -> None:
    told = ("--noise", "p=0.5 kPa", "--noise", "x=0.2 mm", "--unknown", "F_ext=5 N,5 N", "--held")
    files = ("--json", "o.json", "-o", "o.csv", "--plot", "o.png")
    done = command("observe", MODEL, "r.csv", *told, "--of", "F", *files)
    assert done.status == 0 and "consistent" in done.out, done.err
    read = json.loads((place / "o.json").read_text())
    assert (
        read["outputs"] == ["F"]
        and len(read["values"]["F"]) == 20
        and read["consistency"]["consistent"]
    )
    assert len((place / "o.csv").read_text().splitlines()) == 21
    assert drawn(place / "o.png")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--unknown", "F_ext=5 N"], "write its initial standard deviation"),
        (["--noise", "p=2 kPa"], "'p' is given twice"),
        (["--drift", "p=1 kPa"], "no state 'p'"),
        (["--start", "rest"], "give values by name"),
        (["--set", "F_ext=1 kg"], "F_ext=1 kg"),
        (["-o", "r.csv"], "r.csv"),
    ],
)
def test_refused(
    command: Command, recording: Path, place: Path, words: list[str], message: str
) -> None:
    before = recording.read_bytes()
    done = command("observe", MODEL, "r.csv", "--noise", "p=0.5 kPa", *words, "--json", "x.json")
    assert (done.status, done.out) == (2, "") and message in done.err
    assert [p.name for p in place.iterdir()] == ["r.csv"] and recording.read_bytes() == before
