"""Linear models against formulas, against differences, and in the hands of scipy and python-control."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from tests.simulation.misbehaving import repacked

INTEGRATOR = """
model Heater "A store that is heated and loses nothing"
  input Real u(start=2, unit="W");
  output Real T(unit="K");
  parameter Real C(unit="J/K") = 5;
  Real x(start=290, fixed=true, unit="K");
equation
  C*der(x) = u;
  T = x;
end Heater;
"""


@pytest.fixture
def modelica(tmp_path: Path):
    def write(text: str) -> str:
        path = tmp_path / f"{text.split()[1]}.mo"
        path.write_text(text)
        return str(path)

    return write


def test_the_matrices_of_the_slides() -> None:
    tau, c_1, c_2, k, b, m = 0.1, 5.7238e-4, 8061.8, 500.0, 60.0, 2.0
    linear = pam.linearise("LumpedLinear")
    assert (linear.states, linear.inputs, linear.outputs) == (
        ("P", "l", "v"),
        ("p_in",),
        ("p", "L", "F"),
    )
    np.testing.assert_allclose(
        linear.A, [[-1 / tau, 0, 0], [0, 0, 1], [-c_1 / m, -(c_2 + k) / m, -b / m]], rtol=1e-12
    )
    np.testing.assert_allclose(linear.B, [[1 / tau], [0], [0]], rtol=1e-12)
    np.testing.assert_allclose(linear.C, [[1, 0, 0], [0, 1, 0], [c_1, c_2, 0]], rtol=1e-12)
    assert not linear.D.any()
    assert linear.units == {
        "P": "Pa",
        "l": "m",
        "v": "m/s",
        "p_in": "Pa",
        "p": "Pa",
        "L": "m",
        "F": "N",
    }
    swing = np.sqrt((c_2 + k) / m)
    slow, fast = linear.modes
    assert slow.time_constant == pytest.approx(tau) and slow.shares["P"] == pytest.approx(1)
    assert fast.frequency == pytest.approx(swing / (2 * np.pi)) and fast.damping == pytest.approx(
        b / m / (2 * swing)
    )
    assert linear.static_gain[1, 0] == pytest.approx(-c_1 / (c_2 + k))
    assert linear.is_stable and "time constant 0.1 s (P 100%)" in str(linear)


def test_small_steps_of_the_model_are_those_of_the_linear_one() -> None:
    """An independent check of every number on the way from current to contraction."""
    linear_model = pam.linearise(
        "Isotonic", {"u_out": 0.25}, at={"p": "1 bar"}, free=["u_in"]
    ).select(["u_in"], ["p", "x"])
    at = linear_model.point.inputs["u_in"]
    time, size = np.array([0, 60, 60, 70.0]), 1e-3

    def stepped(by: float) -> pam.Trajectory:
        steps = pam.Inputs(time, {"u_in": at + by * np.array([0, 0, 1, 1])})
        return pam.simulate("Isotonic", {"u_out": 0.25}, steps)

    up, down = stepped(size), stepped(-size)  # their difference is free of the curvature
    after = up.time > 60
    linear = linear_model.step(up.time[after] - 60)[:, :, 0]
    for i, name in enumerate(linear_model.outputs):
        real = (up[name] - down[name])[after] / (2 * size)
        np.testing.assert_allclose(real, linear[:, i], atol=1e-3 * np.abs(linear[:, i]).max())


def test_a_state_is_found_from_outputs() -> None:
    linear = pam.linearise("Isotonic", at={"p": "60 kPa", "x": "30 mm", "u_in": 0.2})
    assert linear.point.outputs["p"] == pytest.approx(60e3) and linear.point.states[
        "load.s"
    ] == pytest.approx(0.03)
    assert linear.point.states["muscle.gas.p"] == pytest.approx(60e3 + 101325)
    assert linear.point.inputs["u_in"] == 0.2 and linear.point.states["load.v"] == 0
    assert "Not at rest" in linear.notes[-1]


@pytest.mark.full
def test_differences_where_an_fmu_has_no_derivatives(tmp_path: Path) -> None:
    """Such an FMU is foreign: it runs in a process of its own."""
    built = pam.build("Isotonic")
    foreign = repacked(built, tmp_path / "f.fmu", {'providesDirectionalDerivative="true"': ""})
    exact = pam.linearise("Isotonic", at={"p": "60 kPa", "x": "30 mm"})
    other = pam.linearise(str(foreign), at={"p": "60 kPa", "x": "30 mm"})
    assert (
        exact.method != other.method
        and "central differences" in other.notes[0]
        and not exact.notes[:-1]
    )
    for name in "ABCD":
        one, two = getattr(exact, name), getattr(other, name)
        np.testing.assert_allclose(two, one, rtol=1e-6, atol=1e-7 * np.abs(one).max(initial=0.0))


def test_along_a_run() -> None:
    times = [0.5, 1.0, 3.0]
    steps = pam.Inputs([0, 2, 2, 4], {"u_in": [0.35, 0.35, 0, 0], "u_out": [0, 0, 0.35, 0.35]})
    course = pam.linearise_along("Isotonic", inputs=steps, times=times)
    assert course.times.tolist() == times and course.poles.shape == (3, 3)
    run = pam.simulate("Isotonic", inputs=steps, interval=0.5)
    assert course[2].point.outputs["x"] == pytest.approx(
        float(np.interp(3.0, run.time, run["x"])), rel=1e-4
    )
    assert course[2].point.inputs["u_out"] == 0.35
    one = pam.linearise("Isotonic", at=1.0, inputs=steps)
    np.testing.assert_allclose(one.A, course[1].A, rtol=1e-5, atol=1e-3)


def test_no_rest(modelica) -> None:
    heater = modelica(INTEGRATOR)
    with pytest.raises(
        pam.InputError, match=r"no rest was found.*x still changes by 0.4 K/s.*free: u"
    ):
        pam.linearise(heater)
    linear = pam.linearise(heater, free=["u"])
    assert linear.point.inputs["u"] == pytest.approx(0, abs=1e-5) and "integrates" in str(linear)
    assert np.isnan(linear.static_gain).all() and not linear.is_stable


def test_fewer_states_keep_the_static_gain() -> None:
    whole = pam.linearise("Isotonic", {"u_out": 0.25}, at={"p": "1 bar"}, free=["u_in"])
    small = whole.select(["u_in"], ["x"], ["muscle.gas.p"])
    assert small.A.shape == (1, 1) and "quasi-static" in small.notes[-1]
    assert small.static_gain[0, 0] == pytest.approx(whole.static_gain[1, 0], rel=1e-10)
    assert -1 / small.A[0, 0] == pytest.approx(whole.modes[0].time_constant, rel=0.1)
    with pytest.raises(pam.InputError, match="no output 'xx'; did you mean 'x'"):
        whole.select(outputs=["xx"])


def test_for_scipy_and_python_control() -> None:
    import control

    linear = pam.linearise("LumpedLinear")
    times = np.linspace(0, 1, 201)
    ours = linear.step(times)[:, :, 0]
    from scipy import signal  # half a second, of which nothing else has any use

    scipy_s = signal.step(linear.to_scipy(), T=times)[1]
    np.testing.assert_allclose(ours, scipy_s, atol=1e-9 * np.abs(ours).max())
    system = linear.to_control()
    assert system.state_labels == ["P", "l", "v"] and system.input_labels == ["p_in"]
    np.testing.assert_allclose(np.sort_complex(system.poles()), np.sort_complex(linear.poles))
    frequencies = np.array([0.1, 1, 10, 20])
    theirs = control.frequency_response(system, 2 * np.pi * frequencies).complex
    np.testing.assert_allclose(
        np.moveaxis(linear.response(frequencies), 0, -1), theirs.reshape(3, 1, 4), rtol=1e-9
    )
    assert pam.linearise("Isotonic").to_control().state_labels[0] == "muscle_gas_p"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"at": {"q": 1}}, "no variable 'q'"),
        ({"at": {"load.m": 1}}, "'load.m' is a parameter"),
        ({"at": {"p": "3 kg"}}, "p=3 kg"),
        ({"at": {"T": 400, "p": "1 bar"}}, "no state was found at which"),
        ({"at": "start"}, "'start' is no point"),
        ({"free": ["u"]}, "no input 'u'"),
        ({"at": {"u_in": 0.2}, "free": ["u_in"]}, "'u_in' is given and free"),
        ({"at": -1.0}, "the times must increase, from 0 s on"),
        ({"outputs": ["y"]}, "no variable 'y'"),
        ({"parameters": {"mass": 1}}, "no parameter or input 'mass'"),
        ({"timeout": 0.0}, "a time limit"),
    ],
)
def test_bad_input(words: dict, message: str) -> None:
    with pytest.raises(pam.InputError, match=message.replace("(", r"\(")):
        pam.linearise("Isotonic", **words)
