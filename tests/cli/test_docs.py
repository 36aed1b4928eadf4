"""The commands and the script of ``docs/runs.md`` run as they stand."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome
from tests.cli.test_commands import done
from tests.documentation.pages import DOCS, blocks, commands, unsaid

PAGES = ("runs.md#Runs", "runs.md#Sweeps")


@pytest.mark.full
def test_page_of_runs(
    command: Callable[..., Outcome], place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, inputs in zip(("u.csv", "pulse.csv"), blocks(PAGES[0], "csv"), strict=True):
        (place / name).write_text(inputs)
    lines = [words for page in PAGES for words in commands(page)]
    assert len(lines) >= 4
    said = "\n".join(done(command(*words[1:])).out for words in lines)
    assert unsaid(PAGES[1], said) == []
    assert (place / "sweep.png").read_bytes() == (DOCS / "pictures" / "sweep.png").read_bytes()
    made = {
        "pulse.csv",
        "patterns.csv",
        "run.csv",
        "run.png",
        "sines.csv",
        "sweep.csv",
        "sweep.nc",
        "sweep.png",
    }
    assert {p.name for p in place.iterdir()} == {"u.csv", *made}
    [script] = blocks(PAGES[1], "python")
    capsys.readouterr()
    exec(compile(script, "docs/runs.md", "exec"), {})
    told = capsys.readouterr().out.splitlines()
    assert len([line for line in told if "filling time" in line]) == 7
    [comment] = re.findall(r"print\(swept\)  # (.*)", script)
    assert comment in "\n".join(told)
    assert {p.name for p in place.iterdir()} == {"u.csv", "filling.nc", "filling.png", *made}
