"""A stated parameter that is wrong: its ratio to the truth is a parameter like any other, and is found."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.diagnosis.search.stated_parameters import stated_parameters
from pam_cosim.fitting import Free
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet
from pam_cosim.model.domain import WRONG_PARAMETER
from pam_cosim.model.references import ratio_to_stated
from pam_cosim.reporting import diagnosis_text
from pam_cosim.simulation import Simulator
from rig.measurement import TRUTH
from rig.short import write_light_data

LENGTH, LOAD = ratio_to_stated("muscle.L0"), ratio_to_stated("load.m")


def misled(folder: Path, **ratios: float) -> DataSet:
    """Two short runs of the rig; what is stated of a parameter is the truth over a ratio."""
    data = study.read(write_light_data(folder / "data", seed=2))

    def stated(values: dict[str, float]) -> dict[str, float]:
        return {n: v / ratios.get(n.rpartition(".")[2], 1.0) for n, v in values.items()}

    known = {"muscle.L0": TRUTH.length}
    runs = tuple(replace(run, parameters=stated(known | run.parameters)) for run in data.runs)
    return replace(data, parameters=stated(known | data.parameters), runs=runs)


def test_a_ratio_is_multiplied_by_what_each_run_states(tmp_path: Path) -> None:
    data = misled(tmp_path)
    loads = [data.parameters_of(run, {LOAD: 1.1})["load.m"] for run in data.runs]
    assert loads == pytest.approx([1.1 * run.parameters["load.m"] for run in data.runs])
    assert len(set(loads)) == 2
    assert not any("stated" in name for name in data.parameters_of(data.runs[0], {LOAD: 1.1}))


def test_slopes_by_a_ratio_are_those_of_differences(tmp_path: Path) -> None:
    data = misled(tmp_path)
    data = replace(
        data, signals={n: replace(s, sigma=s.sigma or 1.0) for n, s in data.signals.items()}
    )
    free = [Free(LENGTH, 0.5, 2.0, 1.01, "1", 0.05), Free(LOAD, 0.5, 2.0, 0.98, "1", 0.05)]
    with Simulator(build_model(data.model, (), sensitivities=["muscle.L0", "load.m"])) as simulator:
        objective = Objective(simulator, data, data.runs, free, None, 1e-9)
        z = np.array([f.to_z(f.start) for f in free])
        exact = objective.jacobian(z, objective.residuals(z))
        for i in range(len(free)):
            h = np.zeros(2)
            h[i] = 1e-4
            column = (objective.plain_residuals(z + h) - objective.plain_residuals(z - h)) / 2e-4
            assert np.linalg.norm(column - exact[:, i]) < 1e-3 * np.linalg.norm(column)


def test_what_every_run_states_and_no_fit_moves_may_be_wrong(tmp_path: Path) -> None:
    data = misled(tmp_path)
    with Simulator(build_model(data.model, ())) as simulator:
        hypotheses = stated_parameters(data, simulator.interface)
    names = {h.name for h in hypotheses}
    assert {LENGTH, LOAD} <= names
    assert not names & {ratio_to_stated(n) for n in data.free_names}
    assert {h.family for h in hypotheses} == {WRONG_PARAMETER}


@pytest.mark.full
def test_a_wrong_length_is_named_and_measured(tmp_path: Path, workers: int | None) -> None:
    diagnosis = study.diagnose(misled(tmp_path, L0=1.04), explain=False, workers=workers)
    assert diagnosis.verdict.families[:1] == (WRONG_PARAMETER,), diagnosis.verdict
    estimate = diagnosis.final.parameters[diagnosis.path[0].own_parameters[0]]
    assert diagnosis.path[0].effect == LENGTH, diagnosis.verdict
    assert estimate.low <= 1.04 <= estimate.high
    assert (
        "An instrument, not physics: wrong parameter: what the data set states"
        in diagnosis_text(diagnosis)
    )
