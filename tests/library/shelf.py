"""The catalogue and the benches as the library itself declares them, and how a test drives a bench."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np

from pam_cosim.compiler import ClassTree, Composition, EffectClass, compose, effect_classes, read_library
from pam_cosim.fmu import build_model, build_source
from pam_cosim.interface import Interface, Variable
from pam_cosim.simulation import Inputs, Simulator

TIMES = np.linspace(0, 10, 501)
NOISE = {"Pa": 500.0, "m": 2e-4, "K": 0.3, "N": 1.0, "1": 1e-3, "": 1e-3}
"""What an instrument can show, by the unit of its signal."""

_DRIVE = {
    "u_in": [0.35, 0.35, 0, 0, 0, 0, 0.3, 0.3],
    "u_out": [0, 0, 0, 0, 0.35, 0.35, 0, 0],
}
_DRIVE_TIMES = np.array([0, 2, 2, 4, 4, 6, 6, 10.0])

Values = dict[str, np.ndarray]


@cache
def tree() -> ClassTree:
    return read_library()


@cache
def effects() -> tuple[EffectClass, ...]:
    return tuple(effect_classes(tree()))


@cache
def benches() -> tuple[str, ...]:
    package = "PneumaticMuscle.Benches."
    return tuple(n for n, c in tree().classes.items() if n.rpartition(".")[0] + "." == package and c.kind == "model")


@cache
def homes(effect: str) -> dict[str, Composition]:
    """The benches in which an effect finds a place."""
    found = {bench: compose(tree(), bench, [effect]) for bench in benches()}
    return {bench: composition for bench, composition in found.items() if composition is not None}


def absent(effect: EffectClass) -> dict[str, float]:
    """The parameter values at which the effect says that it vanishes."""
    text = tree().constant(effect.qualified_name, "absent")
    assert isinstance(text, str)
    pairs = (item.split("=") for item in text.split(",") if item.strip())
    return {name.strip(): float(value) for name, value in pairs}


def full_names(effect: EffectClass, composition: Composition) -> dict[str, str]:
    """Full names of an effect's parameters in a composed model, by their own."""
    return {full.rpartition(".")[2]: full for full in composition.parameters[effect.name]}


@cache
def base(bench: str) -> tuple[Values, Interface]:
    return run(build_model(bench), {})


@cache
def built(bench: str, effect: str) -> Path:
    composition = homes(effect)[bench]
    return build_source(composition.name, composition.text)


def run(fmu: Path, parameters: dict[str, float]) -> tuple[Values, Interface]:
    """Outputs of a run in which both valves are opened and shut, where there are valves."""
    with Simulator(fmu) as simulator:
        known = simulator.interface.inputs
        drive = {name: np.array(course) for name, course in _DRIVE.items() if name in known}
        inputs = Inputs(_DRIVE_TIMES, drive, "linear") if drive else None
        found = simulator.run(TIMES, parameters=parameters, inputs=inputs).values
        return {name: found[name] for name in simulator.interface.outputs}, simulator.interface


def noise(variable: Variable) -> float:
    return NOISE[variable.unit or ""]
