"""Every form of the table in the rig: where it lies, that it runs, that it can be made as large as a score asks for.

What a form's family has in common holds of each: springs keep their work, friction takes it, gas leaks outwards.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from blind_cases import cases, table
from blind_cases.setups import SIGNALS, Design, draw
from rig.effect import Effect
from rig.flow import P_ATM, T_ATM
from rig.muscle import MuscleParameters
from rig.states import REST, held, now_at

ALL = (*table.FORMS, *table.STRANGE)
NEW = [form for form in ALL if form.sets == ("score",) and not form.catalogue]
FRICTION = ("dry_friction", "rate_friction", "creep")
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


ISOTONIC = Design("Isotonic", ("p", "x", "T"), 50.0, 1)


@pytest.fixture(scope="module")
def bench():
    return draw(np.random.default_rng(2), ISOTONIC).driven()


@pytest.fixture(scope="module")
def base(bench):
    return bench.simulate()[0]


@pytest.mark.full
@pytest.mark.parametrize("form", ALL[::4], ids=_name)
def test_the_rig_runs_at_the_bounds_of_a_strength_and_shows_the_larger(bench, base, form):
    """What a gauge that errs shows of the pressure has no bound of physics; the gas has, and the load."""
    at = form.make(np.random.default_rng(9), bench.muscle)
    changes = []
    for strength in (form.low, form.high, *((-form.high,) if form.signed else ())):
        effect = at(strength)
        run = bench.simulate([effect])[0]
        noise = {"p": 500.0, "x": 2e-4, "T": 0.3}
        changes.append(max(np.abs(run[n] - base[n]).max() / s for n, s in noise.items()))
        assert type(effect).pressure_shown is not Effect.pressure_shown or run["p"].min() > -2e4
        assert run["x"].max() < 0.5 * bench.muscle.length
        assert 180.0 < run["T"].min() <= run["T"].max() < 480.0
    assert changes[1] > 0.05
    assert changes[0] < 0.7 * changes[1] or form.low == form.high


@pytest.mark.full
@pytest.mark.parametrize("bench", SIGNALS)
def test_new_forms_run_on_each_bench_that_takes_them(bench):
    signals = SIGNALS[bench][0][0]
    setup = draw(np.random.default_rng(3), Design(bench, signals, 50.0, 1)).driven()
    base = setup.simulate()[0]
    taken = [form for form in NEW if setup.design.rig.takes(cases._sample(form), signals)]
    by_family = {form.family: form for form in taken}
    assert len(by_family) >= 3
    for form in by_family.values():
        run = setup.simulate([form.make(np.random.default_rng(9), setup.muscle)(1.0)])[0]
        assert all(np.isfinite(run[name]).all() for name in signals), form.name
        assert any(not np.array_equal(run[name], base[name]) for name in signals), form.name


@pytest.mark.parametrize("form", NEW[::6], ids=_name)
def test_the_rig_runs_at_an_ordinary_strength(bench, base, form):
    """A sample of the new forms; another one, at its bounds, is in the other tier."""
    run = bench.simulate([form.make(np.random.default_rng(9), bench.muscle)(1.0)])[0]
    assert any(not np.allclose(run[name], base[name], rtol=1e-9, atol=0.0) for name in base)


@pytest.mark.parametrize("family", ["elasticity", *FRICTION, "moving_mass"])
def test_work_in_closed_cycles_is_none_of_springs_and_taken_by_friction(family):
    """Two cycles of contraction by 40 mm in 1 s each at 1 bar; the second counts."""

    def now(t):
        swing = 2 * np.pi * t
        return now_at(0.02 * (1 - np.cos(swing)), 0.04 * np.pi * np.sin(swing), 1e5)

    for form in (f for f in ALL if f.family == family):
        effect = form.make(np.random.default_rng(1), MuscleParameters())(min(1.0, form.high))

        def rates(t, y, effect=effect):
            at = now(t)
            return [*effect.rates(y[:-1], at), effect.force(y[:-1], at.x, at.v, at.p_gauge) * at.v]

        y = solve_ivp(
            rates,
            (0, 2),
            [*effect.initial(REST), 0.0],
            "LSODA",
            [1, 1.5, 2],
            rtol=1e-7,
            max_step=5e-3,
        ).y[-1]  # J
        cycle, half = y[2] - y[0], y[1] - y[0]
        if family in FRICTION:
            assert cycle > 0.05, form.name
        elif family == "elasticity":
            assert abs(cycle) < 1e-6 < half, form.name
        else:
            assert cycle > -1e-6, form.name


@pytest.mark.parametrize("form", [f for f in ALL if f.family == "leak"], ids=_name)
def test_gas_leaks_outwards_and_none_at_rest(form):
    effect = form.make(np.random.default_rng(1), MuscleParameters())(1.0)
    full, rest = held(effect, now_at(p_gauge=1e5), 5.0), effect.initial(REST)
    assert effect.exchange(full, 2e5, T_ATM)[0] + effect.leak(2e5, T_ATM) > 1e-7
    assert effect.exchange(rest, P_ATM, T_ATM)[0] + effect.leak(P_ATM, T_ATM) < 1e-8


@pytest.mark.parametrize("form", [f for f in ALL if f.family == "thermocouple_lag"], ids=_name)
def test_thermometers_come_to_the_temperature_that_stays(form):
    """Wires that lead heat away stay a little below it."""
    effect = form.make(np.random.default_rng(1), MuscleParameters())(min(1.0, form.high))
    late = held(effect, now_at(temperature=T_ATM + 10), 60.0)
    assert 9.0 < effect.reading(late, T_ATM + 10) - T_ATM < 10.001
    assert effect.reading(effect.initial(REST), T_ATM) == pytest.approx(T_ATM)
