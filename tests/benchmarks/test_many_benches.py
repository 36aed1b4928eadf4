"""The blind score on many benches: what its generator promises. Nothing is diagnosed here."""

from __future__ import annotations

import hashlib
import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from benchmarks.hidden_effects.outcome import (
    judged,
    names_instruments,
)
from benchmarks.hidden_effects.report import main as report_main
from blind_cases import cases, many
from blind_cases.setups import draw_design
from rig.benches import BENCHES

pytestmark = pytest.mark.full  # of the measuring, not of the product

COUNT = 400


def first(which: str = "tuning2", count: int = COUNT) -> list[many.Case]:
    return [many.case_of(which, n) for n in range(count)]


def test_cases_of_one_bench_are_what_they_were() -> None:
    """Draws of the first 60 tuning cases, by their digest: what is added elsewhere must not move a random number.

    Numbers count with nine digits: processors differ in the last bits of logarithms and powers.
    """
    drawn = []
    for n in range(60):
        case = cases.case_of("tuning", n)
        bench = cases._draw_bench(case.rng(1))
        sensors = cases.draw_sensors(case.rng(2))
        drawn.append(
            (
                case.group,
                case.targets,
                [f.name for f in case.hidden],
                bench.free,
                bench.plan,
                sensors.sigma,
            )
        )
    text = re.sub(r"-?\d+\.\d+(e[-+]?\d+)?", lambda number: f"{float(number[0]):.9g}", repr(drawn))
    assert hashlib.sha256(text.encode()).hexdigest()[:16] == "56267c88b1d37fc0"


def _small(bench: str, which: str = "tuning2") -> many.Case:
    """A case with nothing hidden, made short."""
    null = next(c for c in first(which, 800) if c.group == "null")
    design = draw_design(np.random.default_rng([3, len(bench)]), bench)
    return replace(null, design=replace(design, rate=min(design.rate, 200.0), runs=3))


@pytest.mark.parametrize("bench", BENCHES)
def test_a_data_set_is_read_and_the_truth_leaves_its_noise(bench: str, tmp_path: Path) -> None:
    made = many.make(_small(bench))
    many.write(made, tmp_path)
    data = pam.read(tmp_path)
    truth = pam.compare(data, parameters={p.name: p.true for p in made.setup.free})
    assert set(data.signals) == set(made.setup.signals)
    for role, noise in made.description["noise"].items():
        sigma = {n: float(truth.data.signals[n].sigma or np.nan) for n in noise}
        total = sum(one["mean_square"] * one["samples"] / sigma[n] ** 2 for n, one in noise.items())
        floor = total / sum(one["samples"] for one in noise.values())
        assert truth.chi2_reduced(role) == pytest.approx(floor, rel=0.02), role
    assert json.loads(json.dumps(made.description)) == made.description


# --- judging ------------------------------------------------------------------------------------------------


def result(
    group: str, families: list[str], kind: str, named: list[str], **more: Any
) -> dict[str, Any]:
    hidden = [{"family": f, "form": "x", "size": 5.0, "in_catalogue": True} for f in families]
    case = {"group": group, "families": families, "hidden": hidden, "size": {"projected": {"p": 5.0}},
            "bench": "TankFilling", "signals": ["p"], "rate": 20.0, "runs": 1}  # fmt: skip
    return {
        "set": "tuning2", "number": 0, "seconds": 1.0, "megabytes": 300.0, "case": case | more.pop("case", {}),
        "diagnosis": {
            "verdict": {"kind": kind, "families": named, "effects": named},
            "chi2": {"fit": {"base": 9.0, "final": 1.05, "noise": 1.0}}, **more,
        },
    }  # fmt: skip


