"""The commands and the scripts of the pages on dynamics run as they stand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done
from tests.documentation.pages import blocks, commands


@pytest.mark.full
def test_linear_models_and_frequency_responses(
    command: Callable[..., Outcome], place: Path
) -> None:
    names: dict[str, object] = {}  # the second script continues the first
    for page in ("runs.md#Linear models", "runs.md#Frequency response"):
        for words in commands(page):
            done(command(*words[1:]))
        (script,) = blocks(page, "python")
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
    (script,) = blocks("runs.md#Observer", "python")
    names: dict[str, object] = {}
    exec(compile(script, "runs.md", "exec"), names)
    said = capsys.readouterr().out
    assert "F against the truth: rms" in said and (place / "observer.png").exists()
    recording = names["recording"]
    rows = zip(recording.time, recording["p"], recording["x"], strict=True)
    (place / "recording.csv").write_text(
        "time [s],p [Pa],x [m]\n" + "".join(f"{t},{p},{x}\n" for t, p, x in rows)
    )
    (words,) = commands("runs.md#Observer")
    done(command(*words[1:]))
    assert {"force.csv", "force.json", "force.png"} <= {p.name for p in place.iterdir()}
