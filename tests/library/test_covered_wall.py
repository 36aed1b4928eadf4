"""Walls that the fibres cover wholly: an area of zero is a value like any other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.simulation import Simulator
from tests.library.ode import Model
from tests.library.shelf import BENCH, TIMES, built, effects, on_bench, run, values

COVERED = {"muscle.fibres": 300.0}  # 178 cm2 of fibres on 151 cm2 at rest


@pytest.mark.parametrize("grip", [-10.0, -2.0, 0.0, 2.0, 10.0])
def test_layers_of_a_covered_wall_have_finite_rates(grip: float, tmp_path: Path) -> None:
    composition = on_bench("GeneralWall", BENCH)
    model = Model(composition.name, composition.text, tmp_path)
    p, u = model.parameters(COVERED | {"muscle.wall.grip": grip}), model.inputs()
    start = model.initial(p)
    known = model.at(start, u, p)
    assert known["muscle.wall.A"] == 0
    assert known["muscle.wall.heatPort.Q_flow"] == 0
    assert np.isfinite(model.everything(0, start, u, p).full()).all()
    assert np.isfinite(model.slopes(0, start, u, p).full()).all()


@pytest.mark.parametrize("grip", [-2.0, 0.0, 2.0, 10.0])
def test_a_muscle_fills_whose_fibres_cover_it_at_rest(grip: float) -> None:
    effect = next(e for e in effects() if e.name == "GeneralWall")
    own = values(effect, on_bench(effect.name, BENCH), {"grip": grip})
    outputs, _ = run(built(BENCH, effect.name), COVERED | own)
    assert all(np.isfinite(y).all() for y in outputs.values())
    with Simulator(built(BENCH, effect.name)) as simulator:
        area = simulator.run(TIMES, parameters=COVERED | own, outputs=["muscle.wall.A"])
    assert area["muscle.wall.A"][0] == 0
