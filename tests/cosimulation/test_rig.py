"""A model driven step by step: as a loop in the laboratory, with any FMU, forth and back."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError, SimulationFailure
from tests.simulation.misbehaving import hanging, patched
from tests.tiers import quick
from tests.trajectories import read_trajectory

ROOT = Path(__file__).parents[2]
STEP = "pam_core *core = &c->core;"


@pytest.fixture(scope="module", params=quick(["2.0", "3.0"], "3.0"))
def foreign(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> str:
    """An FMU as a file, which runs in a process of its own."""
    return str(
        pam.build("Isotonic", tmp_path_factory.mktemp("fmu") / "isotonic.fmu", fmi=request.param)
    )


def test_steps_equal_one_run() -> None:
    whole = pam.simulate(
        "Isotonic", {"load.m": "5 kg", "u_in": "0.3 A"}, stop_time=1.0, interval=0.1
    )
    with pam.start("Isotonic", {"load.m": 5.0, "u_in": "300 mA"}) as rig:
        for _ in range(10):
            rig.step("100 ms")
    steps = rig.trajectory
    assert np.allclose(steps.time, whole.time, rtol=0, atol=1e-12)
    for name in ("p", "x", "T"):
        assert steps[name] == pytest.approx(whole[name], rel=1e-9, abs=1e-12)
    assert steps.units["p"] == "Pa" and (steps["u_in"] == 0.3).all()


def test_input_that_steps_stands_twice_and_is_held() -> None:
    with pam.start("Isotonic") as rig:
        rig.step(0.5, u_in=0)
        rig.step(0.5, u_in="350 mA")
        now = rig.step(0.5)
        assert rig.time == 1.5 and now["p"] == rig["p"] == rig.read("p", "kPa") * 1e3
        assert rig.inputs["u_in"] == pytest.approx(0.35)
    assert rig.trajectory.time.tolist() == [0.0, 0.0, 0.5, 0.5, 1.0, 1.5]
    assert rig.trajectory["u_in"] == pytest.approx([0.35, 0.0, 0.0, 0.35, 0.35, 0.35])
    course = pam.Inputs(rig.trajectory.time, {"u_in": rig.trajectory["u_in"]})
    again = pam.simulate("Isotonic", inputs=course, stop_time=1.5, interval=0.5)
    assert again["x"][-1] == pytest.approx(rig.trajectory["x"][-1], rel=1e-6)


@pytest.mark.full
def test_state_goes_back_and_forth(foreign: str) -> None:
    with pam.start(foreign, {"load.m": "5 kg"}) as rig:
        rig.step(0.3, u_in=0.35)
        state = rig.save()
        first, rows = rig.step(0.2), rig.trajectory.time.size
        rig.step(0.2, u_in=0.0)
        rig.restore(state)
        assert rig.time == 0.3 and rig.inputs["u_in"] == 0.35 and rig.trajectory.time[-1] == 0.3
        assert rig.step(0.2) == first and rig.trajectory.time.size == rows
        frozen = state.to_bytes()
    with pam.start(foreign, {"load.m": "5 kg"}) as other:
        other.restore(frozen)
        assert other.time == 0.3 and other.step(0.2) == first
        assert other.trajectory.time.tolist() == [0.3, 0.5]
        with pytest.raises(InputError, match="another rig"):
            other.restore(state)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"u_inn": 1}, "no input 'u_inn'; did you mean 'u_in'"),
        ({"load.m": 3}, "'load.m' is no input of .*: it is set at the start"),
        ({"p": 3}, "'p' is an output of"),
        ({"u_in": "3 kPa"}, "u_in=3 kPa.*cannot be converted to 'A'"),
        ({"u_in": float("nan")}, "must be a finite number"),
    ],
)
def test_bad_input_moves_nothing(settings: dict[str, float | str], message: str) -> None:
    with pam.start("Isotonic") as rig:
        before = rig.step(0.1)
        with pytest.raises(InputError, match=message):
            rig.step(0.1, settings)
        with pytest.raises(InputError, match="did you mean 'p_supply'"):
            rig["p_suply"]
        for duration in (0, -1, float("nan"), "5 kg", "soon"):
            with pytest.raises(InputError, match="step"):
                rig.step(duration)
        assert rig.time == 0.1 and rig.readings == before and rig.trajectory.time.size == 2


def test_crash_keeps_what_happened(tmp_path: Path) -> None:
    path = patched(tmp_path, "pam_cosimulation.c", STEP, f"if (now > 0.25) abort(); {STEP}")
    with pam.start(str(path)) as rig:
        for _ in range(3):
            rig.step(0.1, u=1.0)
        with pytest.raises(SimulationFailure, match="crashed its process \\(signal SIGABRT\\)"):
            rig.step(0.1)
        assert rig.trajectory.time[-1] == pytest.approx(0.3) and rig.trajectory["y"][-1] > 0
        with pytest.raises(SimulationFailure, match="has ended with its process"):
            rig.step(0.1)


@pytest.mark.full
def test_step_that_never_returns_is_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HANG_ABOVE", "5")
    with pam.start(str(hanging(tmp_path)), timeout=2.0) as rig:
        rig.step(0.1, u=1.0)
        with pytest.raises(SimulationFailure, match="no progress for 2 s, fmi2SetReal"):
            rig.step(0.1, u=6.0)
        assert rig.trajectory.time[-1] == pytest.approx(0.1)


def test_model_that_fails_in_a_step_can_go_back(tmp_path: Path) -> None:
    file = tmp_path / "Limited.mo"
    file.write_text(
        'model Limited "Grows"\n input Real u(start=1) "Rate";\n output Real y "Level";\n'
        ' Real x(start=0, fixed=true) "State";\n'
        'equation\n der(x) = u;\n y = x;\n assert(x < 1, "too high");\nend Limited;\n'
    )
    with pam.start(str(file)) as rig:
        rig.step(0.5)
        state = rig.save()
        with pytest.raises(SimulationFailure, match=r"too high.*simulated up to 1 s"):
            rig.step(2)
        rig.restore(state)
        assert rig.step(0.25)["y"] == pytest.approx(0.75)


def test_example_runs(tmp_path: Path) -> None:
    script, table = ROOT / "examples/co-simulation/stepping.py", tmp_path / "steps.csv"
    done = subprocess.run(
        [sys.executable, str(script), str(table)], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert "valves shut: p = " in done.stdout
    assert read_trajectory(table)["x"].max() > 0.03
