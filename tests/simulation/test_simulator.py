"""Runs, failures, foreign FMUs and crashes."""

from __future__ import annotations

import gc
import os
import pickle
import sys
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.simulation import Inputs, RunFailure, Simulator
from tests.fmu import models
from tests.simulation.misbehaving import patched, repacked

TIMES = np.linspace(0.0, 2.0, 21)


def test_parameters_outputs_and_units() -> None:
    with Simulator(models.fmu(models.oscillator)) as simulator:
        run = simulator.run(
            TIMES,
            parameters={"k": 4.0, "m": 1.0, "s": 0.2},
            outputs=["s", "F", "E"],
            tolerance=1e-9,
        )
    assert run["s"] == pytest.approx(0.2 * np.cos(2.0 * TIMES), abs=1e-8)
    assert run["E"] == pytest.approx(np.full(21, 0.08), rel=1e-7)
    assert run.units == {"s": "m", "F": "N", "E": "J"}


def test_runs_are_independent_and_repeat_every_bit() -> None:
    with Simulator(models.fmu(models.lag)) as simulator:
        first = simulator.run(TIMES, inputs=Inputs([0.0, 1.0], {"u": [0.0, 1.0]}))
        simulator.run(TIMES, parameters={"tau": 0.01, "x_start": 3.0}, tolerance=1e-3)
        again = simulator.run(TIMES, inputs=Inputs([0.0, 1.0], {"u": [0.0, 1.0]}))
        rest = simulator.run(TIMES)
    assert first["y"].tolist() == again["y"].tolist() and first["y"][-1] > 0.5
    assert not rest["y"].any()


def test_threads_take_turns() -> None:
    """Without a turn they set and step one instance together: runs fail, or have values of the other."""
    with Simulator(models.fmu(models.lag)) as simulator, ThreadPoolExecutor(4) as threads:

        def end(start: float) -> float:
            return float(simulator.run(many, parameters={"x_start": start})["y"][-1])

        many = np.linspace(0.0, 2.0, 2001)
        starts = [1.0, 2.0, 3.0, 4.0] * 20
        alone = {start: end(start) for start in starts[:4]}
        assert list(threads.map(end, starts)) == [alone[start] for start in starts]


def test_start_time() -> None:
    with Simulator(models.fmu(models.lag)) as simulator:
        late = simulator.run([1.0, 2.0], parameters={"x_start": 1.0}, tolerance=1e-9)
        early = simulator.run(
            [1.0, 2.0], parameters={"x_start": 1.0}, start_time=0.0, tolerance=1e-9
        )
    assert late["y"] == pytest.approx([1.0, np.exp(-2.0)], rel=1e-7)
    assert early["y"] == pytest.approx([np.exp(-2.0), np.exp(-4.0)], rel=1e-7)


def test_feedthrough_before_and_after_a_step() -> None:
    inputs = Inputs(np.array([0.0, 1.0, 1.0]), {"u": np.array([2.0, 2.0, 7.0])})
    with Simulator(models.fmu(models.algebraic)) as simulator:
        run = simulator.run([0.0, 1.0, 1.0, 2.0], inputs=inputs)
        ramp = simulator.run([0.0, 0.5, 1.0], inputs=Inputs([0.0, 1.0], {"u": [0.0, 1.0]}))
    assert run["y"].tolist() == [6.0, 7.0, 22.0, 23.0]
    assert ramp["y"].tolist() == [0.0, 2.0, 4.0]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"parameters": {"taw": 1.0}}, "no parameter or input 'taw'; did you mean 'tau'?"),
        ({"parameters": {"x": 1.0}}, "'x' is a variable inside of Test.Lag and cannot be set"),
        ({"parameters": {"tau": float("nan")}}, "parameter 'tau' must be a finite number"),
        ({"outputs": ["feeed"]}, "no output 'feeed'; did you mean 'feed'?"),
        ({"inputs": Inputs([0.0], {"v": [0.0]})}, "no input 'v'; Known: u"),
    ],
)
def test_unknown_names(arguments: dict, message: str) -> None:  # type: ignore[type-arg]
    with Simulator(models.fmu(models.lag)) as simulator, pytest.raises(InputError) as caught:
        simulator.run(TIMES, **arguments)
    assert message in str(caught.value)


