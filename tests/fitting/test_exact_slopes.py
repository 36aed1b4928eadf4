"""The Jacobian of a fit: by the model's sensitivities where it has them, by differences elsewhere."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pam_cosim.fitting import Free
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet
from pam_cosim.simulation import Simulator
from tests.fitting.models import TIMES, data_set, recording

_FREE = (
    Free("orifice.C_d", 0.3, 1.0, 0.8, "1"),
    Free("tank.n", 1.0, 1.4, 1.2, "1"),
    Free("orifice.d", 1e-4, 2e-2, 2.7e-3, "m"),
)


def _data() -> DataSet:
    p = 4e5 * np.exp(-TIMES / 20.0)
    p[5] = np.nan
    runs = [
        recording(TIMES, {"p": p}),
        replace(recording(TIMES, {"p": p}), parameters={"tank.n": 1.3}),
    ]
    return data_set("VesselOrifice", runs, {"p": 500.0})


def _objective(simulator: Simulator) -> Objective:
    data = _data()
    return Objective(simulator, data, data.runs, _FREE, tolerance=1e-8)


def test_exact_and_difference_agree() -> None:
    names = [f.name for f in _FREE]
    with (
        Simulator(build_model("VesselOrifice")) as plain,
        Simulator(build_model("VesselOrifice", sensitivities=names)) as told,
        Simulator(build_model("VesselOrifice", sensitivities=names[:1])) as part,
    ):
        z = np.array([f.to_z(f.start) for f in _FREE])
        jacobians = []
        for simulator in (plain, told, part):
            objective = _objective(simulator)
            jacobians.append(objective.jacobian(z, objective.residuals(z)))
            evaluations = objective.evaluations
            assert evaluations == {plain: 4, told: 1, part: 3}[simulator]
    size = np.abs(jacobians[0]).max(axis=0)
    assert jacobians[0].shape == (2 * 60, 3)
    assert (np.abs(jacobians[1] - jacobians[0]).max(axis=0) < 5e-3 * size).all()
    assert np.abs(jacobians[2][:, 0] - jacobians[1][:, 0]).max() < 1e-6 * size[0]


def test_a_parameter_known_for_a_run_does_not_move_it() -> None:
    with Simulator(build_model("VesselOrifice", sensitivities=["tank.n"])) as simulator:
        data = _data()
        objective = Objective(simulator, data, data.runs, _FREE[1:2])
        z = np.array([_FREE[1].to_z(1.2)])
        jacobian = objective.jacobian(z, objective.residuals(z))
    assert np.abs(jacobian[:60]).max() > 0.1
    assert not jacobian[60:].any()
