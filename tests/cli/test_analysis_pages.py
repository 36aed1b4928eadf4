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


@pytest.mark.full
@pytest.mark.parametrize("page", ["linear-analysis.md"])
def test_page(
    page: str, command: Callable[..., Outcome], place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shell = "\n".join(blocks(page, "sh")).replace("\\\n", "")
    lines = [line for line in shell.splitlines() if line.startswith("pam-cosim ")]
    assert lines
    for line in lines:
        done(command(*shlex.split(line)[1:]))
    scripts = blocks(page, "python")
    names: dict[str, object] = {}  # the scripts of a page go on from each other
    assert scripts
    for script in scripts:
        exec(compile(script, page, "exec"), names)
    assert (place / "linear.png").exists() and (place / "linear.json").exists()


@pytest.mark.full
def test_page_of_the_observer(
    command: Callable[..., Outcome],
    monkeypatch: pytest.MonkeyPatch,
    place: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Its paths are those of the repository."""
    (place / "examples").symlink_to(ROOT / "examples")
    script = blocks("observer.md", "python")[0]
    names: dict[str, object] = {}
    exec(compile(script, "observer.md", "exec"), names)
    said = capsys.readouterr().out
    assert "F against the truth: rms" in said and (place / "observer.png").exists()
    recording = names["recording"]
    rows = zip(recording.time, recording["p"], recording["x"], strict=True)
    (place / "recording.csv").write_text(
        "time [s],p [Pa],x [m]\n" + "".join(f"{t},{p},{x}\n" for t, p, x in rows)
    )
    line = blocks("observer.md", "sh")[0]
    done(command(*shlex.split(line.replace("\\\n", ""))[1:]))
    assert {"force.csv", "force.json", "force.png"} <= {p.name for p in place.iterdir()}
