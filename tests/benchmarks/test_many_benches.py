"""The blind score on many benches: what its generator promises. Nothing is diagnosed here."""

from __future__ import annotations

import hashlib
import json
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from benchmarks.hidden_effects.calibration import binned, brier, stated
from benchmarks.hidden_effects.one import memory
from benchmarks.hidden_effects.outcome import (
    INSTRUMENTS,
    judged,
    names_instruments,
    stated_probability,
)
from benchmarks.hidden_effects.report import main as report_main
from blind_cases import cases, many, sets
from blind_cases.faults import FAULTS, ON_SOME_BENCH
from blind_cases.noise import Sensors
from blind_cases.setups import SHARES, Design, draw, draw_design
from rig.benches import BENCHES, hooks
from rig.catalogue.elasticity import LinearSpring
from rig.catalogue.rate_friction import LoadFrequency, Viscous
from rig.catalogue.thermocouple_lag import ThermocoupleLag
from rig.instruments import Quantisation
from rig.schedule import SampledSchedule
from rig.seen.leak import PulledCrimp
from tests.library.shelf import composed, effects

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


@pytest.mark.parametrize("which", many.SEEDS)
def test_composition_and_a_fair_prefix(which: str) -> None:
    chosen = first(which)
    assert Counter(c.group for c in chosen) == {
        g: n * COUNT // many.PERIOD for g, n in many.GROUPS.items()
    }
    for group, count in many.GROUPS.items():
        assert abs(sum(c.group == group for c in chosen[:40]) - 40 * count / many.PERIOD) < 1.5
    for bench, share in SHARES.items():
        assert sum(c.design.bench == bench for c in chosen) == pytest.approx(
            COUNT * share / 24, abs=4
        )
    singles = Counter(
        f.family for c in chosen for f in c.hidden if c.group in ("catalogue", "new_form")
    )
    assert len(singles) == 16 and min(singles.values()) >= 8
    faults = Counter(f.family for c in chosen for f in c.hidden if c.group == "instrument")
    assert set(faults) == set(INSTRUMENTS) and min(faults.values()) >= 3
    assert sum(f in ON_SOME_BENCH for c in chosen for f in c.hidden) >= 8  # DY (10)-(11)
    assert {1, 20} <= {c.design.runs for c in chosen} and {20.0, 1000.0} <= {
        c.design.rate for c in chosen
    }


def test_combinations_are_of_different_families_and_fit_the_bench() -> None:
    for case in first():
        wanted = {"pair": 2, "triple": 3, "null": 0}.get(case.group, 1)
        assert len({form.family for form in case.hidden}) == len(case.hidden) == wanted
        for form in case.hidden:
            if form in FAULTS:
                assert form.where(case.design)
            else:
                assert case.design.rig.takes(many._sample(form), case.design.signals)


def test_what_can_be_hidden_follows_from_the_hooks_of_an_effect() -> None:
    assert hooks(LinearSpring()) == {"force"}
    assert BENCHES["Isometric"].takes(LinearSpring(), ["p", "F"])
    assert not BENCHES["Isometric"].takes(
        LinearSpring(), ["p"]
    )  # nothing that is measured shows it
    assert not BENCHES["TankFilling"].takes(LinearSpring(), ["p", "T"])
    assert BENCHES["VesselOrifice"].takes(ThermocoupleLag(), ["p", "T"])
    assert not BENCHES["VesselOrifice"].takes(ThermocoupleLag(), ["p"])
    assert BENCHES["VerticalLoad"].takes(LoadFrequency(), ["x"])
    assert not BENCHES["Isotonic"].takes(LoadFrequency(), ["p", "x", "T"])
    assert not BENCHES["VerticalLoad"].takes(
        Viscous(), ["x"]
    )  # its model has that, with a free coefficient
    assert not BENCHES["TankFilling"].takes(PulledCrimp(), ["p"])  # it reads a contraction
    assert BENCHES["SwitchedMuscle"].takes(Quantisation("p"), ["p"])
    assert not BENCHES["SwitchedMuscle"].takes(Quantisation("T"), ["p"])


