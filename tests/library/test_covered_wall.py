"""Walls that the fibres cover wholly: an area of zero is a value like any other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.library.catalogue import BENCH, on_bench
from tests.library.ode import Model

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
