"""The commands and the scripts of the pages on dynamics run as they stand."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done


def blocks(page: str, kind: str) -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", (ROOT / "docs" / page).read_text(), re.DOTALL)


@pytest.mark.parametrize("page", ["linear-analysis.md"])
def test_page(page: str, command: Callable[..., Outcome], place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = [line for block in blocks(page, "sh") for line in block.splitlines() if line.startswith("pam-cosim ")]
    assert lines
    for line in lines:
        done(command(*shlex.split(line)[1:]))
    scripts = blocks(page, "python")
    names: dict[str, object] = {}  # the scripts of a page go on from each other
    assert scripts
    for script in scripts:
        exec(compile(script, page, "exec"), names)
    assert (place / "linear.png").exists() and (place / "linear.json").exists()