def test_the_library_has_a_member_for_what_is_hidden_on_a_bench() -> None:
    asked = {(c.design.rig.model, f.family) for c in first() for f in c.hidden if f not in FAULTS}
    for model, family in sorted(asked):
        if family != "none_of_these":
            members = [e.name for e in effects() if e.family == family]
            assert any(composed(model, name) for name in members), (model, family)


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


def test_the_data_do_not_say_what_is_hidden(tmp_path: Path) -> None:
    case = next(c for c in first() if c.group == "instrument" and c.design.bench == "VesselOrifice")
    many.write(many.make(case), tmp_path)
    text = "".join(file.read_text() for file in tmp_path.iterdir())
    assert case.hidden[0].family not in text and case.group not in text


def test_quantised_readings_are_whole_steps_and_a_late_clock_shifts_all() -> None:
    design = Design("VesselOrifice", ("p", "T"), 20.0, 2)
    setup = draw(np.random.default_rng(8), design)
    written = setup.recorded(
        [Quantisation("p", 4e3)], lambda read: {n: y + 0.1 for n, y in read.items()}
    )
    steps = written[0]["p"] / 4e3
    assert (
        steps == pytest.approx(np.round(steps), abs=1e-9)
        and len(set(np.round(steps).tolist())) > 10
    )
    assert np.ptp(written[0]["T"]) > 1.0 and len(set(written[0]["T"].tolist())) > 50


@pytest.mark.parametrize("bench", ["Isotonic", "SwitchedMuscle"])
def test_a_controller_follows_its_reference_and_its_currents_are_what_is_told(bench: str) -> None:
    for seed in range(40):
        rng = np.random.default_rng([17, seed])
        design = replace(draw_design(rng, bench), rate=200.0, runs=6)
        setup = draw(rng, design)
        if setup.loops:
            break
    setup = replace(setup, design=replace(setup.design, signals=setup.design.rig.outputs)).driven()
    number, loop = next(iter(setup.loops.items()))
    trial = setup.plan[number]
    assert isinstance(trial.schedules[0], SampledSchedule) is (bench == "Isotonic")
    shown = setup.simulate()[number][loop.signal]
    wanted = np.interp(trial.times, np.arange(len(loop.wanted)) * loop.step, loop.wanted)
    if bench == "Isotonic":
        late = trial.times > trial.times[-1] / 4
        assert np.corrcoef(shown[late], wanted[late])[0, 1] > 0.7
    else:  # on-off valves: one step after the error was beyond the hysteresis
        steps = round(loop.step * trial.rate)
        low = (wanted - shown)[:-steps] > 1.5 * (loop.switching or 0.0)
        filled = np.array([trial.schedules[0].at(float(t))[0] for t in trial.times[steps:]])
        assert low.any() and np.mean(filled[low]) > 0.95
    stiffer = setup.driven([LinearSpring(2000.0)] if bench == "Isotonic" else [])
    told = [s.plan[number].schedules[0].at(float(t)) for s in (setup, stiffer) for t in trial.times]
    half = len(told) // 2
    assert (told[:half] != told[half:]) is (
        bench == "Isotonic"
    )  # a controller meets what is hidden


def test_an_effect_that_the_free_parameters_imitate_is_described_as_such() -> None:
    """An opening that says half as much, of valves that are open or shut: a discharge coefficient, far off."""
    description = many.make(many.case_of("tuning4", 62)).description
    assert description["hidden"][0]["form"] == "current_offset"
    assert description["hidden"][0]["refitted"] < 0.05
    assert description["same_as"] == [[]]
    assert "refitted" not in many.make(many.case_of("tuning4", 91)).description["hidden"][0]