def test_breakdown_says_where_and_with_what() -> None:
    """x' = -1 - sqrt(x - 0.75) from 1: the real numbers end when x reaches the floor, at 0.38 s or so."""
    with Simulator(models.fmu(models.breaks_down)) as simulator:
        with pytest.raises(RunFailure) as caught:
            simulator.run(TIMES, parameters={"floor": 0.75})
        failure = caught.value
        assert isinstance(failure, SimulationFailure)
        assert "'tank.x'" in failure.reason and failure.parameters == {"floor": 0.75}
        assert failure.time is not None and 0.1 <= failure.time <= 0.2
        assert "floor = 0.75" in str(failure)
        copy = pickle.loads(pickle.dumps(failure))
        assert (str(copy), copy.time, copy.parameters) == (
            str(failure),
            failure.time,
            failure.parameters,
        )
        good = simulator.run(np.linspace(0, 0.1, 5), parameters={"floor": -9.0})
    assert np.isfinite(good["y"]).all()


def test_not_a_number_from_the_start() -> None:
    with Simulator(models.fmu(models.breaks_down)) as simulator:
        with pytest.raises(
            RunFailure, match="derivative of 'tank.x' is not a finite number at time 0 s"
        ):
            simulator.run(TIMES, parameters={"floor": 2.0})
        with pytest.raises(RunFailure, match="slope of der\\('tank.x'\\) with respect to 'tank.x'"):
            simulator.run(TIMES, parameters={"floor": 1.0})


def test_output_that_is_not_a_number() -> None:
    ca = models.ca

    def root() -> models.Ode:
        u = ca.SX.sym("u")
        return models.ode("Test.Root", {}, {"y": ca.sqrt(u)}, inputs={"u": u})

    inputs = Inputs([0.0, 1.0], {"u": [1.0, -1.0]})
    message = "'y' is not a finite number at time 1 s"
    with Simulator(models.fmu(root)) as simulator, pytest.raises(RunFailure, match=message):
        simulator.run([0.0, 1.0], inputs=inputs)


def test_time_limit() -> None:
    with Simulator(models.fmu(models.van_der_pol)) as simulator:
        times = np.linspace(0.0, 2000.0, 200_001)
        with pytest.raises(RunFailure, match="longer than it may"):
            simulator.run(times, tolerance=1e-10, max_seconds=0.02)
        assert simulator.run([0.0, 1.0])["y"].size == 2


def test_limit_of_steps() -> None:
    with Simulator(models.fmu(models.oscillator)) as simulator:
        long = np.linspace(0.0, 1000.0, 11)
        simulator.most_steps = (100, 1)
        with pytest.raises(RunFailure, match="far more steps than is usual") as failure:
            simulator.run(long)
        assert failure.value.time is not None and failure.value.time < 1000.0
        simulator.most_steps = (0, 100_000)
        assert simulator.run(long)["s"].shape == (11,)


@pytest.mark.full
def test_thousands_of_runs_in_one_process() -> None:
    """Neither memory nor open files grow, over runs and over instances."""

    def resident() -> int:
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * 4096

    if not sys.platform.startswith("linux"):
        pytest.skip("reads /proc")
    with Simulator(models.fmu(models.lag)) as simulator:
        for _ in range(200):
            simulator.run(TIMES)
        gc.collect()
        before = resident()
        for i in range(3000):
            simulator.run(TIMES, parameters={"tau": 0.1 + 1e-4 * i})
        gc.collect()
        assert resident() - before < 2_000_000
    files = len(os.listdir("/proc/self/fd"))
    for _ in range(30):
        with Simulator(models.fmu(models.lag)) as simulator:
            simulator.run(TIMES)
    assert len(os.listdir("/proc/self/fd")) <= files


