"""Every form of the table in the rig: where it lies, that it runs, that it can be made as large as a score asks for.

What single forms must give is tested by their limits elsewhere.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from blind_cases import many, table
from blind_cases.cases import _draw_bench, _fitting_noise
from blind_cases.noise import draw_sensors
from blind_cases.setups import SIGNALS, Design, draw
from blind_cases.sizes import Ruler, calibrated
from rig.effect import Effect
from rig.muscle import MuscleParameters

ALL = (*table.FORMS, *table.STRANGE)
NEW = [form for form in ALL if form.sets == ("score",) and not form.catalogue]
NARROW = {family for family in table.FAMILIES if family in ("dead_volume", "friction_heat")}
"""A rigid volume has one law, and heat of friction is a known power: what is new there is the way to the gas."""


def _name(form: table.Form) -> str:
    return f"{form.family}-{form.name}"


def test_forms_lie_in_the_folder_and_the_family_that_the_table_says():
    muscle = MuscleParameters()
    for form in ALL:
        effect = form.make(np.random.default_rng(1), muscle)(min(1.0, form.high))
        path = type(effect).__module__.replace(".further.", ".")
        _, folder, family, *_ = path.split(".")
        assert (folder == "catalogue") is form.catalogue, form.name
        assert folder in ("catalogue", "seen"), form.name
        assert effect.family == form.family == family


def test_no_form_comes_twice_and_each_is_a_class_of_its_own():
    muscle = MuscleParameters()
    kinds = {
        (f.family, f.name): type(f.make(np.random.default_rng(1), muscle)(min(1.0, f.high)))
        for f in ALL
    }
    assert len(kinds) == len(ALL)
    assert len(set(kinds.values())) == len(ALL)


def test_a_score_has_new_forms_of_each_family_and_in_none():
    families = [form.family for form in NEW]
    for family in table.FAMILIES:
        assert families.count(family) >= (1 if family in NARROW else 2)
    assert families.count("none_of_these") >= 8


@pytest.fixture(scope="module")
def ruler():
    bench = _draw_bench(np.random.default_rng(77))
    return Ruler(replace(bench, plan=(*bench.plan[:2], bench.plan[-1])))


@pytest.mark.full
@pytest.mark.parametrize("form", NEW, ids=_name)
def test_small_and_large_sizes_are_reached(ruler, form):
    """3 and 20 standard deviations, where the strength is bounded by instruments quieter or louder.

    Friction cannot give more heat than its work, so that no form of its family reaches 20 on this rig.
    """
    sensors = draw_sensors(np.random.default_rng(4))
    at = form.make(np.random.default_rng(5), ruler.bench.muscle)
    for target in (3.0,) if form.family == "friction_heat" else (3.0, 20.0):
        size = calibrated(ruler, at, sensors.sigma, target, form.low, form.high)[1]
        assert _fitting_noise(sensors, size, target)[1] == pytest.approx(target, rel=0.5)


@pytest.mark.full
@pytest.mark.parametrize("form", ALL, ids=_name)
def test_the_rig_runs_at_the_bounds_of_a_strength(form):
    """What a gauge that errs shows of the pressure has no bound of physics; the gas has, and the load."""
    bench = _draw_bench(np.random.default_rng(2))
    bench = replace(bench, plan=bench.plan[-1:])
    at = form.make(np.random.default_rng(9), bench.muscle)
    for strength in (form.low, form.high, *((-form.high,) if form.signed else ())):
        effect = at(strength)
        run = bench.simulate([effect])[0]
        assert type(effect).pressure_shown is not Effect.pressure_shown or run["p"].min() > -2e4
        assert run["x"].max() < 0.5 * bench.muscle.length
        assert 180.0 < run["T"].min() <= run["T"].max() < 480.0


@pytest.mark.full
@pytest.mark.parametrize("bench", SIGNALS)
def test_new_forms_run_on_each_bench_that_takes_them(bench):
    signals = SIGNALS[bench][0][0]
    setup = draw(np.random.default_rng(3), Design(bench, signals, 50.0, 1)).driven()
    base = setup.simulate()[0]
    taken = [form for form in NEW if setup.design.rig.takes(many._sample(form), signals)]
    assert len({form.family for form in taken}) >= 3
    for form in taken:
        run = setup.simulate([form.make(np.random.default_rng(9), setup.muscle)(1.0)])[0]
        assert all(np.isfinite(run[name]).all() for name in signals), form.name
        assert any(not np.array_equal(run[name], base[name]) for name in signals), form.name


@pytest.mark.parametrize("form", NEW[::6], ids=_name)
def test_the_rig_runs_at_an_ordinary_strength(form):
    """A sample of the new forms, shortly; all of them, at their bounds, are in the other tier."""
    bench = _draw_bench(np.random.default_rng(2))
    bench = replace(bench, plan=(replace(bench.plan[0], samples=151),))
    base, run = (
        bench.simulate()[0],
        bench.simulate([form.make(np.random.default_rng(9), bench.muscle)(1.0)])[0],
    )
    assert any(not np.allclose(run[name], base[name], rtol=1e-9, atol=0.0) for name in base)
