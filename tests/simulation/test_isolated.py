"""FMUs that crash or never return end one run, and leave no process and no file behind."""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.errors import InputError
from pam_cosim.fitting import fit
from pam_cosim.measurement import FreeParameter
from pam_cosim.simulation import Inputs, IsolatedSimulator, RunFailure, Simulator
from tests.fitting.models import data_set, recording
from tests.fmu import models
from tests.simulation.misbehaving import hanging, patched, processes_of

TIMES = np.linspace(0.0, 2.0, 21)
LIMIT = 2.0  # [s] in which a process that waits for its processor comes to the call that hangs
DAWDLING = 1.0  # [s] for steps of 0.15 s
STEP = "pam_core *core = &c->core;"

needs_proc = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder for temporary files of this process and of those that it starts."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    return folder


def test_isolated_run_equals_run() -> None:
    with Simulator(models.fmu(models.lag)) as simulator:
        here = simulator.run(TIMES, parameters={"x_start": 1.0})
    with IsolatedSimulator(models.fmu(models.lag)) as simulator:
        there = simulator.run(TIMES, parameters={"x_start": 1.0})
    assert here["y"].tolist() == there["y"].tolist()


def test_crash_ends_one_run_only(tmp_path: Path) -> None:
    path = patched(tmp_path, "pam_cosimulation.c", STEP, f"if (now > 0.99) abort(); {STEP}")
    with IsolatedSimulator(path) as simulator:
        good = simulator.run(TIMES[:5], parameters={"x_start": 1.0})
        with pytest.raises(RunFailure, match="crashed its process \\(signal SIGABRT\\)"):
            simulator.run(TIMES)
        assert (
            simulator.run(TIMES[:5], parameters={"x_start": 1.0})["y"].tolist()
            == good["y"].tolist()
        )
        with pytest.raises(InputError, match="no parameter or input 'taw'"):
            simulator.run(TIMES, parameters={"taw": 1.0})


_EVERY = (
    "fmi2SetupExperiment",
    "fmi2EnterInitializationMode",
    "fmi2ExitInitializationMode",
    "fmi2SetReal",
)
_LATER = ("fmi2GetReal", "fmi2SetRealInputDerivatives", "fmi2Terminate")


@needs_proc
@pytest.mark.parametrize(
    "function",
    [
        "fmi2DoStep",
        *(
            pytest.param(f, marks=pytest.mark.full)
            for f in ("load", "fmi2Instantiate", *_EVERY, *_LATER)
        ),
    ],
)
def test_call_that_never_returns(
    tmp_path: Path, temporary: Path, monkeypatch: pytest.MonkeyPatch, function: str
) -> None:
    monkeypatch.setenv("HANG", function)
    path = hanging(tmp_path)
    with IsolatedSimulator(path, LIMIT) as simulator, pytest.raises(RunFailure) as caught:
        simulator.run(TIMES, parameters={"tau": 0.7}, inputs=Inputs([0.0, 2.0], {"u": [0.0, 1.0]}))
    loading = function in ("load", "fmi2Instantiate")
    assert f"no progress for {LIMIT:g} s, {'while it was loaded' if loading else function}" in str(
        caught.value
    )
    assert "--timeout" in str(caught.value) and caught.value.parameters == {"tau": 0.7}
    assert caught.value.time == (
        None if loading else pytest.approx(2.0 if function == "fmi2Terminate" else 0.0)
    )
    assert processes_of(path) == [] and os.listdir(temporary) == []


@needs_proc
def test_fmu_that_is_never_freed(
    tmp_path: Path, temporary: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HANG", "fmi2FreeInstance")
    path = hanging(tmp_path)
    with IsolatedSimulator(path) as simulator:
        assert simulator.run(TIMES)["y"].size == 21
        assert len(processes_of(path)) == 2
    assert processes_of(path) == [] and os.listdir(temporary) == []


@pytest.mark.full
def test_one_that_hangs_while_it_is_loaded_is_not_loaded_again(tmp_path: Path) -> None:
    path = hanging(tmp_path, "load")
    assert study.describe(str(path)).parameters["tau"].start == 0.5  # read without loading it
    points = study.sweep(str(path), {"tau": np.linspace(0.1, 1.0, 200)}, timeout=LIMIT)
    assert [p for p in points if "while it was loaded" not in str(p.failure)] == [] and len(
        points
    ) == 200


@pytest.mark.full
def test_slow_run_that_goes_on_is_not_ended(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DAWDLE", "yes")
    begin = time.monotonic()
    with IsolatedSimulator(hanging(tmp_path), DAWDLING) as simulator:
        result = simulator.run(TIMES, parameters={"x_start": 1.0})
    assert time.monotonic() - begin > 20 * 0.15 > 2.5 * DAWDLING
    assert result["y"] == pytest.approx(np.exp(-TIMES / 0.5), abs=1e-4)


def test_there_is_a_limit_by_default() -> None:
    with IsolatedSimulator(models.fmu(models.lag)) as simulator:
        assert 10.0 <= simulator.timeout <= 60.0
    with pytest.raises(InputError, match="time limit must be larger than zero"):
        IsolatedSimulator(models.fmu(models.lag), 0.0)


@pytest.mark.full
def test_fit_goes_on_beside_values_that_hang(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("HANG_ABOVE", "1")
    y = np.exp(-TIMES / 0.6) + 0.01 * np.random.default_rng(0).standard_normal(len(TIMES))
    known = {"x_start": 1.0}
    data = data_set(
        "Lag",
        [recording(TIMES, {"y": y})],
        {"y": 0.01},
        [FreeParameter("tau", 0.1, 5.0, 1.2, "s")],
        known,
    )
    with IsolatedSimulator(hanging(tmp_path), LIMIT) as simulator:
        result = fit(simulator, data)
    estimate = result.parameters["tau"]
    assert estimate.low <= 0.6 <= estimate.high
    assert result.failures and f"no progress for {LIMIT:g} s, fmi2SetReal" in result.failures[0]
