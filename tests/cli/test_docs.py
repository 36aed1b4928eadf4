"""The commands and the script of ``docs/runs.md`` run as they stand."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done
from tests.documentation.pages import DOCS, unsaid

PAGE = (ROOT / "docs" / "runs.md").read_text()


def blocks(kind: str) -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", PAGE, re.DOTALL)


@pytest.mark.full
def test_page_of_runs(
    command: Callable[..., Outcome], place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, course in zip(("u.csv", "pulse.csv"), blocks("csv"), strict=True):
        (place / name).write_text(course)
    text = "".join(blocks("sh")).replace("\\\n", " ")
    lines = [line for line in text.splitlines() if line.startswith("pam-cosim ")]
    assert len(lines) >= 4
    said = "\n".join(done(command(*shlex.split(line)[1:])).out for line in lines)
    assert unsaid("runs.md", said) == []
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
    [script] = blocks("python")
    capsys.readouterr()
    exec(compile(script, "docs/runs.md", "exec"), {})
    told = capsys.readouterr().out.splitlines()
    assert len([line for line in told if "filling time" in line]) == 7
    [comment] = re.findall(r"print\(swept\)  # (.*)", script)
    assert comment in "\n".join(told)
    assert {p.name for p in place.iterdir()} == {"u.csv", "filling.nc", "filling.png", *made}
