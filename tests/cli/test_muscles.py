"""Muscles by name on the command line: the page on them as it stands, and what a wrong sleeve says."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pam_cosim as pam
from tests.cli.conftest import Outcome
from tests.documentation.pages import source

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
