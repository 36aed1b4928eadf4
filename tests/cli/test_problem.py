"""The options that state values mean the same in every command, and ``--values`` says what counts."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.cli.test_commands import done
from tests.cli.test_last_step import Command
from tests.problems.test_values import written


@pytest.fixture
def rig(place: Path) -> Path:
    return written(place / "rig", "k = 4")


@pytest.mark.parametrize("name", ["compare", "fit", "check", "diagnose"])
def test_every_command_prints_the_values_that_count(command: Command, rig: Path, name: str) -> None:
    workers = ["--workers", 0] if name in ("check", "diagnose") else []
    said = done(command(name, rig, "--set", "k@run-2=7", "--values", *workers)).out
    assert "k      4  stated by the data set for run-1" in said
    assert "k      7  stated by the caller, in place of 4 of run-2" in said


@pytest.mark.parametrize("name", ["compare", "fit", "diagnose"])
def test_an_earlier_fit_gives_way_to_what_is_stated(
    command: Command, rig: Path, place: Path, name: str
) -> None:
    written(place / "open")
    done(command("fit", place / "open", "--free", "k", "--free", "tau", "-o", "p.json"))
    workers = ["--workers", 0] if name == "diagnose" else []
    said = done(command(name, rig, "--params", "p.json", "--values", *workers))
    assert "the data set states k, and its value is used instead of that of p.json" in said.err
    assert "stated by the data set" in said.out


def test_what_is_stated_after_a_verdict_is_said_in_one_line(
    command: Command, rig: Path, place: Path
) -> None:
    done(command("diagnose", rig, "--free", "k", "-o", "Better.mo", "--workers", 0))
    written(rig, "k = 3")
    said = done(command("compare", rig, "--model", "Better.mo"))
    assert (said.out + said.err).count("it stated 4 when the verdict in Better.mo found 2") == 1
