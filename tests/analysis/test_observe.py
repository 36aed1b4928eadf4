"""The observer against known solutions, and against the force of the independent rig."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from scipy.linalg import solve_continuous_lyapunov, solve_discrete_are
from scipy.stats import multivariate_normal

import pam_cosim as pam
from pam_cosim.analysis.kalman import transition

ROOT = Path(__file__).parents[2]
MODEL = str(ROOT / "examples" / "observer" / "PulledMuscle.mo")
LAG = """
model Lag "One state that is measured"
  input Real u(start=0, unit="N");
  output Real y(unit="m");
  parameter Real tau(unit="s") = 0.5;
  Real x(start=0, fixed=true, nominal=1, unit="m");
equation
  tau*der(x) = u - x;
  y = x;
end Lag;
"""


@pytest.fixture
def lag(tmp_path: Path) -> str:
    (tmp_path / "Lag.mo").write_text(LAG)
    return str(tmp_path / "Lag.mo")


@pytest.fixture(scope="module")
def example() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "observer", ROOT / "examples" / "observer" / "observer.py"
    )
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.END = 3.5
    return module


@pytest.fixture(scope="module")
def run(example: ModuleType) -> tuple[np.ndarray, pam.Trajectory]:
    return example.truth()


def test_covariance_over_a_step() -> None:
    """A stiff system: exact by its eigenvalues; in the long run Lyapunov's equation."""
    slope, power = np.array([[-1.0, 0.3], [0.0, -5000.0]]), np.array([[0.2, 0.1], [0.1, 3.0]])
    over, added = transition(slope, power, 0.1)
    values, vectors = np.linalg.eig(slope)
    np.testing.assert_allclose(
        over, (vectors * np.exp(values * 0.1)) @ np.linalg.inv(vectors), atol=1e-12
    )
    whole = transition(slope, power, 100.0)[1]
    np.testing.assert_allclose(whole, solve_continuous_lyapunov(slope, -power), rtol=1e-8)
    np.testing.assert_allclose(added, whole - over @ whole @ over.T, rtol=1e-8)
    np.testing.assert_allclose(transition(np.zeros((1, 1)), np.eye(1), 0.25)[1], [[0.25]])


def test_settles_where_riccati_says(lag: str) -> None:
    """For a linear model the filter is Kalman's: its covariance settles at the solution of the Riccati equation."""
    time, tau, drift, noise = np.arange(0, 10, 0.1), 0.5, 0.3, 0.05
    zero = np.zeros(time.size)
    recording = pam.Trajectory(time, {"u": zero, "y": zero}, {"u": "N", "y": "m"})
    observation = pam.observe(
        lag, recording, noise={"y": noise}, drift={"x": drift}, spread={"x": 1.0}
    )
    over = np.exp(-0.1 / tau)
    added = drift**2 * tau / 2 * (1 - over**2)
    before = solve_discrete_are([[over]], [[1.0]], [[added]], [[noise**2]])[0, 0]
    after = before * noise**2 / (before + noise**2)
    assert observation.deviations["x"][-1] == pytest.approx(np.sqrt(after), rel=1e-3)
    assert observation.deviations["x"][0] == pytest.approx(1 / np.hypot(1, 1 / noise), rel=1e-6)


@pytest.mark.full
def test_an_input_that_nobody_measures(lag: str) -> None:
    """A constant one is found, and its uncertainty falls as that of a mean of samples does."""
    time = np.arange(0, 20, 0.05)
    chance = np.random.default_rng(3)
    y = 2 * (1 - np.exp(-time / 0.5)) + 0.1 * chance.standard_normal(time.size)
    recording = pam.Trajectory(time, {"y": y}, {"y": "m"})
    observation = pam.observe(
        lag, recording, noise={"y": 0.1}, unknown={"u": (5.0, 1e-6)}, spread={"x": 1e-3}
    )
    assert observation["u"][-1] == pytest.approx(2, abs=3 * observation.deviations["u"][-1])
    assert observation.deviations["u"][-1] == pytest.approx(0.1 / np.sqrt(time.size), rel=0.1)
    assert observation.is_consistent and abs(observation.whiteness["y"]) < 3 / np.sqrt(time.size)


