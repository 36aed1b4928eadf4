"""What is simulated: every bench under inputs as a laboratory applies them, and the isotonic bench in three ways."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from pam_cosim.compiler import Ode, compile_model, with_sensitivities
from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs

Array = NDArray[np.float64]
_BENCHES = "PneumaticMuscle.Benches"
_SUPPLY = 207e3


@dataclass(frozen=True)
class Case:
    """One simulation.

    Attributes:
        name: of the case.
        model: class or ``.mo`` file.
        inputs: straight lines between samples; None: the model has no inputs.
        end: of the run [s].
        count: of output points, equidistant, without the start.
        sensitivities: parameters by which the outputs are differentiated; each derivative is one more output.
    """

    name: str
    model: str
    inputs: Inputs | None
    end: float
    count: int = 1000
    sensitivities: tuple[str, ...] = ()

    @cached_property
    def ode(self) -> Ode:
        """The compiled equations."""
        return with_sensitivities(compile_model(self.model), self.sensitivities)

    @cached_property
    def fmu(self) -> Path:
        """The product's FMU of the model."""
        return build_model(self.model, sensitivities=self.sensitivities)

    @cached_property
    def times(self) -> Array:
        """(count + 1,) output points [s]."""
        return np.linspace(0.0, self.end, self.count + 1)

    @cached_property
    def outputs(self) -> list[str]:
        """The model's outputs."""
        return list(self.ode.interface.outputs)

    @cached_property
    def state_names(self) -> list[str]:
        """The model's states."""
        return [state.name for state in self.ode.states]

    @cached_property
    def nominals(self) -> Array:
        """(states,) size of the states as the FMU's solver takes it [SI]; without a declared one 1."""
        return np.array([state.nominal or 1.0 for state in self.ode.states])

    @cached_property
    def parameters(self) -> Array:
        """(parameters,) the model's values [SI]."""
        return np.array([v.start or 0.0 for v in self.ode.interface.parameters.values()])

    @cached_property
    def start(self) -> Array:
        """(states,) start values [SI]."""
        initial = ca.Function("initial", [self.ode.p], [ca.densify(ca.SX(self.ode.initial))])
        values: Array = initial(self.parameters).full().ravel()
        return values

    def lines(self) -> tuple[Array, Array, Array]:
        """Pieces of straight line: their begins (k,) [s], values there and slopes, both (k, inputs).

        Columns in the order of the model's inputs; the start value is held for inputs without samples.
        """
        names, known = list(self.ode.interface.inputs), self.inputs
        held = np.array([v.start or 0.0 for v in self.ode.interface.inputs.values()])
        if known is None or not names:
            return np.zeros(1), held[None, :], np.zeros((1, len(names)))
        table = np.stack(
            [
                known.values.get(n, np.full(known.time.size, h))
                for n, h in zip(names, held, strict=True)
            ]
        )
        length = np.diff(known.time)
        real = np.flatnonzero(length > 0.0)
        slopes = ((table[:, real + 1] - table[:, real]) / length[real]).T
        return known.time[real], table[:, real].T.copy(), slopes


def courses(end: float, **levels: tuple[tuple[float, float], ...]) -> Inputs:
    """Inputs that are held between steps, each given by (time [s], value [SI]) from which it holds."""
    steps = sorted({time for course in levels.values() for time, _ in course} - {0.0})
    time = np.array([0.0, *np.repeat(steps, 2), end])
    before = np.arange(time.size) % 2 == 1
    return Inputs(
        time, {name: _held(np.array(course), time, before) for name, course in levels.items()}
    )


def _held(course: Array, time: Array, before: NDArray[np.bool_]) -> Array:
    """At the odd samples, which end a piece, the value just before."""
    after = np.searchsorted(course[:, 0], time, side="right") - 1
    until = np.searchsorted(course[:, 0], time, side="left") - 1
    held: Array = course[np.where(before, np.maximum(until, 0), after), 1]
    return held


def _filling(end: float) -> dict[str, tuple[tuple[float, float], ...]]:
    """Currents [A] that fill in two steps, hold, and vent in two steps."""
    return {
        "u_in": ((0.0, 0.35), (0.15 * end, 0.0), (0.3 * end, 0.28), (0.5 * end, 0.0)),
        "u_out": ((0.0, 0.0), (0.6 * end, 0.25), (0.7 * end, 0.0), (0.8 * end, 0.35)),
        "p_supply": ((0.0, _SUPPLY),),
    }


def steps() -> Case:
    """Six steps of the currents in 10 s."""
    return Case("steps", f"{_BENCHES}.Isotonic", courses(10.0, **_filling(10.0)), 10.0)


