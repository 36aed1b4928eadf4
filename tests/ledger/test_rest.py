"""Where a ledger begins a model that begins at rest: where its FMU does."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.compiler import compile_model
from pam_cosim.fmu import build_source
from pam_cosim.ledger.grid import make_grid
from pam_cosim.ledger.model import Model
from pam_cosim.simulation import Inputs, Simulator
from rig.short import write_light_data

TEXT = """model Begun
  extends PneumaticMuscle.Benches.Isotonic(ambient(dynamics=PneumaticMuscle.Types.Dynamics.SteadyStateInitial),
    valve(redeclare model Drive = PneumaticMuscle.Effects.ValveDynamics.ValveLag));
end Begun;
"""


def test_runs_begin_at_rest_and_at_stated_values(tmp_path: Path) -> None:
    file = tmp_path / "Begun.mo"
    file.write_text(TEXT)
    ode = compile_model(str(file))
    data = study.read(write_light_data(tmp_path / "d", [], 1))
    grid = make_grid(ode, data, data.runs, {}, ["p", "x"], 0.05)
    states, first, told = [s.name for s in ode.states], grid.first[:-1], 2.5e5
    inputs = grid.node_inputs.copy()
    inputs[first, :2] = [0.3, 0.2]
    starts = np.full_like(grid.starts, np.nan)
    starts[1, states.index("muscle.gas.p")] = told
    begins = Model(ode, (), (), ("p", "x")).initial(
        grid.parameters, replace(grid, node_inputs=inputs, starts=starts)
    )
    with Simulator(build_source("Begun", TEXT, lean=True, brief=True)) as simulator:
        for run, set_values in ((0, {}), (1, {"muscle.gas.p": told})):
            held = {
                n: np.array([v])
                for n, v in zip(ode.interface.inputs, inputs[first[run]], strict=True)
            }
            stated = dict(zip(ode.interface.parameters, grid.parameters[run].tolist(), strict=True))
            stated |= set_values
            theirs = simulator.run(
                [0.0], parameters=stated, inputs=Inputs(np.array([0.0]), held), outputs=states
            )
            for i, name in enumerate(states):
                assert begins[run, i] == pytest.approx(theirs[name][0], rel=1e-6, abs=1e-9), name
