"""The command ``linearise``: matrices on the screen, in files, and one message for what cannot be done."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome

Command = Callable[..., Outcome]


def test_files(command: Command, place: Path) -> None:
    done = command("linearise LumpedLinear --json l.json -o l.csv --plot l.png")
    assert done.status == 0 and "time constant 0.1 s" in done.out, done.err
    read = json.loads((place / "l.json").read_text())
    assert read["A"][2] == pytest.approx([-2.8619e-4, -4280.9, -30])
    assert read["point"]["kind"] == "rest" and read["units"]["F"] == "N" and read["stable"]
    assert (place / "l.csv").read_text().startswith(",P [Pa]")
    assert (place / "l.png").read_bytes().startswith(b"\x89PNG")


def test_times_of_a_run(command: Command, place: Path) -> None:
    (place / "u.csv").write_text("time [s],u_in [A]\n0,0.2\n3,0.3\n")
    words = ("--input", "u.csv", "--at", "time=1 s", "--at", "time=2", "--json", "r.json")
    done = command("linearise Isotonic", *words)
    assert done.status == 0, done.err
    points = [model["point"] for model in json.loads((place / "r.json").read_text())["models"]]
    assert [point["time"] for point in points] == [1, 2]
    assert points[1]["inputs"]["u_in"] == pytest.approx(0.2 + 0.1 * 2 / 3)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--at", "p=6 kg"], "p=6 kg"),
        (["--at", "p"], "'p': write NAME=VALUE"),
        (["--at", "p=1 bar, time=2 s"], "give either times or values"),
        (["--at", "time=1", "--at", "time=2", "-o", "a.csv"], "are for one point"),
    ],
)
def test_refused(command: Command, place: Path, words: list[str], message: str) -> None:
    (place / "u.csv").write_text("time [s],u_in [A]\n0,0.2\n3,0.3\n")
    done = command("linearise Isotonic", *words, "--json", "x.json")
    assert (done.status, done.out) == (2, "") and message in done.err
    assert done.err.count("\n") == 1 and sorted(p.name for p in place.iterdir()) == ["u.csv"]
