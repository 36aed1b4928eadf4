"""The tolerance asked for is met, on stiff and driven models, wherever the outputs lie."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from pam_cosim.simulation import Inputs, Simulator, SolverStatistics
from tests.fmu import models

Array = NDArray[np.float64]


def _robertson_like() -> models.Ode:
    """Three reactions with rates over nine decades; small states have their own nominal value."""
    ca = models.ca
    a, b, c = (ca.SX.sym(n) for n in "abc")
    slow, fast = -0.04 * a + 1e4 * b * c, 3e7 * b**2
    variables = {"b": models.Variable("b", nominal=1e-5)}
    states = {"a": (a, slow, 1.0), "b": (b, -slow - fast, 0.0), "c": (c, fast, 0.0)}
    return models.ode("Test.Robertson", states, {"y": b}, variables=variables, stop_time=100.0)


@cache
def _van_der_pol_reference(mu: float, end: float, count: int) -> Array:
    return np.asarray(
        solve_ivp(
            lambda t, y: [y[1], mu * ((1 - y[0] ** 2) * y[1] - y[0])],
            (0.0, end),
            [2.0, 0.0],
            method="Radau",
            jac=lambda t, y: [[0.0, 1.0], [mu * (-2 * y[0] * y[1] - 1), mu * (1 - y[0] ** 2)]],
            rtol=1e-12,
            atol=1e-13,
            t_eval=np.linspace(0.0, end, count),
        ).y
    )


def _errors(end: float, count: int, tolerances: Array) -> Array:
    exact, times = _van_der_pol_reference(1000.0, end, count)[0], np.linspace(0.0, end, count)
    with Simulator(models.fmu(models.van_der_pol)) as simulator:
        return np.array(
            [np.abs(simulator.run(times, tolerance=t)["y"] - exact).max() for t in tolerances]
        )


@pytest.mark.full
def test_stiff_branch_meets_the_tolerance() -> None:
    tolerances = 10.0 ** -np.arange(4.0, 10.0)
    assert np.all(_errors(0.7, 71, tolerances) < tolerances)


@pytest.mark.full
def test_error_is_proportional_to_the_tolerance() -> None:
    """Through two jumps of the relaxation oscillator, whose times carry the error of all that went before."""
    tolerances = 10.0 ** -np.arange(4.0, 10.0)
    errors = _errors(2.0, 11, tolerances)
    assert np.all(errors < tolerances)
    slope = np.polyfit(np.log10(tolerances), np.log10(errors), 1)[0]
    assert 0.8 < slope < 1.2, errors


def test_reaction_over_nine_decades() -> None:
    def f(t: float, y: Array) -> list[float]:
        slow, fast = -0.04 * y[0] + 1e4 * y[1] * y[2], 3e7 * y[1] ** 2
        return [slow, -slow - fast, fast]

    times = np.concatenate(([0.0], np.logspace(-4, 2, 60)))
    exact = solve_ivp(
        f, (0.0, 100.0), [1.0, 0, 0], method="Radau", rtol=1e-11, atol=1e-15, t_eval=times
    ).y
    with Simulator(models.fmu(_robertson_like)) as simulator:
        run = simulator.run(times, outputs=["a", "b", "c"], tolerance=1e-7)
    for name, reference, scale in zip("abc", exact, (1.0, 1e-5, 1.0), strict=True):
        assert np.abs(run[name] - reference).max() < 1e-6 * scale, name


def _run(count: int) -> tuple[float, Array, SolverStatistics]:
    with Simulator(models.fmu(models.van_der_pol)) as simulator:
        run = simulator.run(np.linspace(0.0, 2.0, count), tolerance=1e-7)
        statistics = simulator.statistics
    assert statistics is not None
    return float(run["y"][-1]), run["y"][:: (count - 1) // 10], statistics


def test_outputs_cost_no_steps() -> None:
    """10 or 10 000 output points: the same steps and the same values, bit for bit."""
    few, many = _run(11), _run(10001)
    assert few[0] == many[0]
    assert few[2] == many[2]
    assert few[1] == pytest.approx(many[1], abs=1e-13)


@pytest.mark.full
def test_dense_output_is_as_good_as_the_steps() -> None:
    exact = _van_der_pol_reference(1000.0, 0.7, 1401)[0]
    with Simulator(models.fmu(models.van_der_pol)) as simulator:
        simulated = simulator.run(np.linspace(0.0, 0.7, 1401), tolerance=1e-7)["y"]
        statistics = simulator.statistics
    assert statistics is not None and statistics.steps < 350  # most points lie inside a step
    assert np.abs(simulated - exact).max() < 1e-6


def _chain(t: Array, u0: float, slope: float, x0: float) -> Array:
    """x' = u - x with u = u0 + slope t."""
    return u0 - slope + slope * t + (x0 - u0 + slope) * np.exp(-t)


