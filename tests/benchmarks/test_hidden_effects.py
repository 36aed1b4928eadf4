"""The blind score: what its generator promises. Nothing is diagnosed here."""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.hidden_effects.outcome import excess, judged
from benchmarks.hidden_effects.report import wilson
from blind_cases import table
from blind_cases.cases import PERIOD, SEEDS, case_of, make, write
from blind_cases.noise import SIGNALS
from blind_cases.plans import draw_muscle, draw_plan
from blind_cases.sizes import Bench, Ruler
from rig.muscle import MuscleParameters, simulate_muscle
from rig.schedule import SampledSchedule

pytestmark = pytest.mark.full  # of the measuring, not of the product

CASES = 300


def _number(group: str, which: str = "tuning") -> int:
    return next(n for n in range(PERIOD) if case_of(which, n).group == group)


def _digest(folder: Path) -> dict[str, str]:
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in sorted(folder.iterdir())}


def test_same_case_gives_the_same_bytes(tmp_path):
    made = [make(case_of("tuning", _number("new_form"))) for _ in range(2)]
    for k, one in enumerate(made):
        write(one, tmp_path / str(k))
    assert _digest(tmp_path / "0") == _digest(tmp_path / "1")
    assert made[0].description == made[1].description
    assert json.loads(json.dumps(made[0].description)) == made[0].description


def test_sets_are_disjoint():
    forms = {
        which: {(f.family, f.name) for n in range(2 * CASES) for f in case_of(which, n).hidden}
        for which in SEEDS
    }
    assert forms["tuning"] & forms["score"] == {
        ("dead_volume", "constant")
    }  # the catalogue has no second law
    first = {which: case_of(which, 0).rng(1).random(4).tolist() for which in SEEDS}
    assert first["tuning"] != first["score"]


def test_nothing_hidden_leaves_the_noise_alone():
    made = make(case_of("tuning", _number("null")))
    assert made.description["families"] == []
    assert made.description["size"] == {
        k: dict.fromkeys(SIGNALS, 0.0) for k in ("plain", "projected")
    }
    sensors = replace(made.sensors, outliers=0.0)
    if made.sensors == sensors and sensors.colour != "drift":
        for name in SIGNALS:
            noise = made.description["noise"]["fit"][name]["mean_square"] ** 0.5
            assert noise == pytest.approx(sensors.sigma[name], rel=0.15)


def test_the_data_do_not_say_what_is_hidden(tmp_path):
    made = make(case_of("tuning", 0))
    write(made, tmp_path)
    text = (tmp_path / "experiment.toml").read_text()
    assert made.description["hidden"][0]["family"] not in text
    assert sorted(p.name for p in tmp_path.iterdir())[0] == "experiment.toml"
    assert len(list(tmp_path.iterdir())) == len(made.bench.plan) + 1


@pytest.fixture(scope="module")
def ruler():
    rng = np.random.default_rng(5)
    muscle = draw_muscle(rng)
    plan = draw_plan(rng, muscle, one_load=False)[:2]
    made = make(case_of("tuning", _number("null")))
    free = tuple(p for p in made.bench.free if p.nominal is None)
    return Ruler(Bench(replace(muscle, **{p.field: p.true for p in free}), plan, free))


def test_what_a_free_parameter_does_is_projected_away(ruler):
    p = ruler.bench.free[0]
    changed = ruler.bench.simulate((), {p.field: p.true + 0.01 * (p.high - p.low)})
    plain, projected = ruler.sizes(changed, {"p": 500.0, "x": 2e-4, "T": 0.3})
    assert max(plain.values()) > 0.5
    assert max(projected.values()) < 0.1 * max(plain.values())


FORMS = [*table.FORMS, *table.STRANGE]


