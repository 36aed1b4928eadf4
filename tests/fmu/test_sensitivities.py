"""Forward sensitivities against exact solutions, finite differences and another integrator."""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu

from pam_cosim.compiler import smooth_parameters, with_sensitivities
from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import InputError
from pam_cosim.fmu import build_fmu, build_model, build_source
from pam_cosim.simulation import Inputs, Simulator
from tests.fmu import models

_CHOSEN = ("valve.C_A", "muscle.n_g", "muscle.mu_fb", "load.m", "muscle.L0")
_TIMES = np.linspace(0.0, 6.0, 301)
_INPUTS = Inputs(
    np.array([0.0, 0.5, 0.5, 3.0, 3.0, 4.0, 4.0, 6.0]),
    {
        "u_in": np.array([0.0, 0.0, 0.35, 0.35, 0.0, 0.0, 0.0, 0.0]),
        "u_out": np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.35, 0.35]),
    },
    "linear",
)


def _decay() -> Ode:
    """x' = -x/tau + u, x(0) = 2 a, y = b x."""
    x, u, a, b, tau = (ca.SX.sym(n) for n in ("x", "u", "a", "b", "tau"))
    return models.ode(
        "Decay", {"x": (x, -x / tau + u, 2 * a)}, {"y": b * x},
        inputs={"u": u}, parameters={"a": (a, 1.5), "b": (b, 3.0), "tau": (tau, 0.7)},
    )  # fmt: skip


def test_linear_model_has_its_exact_sensitivities(tmp_path: Path) -> None:
    path = build_fmu(with_sensitivities(_decay(), ("a", "b", "tau")), tmp_path / "Decay.fmu")
    t = np.linspace(0.0, 3.0, 61)
    with Simulator(path) as simulator:
        y = simulator.run(t, tolerance=1e-9).values
        again = simulator.run(t, parameters={"a": 1.0}, tolerance=1e-9).values
    e = np.exp(-t / 0.7)
    assert y["sensitivity.y.a"] == pytest.approx(6.0 * e, abs=1e-7)
    assert y["sensitivity.y.b"] == pytest.approx(3.0 * e, abs=1e-7)
    assert y["sensitivity.y.tau"] == pytest.approx(9.0 * t / 0.49 * e, abs=1e-6)
    assert again["sensitivity.y.b"] == pytest.approx(2.0 * e, abs=1e-7)


def _cascade() -> Ode:
    """An oscillator behind a lag behind another one, the last of them first, and two states that nothing depends on."""
    x, y, s, v, w, z = (ca.SX.sym(n) for n in ("x", "y", "s", "v", "w", "z"))
    u, a, k, tau = (ca.SX.sym(n) for n in ("u", "a", "k", "tau"))
    states = {
        "v": (v, -k * s - 0.3 * v + y * s, 0.0), "w": (w, s * v - w, 0.1), "y": (y, (x - y) / tau, 0.2),
        "s": (s, v, a), "z": (z, -z * w, 1.0), "x": (x, (u - x * x) / (2 * tau), a),
    }  # fmt: skip
    parameters = {"a": (a, 0.6), "k": (k, 9.0), "tau": (tau, 0.4)}
    return models.ode("Cascade", states, {"s": s, "z": z}, inputs={"u": u}, parameters=parameters)


def test_a_cascade_has_the_slopes_of_finite_differences(tmp_path: Path) -> None:
    path = build_fmu(with_sensitivities(_cascade(), ("a", "k", "tau")), tmp_path / "Cascade.fmu")
    t, inputs = np.linspace(0.0, 4.0, 81), Inputs([0.0, 4.0], {"u": [0.5, 2.0]})

    def run(**parameters: float) -> dict[str, np.ndarray]:
        return dict(simulator.run(t, parameters=parameters, inputs=inputs, tolerance=1e-11).values)

    with Simulator(path) as simulator:
        slopes = run()
        for name, value in {"a": 0.6, "k": 9.0, "tau": 0.4}.items():
            h = 1e-4 * value
            up, down = run(**{name: value + h}), run(**{name: value - h})
            for output in ("s", "z"):
                difference = (up[output] - down[output]) / (2 * h)
                scale = np.abs(difference).max()
                found = slopes[f"sensitivity.{output}.{name}"]
                assert np.abs(found - difference).max() < 1e-6 * scale, (output, name)


def test_equal_to_careful_finite_differences() -> None:
    outputs = ("p", "x")
    with Simulator(build_model("Isotonic", sensitivities=_CHOSEN)) as exact:
        exact_values = exact.run(_TIMES, inputs=_INPUTS, tolerance=1e-9).values
    with Simulator(build_model("Isotonic")) as simulator:
        for name in _CHOSEN:
            value = simulator.interface.parameters[name].start
            assert value is not None
            h = 1e-4 * value
            shifted = [
                simulator.run(
                    _TIMES,
                    parameters={name: value + k * h},
                    inputs=_INPUTS,
                    outputs=outputs,
                    tolerance=1e-11,
                )
                for k in (-2, -1, 1, 2)
            ]
            for output in outputs:
                a, b, c, d = (s.values[output] for s in shifted)
                difference = (a - 8 * b + 8 * c - d) / (12 * h)
                slope = exact_values[f"sensitivity.{output}.{name}"]
                assert np.abs(slope - difference).max() < 1e-5 * np.abs(difference).max(), (
                    output,
                    name,
                )