@pytest.mark.parametrize("count", [4, 301])
def test_ramps_and_steps_are_met_exactly(count: int) -> None:
    """A ramp, a step at a time that is no output, a second ramp: piecewise exact solution."""
    inputs = Inputs(
        np.array([0.0, 1.23, 1.23, 2.0, 3.0]),
        {"u": np.array([0.0, 1.23, 5.0, 5.0, 3.0]), "v": np.array([1.0, 1.0, 1.0, 1.0, 1.0])},
    )
    times = np.linspace(0.0, 3.0, count)
    x1 = _chain(np.array(1.23), 0.0, 1.0, 0.0)
    x2 = _chain(np.array(0.77), 5.0, 0.0, float(x1))
    exact = np.select(
        [times <= 1.23, times <= 2.0],
        [_chain(times, 0.0, 1.0, 0.0), _chain(times - 1.23, 5.0, 0.0, float(x1))],
        _chain(times - 2.0, 5.0, -2.0, float(x2)),
    )
    with Simulator(models.fmu(models.ramp_driven)) as simulator:
        run = simulator.run(times, inputs=inputs, tolerance=1e-9)
        statistics = simulator.statistics
    assert run["x_out"] == pytest.approx(exact, abs=5e-8)
    assert run["z_out"] == pytest.approx(times, abs=1e-12)
    assert statistics is not None and statistics.restarts == 2


def test_many_samples_on_a_line_are_one_ramp() -> None:
    """500 Hz records of a constant and a ramp cost what their two ends would cost."""
    time = np.arange(0.0, 4.0, 0.002)
    inputs = Inputs(time, {"u": 0.1 + 0.3 * time, "v": np.full_like(time, 0.35)})
    short = Inputs(time[[0, -1]], {k: v[[0, -1]] for k, v in inputs.values.items()})
    with Simulator(models.fmu(models.ramp_driven)) as simulator:
        runs = []
        for given in (inputs, short):
            run = simulator.run(np.linspace(0.0, 3.9, 14), inputs=given)
            runs.append((run["x_out"], simulator.statistics))
    assert runs[0][0] == pytest.approx(runs[1][0], abs=1e-9)
    assert runs[0][1] is not None and runs[0][1].restarts == 0
    assert runs[0][1].steps == runs[1][1].steps


def test_curved_records_are_followed() -> None:
    """A sine sampled at 100 Hz: every sample bends, and the result is that of the broken line."""
    time = np.linspace(0.0, 5.0, 501)
    u = np.sin(3.0 * time)
    inputs = Inputs(time, {"u": u})
    exact, x = [0.0], 0.0
    for i in range(time.size - 1):
        h = time[i + 1] - time[i]
        x = float(_chain(np.array(h), u[i], (u[i + 1] - u[i]) / h, x))
        exact.append(x)
    with Simulator(models.fmu(models.ramp_driven)) as simulator:
        run = simulator.run(time, inputs=inputs, tolerance=1e-8)
    assert run["x_out"] == pytest.approx(np.array(exact), abs=1e-7)


def test_model_that_changes_with_time_is_not_stepped_over() -> None:
    """At rest until a short pulse of its own clock."""
    ca = models.ca

    def pulse() -> models.Ode:
        t, x = ca.SX.sym("t"), ca.SX.sym("x")
        rate = ca.if_else(ca.logic_and(t > 50, t < 52), 1.0, 0.0)
        return models.ode("Test.Pulse", {"x": (x, rate, 0.0)}, {"y": x}, t=t, stop_time=100.0)

    with Simulator(models.fmu(pulse)) as simulator:
        assert simulator.run([0.0, 100.0], tolerance=1e-6)["y"][-1] == pytest.approx(2.0, abs=1e-4)
