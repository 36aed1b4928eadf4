"""Where a mass swings as a recording begins: start values that whole runs have many valleys for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.fitting import Free, fit
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_model
from pam_cosim.measurement import Run
from pam_cosim.measurement.start import Start
from pam_cosim.model.references import START_VALUES
from pam_cosim.simulation import Simulator
from rig.benches import BENCHES
from rig.schedule import Course
from rig.trial import Trial
from tests.fitting.models import data_set, recording

pytestmark = pytest.mark.full

MODEL = "PneumaticMuscle.Examples.ConstantFrictionLoad"
TRUE = {"muscle.D0": 0.0218, "muscle.friction.c_c": 8.0, "muscle.friction.c_v": 20.0}
KNOWN = {"muscle.L0": 0.545, "muscle.alpha_0": 0.383}
SIGMA, BEGIN = 1.2e-4, 4.24  # m, s
FREE = (Free("muscle.D0", 0.020, 0.0244, 0.0222, "m"),)


def _swinging(mass: float, frequency: float, seed: int) -> Run:
    """A wave of pressure pulls a mass up on a slack muscle, on which it bounces; the recording begins in between."""
    time = np.arange(0.0, 10.0, 0.02)
    wave = 2e5 * (1 - np.cos(2 * np.pi * frequency * time))
    late = time >= BEGIN
    own = {**KNOWN, "load.m": mass, "frequency": frequency}
    trial = Trial("waves", "fit", len(time), 50.0, course=Course(tuple(wave.tolist()), 0.02))
    x = BENCHES["VerticalLoad"].simulation({**TRUE, **own}, trial, time, (), 1e-8)["x"][late]
    noise = SIGMA * np.random.default_rng([seed, 8]).standard_normal(len(x))
    run = recording(time[late], {"x": x + noise}, inputs={"p": wave[late]})
    return replace(run, name=f"run-{seed}", parameters=own, start=Start("estimated"))


@pytest.fixture(scope="module")
def objective() -> Iterator[Objective]:
    runs = [_swinging(52.83, 0.5, 1), _swinging(44.91, 1.5, 2)]
    data = data_set(MODEL, runs, {"x": SIGMA})
    path = build_model(MODEL, sensitivities=("muscle.D0", START_VALUES), where_smooth=True)
    with Simulator(path) as simulator:
        yield Objective(simulator, data, data.runs, FREE, TRUE)


def test_the_first_samples_lead_to_where_the_mass_swings(objective: Objective) -> None:
    z = np.array([FREE[0].to_z(TRUE["muscle.D0"])])
    assert objective.squares(z) / objective.size > 100.0
    assert objective.found_other_starts(z)
    assert objective.squares(z) / objective.size < 1.2
    assert not objective.found_other_starts(z)


def test_a_fit_from_another_diameter_finds_both_swings(objective: Objective) -> None:
    found = fit(objective.simulator, objective.data, FREE, fixed=TRUE)
    assert found.parameters["muscle.D0"].value == pytest.approx(TRUE["muscle.D0"], rel=1e-3)
    assert found.residuals["fit"].chi2_reduced < 1.2
