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
