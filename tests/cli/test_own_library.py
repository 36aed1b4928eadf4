"""A library of another field: hidden effects of an independent rig are named, and no Python is about it."""

from __future__ import annotations

import json
import os
import re
import runpy
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done
from tests.documentation.pages import commands, source

LIBRARY = ROOT / "examples" / "own-library" / "DCMotor"
RIG = runpy.run_path(str(ROOT / "examples" / "own-library" / "rig.py"))
PAGE = "adding-an-effect.md#A library of another field"


def diagnosed(command: Callable[..., Outcome], hidden: str, *words: str) -> dict:  # type: ignore[type-arg]
    RIG["write"](Path("motor"), hidden)
    done(command("diagnose motor --file", str(LIBRARY), "--json", "verdict.json", *words))
    diagnosis: dict = json.loads(Path("verdict.json").read_text())  # type: ignore[type-arg]
    return diagnosis


def holdout(summary: dict) -> float:  # type: ignore[type-arg]
    """Mean square error of the runs that were never fitted, in noise variances."""
    return float(summary["holdout"]["chi2_reduced"])


@pytest.mark.full
def test_the_page_as_it_stands(command: Callable[..., Outcome], place: Path) -> None:
    os.symlink(ROOT / "examples", place / "examples")
    (rig, *rest) = commands(PAGE)
    assert rig[:3] == ["python", "examples/own-library/rig.py", "motor"] and rig[3] == "--hidden"
    RIG["write"](place / "motor", rig[4])
    effects, simulate, diagnose, add, build = [done(command(*words[1:])).out for words in rest]
    assert "DCMotor" in effects and "FanDrag" in effects
    assert "w: from 0 rad/s to 238 rad/s" in simulate
    (said,) = re.findall(r"^Verdict.*\n", source(PAGE), re.MULTILINE)
    assert said in diagnose and "voltage" not in diagnose.partition("Ledger of the base model")[2]
    errors = re.findall(r"^  holdout .*$", source(PAGE), re.MULTILINE)
    assert len(errors) == 2 and all(line in diagnose for line in errors), diagnose
    assert "share of the error in the torque balance 100" in diagnose
    assert "extends DCMotor.Benches.FreeRun" in add
    estimates = {n: float(v) for n, v in re.findall(r"^  (\S+) = (\S+) \(", diagnose, re.MULTILINE)}
    assert estimates["coulombFriction.tau_C"] == pytest.approx(0.012, rel=0.01)
    assert "better.fmu" in build and (place / "better.fmu").is_file()
    report = (place / "motor.html").read_text(encoding="utf-8")
    assert "within the range of voltages, loads and speeds that was tested" in report
    assert not re.search(r"filling|venting|pressure|muscle", report), "words of another field"


@pytest.mark.parametrize(
    ("hidden", "balance"),
    [("winding_heat", "voltage"), pytest.param("brush_contact", "voltage", marks=pytest.mark.full),
     pytest.param("air_drag", "torque", marks=pytest.mark.full)],
)  # fmt: skip
def test_hidden_effect_is_named(
    command: Callable[..., Outcome], place: Path, hidden: str, balance: str
) -> None:
    diagnosis = diagnosed(command, hidden)
    assert (diagnosis["verdict"]["kind"], diagnosis["verdict"]["families"]) == (
        "identified",
        [hidden],
    )
    best = next(
        c for c in diagnosis["candidates"] if c["effects"] == diagnosis["verdict"]["effects"]
    )
    assert best["balance"] == balance
    assert holdout(best) < 0.1 * holdout(diagnosis["base"]) and holdout(best) < 1.3


@pytest.mark.full
def test_nothing_is_found_where_nothing_is_hidden(
    command: Callable[..., Outcome], place: Path
) -> None:
    assert diagnosed(command, "none")["verdict"]["kind"] == "none_missing"


def test_a_domain_that_is_none_says_what_it_must_be(
    command: Callable[..., Outcome], place: Path
) -> None:
    text = (LIBRARY / "Domain.mo").read_text(encoding="utf-8")
    for file in LIBRARY.rglob("*.mo"):
        copy = place / "DCMotor" / file.relative_to(LIBRARY)
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_bytes(file.read_bytes())
    (place / "DCMotor" / "Domain.mo").write_text(text.replace('{{"w", "i"}}', '{"w", "i"}'))
    RIG["write"](place / "motor", "none")
    refused = command("compare motor --file DCMotor")
    assert refused.status == 2
    assert refused.err.strip().endswith(
        "DCMotor/Domain.mo:2: DCMotor.Domain: planes must be rows of 2 texts"
    )
