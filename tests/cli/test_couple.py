"""The command that couples FMUs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome
from tests.trajectories import read_trajectory

SYSTEM = """\
title = "the isotonic bench in pieces"
stop_time = "300 ms"
connections = [
  "gas.p -> muscle.p",
  "muscle.V -> gas.V",
  "muscle.V_flow -> gas.V_flow",
  "muscle.A -> gas.A",
%s]
[components]
gas = "CoSimulation.ValveAndGas"
muscle = "CoSimulation.MuscleAndLoad"
[parameters]
"muscle.load.m" = "3 kg"
"""
CONTROLLER = """\
import pam_cosim as pam

@pam.controller(inputs={"x": "mm"}, outputs={"u_in": "mA"}, interval="20 ms")
def lift(time, x):
    if time > 0.1:
        raise RuntimeError("the cable is off")
    return 350

@pam.controller(inputs={"x": "mm"}, outputs={"u_in": "mA"}, interval="20 ms")
def leaves(time, x):
    raise SystemExit(0)

def plain(time, x):
    return 350
"""
WIRES = '  "muscle.x -> lift.x",\n  "lift.u_in -> gas.u_in",\n'
Run = Callable[..., Outcome]


@pytest.fixture
def system(place: Path) -> Path:
    file = place / "system.toml"
    file.write_text(SYSTEM % "")
    (place / "controlled.toml").write_text(SYSTEM % WIRES)
    (place / "lift.py").write_text(CONTROLLER)
    return file


def test_couples_a_written_system(command: Run, system: Path) -> None:
    done = command("couple", system, "--step", "1ms", "--method", "jacobi", "--set", "muscle.load.m=5 kg",
               "--keep", "muscle.load.v", "-o", "out.csv", "--plot", "out.png", "--ssp", "system.ssp")  # fmt: skip
    assert done.status == 0, done.err
    assert (
        "jacobi up to 0.3 s: 300 steps of 0.001 s" in done.out
        and "muscle.x: from -0.245 mm to " in done.out
    )
    trajectory = read_trajectory(Path("out.csv"))
    assert trajectory.time[-1] == 0.3 and trajectory["muscle.load.v"].max() > 0
    assert Path("out.png").read_bytes().startswith(b"\x89PNG")
    again = command("couple system.ssp --stop-time '300 ms' --tolerance 1e-4 -o again.csv")
    assert again.status == 0 and "rollbacks" in again.out
    other = read_trajectory(Path("again.csv"))
    assert other["muscle.x"][-1] == pytest.approx(trajectory["muscle.x"][-1], abs=1e-4)


def test_controller_that_raises_leaves_what_was_reached(command: Run, system: Path) -> None:
    done = command(
        "couple controlled.toml --controller lift=lift.py:lift --step '5 ms' -o out.csv",
    )
    assert done.status == 2
    assert (
        "controller 'lift' (lift) raised RuntimeError: the cable is off at 0.12 s, in line 6 of lift.py"
        in done.err
    )
    assert "written: out.csv" in done.err and "Traceback" not in done.err
    assert read_trajectory(Path("out.csv")).time[-1] == pytest.approx(0.12)


def test_fmu_that_fails_has_status_1_and_leaves_what_was_reached(command: Run, place: Path) -> None:
    Path("Limited.mo").write_text(
        'model Limited "Level"\n input Real u(start=1) "u";\n output Real y(start=0, fixed=true) "y";\n'
        'equation\n der(y) = u;\n assert(y < 0.5, "level too high");\nend Limited;\n'
    )
    Path("level.toml").write_text('[components]\na = "Limited.mo"\n')
    done = command("couple level.toml --step '100 ms' --stop-time 2 -o out.csv")
    assert done.status == 1
    assert (
        "component 'a' (" in done.err
        and "level too high" in done.err
        and "coupled up to" in done.err
    )
    assert read_trajectory(Path("out.csv"))["a.y"].max() == pytest.approx(0.5, abs=0.11)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["none.toml"], "cannot be read"),
        (["system.toml", "--method", "jakobi"], "unknown method 'jakobi'; did you mean 'jacobi'"),
        (["system.toml", "--step", "5 kg"], "the step: "),
        (["system.toml", "--set", "muscle.load.mm=5"], "did you mean 'muscle.load.m'"),
        (["system.toml", "--keep", "muscle.w"], "no variable 'w'"),
        (["system.toml", "-o", "system.toml"], "system.toml"),
        (
            ["system.toml", "--ssp-version", "2.0"],
            "--ssp-version needs --ssp FILE",
        ),
        (
            ["system.toml", "--sample", "muscle=1ms", "--sample", "muscle=2ms"],
            "--sample: 'muscle' is given twice",
        ),
        (["system.toml", "--sample", "muscel=1ms"], "did you mean 'muscle'"),
        (["controlled.toml", "--controller", "lift=lift.py"], "write NAME=FILE.py:FUNCTION"),
        (["controlled.toml", "--controller", "lift=none.py:lift"], "there is no such file"),
        (
            ["controlled.toml", "--controller", "lift=lift.py:lifted"],
            "no controller 'lifted'; did you mean 'lift'",
        ),
        (["controlled.toml", "--controller", "lift=lift.py:plain"], "write @pam.controller"),
        (
            ["controlled.toml", "--controller", "lift=lift.py:lift", "--ssp", "x.ssp"],
            "an SSP archive cannot hold",
        ),
    ],
)
def test_bad_input_writes_nothing(
    command: Run, system: Path, words: list[str], message: str
) -> None:
    before = {path: path.read_bytes() for path in system.parent.iterdir() if path.is_file()}
    done = (
        command("couple", *words) if "-o" in words else command("couple", *words, "-o", "out.csv")
    )
    assert done.status == 2 and message in done.err and "Traceback" not in done.err
    assert {path: path.read_bytes() for path in system.parent.iterdir() if path.is_file()} == before


def test_example_runs(command: Run, place: Path) -> None:
    example = Path(__file__).parents[2] / "examples/co-simulation/isotonic.toml"
    done = command("couple", example, "--adaptive", "-o", "out.csv")
    assert done.status == 0, done.err
    assert read_trajectory(Path("out.csv"))["muscle.x"].max() > 0.015
