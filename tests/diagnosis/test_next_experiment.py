"""Rivals that mean the same are one; rivals that differ come with the run that would decide."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.catalogue import compose
from pam_cosim.compiler import read_library
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.judgement.next_experiment import (
    distinguishable_rivals,
    next_experiment,
)
from pam_cosim.diagnosis.judgement.prediction import Hypothesis
from pam_cosim.fitting import Estimate, Fit
from pam_cosim.measurement import DataSet, read_data_set
from rig.short import write_light_data


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> DataSet:
    folder = write_light_data(tmp_path_factory.mktemp("rig") / "d")
    return read_data_set(folder, lambda name: study.describe(name))


def rival(effect: str, family: str, data: DataSet, **values: float) -> Candidate:
    """The Isotonic bench with an effect at these parameters."""
    composition = compose(read_library(), data.model, [effect])
    own = composition.parameters[effect]
    given = {n: Estimate(values[n.rpartition(".")[2]], 0.0, 1.0) for n in own}
    fit = Fit(composition.name, given, None, {}, 1)  # type: ignore[arg-type]
    return Candidate(
        effect, family, "force", (effect,), tuple(own), fit, equations=composition.text
    )


@pytest.mark.full
def test_creep_without_end_is_a_spring(data: DataSet) -> None:
    spring = rival("LinearBladder", "elasticity", data, k=250.0)
    slow = rival("MaxwellCreep", "creep", data, k=250.0, tau=1e4)
    fast = rival("MaxwellCreep", "creep", data, k=250.0, tau=1.5)
    assert distinguishable_rivals(data, spring, [slow]) == []
    ((kept, plan),) = distinguishable_rivals(data, spring, [slow, fast])
    assert kept is fast
    assert plan is not None and plan.separation > 5
    assert plan.between == ("elasticity", "creep")


def test_what_a_refit_would_take_away_does_not_count(data: DataSet) -> None:
    """Two strengths of one law differ by little more than what the data at hand forbid; two laws by far more."""
    a = rival("ViscousFriction", "rate_friction", data, c=300.0)
    b = rival("ViscousFriction", "rate_friction", data, c=330.0)
    with Hypothesis(a, data) as first, Hypothesis(b, data) as second:
        run = data.runs[1]
        one, two = first.predict(run), second.predict(run)
        plain = float(np.sum(((one.values - two.values) / one.sigma) ** 2))
        measured = second.refitted_miss(one, two)
        second._information_root = np.zeros((1, len(second.free)))  # nothing measured yet
        free = second.refitted_miss(one, two)
    assert free < 0.02 * plain and free < measured < plain


def test_the_run_can_be_made_as_printed(data: DataSet) -> None:
    """The table holds the points between which the inputs are straight: it gives back the run."""
    a = rival("ViscousFriction", "rate_friction", data, c=300.0)
    b = rival("LinearBladder", "elasticity", data, k=200.0)
    plan = next_experiment(data, a, b)
    assert plan is not None
    table, parameters = plan.table, plan.parameters
    assert isinstance(table, dict) and isinstance(parameters, dict)
    assert set(table) == {"time", "u_in", "u_out", "p_supply"} and set(parameters) == {"load.m"}
    assert len({len(column) for column in table.values()}) == 1 and len(table["time"]) < 60
    run = next(r for r in data.runs if r.name == plan.run)
    assert run.interpolation == plan.interpolation == "previous"
    if plan.change.startswith(("load.m", "p_supply", "u_out", "repeat")):
        row = np.searchsorted(table["time"], run.time, side="right") - 1
        assert np.array_equal(np.array(table["u_in"])[row], run.inputs["u_in"])
