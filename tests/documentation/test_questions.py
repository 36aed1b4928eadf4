"""Commands of the pages exist with the options that the pages name, and scripts are where they say."""

from __future__ import annotations

from importlib.util import find_spec

import pytest
import typer

from pam_cosim.cli.app import app
from tests.documentation.pages import DOCS, ROOT, commands

COMMANDS = typer.main.get_command(app).commands  # type: ignore[attr-defined]


@pytest.mark.parametrize("page", sorted(page.name for page in DOCS.glob("*.md")))
def test_commands_and_options_exist(page: str) -> None:
    for program, *words in commands(page):
        if program == "pam-cosim":
            options = {option for one in COMMANDS[words[0]].params for option in one.opts}
            assert {word for word in words if word.startswith("-")} <= options, words
        elif program == "python" and words[0] == "-m":
            assert words[1] == "venv" or find_spec(words[1]), words
        elif program == "python":
            assert (ROOT / words[0]).is_file(), words
