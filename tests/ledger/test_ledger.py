"""An effect is hidden in the independent rig's data: the ledger names its balance and gives its size over time."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.errors import InputError
from pam_cosim.fmu import source_ode
from pam_cosim.ledger import BalanceEntry, Ledger, binned, keep_ledger, mapped
from pam_cosim.ledger.augmented import AugmentedModel
from pam_cosim.ledger.explainer import Explainer
from pam_cosim.ledger.ledger import TermSeries
from pam_cosim.ledger.unaugmented import unaugmented
from pam_cosim.measurement import DataSet, FreeParameter
from pam_cosim.model.domain import Domain
from rig.flow import P_ATM
from rig.instruments import ClockOffset
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from rig.named import effect_of
from rig.short import PLAN, write_light_data
from tests.fitting.models import data_set, recording
from tests.tiers import quick

BALANCE = {
    "elasticity:linear": "force",
    "elasticity:exponential": "force",
    "dry_friction:coulomb": "force",
    "rate_friction:viscous": "force",
    "moving_mass:hanging": "force",
    "leak:orifice": "mass",
    "gas_energy:film": "energy",
}


PAIRS = {
    "gas_energy:film+elasticity:linear": {"energy", "force"},
}


def _data(hidden: str, seed: int = 1) -> DataSet:
    effects = [] if hidden == "none" else [effect_of(name) for name in hidden.split("+")]
    return study.read(write_light_data(Path(mkdtemp()) / "d", effects, seed))


@cache
def _ledger(hidden: str, seed: int = 1) -> Ledger:
    data = _data(hidden, seed)
    return keep_ledger(data, study.fit(data).values)


@pytest.mark.parametrize(
    "hidden",
    quick(BALANCE, "leak:orifice"),
)
def test_failing_balance_is_named(hidden: str) -> None:
    ledger = _ledger(hidden)
    assert ledger.failing == (BALANCE[hidden],), str(ledger)
    assert ledger.closed and ledger.before > 2 * ledger.after
    assert ledger.shares[BALANCE[hidden]] == pytest.approx(1.0, abs=0.01)
    assert sum(ledger.shares.values()) == pytest.approx(1.0)


@pytest.mark.full
@pytest.mark.parametrize("hidden", PAIRS)
def test_both_failing_balances_are_named(hidden: str) -> None:
    ledger = _ledger(hidden)
    assert set(ledger.failing) == PAIRS[hidden], str(ledger)
    assert ledger.closed


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.full)])
def test_nothing_fails_where_nothing_is_missing(seed: int) -> None:
    ledger = _ledger("none", seed)
    assert ledger.failing == () and ledger.closed
    assert set(ledger.shares.values()) == {0.0}
    for entry in ledger.entries:  # the terms hardly vary in time: a run is one draw, not a hundred
        for course in entry.courses:
            assert np.all(np.abs(course.value) < 3.5 * course.deviation), entry.balance


@pytest.mark.full
@pytest.mark.parametrize("shift", [0.04, -0.04])
def test_a_record_that_is_shifted_is_read_by_the_clock_of_the_model(shift: float) -> None:
    folder = write_light_data(Path(mkdtemp()) / "d", seed=1, faults=[ClockOffset(shift)])
    data = study.read(folder)
    values = {"valve.C_A": TRUTH.calibration, "muscle.mu_fb": TRUTH.mu_fb, "recorder.shift": shift}
    assert keep_ledger(data, values, effects=["ClockOffset"]).failing == ()
    assert (
        keep_ledger(data, values | {"recorder.shift": 0.0}, effects=["ClockOffset"]).failing != ()
    )


@pytest.mark.parametrize(
    "hidden",
    quick(
        ["elasticity:linear", "dry_friction:coulomb", "rate_friction:viscous"],
        "rate_friction:viscous",
    ),
)
def test_missing_force_is_the_hidden_force(hidden: str) -> None:
    entry = _ledger(hidden).entry("force")
    assert entry is not None and entry.unit == "N"
    effect = effect_of(hidden)
    true = []
    for course, run in zip(entry.courses, PLAN, strict=True):
        rig = simulate_muscle(
            replace(TRUTH, load=run.load), run.p_supply, run.schedule, course.time, [effect]
        )
        true.append(
            [effect.force((), x, v, p) for x, v, p in zip(rig.x, rig.v, rig.p, strict=True)]
        )
    _check(entry, np.concatenate(true), "x", 2e-3, 0.1)


def test_missing_mass_flow_is_the_leak() -> None:
    entry = _ledger("leak:orifice").entry("mass")
    assert entry is not None and entry.unit == "kg/s"
    effect = effect_of("leak:orifice")
    true = []
    for course, run in zip(entry.courses, PLAN, strict=True):
        rig = simulate_muscle(
            replace(TRUTH, load=run.load), run.p_supply, run.schedule, course.time, [effect]
        )
        true.append(
            [-effect.leak(p + P_ATM, t) for p, t in zip(rig.p, rig.temperature, strict=True)]
        )
    _check(entry, np.concatenate(true), "p_gauge", 1e4, 0.15)


def _check(
    entry: BalanceEntry, true: np.ndarray, sized: str, least: float, accuracy: float
) -> None:
    """Where the muscle works, the term is the truth but for a multiple of what a free parameter imitates."""
    value, deviation = (
        np.concatenate([getattr(c, n) for c in entry.courses]) for n in ("value", "deviation")
    )
    imitated = np.concatenate([np.column_stack(list(c.imitated.values())) for c in entry.courses])
    z = np.concatenate([c.against[sized] for c in entry.courses])
    kept = (z > least) & (deviation < np.quantile(deviation[z > least], 0.9))
    rows = imitated[kept] / deviation[kept, None]
    error = (value - true)[kept]
    error -= imitated[kept] @ np.linalg.lstsq(rows, error / deviation[kept], rcond=None)[0]
    assert np.sqrt(np.mean(error**2)) < accuracy * np.sqrt(np.mean(true[kept] ** 2))
    assert np.mean(np.abs(error) < 2 * deviation[kept]) > 0.9


def test_mass_and_heat_are_said_to_be_one_where_the_gas_law_cannot_tell() -> None:
    ledger = _ledger("leak:orifice")
    entry = ledger.entry("mass")
    assert entry is not None and entry.same_as == ("energy",)
    assert any("mass" in n and "energy" in n and "do the same" in n for n in ledger.notes)


@pytest.mark.full
def test_summaries_and_plain_data() -> None:
    entry = _ledger("elasticity:linear").entry("force")
    assert entry is not None
    bands = binned(entry, "x", 8)
    assert sum(b.samples for b in bands) == sum(len(c.time) for c in entry.courses)
    assert bands[-1].mean > bands[0].mean + 5 * bands[0].deviation
    assert sum(b.samples for b in binned(entry, "time")) == sum(b.samples for b in bands)
    plane = mapped(entry, "x", "p_gauge", 6)
    assert plane.value.shape == (6, 6) and np.isfinite(plane.value).any()
    text = json.dumps(_ledger("elasticity:linear").as_dict())
    assert json.loads(text)["failing"] == ["force"]
    assert "courses" not in json.dumps(_ledger("elasticity:linear").as_dict(courses=False))


def test_bad_input() -> None:
    data = _data("none")
    with pytest.raises(InputError, match="FMU"):
        keep_ledger(data, model="muscle.fmu")
    with pytest.raises(InputError, match="has no states"):
        keep_ledger(replace(data, model="PneumaticMuscle.Benches.StaticForce"))


@pytest.mark.parametrize("known", [True, False], ids=["known", "fitted by itself"])
def test_stated_values_of_a_run_are_kept(known: bool) -> None:
    """The value that runs share was written into all of them."""
    model = Path(__file__).parents[1] / "fitting" / "Decay.mo"
    time, rng, runs = np.linspace(0.0, 1.0, 101), np.random.default_rng(0), []
    for name, rate in (("second", 5.0), ("first", 2.0)):
        y = np.exp(-rate * time) + 0.01 * rng.standard_normal(len(time))
        own = {"a": 5.0} if known and rate == 5.0 else {}
        runs.append(replace(recording(time, {"y": y}), name=name, parameters=own))
    data = data_set("Decay", runs, {"y": 0.01}, [FreeParameter("a", 0.0, 10.0, 3.0, "1")])
    augmented = AugmentedModel(source_ode("Decay", model.read_text(), []), (), False)
    values = {"a": 2.0} if known else {"a": 2.0, "a@second": 5.0}
    explainer = Explainer(data, values, [augmented], Domain())
    problem, states = explainer.problem(augmented, ())
    alone = unaugmented(problem, states)
    assert alone.chi2 / (2 * len(time)) == pytest.approx(1.0, abs=0.3)
    assert problem.prior == pytest.approx([2.0], abs=0.05)


def test_a_map_ends_where_its_variables_do() -> None:
    """A variable below zero that ended at zero had a map up to one."""
    time = np.linspace(0.0, 1.0, 100)
    course = TermSeries("run", "fit", time, time, np.ones(100), {"v": -time, "rest": 0 * time})
    plane = mapped(BalanceEntry("force", 0, 0, 0, courses=(course,)), "v", "rest", 4)
    np.testing.assert_allclose(plane.x_edges, [-1.0, -0.75, -0.5, -0.25, 0.0])


def _course(value: list[float], deviation: list[float], **against: list[float]) -> TermSeries:
    time, columns = np.arange(float(len(value))), {n: np.array(v) for n, v in against.items()}
    return TermSeries("run", "fit", time, np.array(value), np.array(deviation), columns)


def test_a_band_weighs_by_certainty_and_is_as_uncertain_as_its_runs_differ() -> None:
    """Weights 1 and 1/4, then 1/4 twice: 15/7 together, 1.4 and 4 alone, which differ by 2.6."""
    one, other = _course([1.0, 3.0], [1.0, 2.0]), _course([4.0, 4.0], [2.0, 2.0])
    (band,) = binned(BalanceEntry("force", 0, 0, 0, courses=(one, other)), "time", 1)
    assert band.mean == pytest.approx(15 / 7) and band.samples == 4
    assert band.deviation == pytest.approx(2.6 / np.sqrt(2) / np.sqrt(2))
    assert band.scatter == pytest.approx(np.sqrt(1.5))
    (alone,) = binned(BalanceEntry("force", 0, 0, 0, courses=(one,)), "time", 1)
    assert alone.mean == pytest.approx(1.4) and alone.deviation == 1.0
