"""The command ``bode``."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome
from tests.pictures import drawn

Command = Callable[..., Outcome]


@pytest.mark.full
def test_files(command: Command, place: Path) -> None:
    done = command(
        "bode LumpedLinear --by p_in --of F --amplitude '0.5 bar' --frequencies "
        "0.1:20:5 --json b.json -o b.csv --plot b.png"
    )
    assert done.status == 0 and "which swings by 50 kPa" in done.out, done.err
    read = json.loads((place / "b.json").read_text())
    assert read["outputs"]["F"]["gain"] == pytest.approx(
        read["outputs"]["F"]["linear_gain"], rel=1e-4
    )
    assert read["frequencies"] == pytest.approx([0.1, 0.376, 1.414, 5.318, 20], rel=1e-3)
    assert len((place / "b.csv").read_text().splitlines()) == 6
    assert drawn(place / "b.png")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--frequencies", "20:0.1:5"], "the lower one first"),
        (["--frequencies", "1:2"], "write FROM:TO:N"),
        (["--frequencies", "a"], "frequencies=a"),
        (["--amplitude", "1 kg"], "p_in=1 kg"),
        (["--at", "time=2"], "not about a time"),
        (["--of", "Q"], "no variable 'Q'"),
    ],
)
def test_refused(command: Command, place: Path, words: list[str], message: str) -> None:
    amplitude = [] if "--amplitude" in words else ["--amplitude", "1 bar"]
    done = command("bode LumpedLinear --by p_in", *amplitude, *words, "--json", "x.json")
    assert (done.status, done.out) == (2, "") and message in done.err
    assert not list(place.iterdir())
