"""The commands of the tutorials run in order, and print what the page quotes."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome, command, place
from tests.cli.test_commands import done
from tests.documentation.pages import ROOT, commands, unsaid

__all__ = ["command", "place"]


@pytest.mark.full
@pytest.mark.parametrize("heading", ["A step test", "A static map", "A sine"])
def test_tutorial(heading: str, command: Callable[..., Outcome], place: Path) -> None:  # noqa: F811
    os.symlink(ROOT / "examples", place / "examples")
    page = f"tutorials.md#{heading}"
    printed = "\n".join(
        done(command(*words)).out
        if program == "pam-cosim"
        else subprocess.run(
            [sys.executable, *words], capture_output=True, text=True, check=True
        ).stdout
        for program, *words in commands(page)
    )
    assert unsaid(page, printed) == []