def smooth() -> Case:
    """Currents that are formulas of time, inside the model: 0.4 Hz."""
    return Case("smooth", str(Path(__file__).with_name("SmoothIsotonic.mo")), None, 10.0)


def sampled() -> Case:
    """Recorded currents: 100 samples a second, joined by lines; the steps of ``steps`` through 50 ms, and noise."""
    noise = np.random.default_rng(1)
    time = np.linspace(0.0, 10.0, 1001)
    held = steps().inputs
    assert held is not None
    values = {"p_supply": np.full(time.size, _SUPPLY)}
    for name in ("u_in", "u_out"):
        level = np.interp(time, held.time + 1e-9 * np.arange(held.time.size), held.values[name])
        lagged = level.copy()
        for i in range(1, time.size):
            lagged[i] = lagged[i - 1] + (level[i] - lagged[i - 1]) * 0.2
        values[name] = lagged + noise.normal(0.0, 5e-4, time.size)
    return Case("sampled", f"{_BENCHES}.Isotonic", Inputs(time, values), 10.0)


def _isometric() -> Inputs:
    """The filling, while the end is moved back and forth along straight lines."""
    currents = courses(10.0, **_filling(10.0))
    time = np.unique(np.concatenate((currents.time, [2.0, 4.0, 5.5, 7.5])))
    bends = np.interp(
        np.arange(0.0, 10.1, 0.5),
        [0.0, 2.0, 4.0, 5.5, 7.5, 10.0],
        [0.0, 0.02, 0.005, 0.03, 0.03, 0.0],
    )
    time = np.sort(np.concatenate((currents.time, np.setdiff1d(time, currents.time))))
    values = {n: _at(currents, n, time) for n in currents.values}
    return Inputs(time, values | {"s": np.interp(time, np.arange(0.0, 10.1, 0.5), bends)})


def _at(inputs: Inputs, name: str, time: Array) -> Array:
    """A held course at other times; a time that stands twice has the values before and after."""
    twice = np.append(np.diff(time) == 0.0, False)
    after = np.searchsorted(inputs.time, time, side="right") - 1
    before = np.searchsorted(inputs.time, time, side="left") - 1
    return inputs.values[name][np.where(twice, np.maximum(before, 0), after)]


def _antagonistic() -> Inputs:
    """The first muscle is filled, the second, both are vented."""
    return courses(
        10.0,
        u_in_1=((0.0, 0.35), (3.0, 0.0)),
        u_out_1=((0.0, 0.0), (4.0, 0.35), (7.0, 0.2)),
        u_in_2=((0.0, 0.0), (4.0, 0.35), (7.0, 0.0)),
        u_out_2=((0.0, 0.25), (4.0, 0.0), (8.0, 0.3)),
        p_supply=((0.0, _SUPPLY),),
    )


def _regulated() -> Inputs:
    """Steps and a ramp of the pressure that the regulator is told."""
    return Inputs(
        np.array([0.0, 0.5, 0.5, 1.0, 1.5, 2.0]),
        {"p_in": np.array([4.5e5, 4.5e5, 2e5, 2e5, 5e5, 5e5])},
    )


def _grid() -> Inputs:
    """Ramps of pressure at rising contraction."""
    time = np.linspace(0.0, 1.0, 11)
    return Inputs(time, {"p": np.tile([1e5, 6e5], 6)[:11], "eps": 0.25 * time})


def _wave() -> Inputs:
    """A pressure wave of 0.5 Hz in 20 lines a second."""
    time = np.linspace(0.0, 10.0, 201)
    return Inputs(time, {"p": 200e3 - 100e3 * np.cos(np.pi * time)})


_BENCH_INPUTS: Mapping[str, tuple[Callable[[], Inputs | None], float]] = {
    "Antagonistic": (_antagonistic, 10.0),
    "Isometric": (_isometric, 10.0),
    "Isotonic": (lambda: steps().inputs, 10.0),
    "LumpedLinear": (_regulated, 2.0),
    "StaticForce": (_grid, 1.0),
    "TankFilling": (lambda: courses(60.0, **_filling(60.0)), 60.0),
    "VerticalLoad": (_wave, 10.0),
    "VesselOrifice": (lambda: None, 60.0),
}


def bench_names() -> list[str]:
    """The benches that have inputs here."""
    return sorted(_BENCH_INPUTS)


def bench(name: str) -> Case:
    """A bench under its inputs.

    Raises:
        SystemExit: a bench that has no inputs here.
    """
    if name not in _BENCH_INPUTS:
        raise SystemExit(
            f"benchmarks/speed/cases.py has no inputs for the bench '{name}': add them to _BENCH_INPUTS"
        )
    inputs, end = _BENCH_INPUTS[name]
    return Case(name, f"{_BENCHES}.{name}", inputs(), end)
