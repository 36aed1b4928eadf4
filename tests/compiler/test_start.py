"""Parameters with ``fixed=false``, and comparisons of time with the start."""

from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from pam_cosim.compiler import compile_model
from pam_cosim.errors import ModelError
from pam_cosim.fmu import build_fmu
from pam_cosim.simulation import Inputs, Simulator
from tests.compiler.run import MODELS, at, compiled, defaults


def test_the_start_time_becomes_a_signal_that_begins_late():
    ode = compiled("Start.Late")
    assert list(ode.interface.parameters) == ["T"] and "t_0" not in ode.interface.locals
    times = (
        ca.Function("times", [ode.p], [ca.vertcat(*[d.time for d in ode.delays])])(defaults(ode))
        .full()
        .ravel()
    )
    assert sorted((d.input is None, t) for d, t in zip(ode.delays, times, strict=True)) == [
        (False, 0.5), (True, 0.5), (True, 1.0), (True, 1.0)
    ]  # fmt: skip
    assert not ca.depends_on(ode.outputs, ode.t) and not ca.depends_on(ode.derivatives, ode.t)


@pytest.mark.parametrize("start", [0.0, -3.0, 10.25])
def test_the_changes_are_met_wherever_the_run_starts(start: float, tmp_path: Path):
    """Exactly: x grows by 1 a second from t_0 + T on, with steps of the solver that end there."""
    path = build_fmu(compiled("Start.Late"), tmp_path / "late.fmu")
    times = start + np.array([0.0, 0.3, 0.4999, 0.5, 0.75, 0.999, 1.0, 1.25])
    held = Inputs(np.array([start]), {"u": np.array([1.0])})
    with Simulator(path) as simulator:
        run = simulator.run(
            times, inputs=held, outputs=["y", "x", "before", "after"], start_time=start
        )
        assert run["y"].tolist() == [0, 0, 0, 1, 1, 1, 1, 1]
        assert run["before"].tolist() == [1, 1, 1, 1, 1, 1, 0, 0]
        assert run["after"].tolist() == [2, 2, 2, 2, 2, 2, 3, 3]
        np.testing.assert_allclose(run["x"], np.maximum(times - start - 0.5, 0), atol=1e-12)
        short = simulator.run(
            times, inputs=held, outputs=["x"], start_time=start, parameters={"T": 0.0}
        )
        np.testing.assert_allclose(short["x"], times - start, atol=1e-12)


def test_a_parameter_that_initial_equations_determine():
    ode = compiled("Start.Steady")
    values = at(ode, p={"k": 5.0}, t=14.0)
    assert (
        values["q"] == 15.0
        and values["twice"] == 30.0
        and values["y"] == 45.0
        and values["der(x)"] == 0.0
    )
    assert (values["switched"], at(ode, p={"k": 5.0}, t=16.0)["switched"]) == (0.0, 1.0)
    assert "q" not in ode.interface.parameters


@pytest.mark.parametrize(
    ("declared", "initial", "used", "words"),
    [
        (
            "t_0(fixed=false)",
            "t_0 = time",
            "time - t_0",
            "'t_0' is the start time; it can only be used in comparisons",
        ),
        ("t_0(fixed=false)", "t_0 = time", "if x > t_0 then 1 else 0", "'t_0' is the start time"),
        (
            "t_0(fixed=false)",
            "t_0 = 2*time",
            "if time > t_0 then 1 else 0",
            "depends on the start time",
        ),
        (
            "t_0(fixed=false) = 3",
            "t_0 = time",
            "1",
            "has a value, and fixed=false leaves it to initial equations",
        ),
        ("t_0(fixed=false)", "x = 1", "t_0", "t_0"),
        ("t_0(fixed=false)", "t_0 = u", "t_0", "depends on the input 'u'"),
    ],
)
def test_refused(declared: str, initial: str, used: str, words: str, tmp_path: Path):
    file = tmp_path / "M.mo"
    file.write_text(
        f"model M\n  input Real u;\n  parameter Real {declared};\n  Real x(start=1, fixed=true);\n"
        f"  output Real y = {used};\ninitial equation\n  {initial};\nequation\n  der(x) = 1;\nend M;\n"
    )
    with pytest.raises(ModelError) as caught:
        compile_model(str(file), root=MODELS)
    assert words in str(caught.value) and caught.value.file == file
