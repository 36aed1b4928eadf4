"""The pages of ``docs/questions``: their commands exist with the options that they name."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from functools import cache

import pytest
import typer

from pam_cosim.cli.app import app
from tests.documentation.pages import ROOT

PAGES = sorted((ROOT / "docs" / "questions").glob("*.md"))
COMMANDS = typer.main.get_command(app).commands  # type: ignore[attr-defined]


@cache
def options_of_script(script: str) -> set[str]:
    """The options that a script of the repository prints with --help."""
    command = [sys.executable, ROOT / script, "--help"]
    told = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", told))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_and_options_are_there(page: object) -> None:
    blocks = re.findall(
        r"^```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
    )  # type: ignore[attr-defined]
    lines = [shlex.split(line, comments=True) for block in blocks for line in block.splitlines()]
    assert lines
    for program, name, *words in lines:
        assert program in ("pam-cosim", "python")
        known = (
            options_of_script(name)
            if program == "python"
            else {option for one in COMMANDS[name].params for option in one.opts}
        )
        assert {word for word in words if word.startswith("-")} <= known, (name, words)


def test_the_first_page_leads_to_each() -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    assert len(PAGES) == 5 and all(f"questions/{page.name}" in index for page in PAGES)
