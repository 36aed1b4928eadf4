"""What ``compare`` and ``fit`` say before and after their work: tables, endings, notes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from pam_cosim.cli.commands.compare import _notes
from pam_cosim.study import comparisons
from tests.cli.conftest import Outcome
from tests.comparison.fake import run

Command = Callable[..., Outcome]


def no_simulation(*_: object, **__: object) -> None:
    raise AssertionError("it was simulated before")


def test_a_table_is_checked_before_the_simulation(
    command: Command, data: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(comparisons, "_compare", no_simulation)
    outcome = command("compare", data, "--table", "tank.V", "orifice.q")
    assert outcome.status == 2 and "no parameter 'orifice.q'" in outcome.err


def test_a_note_of_several_runs_is_printed_once() -> None:
    runs = [replace(run(name, [0.0, 1.0]), notes=("it pauses", name)) for name in ("a", "b")]
    assert _notes(runs) == ["a, b: it pauses", "a: a", "b: b"]