@pytest.mark.parametrize(
    ("which", "number", "same"),
    [
        ("tuning4", 91, [["clock_offset"]]),  # VerticalLoad, x: a ruler with a dead time
        ("tuning4", 187, [["clock_offset"], ["valve_dynamics"]]),  # TankFilling, p
        ("tuning2", 267, [["position_sensor"]]),  # a late recorder of x alone
    ],
)
def test_whatever_delays_all_that_is_measured_gives_the_same_data(
    which: str, number: int, same: list[list[str]]
) -> None:
    assert many.outline(many.case_of(which, number))["same_as"] == same


def test_outliers_are_no_part_of_what_the_truth_leaves() -> None:
    sensors = Sensors({"p": 2.0}, "white", outliers=0.01)
    error = np.array([1.0, -3.0, 20.0, 13.9])
    assert sensors.without_outliers("p", error).tolist() == [1.0, -3.0, 13.9]
    assert len(replace(sensors, outliers=0.0).without_outliers("p", error)) == 4


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


def test_two_names_of_three_are_right_where_all_say_the_same() -> None:
    same = {"case": {"same_as": [["clock_offset"], ["pressure_sensor_lag"]]}}
    said = result(
        "catalogue",
        ["valve_dynamics"],
        "ambiguous",
        ["clock_offset", "pressure_sensor_lag"],
        **same,
    )
    assert judged(said) == "right"


def test_what_the_base_model_says_itself_is_not_missing() -> None:
    def said(kind: str, named: list[str]) -> str:
        return judged(result("new_form", ["valve_area"], kind, named, case={"same_as": [[]]}))

    assert said("none_missing", []) == said("identified", ["valve_area"]) == "right"
    assert said("ambiguous", ["leak", "valve_area"]) == "ambiguous"


def test_an_effect_in_no_family_is_none_of_those_that_are_named() -> None:
    said = result("none_of_these", [], "ambiguous", ["creep", "elasticity"], probability=0.9)
    assert judged(said) == "right"
    assert stated_probability(said) == (0.9, False)


def test_instruments_count_whichever_is_named() -> None:
    assert names_instruments(result("instrument", ["quantisation"], "identified", ["saturation"]))
    assert not names_instruments(result("instrument", ["quantisation"], "identified", ["leak"]))
    assert not names_instruments(result("instrument", ["quantisation"], "unknown", []))


def test_brier_score_and_classes_of_stated_probabilities() -> None:
    right = [
        result("catalogue", ["leak"], "identified", ["leak"], probability=0.9) for _ in range(9)
    ]
    wrong = [result("catalogue", ["leak"], "identified", ["creep"], probability=0.9)]
    silent = [
        result("catalogue", ["leak"], "identified", ["leak"]),
        result("null", [], "unknown", [], probability=0.1),
    ]
    pairs = stated([*right, *wrong, *silent])
    assert len(pairs) == 10 and brier(pairs) == pytest.approx(0.9 * 0.01 + 0.1 * 0.81)
    ((low, high, some),) = binned(pairs)
    assert (low, high, some[:, 1].mean()) == (0.9, 0.95, pytest.approx(0.9))
    assert stated_probability(silent[1]) is None
    either = result("catalogue", ["leak"], "ambiguous", ["creep", "leak"], probability=0.8)
    assert stated_probability(either) == (0.8, True)


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


def test_sets_are_reached_by_one_door() -> None:
    assert set(sets.SETS) == {
        "tuning",
        "score",
        "tuning2",
        "score2",
        "score3",
        "tuning3",
        "tuning4",
    }
    assert isinstance(sets.case_of("score2", 3), many.Case) and isinstance(
        sets.case_of("score", 3), cases.Case
    )
    assert sets.outline(sets.case_of("tuning", 3)) == cases.outline(cases.case_of("tuning", 3))
    with pytest.raises(ValueError, match="there is no case -1"):
        sets.case_of("tuning2", -1)
    assert 10 < memory() < 1e5
