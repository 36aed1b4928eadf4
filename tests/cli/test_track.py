"""The command ``track``."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.analysis.test_track import PLANT, PROPORTIONAL
from tests.cli.conftest import Outcome
from tests.pictures import drawn

Command = Callable[..., Outcome]
LAW = """
import pam_cosim as pam

@pam.controller(inputs={"y": "m", "y_wanted": "m"}, outputs={"u": "m/s"}, interval="5 ms")
def law(time, y, y_wanted):
    return 6 * (y_wanted - y)
"""
TOLD = ("--of", "y", "--mean", "1 m", "--amplitude", "10 cm", "--frequencies", "1,2", "--lead", "2")


@pytest.fixture
def sources(place: Path) -> Path:
    (place / "Slide.mo").write_text(PLANT)
    (place / "law.py").write_text(LAW)
    return place


def test_files(command: Command, sources: Path) -> None:
    done = command("track", "Slide.mo", "--controller", "law.py:law", *TOLD, "--json", "t.json", "-o", "t.csv",
                   "--plot", "t.png")  # fmt: skip
    assert done.status == 0 and "follows" in done.out, done.err
    read = json.loads((sources / "t.json").read_text())
    assert read["relative_error"] == pytest.approx([0.723, 0.902], abs=0.04)
    assert len((sources / "t.csv").read_text().splitlines()) == 3
    assert drawn(sources / "t.png")


def test_a_compiled_controller_acts_so_often(command: Command, sources: Path) -> None:
    (sources / "Gain.mo").write_text(PROPORTIONAL)
    told = (*TOLD, "--rate", "50", "--json", "t.json")
    done = command("track", "Slide.mo", "--controller", "Gain.mo", *told)
    assert done.status == 0, done.err
    assert json.loads((sources / "t.json").read_text())["rate"] == 50


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--controller", "law.py:low"], "has no controller 'low'"),
        (["--controller", "lew.py:law"], "there is no such file"),
        (["--controller", "law.py:law", "--set", "plant.q=1"], "'q'"),
        (["--controller", "law.py:law", "-o", "law.py"], "law.py"),
        (["--controller", "Isotonic"], "no input 'y_wanted'"),
        (["--controller", "law.py:law", "--periods", "1"], "two periods at least"),
        (["--controller", "law.py:law", "--periods", "1000000000"], "1000000000 periods take"),
    ],
)
def test_refused(command: Command, sources: Path, words: list[str], message: str) -> None:
    done = command("track", "Slide.mo", *words, *TOLD, "--json", "x.json")
    assert (done.status, done.out) == (2, "") and message in done.err
    assert sorted(p.name for p in sources.iterdir()) == ["Slide.mo", "law.py"]
    assert (sources / "law.py").read_text() == LAW


def test_a_limit_of_no_time(command: Command, sources: Path) -> None:
    told = command("track", "Slide.mo", "--controller", "law.py:law", *TOLD, "--timeout", "0")
    assert told.status == 2 and "a time limit must be larger than zero" in told.err