@pytest.mark.full
def test_model_exchange_with_another_integrator_agrees() -> None:
    path = str(build_model("Isotonic", sensitivities=("load.m", "valve.C_A")))
    assert validate_fmu(path) == []
    columns = [("time", float), *((name, float) for name in _INPUTS.values)]
    rows = list(zip(_INPUTS.time, *_INPUTS.values.values(), strict=True))
    runs = [
        fmpy.simulate_fmu(path, fmi_type=kind, input=np.array(rows, dtype=columns), stop_time=2.5,
                          output_interval=0.05, relative_tolerance=1e-8)
        for kind in ("ModelExchange", "CoSimulation")
    ]  # fmt: skip
    for name in ("sensitivity.x.load.m", "sensitivity.p.valve.C_A"):
        times, slopes = np.unique(runs[0]["time"], return_index=True)
        reference = np.interp(times, runs[1]["time"], runs[1][name])
        assert np.abs(runs[0][name][slopes] - reference).max() < 1e-3 * np.abs(reference).max()


def test_state_of_the_fmu_holds_the_sensitivities(tmp_path: Path) -> None:
    path = build_fmu(with_sensitivities(_decay(), ("tau",)), tmp_path / "Decay.fmu")
    description = fmpy.read_model_description(str(path))
    fmu = fmpy.instantiate_fmu(fmpy.extract(str(path)), description, "CoSimulation")
    reference = next(
        v.valueReference for v in description.modelVariables if v.name == "sensitivity.y.tau"
    )
    fmu.setupExperiment(startTime=0.0)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()
    fmu.doStep(0.0, 0.33)
    state = fmu.getFMUState()
    first = [fmu.doStep(0.33, 0.4) or fmu.getReal([reference])[0]]
    fmu.setFMUState(state)
    assert [fmu.doStep(0.33, 0.4) or fmu.getReal([reference])[0]] == first
    fmu.freeFMUState(state)
    fmu.terminate()
    fmu.freeInstance()


def test_a_delayed_input_drives_the_sensitivities(tmp_path: Path) -> None:
    path = build_fmu(with_sensitivities(models.delayed_lag(), ("tau",)), tmp_path / "Lag.fmu")
    t = np.linspace(0.0, 3.0, 31)
    step = Inputs(np.array([0.0, 1.0, 1.0, 3.0]), {"u": np.array([0.0, 0.0, 2.0, 2.0])}, "linear")
    with Simulator(path) as simulator:
        sensitivity = simulator.run(t, inputs=step, tolerance=1e-8).values["sensitivity.y.tau"]
    since = np.maximum(t - 1.3, 0.0)
    assert sensitivity == pytest.approx(-2.0 * since / 0.25 * np.exp(-since / 0.5), abs=1e-5)


def test_delays_and_wrong_names_are_refused() -> None:
    delayed = models.delayed_lag()
    assert smooth_parameters(delayed) == ("tau",)
    with pytest.raises(InputError, match="length of a delay"):
        with_sensitivities(delayed, ["T"])
    with pytest.raises(InputError, match="no parameter 'nothing'"):
        with_sensitivities(_decay(), ["nothing"])
    with pytest.raises(InputError, match="named twice"):
        with_sensitivities(_decay(), ["a", "a"])


_FALLING = """model Falling
  parameter Real k(min = 0.1, max = 10) = 2 "Rate";
  input Real u = 0;
  output Real y;
  Real x(start = 1, fixed = true);
  Real half;
equation
  der(x) = u - k * x;
  half = x / 2;
  y = half + 1;
end Falling;
"""


def test_lean_model_simulates_as_the_whole_one_and_refuses_what_it_has_not() -> None:
    lean = build_source("Falling", _FALLING, sensitivities=["k"], lean=True)
    times = np.linspace(0.0, 2.0, 41)
    with (
        Simulator(lean) as small,
        Simulator(build_source("Falling", _FALLING, sensitivities=["k"])) as whole,
    ):
        assert "half" in whole.interface.locals and "half" not in small.interface.locals
        assert small.interface.settable.keys() == whole.interface.settable.keys()
        one, other = (s.run(times, parameters={"k": 3.0}).values for s in (small, whole))
        assert {n: v.tobytes() for n, v in one.items()} == {
            n: v.tobytes() for n, v in other.items()
        }
        assert one["y"] == pytest.approx(1 + np.exp(-3 * times) / 2, abs=1e-5)
        instance = small._instance.with_steps()
        with pytest.raises(FMICallException):
            instance.getDirectionalDerivative([0], [0], [1.0])
    assert lean.is_dir() and validate_fmu(str(lean)) == []
    with Simulator(lean) as again:  # closing it has left the files where they were
        assert again.run(times).time.size == times.size
