"""Delayed inputs against exact solutions: jumps come out at their time plus the delay, wherever the outputs lie."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from pam_cosim.errors import SimulationFailure
from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Inputs, Simulator, SolverStatistics
from pam_cosim.simulation.inputs import Pieces, pieces
from tests.fmu import models

Array = NDArray[np.float64]

RAMP_AND_STEPS = Inputs(
    np.array([0.0, 0.4, 0.4, 0.45, 0.45, 0.5, 0.5, 0.7, 1.9, 1.9, 3.0]),
    {"u": np.array([1.0, 1.0, 3.0, 3.0, -2.0, -2.0, 0.5, 0.5, 2.9, 0.0, 0.0])},
)
STEP = Inputs(np.array([0.0, 0.777, 0.777, 3.0]), {"u": np.array([0.0, 0.0, 1.0, 1.0])})
RAMP = Inputs(np.array([0.0, 3.0]), {"u": np.array([0.5, 2.0])})


def _delayed(inputs: Inputs, name: str, delay: float) -> Pieces:
    line = pieces(inputs.time, inputs.values[name], inputs.interpolation)
    return Pieces(line.time + delay, line.value, line.slope)


def _exact_lag(inputs: Inputs, delay: float, times: Array, tau: float = 0.5) -> Array:
    """x' = (u(t - delay) - x)/tau from x(0) = 0, line by line."""
    lines = _delayed(inputs, "u", delay)
    ends = np.append(lines.time[1:], np.inf)
    x_of_times, x, begin = np.full(times.shape, np.nan), 0.0, 0.0
    for end in ends[ends > 0.0]:
        value, slope = (float(v) for v in lines.at(np.array(begin)))
        steady = value - slope * tau

        def at(
            t: Array, b: float = begin, s: float = steady, k: float = slope, x0: float = x
        ) -> Array:
            return s + k * (t - b) + (x0 - s) * np.exp(-(t - b) / tau)

        inside = (times >= begin) & (times <= end)
        x_of_times[inside] = at(times[inside])
        if np.isfinite(end):
            x, begin = float(at(end)), float(end)
    return x_of_times


@pytest.mark.parametrize("count", [11, 10001])
@pytest.mark.parametrize("delay", [0.0, 1e-12, 1e-3, 0.05, 0.3, 1.3, 100.0])
@pytest.mark.parametrize("inputs", [STEP, RAMP, RAMP_AND_STEPS], ids=["step", "ramp", "several"])
def test_exact_solution(inputs: Inputs, delay: float, count: int) -> None:
    """The delay is none at all, less than the distance of two jumps, more than that, longer than the run."""
    times = np.linspace(0.0, 3.0, count)
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        run = simulator.run(times, inputs=inputs, parameters={"T": delay}, tolerance=1e-9)
    assert run["y"] == pytest.approx(_exact_lag(inputs, delay, times), abs=2e-8)


@pytest.mark.parametrize("start", [0.0, -7.5, 1e4])
def test_runs_may_start_at_any_time(start: float) -> None:
    times = np.linspace(0.0, 3.0, 31)
    late = Inputs(RAMP_AND_STEPS.time + start, RAMP_AND_STEPS.values)
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        run = simulator.run(times + start, inputs=late, tolerance=1e-9)
    assert run["y"] == pytest.approx(_exact_lag(RAMP_AND_STEPS, 0.3, times), abs=2e-8)