@pytest.mark.parametrize("form", FORMS, ids=lambda f: f"{f.family}-{f.name}")
def test_every_form_changes_what_is_measured_and_vanishes_with_its_strength(form):
    muscle = MuscleParameters(load=3.0)
    plan = draw_plan(np.random.default_rng(11), muscle, one_load=True)[:1]
    short = replace(plan[0], samples=501)
    bench = Bench(muscle, (short,), ())
    base = bench.simulate()[0]
    at = form.make(np.random.default_rng(3), muscle)

    def change(strength: float) -> float:
        changed = bench.simulate([at(strength)])[0]
        return max(
            float(np.abs(changed[n] - base[n]).max()) / s
            for n, s in (("p", 500.0), ("x", 2e-4), ("T", 0.3))
        )

    ordinary = change(min(1.0, form.high))
    assert ordinary > 0.05
    if form.low < 1.0:
        assert change(max(form.low, 0.02)) < 0.7 * ordinary


def test_lines_between_samples_are_integrated_as_fine_steps_are():
    muscle = MuscleParameters()
    times = np.arange(101) / 100
    rising = SampledSchedule.joined([(0.145 + 0.002 * k, 0.0) for k in range(101)], 0.01)
    fine = SampledSchedule.joined([(0.145 + 0.0002 * k, 0.0) for k in range(1001)], 0.001)
    a, b = (simulate_muscle(muscle, 2e5, s, times) for s in (rising, fine))
    assert a.p == pytest.approx(b.p, abs=2.0)


# --- judging ------------------------------------------------------------------------------------------------


def _result(group: str, families: list[str], kind: str, named: list[str]) -> dict:
    hidden = [{"family": f, "form": "x", "size": 5.0} for f in families]
    size = {"projected": {"p": 5.0 if families else 0.0, "x": 0.0, "T": 0.0}}
    return {
        "set": "score", "number": 0, "seconds": 1.0,
        "case": {"group": group, "families": families, "hidden": hidden, "size": size},
        "diagnosis": {
            "verdict": {"kind": kind, "families": named, "effects": named},
            "chi2": {"holdout": {"base": 9.0, "final": 1.05, "noise": 1.0}},
        },
    }  # fmt: skip


@pytest.mark.parametrize(
    ("group", "true", "kind", "named", "outcome"),
    [
        ("catalogue", ["leak"], "identified", ["leak"], "right"),
        ("catalogue", ["leak"], "identified", ["leak", "creep"], "wrong"),
        ("catalogue", ["leak"], "identified", ["creep"], "wrong"),
        ("catalogue", ["leak"], "ambiguous", ["creep", "leak"], "ambiguous"),
        ("catalogue", ["leak"], "ambiguous", ["creep", "end_shape"], "wrong"),
        ("catalogue", ["leak"], "unknown", ["leak"], "unknown"),
        ("catalogue", ["leak"], "none_missing", [], "missed"),
        ("pair", ["leak", "creep"], "identified", ["creep", "leak"], "right"),
        ("pair", ["leak", "creep"], "identified", ["creep"], "wrong"),
        ("null", [], "none_missing", [], "right"),
        ("null", [], "unknown", [], "unknown"),
        ("null", [], "identified", ["leak"], "wrong"),
        ("none_of_these", [], "unknown", ["leak"], "right"),
        ("none_of_these", [], "ambiguous", ["leak", "creep"], "right"),
        ("none_of_these", [], "identified", ["leak"], "wrong"),
        ("none_of_these", [], "none_missing", [], "missed"),
    ],
)
def test_judging(group, true, kind, named, outcome):
    assert judged(_result(group, true, kind, named)) == outcome


def test_a_crash_is_an_error_and_has_no_chi_square():
    crashed = {
        "set": "score",
        "number": 1,
        "case": {"group": "null", "families": [], "hidden": []},
        "error": {"where": "process"},
    }
    assert judged(crashed) == "error"
    assert excess(crashed) is None


def test_wilson_interval_of_the_textbook():
    low, high = wilson(81, 263)  # Newcombe (1998), table I
    assert (low, high) == pytest.approx((0.2553, 0.3662), abs=5e-5)
