"""A muscle covered with more fibre than it has surface: the model's warning reaches every reader."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.cli.app import main
from rig.short import write_light_data
from tests.library.rigs import held, rig, run

COVERS = "by DP (48) they cover 177.448 cm2 of 150.796 cm2"
VALUES = "muscle.L0 = 0.24 m, muscle.D0 = 0.02 m, muscle.turns = 2, muscle.fibres = 300"
BENCH = "PneumaticMuscle.Benches.Isotonic"


@pytest.fixture(scope="module")
def covered(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A rig whose number of fibres is stated wrong."""
    folder = write_light_data(tmp_path_factory.mktemp("covered") / "data", seed=1)
    file = folder / "experiment.toml"
    file.write_text(file.read_text() + '[parameters]\n"muscle.fibres" = 300\n')
    return folder


def said(capsys: pytest.CaptureFixture[str], *words: object) -> list[str]:
    """What a command prints, line by line."""
    capsys.readouterr()
    assert main([str(word) for word in words]) == 0
    return capsys.readouterr().out.splitlines()


def is_warned(line: str) -> bool:
    return "LOOK FIRST: every run: " in line and COVERS in line and VALUES in line


def test_a_comparison_and_a_fit_begin_with_the_warning(
    covered: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    written = tmp_path / "compared.json"
    page = tmp_path / "compared.html"
    compared = said(capsys, "compare", covered, "--json", written, "--report", page)
    assert is_warned(compared[1]) and sum(map(is_warned, compared)) == 1
    first = json.loads(written.read_text())["doubts"][0]
    assert (first["kind"], first["signal"]) == ("warning", "") and COVERS in first["text"]
    assert page.read_text().count(COVERS) == 1
    assert is_warned(said(capsys, "fit", covered)[1])


def test_a_sweep_and_a_simulation_warn(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    swept = said(
        capsys, "sweep", BENCH, "--vary", "muscle.fibres=100,300,400", "--scalar", "max(p)",
        "--set", "u_in=0.35", "--stop-time", 1, "-o", tmp_path / "swept.csv",
    )  # fmt: skip
    assert swept[1].startswith("  LOOK FIRST: run 1, run 2: ") and COVERS in swept[1]
    simulated = said(capsys, "simulate", BENCH, "--set", "muscle.fibres=300", "--stop-time", 1)
    assert simulated[0].startswith("LOOK FIRST: ") and COVERS in simulated[0]


@pytest.mark.parametrize("length, diameter", [(0.24, 0.02), (0.25, 0.012), (0.1, 0.04)])
@pytest.mark.parametrize("angle", [10.0, 25.0, 45.0])
def test_fibres_that_are_not_stated_fill_the_share_of_the_reference_muscle(
    length: float, diameter: float, angle: float
) -> None:
    """N w/(2 pi D0 cos(alpha_0)) is that of 216 fibres of 0.254 mm on 20 mm, and they fit."""
    sleeve = {"L0": length, "D0": diameter, "turns": 0.0, "alpha_0": np.radians(angle)}
    own = {f"muscle.sleeve.{name}": value for name, value in sleeve.items()}
    bench = rig("imposed-pressure", "imposed-length", "any-geometry", "F")
    made = run(bench, np.linspace(0, 1, 3), own, held(1.0, p=2e5, s=0.0), ["muscle.N"])
    reference = 216 / (0.02 * np.cos(np.arctan(2 * np.pi * 0.02 / 0.24)))
    expected = reference * diameter * np.cos(np.radians(angle))
    assert made.values["muscle.N"][0] == pytest.approx(expected, rel=1e-12)
    assert made.warnings == ()
