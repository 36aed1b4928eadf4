"""./scripts/other_systems fails where another system computes something else, fails, or could not load the binary."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from scripts.systems import run
from tests.documentation.pages import ROOT

OTHERS = tuple(replace(system, runner=None) for system in run.OTHERS)  # as if each were here


class Machines:
    """What each system puts out, without one.

    Attributes:
        far: by platform, how far the outputs are from those of Linux, in their range; None: the run fails.
        faults: of the binary for macOS.
    """

    def __init__(self) -> None:
        self.far: dict[str, float | None] = {}
        self.faults: list[str] = []

    def simulate(self, fmu: Path, system: run.System, folder: Path) -> np.ndarray:
        course = np.linspace(0.0, 1.0, run.STEPS + 1)[:, None]
        far = self.far.get(system.platform, 0.0)
        if far is None:
            raise RuntimeError(f"{fmu.stem} on {system.name}: the program crashed")
        return course + far


@pytest.fixture
def machines(monkeypatch: pytest.MonkeyPatch) -> Machines:
    made = Machines()
    monkeypatch.setattr(run, "OTHERS", OTHERS)
    monkeypatch.setattr(run, "built", lambda bench, folder: folder / f"{bench}.fmu")
    monkeypatch.setattr(run, "simulate", made.simulate)
    monkeypatch.setattr(run, "mac_faults", lambda fmu: made.faults)
    return made


def test_the_same_everywhere_is_in_order(
    machines: Machines, capsys: pytest.CaptureFixture[str]
) -> None:
    machines.far = {"x86_64-windows": 1e-7, "aarch64-linux": 1e-13}
    assert run.main(["Isotonic", "TankFilling"]) == 0
    said = capsys.readouterr()
    assert "| Isotonic | 1 | 1.0e-07 | 1.0e-13 | in order |" in said.out and not said.err
    assert said.out.count("| TankFilling |") == 1


@pytest.mark.parametrize(
    ("platform", "far"),
    [
        ("x86_64-windows", 2e-6),
        ("aarch64-linux", 2e-12),
        ("aarch64-linux", float("nan")),
        ("x86_64-windows", None),
    ],
)
def test_what_is_farther_off_or_fails_is_a_fault(
    machines: Machines, capsys: pytest.CaptureFixture[str], platform: str, far: float | None
) -> None:
    machines.far = {platform: far}
    assert run.main(["Isotonic"]) == 1
    (system,) = (system for system in OTHERS if system.platform == platform)
    assert f"Isotonic on {system.name}" in capsys.readouterr().err


def test_a_binary_that_could_not_be_loaded_is_a_fault(
    machines: Machines, capsys: pytest.CaptureFixture[str]
) -> None:
    machines.faults = ["no slice for arm64"]
    assert run.main(["Isotonic"]) == 1
    assert "Isotonic on macOS: no slice for arm64" in capsys.readouterr().err


@pytest.mark.parametrize("word", ["--page", "-x"])
def test_words_that_it_does_not_know_are_refused(machines: Machines, word: str) -> None:
    with pytest.raises(SystemExit) as ended:
        run.main([word, "Isotonic"])
    assert ended.value.code == 2


def test_what_is_allowed_is_what_the_page_says() -> None:
    page = (ROOT / "docs" / "own-fmu.md").read_text(encoding="utf-8")
    stated = re.search(
        r"1e-(\d+),\s+and that is what the tests hold Windows to; ARM they hold to 1e-(\d+)", page
    )
    assert stated
    assert run.WINDOWS.tolerance == pytest.approx(10.0 ** -int(stated[1]))
    assert run.ARM.tolerance == pytest.approx(10.0 ** -int(stated[2]))
