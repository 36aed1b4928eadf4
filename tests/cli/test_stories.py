"""The commands of the stories run as they stand, and print the numbers that the page quotes."""

from __future__ import annotations

import importlib
import json
import os
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from rig import measurement
from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done
from tests.documentation.pages import commands, other_numbers, text_of, unsaid

VESSEL = "stories.md#A vessel that cools as it empties"
MUSCLE = "stories.md#A rubber bladder that the model leaves out"
TEMPERATURE = "stories.md#The temperature that a paper prints"
FRICTION = "stories.md#A friction that depends on load and frequency"


def rms(compared: str, signal: str) -> str:
    """What ``compare`` prints as the error of a signal over the runs that are fitted."""
    found = re.search(rf"^ *fit +{signal} +.*?rms[^0-9]*([0-9.]+ \S+)", compared, re.MULTILINE)
    assert found, compared
    return found.group(1)


@pytest.mark.full
def test_vessel(command: Callable[..., Outcome], place: Path) -> None:
    os.symlink(ROOT / "examples", place / "examples")
    said = [done(command(*words[1:])) for words in commands(VESSEL) if words[0] == "pam-cosim"]
    assert len(said) == 3 and "identified: gas_energy (EnergyGas)" in said[1].out
    assert "8.41 kPa -> 1.96 kPa" in said[1].out
    assert rms(said[2].out, "p") == "1.96 kPa"  # the error falls at the last command
    assert {"vessel.html", "Vessel.mo"} <= {p.name for p in place.iterdir()}


@pytest.mark.full
def test_muscle(
    command: Callable[..., Outcome], place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    python, *rest = commands(MUSCLE)
    assert python[:3] == ["python", "-m", "rig"]
    measurement.main(python[3:])
    kept = {"diagnose": ["--json", "muscle.json"]}
    said = [done(command(*words[1:], *kept.get(words[1], []))) for words in rest]
    before, diagnosis, after = [outcome.err + outcome.out for outcome in said]
    assert unsaid(MUSCLE, diagnosis) == []
    assert other_numbers(MUSCLE, errors_of(place / "muscle.json")) == []
    assert "FlexibleBladder" in (place / "Better.mo").read_text(encoding="utf-8")
    assert "1.8 mm -> 0.201 mm" in diagnosis
    assert rms(after, "x") == "0.201 mm" != rms(before, "x")


def errors_of(file: Path) -> dict[str, list[float]]:
    """Errors of p [kPa], x [mm] and T [K] in fitted runs and of x in the others, of the models of the story's table."""
    errors = {}
    for c in json.loads(file.read_text(encoding="utf-8"))["candidates"]:
        if (
            c["failure"] is None
            and f"(`{c['effect']}`)" in text_of(MUSCLE)
            and len(c["effects"]) == 1
        ):
            fit, others = c["fit"]["signals"], c["holdout"]["signals"]
            errors[c["effect"]] = [
                1e-3 * fit["p"]["rmse"],
                1e3 * fit["x"]["rmse"],
                fit["T"]["rmse"],
            ]
            errors[c["effect"]].append(1e3 * others["x"]["rmse"])
    assert len(errors) == 6
    return errors


def test_temperature(command: Callable[..., Outcome], place: Path) -> None:
    for words in commands(TEMPERATURE):
        if words[:2] in (["pam-cosim", "add"], ["pam-cosim", "simulate"]):
            done(command(*words[1:]))
    rows = (place / "filling.csv").read_text(encoding="utf-8").splitlines()
    last = dict(zip(rows[0].split(","), rows[-1].split(","), strict=True))
    assert float(next(v for k, v in last.items() if k.startswith("x"))) == pytest.approx(
        0.06788, rel=1e-3
    )


def test_class_of_the_library_goes_by_its_shorter_name(
    command: Callable[..., Outcome], place: Path
) -> None:
    done(command("add EnergyGas --to Examples.PrintedWallIsotonic -o Better.mo"))
    assert "extends PneumaticMuscle.Examples.PrintedWallIsotonic" in (
        place / "Better.mo"
    ).read_text(encoding="utf-8")
    done(command("simulate Examples.PrintedWallEnergyGas -o run.csv"))
    assert command("simulate Examples.NoSuchModel -o run2.csv").status == 2


@pytest.mark.full
def test_friction(
    command: Callable[..., Outcome], place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With twelve of the paper's 24 conditions, its extremes among them."""
    write, *rest = commands(FRICTION)
    monkeypatch.syspath_prepend(ROOT / Path(write[1]).parent)
    rig = importlib.import_module(Path(write[1]).stem)
    rig.write_data_set(Path(write[2]), loads=(5.0, 10.0, 20.0, 30.0), frequencies=(0.5, 1.0, 2.0))
    said = [done(command(*words[1:])).out for words in rest if words[0] == "pam-cosim"]
    assert "LoadFrequencyFriction damper" in (place / "Proposed.mo").read_text(encoding="utf-8")
    assert rms(said[0], "x") != rms(said[-1], "x") and f"-> {rms(said[-1], 'x')} (noise" in said[1]
    found = json.loads((place / "dy.json").read_text(encoding="utf-8"))
    assert found["verdict"]["kind"] == "identified"
    assert found["verdict"]["effects"] == ["LoadFrequencyFriction"]
    assert max(found["balance"], key=found["balance"].get) == "force"
    best = found["candidates"][0]
    assert found["base"]["holdout"]["signals"]["x"]["rmse"] > 5e-4
    assert best["holdout"]["signals"]["x"]["rmse"] < 1.05e-4
    assert best["holdout"]["chi2_reduced"] < 1.1
    own = {name: e["value"] for name, e in best["parameters"].items()}
    assert [own[f"muscle.braid.c_{i}"] for i in (3, 4, 5)] == pytest.approx(
        rig.Muscle().slenderness, rel=0.03
    )
    assert own["damper.ab"] == pytest.approx(0.12, rel=0.02)
    assert own["muscle.friction.c_c"] == pytest.approx(6.0, rel=0.02)
    assert own["muscle.friction.c_v"] < 0.01 * 0.12 * 15 * 9.81  # of the coefficient, 15 kg, 1 Hz
