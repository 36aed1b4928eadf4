"""The blind score: what its generator and its judging hold. Nothing is diagnosed here."""

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
from benchmarks.hidden_effects.outcome import excess, judged, names_instruments
from benchmarks.hidden_effects.report import main as report_main
from benchmarks.hidden_effects.report import wilson
from blind_cases import cases
from blind_cases.setups import Design, draw, draw_design
from blind_cases.sizes import Ruler
from rig.benches import BENCHES
from rig.muscle import MuscleParameters, simulate_muscle
from rig.schedule import SampledSchedule

COUNT = 400


def first(which: str = "tuning2", count: int = COUNT) -> list[cases.Case]:
    return [cases.case_of(which, n) for n in range(count)]


def test_draws_are_what_they_were() -> None:
    """Draws of the first 60 cases, by their digest: what is added elsewhere must not move a random number.

    Numbers count with nine digits: processors differ in the last bits of logarithms and powers.
    """
    drawn = [
        (c.group, c.targets, [f.name for f in c.hidden], c.design, draw(c.rng(1), c.design).free)
        for c in first("score2", 60)
    ]
    text = re.sub(r"-?\d+\.\d+(e[-+]?\d+)?", lambda number: f"{float(number[0]):.9g}", repr(drawn))
    assert hashlib.sha256(text.encode()).hexdigest()[:16] == "30d6c225add449aa"


@pytest.mark.full
def test_the_same_case_gives_the_same_bytes_which_do_not_say_what_is_hidden(
    tmp_path: Path,
) -> None:
    case = next(c for c in first() if c.group == "new_form" and c.design.bench == "TankFilling")
    made = [cases.make(case) for _ in range(2)]
    files = []
    for k, one in enumerate(made):
        cases.write(one, tmp_path / str(k))
        files.append({p.name: p.read_bytes() for p in (tmp_path / str(k)).iterdir()})
    assert files[0] == files[1] and made[0].description == made[1].description
    assert len(files[0]) == len(made[0].setup.plan) + 1
    hidden = made[0].description["hidden"][0]
    assert hidden["family"].encode() not in (text := files[0]["experiment.toml"])
    assert hidden["form"].encode() not in text


@pytest.mark.full
def test_what_a_free_parameter_does_is_projected_away() -> None:
    setup = draw(np.random.default_rng(5), Design("TankFilling", ("p",), 50.0, 2)).driven()
    ruler, p = Ruler(setup), setup.free[0]
    changed = setup.simulate((), {p.field: p.true + 0.01 * (p.high - p.low)})
    plain, projected = ruler.sizes(changed, {"p": 500.0})
    assert plain["p"] > 0.5 and projected["p"] < 0.1 * plain["p"]


def test_lines_between_samples_are_integrated_as_fine_steps_are() -> None:
    times = np.arange(101) / 100
    rising = SampledSchedule.joined([(0.145 + 0.002 * k, 0.0) for k in range(101)], 0.01)
    fine = SampledSchedule.joined([(0.145 + 0.0002 * k, 0.0) for k in range(1001)], 0.001)
    a, b = (simulate_muscle(MuscleParameters(), 2e5, s, times) for s in (rising, fine))
    assert a.p == pytest.approx(b.p, abs=2.0)


def _small(bench: str, which: str = "tuning2") -> cases.Case:
    """A case with nothing hidden, made short."""
    null = next(c for c in first(which, 800) if c.group == "null")
    design = draw_design(np.random.default_rng([3, len(bench)]), bench)
    return replace(null, design=replace(design, rate=min(design.rate, 200.0), runs=3))


@pytest.mark.full
@pytest.mark.parametrize("bench", BENCHES)
def test_a_data_set_is_read_and_the_truth_leaves_its_noise(bench: str, tmp_path: Path) -> None:
    made = cases.make(_small(bench))
    cases.write(made, tmp_path)
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
        ("catalogue", ["leak"], "identified", ["leak"], "right"),
        ("catalogue", ["leak"], "identified", ["leak", "creep"], "wrong"),
        ("catalogue", ["leak"], "ambiguous", ["creep", "leak"], "ambiguous"),
        ("catalogue", ["leak"], "ambiguous", ["creep", "end_shape"], "wrong"),
        ("catalogue", ["leak"], "none_missing", [], "missed"),
        ("pair", ["leak", "creep"], "identified", ["creep", "leak"], "right"),
        ("null", [], "none_missing", [], "right"),
        ("null", [], "identified", ["leak"], "wrong"),
        ("none_of_these", [], "ambiguous", ["leak", "creep"], "right"),
        ("none_of_these", [], "identified", ["leak"], "wrong"),
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


@pytest.mark.full
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


def test_a_crash_is_an_error_and_has_no_chi_square() -> None:
    crashed = {
        "set": "score",
        "number": 1,
        "case": {"group": "null", "families": [], "hidden": []},
        "error": {"where": "process"},
    }
    assert judged(crashed) == "error"
    assert excess(crashed) is None


def test_wilson_interval_of_the_textbook() -> None:
    low, high = wilson(81, 263)  # Newcombe (1998), table I
    assert (low, high) == pytest.approx((0.2553, 0.3662), abs=5e-5)
