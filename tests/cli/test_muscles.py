"""Muscles by name on the command line: the page on them as it stands, and what a wrong sleeve says."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

import pam_cosim as pam
from tests.cli.conftest import Outcome
from tests.cli.test_commands import done
from tests.documentation.pages import blocks, source

PAGE = "benches.md#Muscles by name"


def test_every_muscle_of_the_page_is_there() -> None:
    table = source(PAGE).split("| `--muscle` |")[1].split("\n\n")[0]
    named = {
        name
        for row in table.splitlines()
        for name in re.findall(r"`([^`]+)`", row.split("|")[1] if "|" in row else "")
    }
    known = {part.name for part in pam.rig_parts() if part.role == "muscle"}
    assert {name.lower() for name in named} == known


def test_the_class_and_the_measures_of_the_page(
    command: Callable[..., Outcome], place: Path
) -> None:
    (mine,), (toml,) = blocks(PAGE, "modelica"), blocks(PAGE, "toml")
    (place / "Mine.mo").write_text(mine)
    words = ("--pneumatics", "imposed-pressure", "--mechanics", "imposed-length", "-o")
    done(command("bench", *words, "Own.mo", "--muscle", "mine", "--file", "Mine.mo"))
    run = pam.simulate(
        "Own.mo", {"p": "300 kPa", "s": 0.0}, files=["Mine.mo"], outputs=["F", "muscle.turns"]
    )
    assert run["muscle.turns"][0] == pytest.approx(1.84, abs=0.01) and run["F"][-1] > 100

    done(command("bench", *words, "Any.mo", "--muscle", "any-geometry"))
    measures = [
        f"{key}={value}" for key, value in re.findall(r'"(muscle[^"]+)" = "?([^"\n]+)"?', toml)
    ]
    assert len(measures) == 4
    done(
        command(
            "simulate",
            "Any.mo",
            *(word for one in measures for word in ("--set", one)),
            "-o",
            "any.csv",
        )
    )
    wrong = command(
        "simulate",
        "Any.mo",
        *(word for one in measures[:3] for word in ("--set", one)),
        "-o",
        "wrong.csv",
    )
    assert wrong.status != 0 and "contradict each other" in wrong.err and "turns = 2" in wrong.err
    assert (place / "any.csv").is_file() and not (place / "wrong.csv").exists()


def test_a_muscle_that_is_not_there_names_those_that_are_like_it(
    command: Callable[..., Outcome], place: Path
) -> None:
    words = (
        "--pneumatics",
        "regulator",
        "--mechanics",
        "spring",
        "--muscle",
        "DMSP-15",
        "-o",
        "R.mo",
    )
    outcome = command("bench", *words)
    assert (
        outcome.status == 2 and "did you mean 'dmsp10'" in outcome.err and not list(place.iterdir())
    )
