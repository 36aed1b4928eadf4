"""A muscle covered with more fibre than it has surface: the model's warning reaches every reader."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from pam_cosim.cli.app import main
from rig.short import write_light_data

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
