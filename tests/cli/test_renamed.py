"""A name that was public once answers with its new one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim import renamed
from tests.cli.conftest import ROOT, Outcome

RENAMING = renamed.Renaming("benches", "0.2.0", "0.4.0")


def test_python(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(renamed.PYTHON, "rigs", RENAMING)
    with pytest.warns(
        DeprecationWarning, match="pam_cosim.rigs is called benches since 0.2.0; .* gone in 0.4.0"
    ):
        assert pam.rigs is pam.benches
    with pytest.raises(AttributeError, match="no attribute 'rig_list'"):
        _ = pam.rig_list


def test_commands(
    command: Callable[..., Outcome], place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(
        renamed.COMMANDS, "catalogue", renamed.Renaming("effects", "0.2.0", "0.4.0")
    )
    old, new = command("catalogue"), command("effects")
    assert old.status == 0 and old.out == new.out
    assert "catalogue is called effects since 0.2.0" in old.err
    assert command("catalog").status == 2


def test_a_variable_that_output_named(command: Callable[..., Outcome], place: Path) -> None:
    words = ("simulate", "TankFilling", "--stop-time", "0.1")
    old = command(*words, "-o", "old.csv", "--output", "valve.inlet.m_flow")
    new = command(*words, "--output", "new.csv", "--keep", "valve.inlet.m_flow")
    assert (old.status, new.status) == (0, 0)
    assert "simulate --output VARIABLE is called --keep VARIABLE since 0.2.0" in old.err
    assert "since" not in new.err
    assert "valve.inlet.m_flow" in (place / "old.csv").read_text().splitlines()[0]
    assert (place / "old.csv").read_bytes() == (place / "new.csv").read_bytes()


def test_a_file_of_any_name_is_a_file(command: Callable[..., Outcome], place: Path) -> None:
    assert command("simulate", "TankFilling", "--stop-time", "0.1", "-o", "result").status == 0
    assert (place / "result").read_text().startswith("time [s],")


def test_new_names_are_there() -> None:
    assert {one.new for one in renamed.PYTHON.values()} <= set(pam.__all__)
    page = (ROOT / "docs" / "versions.md").read_text(encoding="utf-8")
    assert all(f"`{old}`" in page for old in (*renamed.PYTHON, *renamed.COMMANDS, *renamed.OPTIONS))
