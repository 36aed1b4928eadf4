"""The commands of the stories run as they stand, and print the numbers that the page quotes."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
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
def test_friction(command: Callable[..., Outcome], place: Path) -> None:
    write, *rest = commands(FRICTION)
    assert write[0] == "python" and write[1].endswith("vertical_rig.py")
    subprocess.run([sys.executable, ROOT / write[1], *write[2:]], check=True, capture_output=True)
    said = [done(command(*words[1:])).out for words in rest if words[0] == "pam-cosim"]
    assert "LoadFrequencyFriction damper" in (place / "Proposed.mo").read_text(encoding="utf-8")
    assert rms(said[0], "x") != rms(said[-1], "x") and f"-> {rms(said[-1], 'x')} (noise" in said[1]
