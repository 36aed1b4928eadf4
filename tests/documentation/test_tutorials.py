"""The tutorials as they stand: their commands run in order, and what they quote is said."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome, command, place
from tests.cli.test_commands import done
from tests.documentation.pages import ROOT, unsaid

__all__ = ["command", "place"]
SCRIPT = {"capture_output": True, "text": True, "check": True}
PAGES = sorted((ROOT / "docs" / "tutorials").glob("*.md"))


@pytest.mark.full
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_tutorial(page: Path, command: Callable[..., Outcome], place: Path) -> None:  # noqa: F811
    os.symlink(ROOT / "examples", place / "examples")
    blocks = re.findall(
        r"^```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
    )
    lines = [shlex.split(line) for block in blocks for line in block.splitlines()]
    assert len(lines) >= 2 and {words[0] for words in lines} <= {"pam-cosim", "python"}
    said = "\n".join(
        done(command(*words[1:])).out
        if words[0] == "pam-cosim"
        else subprocess.run([sys.executable, *words[1:]], **SCRIPT).stdout
        for words in lines
    )
    assert unsaid(f"tutorials/{page.name}", said) == []
    asked = {
        words[i + 1]
        for words in lines
        for i, word in enumerate(words)
        if word in ("-o", "--plot", "--report")
    }
    assert asked <= {file.name for file in place.iterdir()}


def test_there_are_tutorials() -> None:
    assert [page.stem for page in PAGES] == ["sine", "static-map", "step-test"]
