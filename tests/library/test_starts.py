"""How what is stored begins: fixed, at rest, or as nothing else says. Every class that stores something can choose."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

from pam_cosim.compiler import Ode, compile_model
from pam_cosim.fmu import build_source
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.resources import modelica_root
from pam_cosim.simulation import Inputs, Settle, Simulator, Trajectory
from tests.library.catalogue import BENCH, check_each, effects, on_bench
from tests.library.rigs import choices, rig

CLASSES = sorted(
    p for p in (modelica_root() / "PneumaticMuscle").rglob("*.mo") if p.name != "package.mo"
)
STEADY, GUESS = (
    "PneumaticMuscle.Types.Dynamics." + name
    for name in ("SteadyStateInitial", "DynamicFreeInitial")
)
OPEN = {"u_in": 0.3, "u_out": 0.2}
# At rest the valves of these are as they were told before: a run of their default that settles begins with them shut.
LATE = {"ValveDelay", "FlexibleDrive", "FlexibleOpening", "GeneralDrive"}
# What slipped before is not known from the rest.
ANYWHERE = {
    "DahlFriction",
    "FlexibleDryFriction",
    "GeneralDryFriction",
    "MaxwellSlipFriction",
    "PressureDryFriction",
}
AS_EQUAL = 1e-8  # of a signal


def code(path: Path) -> str:
    return path.read_text().split("Documentation(info")[0]


@cache
def storing() -> tuple[str, ...]:
    """Effects that have a state of their own."""
    by_name = {path.stem: code(path) for path in CLASSES if "Effects" in path.parts}
    return tuple(e.name for e in effects() if "dynamics" in by_name[e.name])


def one_of_each_family() -> list[str]:
    families = {e.family: e.name for e in reversed(effects()) if e.name in storing()}
    return sorted(families.values())


def begun(text: str, name: str, how: str) -> str:
    """Modelica of a model, and of one that begins in another way."""
    return f"{text}\nmodel Begun = {name}(ambient(dynamics={how}));\n"


def ran(text: str, name: str, settle: Settle = "none") -> tuple[Simulator, Trajectory]:
    """Under open valves, where there are some."""
    with Simulator(build_source(name, text, lean=True, brief=True)) as simulator:
        inputs = {
            n: np.array([OPEN.get(n, v.start or 0.0)])
            for n, v in simulator.interface.inputs.items()
        }
        names = [*simulator.interface.states, *simulator.interface.outputs]
        return simulator, simulator.run(
            [0.0, 0.5],
            inputs=Inputs(np.array([0.0]), inputs),
            outputs=names,
            settle=settle,
            tolerance=1e-9,
        )


def check_effect(effect: str) -> None:
    """It begins at rest and stays there, with the same states, where its default comes when it settles."""
    made = on_bench(effect)
    simulator, run = ran(begun(made.text, made.name, STEADY), "Begun")
    default, settled = ran(made.text, made.name, "all")
    assert simulator.interface.states == default.interface.states
    for name in simulator.interface.outputs:
        assert run[name][1] == pytest.approx(run[name][0], rel=AS_EQUAL), name
        if effect not in LATE:
            assert run[name][0] == pytest.approx(
                settled[name][0], rel=1e-6 if effect in ANYWHERE else AS_EQUAL
            ), name


def check_marks(effect: str) -> None:
    """All states but those that may rest anywhere are sought; none is where nothing is said."""
    made = on_bench(effect)
    steady, free = (compiled(begun(made.text, made.name, how)) for how in (STEADY, GUESS))
    assert free.resting == ()
    others = [s.name for s in steady.states if s.name not in steady.resting]
    assert bool(others) == (effect in ANYWHERE), others


def compiled(text: str) -> Ode:
    """The last model of a text."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "Begun.mo"
        file.write_text(text)
        return compile_model(str(file))


def test_every_class_that_stores_something_has_the_choice() -> None:
    """No start is fixed for good, and no initial equation holds whatever is chosen, but that a delay begins now."""
    for path in CLASSES:
        text = code(path)
        assert "fixed=true" not in text, path
        if re.search(r"(?m)^initial equation", text):
            said = text.split("initial equation\n")[1].split("\nequation\n")[0]
            assert said.strip() == "t_0 = time;" or "dynamics == " in said, path
    assert len(storing()) > 45


def test_a_law_of_each_family_begins_at_rest() -> None:
    check_each(check_effect, one_of_each_family())


@pytest.mark.full
def test_every_effect_begins_at_rest() -> None:
    check_each(check_effect, storing())


@pytest.mark.full
def test_states_that_begin_at_rest_are_marked() -> None:
    check_each(check_marks, storing())


@pytest.mark.parametrize(
    ("pneumatics", "mechanics"),
    [(p, "spring") for p in choices("pneumatics")]
    + [("regulator", m) for m in choices("mechanics")],
)
def test_the_parts_of_rigs_begin_at_rest(pneumatics: str, mechanics: str) -> None:
    made = rig(pneumatics, mechanics)
    simulator, run = ran(begun(made.text, made.name, STEADY), "Begun")
    default, settled = ran(made.text, made.name, "all")
    assert simulator.interface.states == default.interface.states
    for name in simulator.interface.outputs:
        assert run[name][0] == pytest.approx(settled[name][0], rel=AS_EQUAL, abs=1e-12), name
        assert run[name][1] == pytest.approx(run[name][0], rel=1e-6, abs=1e-9), name


@pytest.mark.parametrize("by", ["valve.C_A", "muscle.mu_fb", "load.m"])
def test_slopes_of_a_bench_at_rest_are_those_of_finite_differences(by: str) -> None:
    text = f"model Begun = {BENCH}(ambient(dynamics={STEADY}), load(s_start=0.05));"
    slopes = {name: sensitivity_name(name, by) for name in ("p", "x", "T")}
    held = Inputs(np.array([0.0]), {name: np.array([value]) for name, value in OPEN.items()})
    with Simulator(
        build_source("Begun", text, sensitivities=[by], lean=True, brief=True)
    ) as simulator:
        usual = simulator.interface.parameters[by].start or 0.0
        step = 1e-5 * usual
        runs = [
            simulator.run(
                [0.0], parameters={by: usual + s}, inputs=held, outputs=[*slopes, *slopes.values()]
            )
            for s in (-step, 0.0, step)
        ]
        for name, slope in slopes.items():
            difference = (runs[2][name][0] - runs[0][name][0]) / (2 * step)
            size = abs(runs[1][name][0]) / abs(usual)
            assert runs[1][slope][0] == pytest.approx(difference, rel=1e-4, abs=1e-8 * size)