def test_valves_that_open_late() -> None:
    """The library's dead time, from a command at the very start of the run: all is late, and nothing else."""
    delay, times = 0.05, np.linspace(0.0, 4.0, 81)
    inputs = Inputs(
        np.array([0.0, 1.5, 1.5, 2.0, 2.0]),
        {
            "u_in": np.array([0.35, 0.35, 0.0, 0.0, 0.0]),
            "u_out": np.array([0.0, 0.0, 0.0, 0.0, 0.35]),
        },
    )
    model = "model Late extends PneumaticMuscle.Benches.Isotonic(valve(redeclare model Drive = "
    model += "PneumaticMuscle.Effects.ValveDynamics.ValveDelay)); end Late;"
    runs = []
    for path, shift in ((build_model("Isotonic"), 0.0), (build_source("Late", model), delay)):
        with Simulator(path) as simulator:
            held = {} if shift == 0.0 else {"valve.drive.dead_time": delay}
            wanted = np.concatenate(([0.0], times + shift))
            runs.append(
                simulator.run(
                    wanted, inputs=inputs, parameters=held, outputs=["p", "x"], tolerance=1e-9
                )
            )
    for name, scale in (("p", 2e5), ("x", 0.05)):
        assert runs[0][name][0] == runs[1][name][0]
        assert runs[1][name][1:] == pytest.approx(runs[0][name][1:], abs=1e-5 * scale)
    assert runs[0]["x"].max() > 0.02


@pytest.mark.parametrize(
    "make", [models.delayed_lag, models.delayed_gain], ids=lambda make: make.__name__
)
@pytest.mark.parametrize(
    "spacing", [[0.0, 1.0], [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]]
)
def test_a_jump_comes_out_at_its_time_plus_the_delay(make: object, spacing: list[float]) -> None:
    """To rounding: not at a communication point before or after."""
    jump, delay = 0.31234, 0.29876
    out = jump + delay
    inputs = Inputs(np.array([0.0, jump, jump]), {"u": np.array([2.0, 2.0, 7.0])})
    times = np.sort(np.concatenate((spacing, [out - 1e-11, out + 1e-11, 2.0])))
    name, early, late = (
        ("echo", 2.0, 7.0) if make is models.delayed_lag else ("y", 7.0 + 20.0, 7.0 + 70.0)
    )
    with Simulator(models.fmu(make)) as simulator:  # type: ignore[arg-type]
        values = simulator.run(times, inputs=inputs, parameters={"T": delay})[name]
    assert values[times > out] == pytest.approx(late, abs=0.0)
    assert values[(times > jump) & (times < out)] == pytest.approx(early, abs=0.0)


