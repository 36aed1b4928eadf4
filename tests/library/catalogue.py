"""The catalogue and the benches as the library itself declares them, and how a test drives a bench."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from pam_cosim.catalogue import Composition, EffectClass, compose_on, effect_classes
from pam_cosim.compiler import ClassTree, Ode, Structure, read_library, read_structure
from pam_cosim.errors import ModelError
from pam_cosim.fmu import build_model, build_source, source_ode
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.simulation import Inputs, Simulator

BENCH = "PneumaticMuscle.Benches.Isotonic"
TIMES = np.linspace(0, 10, 501)
NOISE = {"Pa": 500.0, "m": 2e-4, "K": 0.3, "N": 1.0, "1": 1e-3, "": 1e-3}
"""What an instrument can show, by the unit of its signal."""

_DRIVE = {
    "u_in": [0.35, 0.35, 0, 0, 0, 0, 0.3, 0.3],
    "u_out": [0, 0, 0, 0, 0.35, 0.35, 0, 0],
}
_OPENED = (1e-5 + 2.61e-7) / 1.80e-6
"""Current [A] that a command of 1 stands for where valves are switched; the drive opens them as far as the others."""
_DRIVE_TIMES = np.array([0, 2, 2, 4, 4, 6, 6, 10.0])

Values = dict[str, np.ndarray]


def check_each(check: Callable[[str], None], names: Iterable[str]) -> None:
    """One question to many classes: names all that fail it, with the reason."""
    failed = []
    for name in names:
        try:
            check(name)
        except AssertionError as problem:
            failed.append(f"{name}: {problem}")
    assert not failed, "\n".join(failed)


@cache
def tree() -> ClassTree:
    return read_library()


@cache
def effects() -> tuple[EffectClass, ...]:
    return tuple(effect_classes(tree()))


@cache
def benches() -> tuple[str, ...]:
    package = "PneumaticMuscle.Benches."
    return tuple(
        n
        for n, c in tree().classes.items()
        if n.rpartition(".")[0] + "." == package and c.kind == "model"
    )


@cache
def structure(bench: str) -> Structure:
    """What a bench consists of, for all effects that are put into it."""
    return read_structure(bench)


@cache
def composed(bench: str, effect: str) -> Composition | None:
    """The bench with an effect; None where it finds no place."""
    return compose_on(tree(), structure(bench), [effect])


@cache
def law_bench(effect: str) -> str:
    """The one bench on which an effect's law is tested; elsewhere it only has to find its place."""
    return next(b for b in (BENCH, *benches()) if compiled(b, effect) is not None)


def on_bench(effect: str, bench: str = "") -> Composition:
    """The composition on a bench, by default the one on which its law is tested."""
    composition = composed(bench or law_bench(effect), effect)
    assert composition is not None
    return composition


@cache
def homes(effect: str) -> dict[str, Composition]:
    """Benches in which an effect finds a place: of every fifth, and the next member of its family of the next ones.

    So a family of five is seen on each bench.
    Where a bench imposes a contraction or a pressure without its rate, what depends on the rate has none; nor has a
    reading that begins at rest where it follows an input at once.
    """
    turn = [e.name for e in effects()].index(effect)
    found = {b: composed(b, effect) for i, b in enumerate(benches()) if (i - turn) % 5 == 0}
    return {b: c for b, c in found.items() if c is not None and _equations(c) is not None}


@cache
def compiled(bench: str, effect: str) -> Ode | None:
    """The equations of the bench with an effect, if it finds a place there and needs no rate of an input."""
    composition = composed(bench, effect)
    return None if composition is None else _equations(composition)


def _equations(composition: Composition) -> Ode | None:
    try:
        return source_ode(composition.name, composition.text)
    except ModelError as problem:
        if any(
            text in problem.message
            for text in ("needs the derivative of its input", "depends on the input")
        ):
            return None
        raise


def values(
    effect: EffectClass, composition: Composition, own: dict[str, float]
) -> dict[str, float]:
    """Values of an effect's parameters by their full names in a composed model, at every place that it has there."""
    return {
        full: own[n]
        for full in composition.parameters[effect.name]
        if (n := full.rpartition(".")[2]) in own
    }


@cache
def base(bench: str, tolerance: float | None = None) -> tuple[Values, Interface]:
    return run(build_model(bench, brief=True), {}, tolerance)


@cache
def built(bench: str, effect: str) -> Path:
    composition = on_bench(effect, bench)
    return build_source(composition.name, composition.text, brief=True)


def run(
    fmu: Path, parameters: dict[str, float], tolerance: float | None = None
) -> tuple[Values, Interface]:
    """Outputs of a run in which both valves are opened and shut, where there are valves."""
    with Simulator(fmu) as simulator:
        return driven(simulator, parameters, tolerance), simulator.interface


def driven(
    simulator: Simulator, parameters: dict[str, float], tolerance: float | None = None
) -> Values:
    """As ``run``, of a model that is open."""
    known = simulator.interface.inputs
    drive = {
        name: np.array(course) / (_OPENED if known[name].unit == "1" else 1)
        for name, course in _DRIVE.items()
        if name in known
    }
    inputs = Inputs(_DRIVE_TIMES, drive, "linear") if drive else None
    courses = simulator.run(TIMES, parameters=parameters, inputs=inputs, tolerance=tolerance).values
    return {name: courses[name] for name in simulator.interface.outputs}


def without_numbers(
    effect: str,
    bench: str,
    places: Callable[[Interface, Sequence[str]], Iterable[dict[str, float]]],
) -> list[dict[str, float]]:
    """Where outputs are not finite: of the stated values, and of places by the interface and the own parameters."""
    names = on_bench(effect, bench).parameters[effect]
    with Simulator(built(bench, effect)) as simulator:
        return [
            place
            for place in ({}, *places(simulator.interface, names))
            if not all(np.isfinite(y).all() for y in driven(simulator, place).values())
        ]


def noise(variable: Variable) -> float:
    return NOISE[variable.unit or ""]
