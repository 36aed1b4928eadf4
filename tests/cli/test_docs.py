"""The commands and the script of ``docs/runs.md`` run as they stand."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done

PAGE = (ROOT / "docs" / "runs.md").read_text()


def blocks(kind: str) -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", PAGE, re.DOTALL)


def test_page_of_runs(command: Callable[..., Outcome], place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    [course] = blocks("csv")
    (place / "u.csv").write_text(course)
    text = "".join(blocks("sh")).replace("\\\n", " ")
    lines = [line for line in text.splitlines() if line.startswith("pam-cosim ")]
    assert len(lines) >= 4
    for line in lines:
        done(command(*shlex.split(line)[1:]))
    made = {"run.csv", "run.png", "sweep.csv", "sweep.nc", "sweep.png"}
    assert {p.name for p in place.iterdir()} == {"u.csv", *made}
    [script] = blocks("python")
    capsys.readouterr()
    exec(compile(script, "docs/runs.md", "exec"), {})
    said = capsys.readouterr().out.splitlines()
    assert len([line for line in said if "filling time" in line]) == 9
    assert {p.name for p in place.iterdir()} == {"u.csv", "filling.nc", "filling.png", *made}