def test_force_of_the_independent_rig(
    example: ModuleType, run: tuple[np.ndarray, pam.Trajectory]
) -> None:
    force, truth = run
    for rate in (10.0, 80.0):
        observation = example.observed(example.sampled(truth, rate, seed=11), force, 5.0)
        error = observation.errors(since=0.5)["F"]
        assert error.rms < 1.8 and 0.4 < error.nees < 1.6 and error.inside >= 0.9
        assert observation.nis < observation.nis_range[1]
    assert error.rms < example.without_filter(example.sampled(truth, rate, seed=11), force) / 3


def test_who_is_too_sure_is_told(
    example: ModuleType, run: tuple[np.ndarray, pam.Trajectory]
) -> None:
    force, truth = run
    observation = example.observed(example.sampled(truth, 20.0, seed=11), force, 0.5)
    assert (
        not observation.is_consistent
        and "too sure of itself" in str(observation)
        and observation.errors()["F"].nees > 3
    )


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"noise": {}}, "no signal is measured"),
        ({"noise": {"q": 1}}, "no column 'q'"),
        ({"noise": {"x": "1 kg"}}, "x=1 kg"),
        ({"noise": {"x": 0}}, "a standard deviation must be above zero"),
        ({"noise": {"x": 1e-160}}, "below the last digit of its samples"),
        ({"noise": {"u_in": 0.1}}, "'u_in' is an input"),
        ({"noise": {"p": 1}}, "no sample of 'p'"),
        ({"unknown": {"F": (1, 1)}}, "no input 'F'"),
        ({"unknown": {"u_in": (1, 1)}}, "'u_in' is recorded and unknown"),
        ({"drift": {"p": 1}}, "no state 'p'"),
        ({"spread": {"load.q": 1}}, "no state 'load.q'"),
        ({"start": {"p": "1 kg"}}, "p=1 kg"),
        ({"outputs": ["f"]}, "no variable 'f'"),
    ],
)
def test_bad_input(words: dict, message: str) -> None:
    time = np.array([0, 0.1])
    values = {"u_in": 0 * time, "x": 0 * time, "p": np.nan * time}
    recording = pam.Trajectory(time, values, {"u_in": "A", "x": "m", "p": "Pa"})
    with pytest.raises(pam.InputError, match=message):
        pam.observe(MODEL, recording, **({"noise": {"x": 1e-3}} | words))


def test_the_likelihood_is_that_of_all_readings_together(lag: str) -> None:
    """Of a linear model they are of one normal distribution: of two gauges of one state, at four times."""
    time, tau, drift, spread = np.array([0.0, 0.1, 0.4, 0.5]), 0.5, 0.3, 0.7
    y, x = np.array([0.5, -0.2, 0.4, 0.1]), np.array([0.4, -0.1, 0.1, 0.6])
    recording = pam.Trajectory(
        time, {"u": 0 * time, "y": y, "x": x}, {"u": "N", "y": "m", "x": "m"}
    )
    noise = {"y": 0.2, "x": 0.4}
    seen = pam.observe(lag, recording, noise=noise, drift={"x": drift}, spread={"x": spread})
    old = np.exp(-2 * time / tau)
    variance = old * spread**2 + (1 - old) * drift**2 * tau / 2
    earlier = np.minimum.outer(np.arange(4), np.arange(4))
    state = np.exp(-np.abs(np.subtract.outer(time, time)) / tau) * variance[earlier]
    whole = np.tile(state, (2, 2)) + np.diag(np.repeat([0.2**2, 0.4**2], 4))
    expected = multivariate_normal.logpdf(np.concatenate([y, x]), np.zeros(8), whole)
    assert seen.log_likelihood == pytest.approx(expected, rel=1e-5)