def _cost(count: int, tolerance: float = 1e-7) -> tuple[Array, SolverStatistics]:
    times = np.linspace(0.0, 3.0, count)
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        run = simulator.run(times, inputs=RAMP_AND_STEPS, tolerance=tolerance)
        assert simulator.statistics is not None
        return run["y"][:: (count - 1) // 10], simulator.statistics


def test_outputs_cost_no_steps() -> None:
    few, many = _cost(11), _cost(10001)
    assert few[0] == pytest.approx(many[0], abs=1e-13)
    assert few[1].steps <= many[1].steps + 2 and many[1].steps < 120


def test_delay_costs_no_more_than_the_same_jumps_at_once() -> None:
    """Where the solver knows of a change beforehand it ends a step there and throws none away."""
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        steps = []
        for delay in (0.0, 0.3):
            simulator.run(
                np.linspace(0.0, 3.0, 301),
                inputs=RAMP_AND_STEPS,
                parameters={"T": delay},
                tolerance=1e-7,
            )
            assert simulator.statistics is not None
            steps.append(simulator.statistics.steps)
    assert steps[1] <= 1.1 * steps[0]


def test_runs_with_other_delays_do_not_disturb_each_other() -> None:
    times = np.linspace(0.0, 3.0, 201)
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        by_turn = {}
        for turn, delay in enumerate((0.3, 0.01, 1.2, 0.3)):
            run = simulator.run(
                times, inputs=RAMP_AND_STEPS, parameters={"T": delay}, tolerance=1e-9
            )
            by_turn[turn] = run["y"]
            assert run["y"] == pytest.approx(_exact_lag(RAMP_AND_STEPS, delay, times), abs=2e-8)
    assert np.array_equal(by_turn[0], by_turn[3])


def test_curved_records_are_followed() -> None:
    """Every sample of a sine at 500 Hz bends; there are 150 bends inside the delay."""
    time = np.linspace(0.0, 3.0, 1501)
    inputs = Inputs(time, {"u": 1.0 + np.sin(3.0 * time)})
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        run = simulator.run(time, inputs=inputs, tolerance=1e-8)
    assert run["y"] == pytest.approx(_exact_lag(inputs, 0.3, time), abs=1e-7)


def test_result_is_smooth_in_the_delay() -> None:
    """What least squares needs: differences of 1e-5 s give the derivative -tau' of the exact solution."""
    times, h = np.linspace(0.0, 3.0, 61), 1e-5
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        for delay in (0.0501, 0.2, 0.2503):
            sides = [
                simulator.run(
                    times, inputs=RAMP_AND_STEPS, parameters={"T": delay + s * h}, tolerance=1e-8
                )["y"]
                for s in (-1, 1)
            ]
            exact = [_exact_lag(RAMP_AND_STEPS, delay + s * h, times) for s in (-1, 1)]
            assert (sides[1] - sides[0]) / (2 * h) == pytest.approx(
                (exact[1] - exact[0]) / (2 * h), abs=2e-3
            )


def test_negative_delay_is_refused() -> None:
    with Simulator(models.fmu(models.delayed_lag)) as simulator:
        with pytest.raises(SimulationFailure, match="a delay of an input is -0.1 s"):
            simulator.run([0.0, 1.0], parameters={"T": -0.1})
        assert np.isfinite(simulator.run([0.0, 1.0])["y"]).all()


def _random_inputs(chance: np.random.Generator) -> Inputs:
    """Jumps and ramps at times that both inputs share."""
    inner = np.sort(chance.uniform(0.0, 4.0, 9))
    time = np.concatenate(([0.0], np.repeat(inner, 2), [4.0]))
    values = {}
    for name in "uv":
        ends = chance.normal(size=time.size)
        continuous = chance.uniform(size=9) < 0.4
        ends[2:-1:2] = np.where(continuous, ends[1:-1:2], ends[2:-1:2])
        values[name] = ends
    return Inputs(time, values)


def _reference_mix(inputs: Inputs, delay: float, times: Array) -> Array:
    """``delayed_mix`` by an explicit method of order 8, begun again at every change of every input."""
    u = _delayed(inputs, "u", 0.0)
    d, e, g = (
        _delayed(inputs, n, t) for n, t in (("u", delay), ("v", 0.1 + delay / 2), ("u", 2 * delay))
    )
    changes = np.unique(np.concatenate([line.time for line in (u, d, e, g)]))
    ends = np.concatenate((changes[(changes > 0.0) & (changes < times[-1])], [times[-1]]))
    state, begin, columns = np.array([0.2, 1.0]), 0.0, []
    for end in ends:
        middle = np.array((begin + end) / 2)
        straight = [(line.at(middle), middle) for line in (u, d, e, g)]

        def rate(
            t: float, y: Array, straight: list[tuple[tuple[Array, Array], Array]] = straight
        ) -> list[float]:
            now, du, ev, gu = (float(v + s * (t - m)) for (v, s), m in straight)
            return [du - y[0] ** 3 + np.sin(ev), now * gu - y[1] * abs(y[0])]

        inside = times[(times > begin) & (times <= end)]
        wanted = np.unique(np.append(inside, end))
        solution = solve_ivp(rate, (begin, end), state, "DOP853", wanted, rtol=1e-11, atol=1e-12)
        columns.append(solution.y[:, : inside.size])
        state, begin = solution.y[:, -1], float(end)
    return np.concatenate([np.array([[0.2], [1.0]]), *columns], axis=1)


@pytest.mark.parametrize("seed", range(12))
def test_random_inputs_and_delays(seed: int) -> None:
    chance = np.random.default_rng(seed)
    inputs, delay = _random_inputs(chance), float(10.0 ** chance.uniform(-2.5, 0.2))
    times = np.linspace(0.0, 4.0, int(chance.choice([5, 41, 401])))
    exact = _reference_mix(inputs, delay, times)
    with Simulator(models.fmu(models.delayed_mix)) as simulator:
        run = simulator.run(times, inputs=inputs, parameters={"T": delay}, tolerance=1e-9)
    assert run["x_out"] == pytest.approx(exact[0], abs=2e-7)
    assert run["z_out"] == pytest.approx(exact[1], abs=2e-7)
