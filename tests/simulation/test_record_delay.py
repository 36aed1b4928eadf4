"""A record that is late or early against that of the inputs: the same readings, at other times."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

from pam_cosim.compiler import smooth_parameters, with_sensitivities
from pam_cosim.errors import InputError
from pam_cosim.fmu import build_fmu
from pam_cosim.model.interface import RECORD_DELAY, Variable
from pam_cosim.simulation import Inputs, Simulator
from tests.fmu import models

STEP = Inputs(np.array([0.0, 0.5, 0.5, 3.0]), {"u": np.array([0.0, 0.0, 1.0, 1.0])})
TIMES = np.linspace(0.0, 2.0, 81)


def lag():
    """x' = (u - x)/0.2 from x = 0, with a clock."""
    x, u, late = ca.SX.sym("x"), ca.SX.sym("u"), ca.SX.sym("late")
    ode = models.ode(
        "Lag",
        {"x": (x, (u - x) / 0.2, 0.0)},
        {"y": x},
        inputs={"u": u},
        parameters={"late": (late, 0.0)},
    )
    clock = Variable("late", "s", start=0.0, quantity=RECORD_DELAY)
    return replace(ode, interface=replace(ode.interface, parameters={"late": clock}))


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
@pytest.mark.parametrize("late", [0.3, -0.3, 0.0])
def test_readings_are_those_of_another_time(tmp_path, late, fmi):
    with Simulator(build_fmu(lag(), tmp_path / "Lag.fmu", fmi=fmi)) as simulator:
        assert list(simulator.interface.record_delays) == ["late"]
        shown = simulator.run(TIMES, inputs=STEP, parameters={"late": late})
    since = np.maximum(TIMES - late - 0.5, 0.0)
    exact = -np.expm1(-since / 0.2)
    assert np.abs(shown["y"] - exact).max() < 1e-5
    assert np.array_equal(shown.time, TIMES)


def test_what_a_record_shows_before_the_start_is_the_start(tmp_path):
    with Simulator(build_fmu(lag(), tmp_path / "Lag.fmu")) as simulator:
        shown = simulator.run(TIMES, inputs=STEP, parameters={"late": 5.0})
    assert not shown["y"].any()


def test_nothing_is_differentiated_by_it():
    assert smooth_parameters(lag()) == ()
    with pytest.raises(InputError, match="'late' is the delay of a record"):
        with_sensitivities(lag(), ["late"])
