"""The pages of ``docs/questions``: their commands exist with the options that they name."""

from __future__ import annotations

import re
import shlex

import pytest
import typer

from pam_cosim.cli.app import app
from tests.documentation.pages import ROOT

PAGES = sorted((ROOT / "docs" / "questions").glob("*.md"))
COMMANDS = typer.main.get_command(app).commands  # type: ignore[attr-defined]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_and_options_are_there(page: object) -> None:
    blocks = re.findall(
        r"^```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
    )  # type: ignore[attr-defined]
    lines = [shlex.split(line, comments=True) for block in blocks for line in block.splitlines()]
    assert lines
    for program, name, *words in lines:
        assert program == "pam-cosim"
        known = {option for one in COMMANDS[name].params for option in one.opts}
        assert {word for word in words if word.startswith("-")} <= known, (name, words)


def test_the_first_page_leads_to_each() -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    assert len(PAGES) == 5 and all(f"questions/{page.name}" in index for page in PAGES)
