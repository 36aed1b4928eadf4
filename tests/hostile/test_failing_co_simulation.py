"""FMUs whose own solver fails, or that have none: their model exchange is run with CVode, which is said in a line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.simulation import Inputs, IsolatedSimulator, Simulator
from tests.fmu import models
from tests.simulation.misbehaving import patched
from tests.tiers import quick

TIMES = np.linspace(0.0, 2.0, 21)
STEP = "pam_core *core = &c->core;"


def failing(
    folder: Path, how: str = 'if (now > 0.99) return pam_log(c, PAM_ERROR, "no \\x1b[31m more");'
) -> Path:
    """The lag, whose co-simulation fails half-way."""
    return patched(folder, "pam_cosimulation.c", STEP, f"{how} {STEP}")


def test_a_solver_that_fails_is_replaced_and_that_is_said(tmp_path: Path) -> None:
    with IsolatedSimulator(failing(tmp_path)) as simulator:
        for _ in range(2):
            run = simulator.run(TIMES, parameters={"x_start": 1.0})
            assert run["y"] == pytest.approx(np.exp(-TIMES / 0.5), abs=2e-5)
            assert run.solver == (
                "the co-simulation of x.fmu fails, so that its model exchange was run with CVode: no  [31m more "
                "(simulated up to 1 s)"
            )
        early = simulator.run(TIMES[:5], parameters={"x_start": 1.0})
        assert (
            early.solver == ""
            and early.to_xarray().attrs == {}
            and run.to_xarray().attrs == {"solver": run.solver}
        )
        with pytest.raises(InputError, match="no parameter or input 'taw'"):
            simulator.run(TIMES, parameters={"taw": 1.0})


@pytest.mark.parametrize("interpolation", quick(["linear", "previous"], "linear"))
def test_inputs_that_rise_and_jump(tmp_path: Path, interpolation: str) -> None:
    inputs = Inputs([0.0, 0.33, 0.33, 1.5, 2.0], {"u": [0.0, 1.0, 3.0, -1.0, 2.0]}, interpolation)  # type: ignore[arg-type]
    with Simulator(models.fmu(models.lag)) as simulator:
        expected = simulator.run(TIMES, inputs=inputs, tolerance=1e-9)
    with IsolatedSimulator(failing(tmp_path, "return PAM_ERROR;")) as simulator:
        run = simulator.run(TIMES, inputs=inputs, tolerance=1e-9)
    assert run.solver and run["y"] == pytest.approx(expected["y"], abs=1e-6)