def test_closing_removes_the_files() -> None:
    simulator = Simulator(models.fmu(models.lag))
    folder = Path(simulator._directory)
    assert folder.exists()
    simulator.close()
    simulator.close()
    assert not folder.exists()
    with pytest.raises(RuntimeError, match="closed"):
        simulator.run(TIMES)


def test_a_thousand_outputs_take_no_step_more_than_three() -> None:
    with Simulator(models.fmu(models.van_der_pol)) as simulator:
        work = []
        for count in (3, 1001):
            simulator.run(np.linspace(0.0, 2.0, count), tolerance=1e-6)
            work.append(simulator.statistics)
    assert work[0] is not None and work[0] == work[1]
    assert 100 < work[0].steps < 1000 and work[0].restarts == 0


# --- FMUs of other tools ----------------------------------------------------------------------------------------


def test_fmu_without_slopes_gets_steps_of_the_default_interval(tmp_path: Path) -> None:
    change = {'canInterpolateInputs="true"': 'canInterpolateInputs="false"'}
    path = repacked(models.fmu(models.lag), tmp_path / "x.fmu", change)
    with Simulator(path) as simulator:
        run = simulator.run(TIMES, inputs=Inputs([0.0, 2.0], {"u": [0.0, 2.0]}), tolerance=1e-8)
    exact = TIMES - 0.5 + 0.5 * np.exp(-TIMES / 0.5)
    error = np.abs(run["y"] - exact).max()
    interval = simulator.interface.interval
    assert 1e-5 < error < interval**2 / 6  # means over each step; held inputs lag by half of it


def test_fmu_that_cannot_be_reset_is_made_anew(tmp_path: Path) -> None:
    reset = "ASK(ANY_KIND, ANY, pam_reset(c))"
    with Simulator(
        patched(tmp_path, "pam_fmi2.c", reset, "(void)component; return fmi2Error")
    ) as simulator:
        runs = [simulator.run(TIMES, parameters={"x_start": 1.0})["y"].tolist() for _ in range(3)]
    assert runs[0] == runs[1] == runs[2]


def test_fmu_without_a_binary_for_this_platform(tmp_path: Path) -> None:
    path = tmp_path / "x.fmu"
    with zipfile.ZipFile(models.fmu(models.lag)) as old, zipfile.ZipFile(path, "w") as new:
        new.writestr("modelDescription.xml", old.read("modelDescription.xml"))
    with pytest.raises(
        InputError, match="has no binary for this machine, binaries/.*; it has none"
    ):
        Simulator(path)


def test_binary_that_is_none(tmp_path: Path) -> None:
    path = repacked(models.fmu(models.lag), tmp_path / "x.fmu", binary=b"nothing")
    here = os.getcwd()
    with pytest.raises(InputError, match="cannot be loaded"):
        Simulator(path)
    assert os.getcwd() == here


def test_guid_that_does_not_belong(tmp_path: Path) -> None:
    path = repacked(models.fmu(models.lag), tmp_path / "x.fmu", {'guid="{': 'guid="{0'})
    with pytest.raises(SimulationFailure, match="GUID does not belong"):
        Simulator(path)


def test_a_step_without_slopes_holds_an_input_at_its_middle(tmp_path: Path) -> None:
    """From 0 to 0.2 within the step: the lag sees 0.1, and what follows at once is read at its end."""
    change = {'canInterpolateInputs="true"': 'canInterpolateInputs="false"'}
    path = repacked(models.fmu(models.lag), tmp_path / "x.fmu", change)
    with Simulator(path) as simulator:
        stepper = simulator.stepper()
        stepper.begin({"tau": 0.5}, tolerance=1e-8)
        stepper.initialised()
        y, feed = stepper.advance(0.1, {"u": 0.0}, {"u": 2.0}, ["y", "feed"])
        stepper.close()
    assert y == pytest.approx(0.1 * (1 - np.exp(-0.1 / 0.5)), rel=1e-5)
    assert feed == pytest.approx(0.2 + 2 * y)
