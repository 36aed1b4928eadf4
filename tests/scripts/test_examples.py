"""Examples make the folder that they write into."""

from __future__ import annotations

import runpy
from pathlib import Path

import pytest

import pam_cosim as pam
from tests.documentation.pages import ROOT


class Swept:
    """A sweep that writes nothing but its table."""

    def save(self, file: Path) -> None:
        file.write_text("")


def test_the_valve_writes_into_a_folder_that_is_not_there_yet(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "not" / "there"

    def sweep(*words: object, output: Path, **options: object) -> Swept:
        output.write_text("")
        return Swept()

    monkeypatch.setattr(pam, "sweep", sweep)
    monkeypatch.setattr(pam, "draw", lambda swept, file: file.write_text(""))
    runpy.run_path(str(ROOT / "examples" / "sweeps" / "valve.py"))["calibration"](folder)
    assert sorted(file.name for file in folder.iterdir()) == ["valve.csv", "valve.nc", "valve.png"]