@pytest.mark.parametrize(
    ("group", "true", "kind", "named", "outcome"),
    [
        (
            "triple",
            ["leak", "creep", "end_shape"],
            "identified",
            ["creep", "end_shape", "leak"],
            "right",
        ),
        ("triple", ["leak", "creep", "end_shape"], "identified", ["creep", "leak"], "wrong"),
        ("instrument", ["quantisation"], "identified", ["quantisation"], "right"),
        ("instrument", ["quantisation"], "none_missing", [], "right"),
        ("instrument", ["saturation"], "none_missing", [], "missed"),
        ("instrument", ["quantisation"], "identified", ["saturation"], "wrong"),
        ("none_of_these", [], "identified", ["position_sensor"], "right"),
        ("none_of_these", [], "identified", ["position_sensor", "leak"], "wrong"),
    ],
)
def test_judging(group: str, true: list[str], kind: str, named: list[str], outcome: str) -> None:
    assert judged(result(group, true, kind, named)) == outcome


def test_same_data_under_another_name_are_right_and_so_is_saying_so() -> None:
    def said(kind: str, named: list[str]) -> str:
        same = {"case": {"same_as": [["clock_offset"]]}}
        return judged(result("catalogue", ["valve_dynamics"], kind, named, **same))

    assert said("identified", ["clock_offset"]) == said("identified", ["valve_dynamics"]) == "right"
    assert said("ambiguous", ["clock_offset", "valve_dynamics"]) == "right"
    assert said("ambiguous", ["leak", "valve_dynamics"]) == "ambiguous"
    assert said("identified", ["leak"]) == "wrong"
    assert said("ambiguous", ["clock_offset", "leak"]) == "ambiguous"
    assert said("none_missing", []) == "missed"


def test_what_the_base_model_says_itself_is_not_missing() -> None:
    def said(kind: str, named: list[str]) -> str:
        return judged(result("new_form", ["valve_area"], kind, named, case={"same_as": [[]]}))

    assert said("none_missing", []) == said("identified", ["valve_area"]) == "right"
    assert said("ambiguous", ["leak", "valve_area"]) == "ambiguous"


def test_instruments_count_whichever_is_named() -> None:
    assert names_instruments(result("instrument", ["quantisation"], "identified", ["saturation"]))
    assert not names_instruments(result("instrument", ["quantisation"], "identified", ["leak"]))
    assert not names_instruments(result("instrument", ["quantisation"], "unknown", []))


@pytest.mark.parametrize("probability", [{}, {"probability": 0.97}])
def test_report_of_many_benches(tmp_path: Path, probability: dict[str, float]) -> None:
    lines = [
        result(
            "triple",
            ["leak", "creep", "end_shape"],
            "identified",
            ["creep", "leak", "end_shape"],
            **probability,
        ),
        result("instrument", ["quantisation"], "identified", ["newest_family"], **probability)
        | {"number": 1},
        result("null", [], "none_missing", [], case={"start": "unstated"}) | {"number": 3},
        result("null", [], "none_missing", []) | {"number": 2, "seconds": 80.0},
    ]
    file = tmp_path / "results.jsonl"
    file.write_text("\n".join(json.dumps(line) for line in lines) + "\n")
    assert report_main([str(file), "--out", str(tmp_path / "out")]) == 0
    text = (tmp_path / "out" / "report.md").read_text()
    assert (
        "3 standard deviations each: all found | 75 % | 100 % (21 to 100; 1 of 1) | yes |" in text
    )
    assert "| time of a diagnosis, longest | 60 s | 80 s | no |" in text
    assert "| memory, most | 1000 MB | 300 MB | yes |" in text
    assert "## By start" in text and "| in the middle, not stated |" in text
    assert "newest_family" in text and "| TankFilling |" in text and "| 20 Hz |" in text
    assert ("No verdict states a probability." in text) is not bool(probability)
    figures = {p.name for p in (tmp_path / "out").iterdir()}
    assert {"breakdown.png", "confusion.png", "hit-rate.png", "outcomes.png"} <= figures
    assert ("calibration.png" in figures) is bool(probability)
