"""Coupled FMUs come to what the model in one piece does; what goes wrong names the component and the time."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.cosimulation import ControllerError, CouplingFailure
from pam_cosim.errors import InputError
from tests.cosimulation.systems import CUT, error, gain, halves, thirds, written
from tests.fmu import models
from tests.simulation.misbehaving import patched, repacked
from tests.trajectories import read_trajectory

ROOT = Path(__file__).parents[2]
STEP = "pam_core *core = &c->core;"


@pytest.mark.parametrize(
    ("method", "extrapolation", "order"),
    [
        ("jacobi", "constant", 1),
        ("jacobi", "linear", 2),
        ("gauss-seidel", "constant", 1),
        ("gauss-seidel", "linear", 2),
    ],
)
def test_error_falls_with_the_step_by_the_order_of_the_method(
    method: Any, extrapolation: Any, order: int
) -> None:
    system, errors = halves(), []
    for step in ("4 ms", "2 ms", "1 ms"):
        run = system.simulate(
            0.5, method=method, step=step, extrapolation=extrapolation, solver_tolerance=1e-9
        )
        errors.append(error(run, "muscle.x", "Isotonic", "x"))
    assert math.log2(errors[1] / errors[2]) == pytest.approx(order, abs=0.25)
    assert errors[2] < 1e-3


def test_three_fmus_are_the_controlled_bench() -> None:
    run = thirds().simulate(0.6, step="1 ms", solver_tolerance=1e-9)
    assert error(run, "muscle.x", "CoSimulation.ControlledIsotonic", "x") < 2e-5
    assert error(run, "control.u_in", "CoSimulation.ControlledIsotonic", "u_in") < 1e-3
    assert run.component_steps == {"gas": 600, "muscle": 600, "control": 600}
    assert {"gas.p", "gas.T", "muscle.V", "control.u_out"} <= set(run.trajectory.values)


def test_steps_chosen_by_their_error() -> None:
    system = halves()
    errors, costs = [], []
    for tolerance in (1e-3, 1e-5):
        run = system.simulate(1, tolerance=tolerance, solver_tolerance=1e-9)
        errors.append(error(run, "gas.p", "Isotonic", "p"))
        costs.append(sum(run.component_steps.values()))
        assert run.trajectory.time[-1] == 1 and (np.diff(run.trajectory.time) > 0).all()
        trials = run.steps // 2 + run.rejected
        assert run.component_steps == {"gas": 3 * trials, "muscle": 3 * trials}
        assert run.rollbacks == trials + run.rejected and run.largest > 3 * run.smallest
    assert errors[1] < errors[0] / 5 and costs[0] < costs[1]
    assert errors[0] < 1e-2 * 207e3


def test_order_matters_to_gauss_seidel_only() -> None:
    system = halves()
    settings: dict[str, Any] = {"step": "5 ms", "extrapolation": "constant"}
    first, second = (
        system.simulate(0.1, method="gauss-seidel", order=order, **settings).trajectory["gas.p"][-1]
        for order in (["gas", "muscle"], ["muscle", "gas"])
    )
    assert first != second
    same = [
        system.simulate(0.1, method="jacobi", order=order, **settings).trajectory["gas.p"].tolist()
        for order in (["gas", "muscle"], ["muscle", "gas"])
    ]
    assert same[0] == same[1]


@pytest.mark.full
def test_foreign_fmus_of_both_versions_come_to_the_same(tmp_path: Path) -> None:
    files = {
        "gas": str(pam.build("CoSimulation.ValveAndGas", tmp_path / "gas.fmu", fmi="3.0")),
        "muscle": str(pam.build("CoSimulation.MuscleAndLoad", tmp_path / "muscle.fmu")),
    }
    foreign = pam.couple(files, CUT).simulate(0.05, step="1 ms")
    own = halves().simulate(0.05, step="1 ms")
    assert foreign.trajectory["muscle.x"].tolist() == own.trajectory["muscle.x"].tolist()
    chosen = pam.couple(files, CUT).simulate(0.05, tolerance=1e-3)
    assert chosen.trajectory["muscle.x"][-1] == pytest.approx(
        own.trajectory["muscle.x"][-1], abs=1e-5
    )


@pytest.mark.full
def test_fmu_without_slopes_keeps_the_order(tmp_path: Path) -> None:
    change = {'canInterpolateInputs="true"': 'canInterpolateInputs="false"'}
    files = {}
    for name, model in (("gas", "ValveAndGas"), ("muscle", "MuscleAndLoad")):
        files[name] = str(
            repacked(pam.build(f"CoSimulation.{model}"), tmp_path / f"{name}.fmu", change)
        )
    errors = [
        error(
            pam.couple(files, CUT).simulate(0.3, method="jacobi", step=step),
            "muscle.x",
            "Isotonic",
            "x",
        )
        for step in ("4 ms", "2 ms")
    ]
    assert math.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.4)


@pytest.mark.parametrize("settings", [{}, {"method": "jacobi", "extrapolation": "constant"}])
def test_fmu_without_slopes_shows_the_present_input(tmp_path: Path, settings: Any) -> None:
    """y = 2 u, where u rises along a line, and what is joined to y."""
    change = {'canInterpolateInputs="true"': 'canInterpolateInputs="false"'}
    plain = repacked(pam.build(gain(tmp_path, "Two", 2)), tmp_path / "plain.fmu", change)
    system = pam.couple({"a": str(plain), "b": gain(tmp_path, "Three", 3)}, ["a.y -> b.u"])
    rising = pam.Inputs([0.0, 1.0], {"a.u": [0.0, 1.0]})
    course = system.simulate(1, step=0.1, inputs=rising, **settings).trajectory
    for name, factor in (("a.u", 1), ("a.y", 2), ("b.y", 6)):
        np.testing.assert_allclose(course[name], factor * course.time, atol=1e-11)


def test_units_are_converted(tmp_path: Path) -> None:
    source = written(
        tmp_path,
        "Source",
        'output Real T(unit="degC") "T";\noutput Real l(unit="mm") "l";\nequation\nT = 20;\nl = 5 + time;',
    )
    sink = written(
        tmp_path, "Sink",
        'input Real T(unit="K") "T";\ninput Real l(unit="m") "l";\noutput Real y "y";\nequation\ny = T + l;',
    )  # fmt: skip
    system = pam.couple({"a": source, "b": sink}, ["a.T -> b.T", "a.l -> b.l"])
    run = system.simulate(1, step=0.1)
    assert run.trajectory["b.y"] == pytest.approx(
        293.15 + (5 + run.trajectory.time) * 1e-3, rel=1e-12
    )


def test_input_of_the_system_that_jumps_between_steps(tmp_path: Path) -> None:
    body = 'input Real u "u";\noutput Real y(start=0, fixed=true) "y";\nequation\nder(y) = u;'
    parts = {"a": written(tmp_path, "Sum", body), "b": written(tmp_path, "Twice", body)}
    system = pam.couple(parts, ["a.y -> b.u"])
    course = pam.Inputs([0.0, 0.33, 0.33, 1.0], {"a.u": [0.0, 0.0, 1.0, 1.0]})
    for settings in ({"step": 0.1}, {"step": 0.1, "method": "jacobi"}, {"tolerance": 1e-6}):
        run = system.simulate(1, inputs=course, **settings)  # type: ignore[arg-type]
        assert run.trajectory["a.y"][-1] == pytest.approx(0.67, rel=1e-9)
        # a step after the jump, 0.07 s long, Jacobi does not know that the output rises
        assert run.trajectory["b.y"][-1] == pytest.approx(0.67**2 / 2, abs=0.07**2 / 2 + 1e-9)
        at = np.flatnonzero(run.trajectory.time == 0.33)
        assert run.trajectory["a.u"][at].tolist() == [0.0, 1.0]


# --- controllers in Python -----------------------------------------------------------------------------------


def test_controller_is_called_once_for_every_sample() -> None:
    calls: list[float] = []

    @pam.controller(inputs={"x": "mm"}, outputs={"u_in": "mA"}, interval="20 ms")
    def lift(time: float, x: float) -> float:
        calls.append(time)
        return 350.0 if x < 5 else 0.0

    parts = {
        "gas": "CoSimulation.ValveAndGas",
        "muscle": "CoSimulation.MuscleAndLoad",
        "lift": lift,
    }
    system = pam.couple(parts, [*CUT, "muscle.x -> lift.x", "lift.u_in -> gas.u_in"])
    assert "lift: lift, every 0.02 s" in str(system)
    for settings in ({"step": "3 ms"}, {"tolerance": 1e-4}):
        calls.clear()
        run = system.simulate(0.5, **settings)  # type: ignore[arg-type]
        assert calls == pytest.approx(np.arange(0, 0.51, 0.02))
        u = run.trajectory["lift.u_in"]
        assert u[0] == 350 and u[-1] == 0 and 0.004 < run.trajectory["muscle.x"][-1] < 0.012
        jump = int(np.flatnonzero(np.diff(u))[0])
        assert run.trajectory.time[jump] == run.trajectory.time[jump + 1]


def _failing(time: float, x: float) -> float:
    if time > 0.1:
        raise ValueError("the sensor came off")
    return 0.35


@pytest.mark.parametrize(
    ("function", "message"),
    [
        (
            _failing,
            r"'lift' \(_failing\) raised ValueError: the sensor came off at 0.12 s, in line \d+ of .*coupling.py",
        ),
        (lambda time, x: math.nan, "returned u_in = 'nan' at 0 s; it must be a finite number"),
        (lambda time, x: {"u": 1}, "returned u at 0 s; its outputs are u_in"),
        (lambda time, x: "open", "returned u_in = 'open'"),
        (lambda time: 1.0, "raised TypeError: .*unexpected keyword argument 'x'"),
    ],
)
def test_controller_that_goes_wrong_names_itself_and_the_time(function: Any, message: str) -> None:
    lift = pam.Controller(function, {"x": "m"}, {"u_in": "A"}, "20 ms")
    parts = {
        "gas": "CoSimulation.ValveAndGas",
        "muscle": "CoSimulation.MuscleAndLoad",
        "lift": lift,
    }
    system = pam.couple(parts, [*CUT, "muscle.x -> lift.x", "lift.u_in -> gas.u_in"])
    with pytest.raises(ControllerError, match=message) as caught:
        system.simulate(0.5, step="5 ms")
    if function is _failing:
        kept = caught.value.run.trajectory
        assert kept.time[-1] == pytest.approx(0.12) and kept["muscle.x"][-1] > 0


# --- FMUs that fail ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("settings", [{"step": 0.1}, {"tolerance": 1e-3}])
def test_fmu_that_fails_is_named_and_nothing_is_lost(tmp_path: Path, settings: Any) -> None:
    body = 'input Real u "u";\noutput Real y(start=0, fixed=true) "y";\nequation\nder(y) = u;'
    limited = written(tmp_path, "Limited", body + '\nassert(y < 0.5, "level too high");')
    system = pam.couple(
        {"a": written(tmp_path, "Sum", body), "b": limited}, ["a.y -> b.u"], {"a.u": 1.0}
    )
    with pytest.raises(
        CouplingFailure, match=r"component 'b' \(.*Limited.mo\) failed: .*level too high"
    ) as caught:
        system.simulate(2, **settings)
    kept = caught.value.run.trajectory
    assert "coupled up to" in str(caught.value) and kept.time[-1] == pytest.approx(1.0, abs=0.11)
    assert kept["b.y"] == pytest.approx(kept.time**2 / 2, abs=0.02)


@pytest.mark.parametrize(
    "settings", [{"step": 0.1}, pytest.param({"tolerance": 1e-3}, marks=pytest.mark.full)]
)
def test_fmu_that_crashes_is_named(tmp_path: Path, settings: Any) -> None:
    path = patched(tmp_path, "pam_cosimulation.c", STEP, f"if (now > 0.45) abort(); {STEP}")
    system = pam.couple(
        {"good": str(models.fmu(models.lag)), "bad": str(path)},
        ["good.y -> bad.u"],
        {"good.u": 1.0},
    )
    with pytest.raises(
        CouplingFailure, match=r"'bad' .* crashed its process \(signal SIGABRT\).*coupled up to"
    ) as caught:
        system.simulate(1, **settings)
    assert 0.3 < caught.value.run.trajectory.time[-1] < 0.51


# --- algebraic loops -----------------------------------------------------------------------------------------


def test_algebraic_loop_is_named_and_solved(tmp_path: Path) -> None:
    parts = {"a": gain(tmp_path, "Up", 3, 1), "b": gain(tmp_path, "Down", -2)}
    system = pam.couple(parts, ["a.y -> b.u", "b.y -> a.u"])
    assert {str(one) for one in system.algebraic_loop} == {"a.u", "a.y", "b.u", "b.y"}
    with pytest.raises(InputError) as caught:
        system.simulate(1, step=0.1)
    for word in (
        "algebraic loop: ",
        "a.y -> b.u -> b.y",
        "loops='iterate'",
        "loops='delay'",
        "a filter",
    ):
        assert word in str(caught.value), word
    run = system.simulate(1, step=0.1, loops="iterate")  # y = 3 (-2 y) + 1
    assert run.trajectory["a.y"] == pytest.approx(1 / 7, rel=1e-9)


def loop(folder: Path, up: str, down: str) -> pam.System:
    """Two FMUs that act on one another at once; w is given over time."""
    parts = {
        name: written(
            folder,
            name.upper(),
            f"input Real u(start=0);\ninput Real w(start=0);\noutput Real y;\nequation\ny = {law};",
        )
        for name, law in (("a", up), ("b", down))
    }
    return pam.couple(parts, ["a.y -> b.u", "b.y -> a.u"])


@pytest.mark.parametrize(
    ("up", "down", "solution"),
    [
        ("0.3*u", "-0.7*u", 0.0),
        ("0.3*(u + 0.1) - 0.03", "-0.7*u", 0.0),  # but for rounding
        ("0.3*u + 1e-12", "-0.7*u", 1e-12 / 1.21),
        ("0.3*u + 1e6", "-0.7*u", 1e6 / 1.21),
        ("0.3*u + 1", "-tanh(u)", 0.8006756946),  # y + 0.3 tanh(y) = 1
    ],
)
def test_loop_of_any_size(tmp_path: Path, up: str, down: str, solution: float) -> None:
    run = loop(tmp_path, up, down).simulate(1, step=0.1, loops="iterate")
    np.testing.assert_allclose(run.trajectory["a.y"], solution, rtol=1e-9, atol=1e-16)


def test_a_loop_without_solution_is_reported(tmp_path: Path) -> None:
    parts = {"a": gain(tmp_path, "Same", 1, 1), "b": gain(tmp_path, "Back", 1)}
    system = pam.couple(parts, ["a.y -> b.u", "b.y -> a.u"])
    with pytest.raises(CouplingFailure, match="has no solution that Newton's method finds"):
        system.simulate(1, step=0.1, loops="iterate")


def test_undeclared_dependencies_count_as_all(tmp_path: Path) -> None:
    path = models.fmu(models.lag)
    import re
    import zipfile

    text = zipfile.ZipFile(path).read("modelDescription.xml").decode()
    part = re.search("<Outputs>.*?</Outputs>", text, re.DOTALL)
    assert part is not None
    silent = re.sub(r' dependencies(Kind)?="[^"]*"', "", part[0])
    other = repacked(path, tmp_path / "Silent.fmu", {part[0]: silent})
    assert not pam.couple(
        {"a": str(path), "b": str(path)}, ["a.y -> b.u", "b.y -> a.u"]
    ).algebraic_loop
    system = pam.couple({"a": str(other), "b": str(other)}, ["a.y -> b.u", "b.y -> a.u"])
    with pytest.raises(
        InputError, match="a, b does not declare which inputs .* may not be a real one"
    ):
        system.simulate(1, step=0.1)


# --- bad input -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("connections", "parameters", "message"),
    [
        (["gas.p > muscle.p"], {}, "write 'a.output -> b.input'"),
        (["gass.p -> muscle.p"], {}, "no component 'gass'; did you mean 'gas'"),
        (["gas.pp -> muscle.p"], {}, "no output 'pp'; did you mean 'p'"),
        (["gas.p -> muscle.pp"], {}, "no input 'pp'; did you mean 'p'"),
        (
            ["gas.T -> muscle.p"],
            {},
            "connection 'gas.T -> muscle.p': unit 'K' cannot be converted to 'Pa'",
        ),
        (["gas.p -> muscle.p", "gas.p -> muscle.p"], {}, "'muscle.p' has more than one source"),
        (
            ["gas.p -> muscle.p"],
            {"muscle.p": 1.0},
            "'muscle.p' has more than one source: gas.p, a value",
        ),
        ([], {"muscle.load.mm": 1.0}, "no parameter or input 'load.mm'; did you mean 'load.m'"),
        ([], {"muscle.load.m": "5 m"}, "cannot be converted to 'kg'"),
        ([], {"load.m": 5}, "no component 'load'"),
    ],
)
def test_system_that_cannot_be_made(
    connections: list[str], parameters: dict[str, Any], message: str
) -> None:
    parts = {"gas": "CoSimulation.ValveAndGas", "muscle": "CoSimulation.MuscleAndLoad"}
    with pytest.raises(InputError, match=message):
        pam.couple(parts, connections, parameters)


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"method": "jakobi"}, "unknown method 'jakobi'; did you mean 'jacobi'"),
        ({"extrapolation": "cubic"}, "unknown extrapolation"),
        ({"step": "5 kg"}, "the step: "),
        ({"step": -1}, "the step must be larger than zero"),
        ({"step": 1e-9}, "steps at most"),
        ({"tolerance": 0}, "the tolerance of a step must be larger than zero"),
        ({"outputs": ["muscle.load.w"]}, "no variable 'load.w'; did you mean 'load.[mvs]'"),
        ({"order": ["gas"]}, "the order must name each FMU once: gas, muscle"),
        ({"inputs": pam.Inputs([0.0], {"gas.V": [1.0]})}, "'gas.V' is connected"),
        (
            {"inputs": pam.Inputs([0.0], {"gas.u_inn": [1.0]})},
            "no free input 'gas.u_inn'; did you mean 'gas.u_in'",
        ),
    ],
)
def test_run_that_cannot_be_made(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        halves().simulate(0.1, **settings)


def test_example_runs(tmp_path: Path) -> None:
    script, table = ROOT / "examples/co-simulation/coupling.py", tmp_path / "coupled.csv"
    done = subprocess.run(
        [sys.executable, str(script), str(table)], cwd=tmp_path, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("the load is at 16.35 mm") == 2  # fixed and chosen steps agree
    assert read_trajectory(table)["lift.u_in"].max() <= 350
