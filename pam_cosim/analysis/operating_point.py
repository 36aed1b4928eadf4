"""The point about which a model is linearised: a given state, a rest that is looked for, a time of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.analysis.flow import constant_course, flow
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.units import format_quantity, quotient

# A state rests that changes by less than this part of its size in a second; a condition holds within the same part.
STILL = 1e-6
# Runs towards a rest are prolonged until nothing changes by more than this part of its size in a second.
_NEARLY_STILL = 1e-4
_LONGEST = 64  # default durations of the model

# The kinds of points: as given, found at rest, met on a run.
GIVEN, REST, RUN = "given", "rest", "run"


@dataclass(frozen=True)
class OperatingPoint:
    """Where a model was linearised.

    Attributes:
        kind: "given", "rest" or "run".
        time: [s].
        states, inputs, outputs: values by name [``units``].
        rates: of the states, per second.
        units: of states, inputs and outputs.
        parameters: by name [SI], what differs from the model's defaults.
        how: how it was found, in words.
    """

    kind: str
    time: float
    states: dict[str, float]
    inputs: dict[str, float]
    outputs: dict[str, float]
    rates: dict[str, float]
    units: dict[str, str]
    parameters: dict[str, float]
    how: str

    def __str__(self) -> str:
        parts = [f"{self.how}, at {self.time:g} s"] if self.time else [self.how]
        for title, values in (
            ("states", self.states),
            ("inputs", self.inputs),
            ("outputs", self.outputs),
        ):
            if values:
                listed = ", ".join(
                    f"{n} = {format_quantity(v, self.units.get(n, ''), 5)}"
                    for n, v in values.items()
                )
                parts.append(f"  {title}: {listed}")
        return "\n".join(parts)


def present(
    model: ExchangeModel,
    outputs: Sequence[str],
    kind: str,
    how: str,
    parameters: Mapping[str, float],
) -> OperatingPoint:
    """The point at which the model is now."""
    inputs = list(model.interface.inputs)
    names = [*model.states, *inputs, *outputs]
    return OperatingPoint(
        kind,
        model.time,
        dict(zip(model.states, model.state().tolist(), strict=True)),
        dict(zip(inputs, model.inputs().tolist(), strict=True)),
        dict(zip(outputs, model.values(outputs).tolist(), strict=True)),
        dict(zip(model.states, model.rates().tolist(), strict=True)),
        {name: model.unit(name) for name in names},
        dict(parameters),
        how,
    )


def go_to_state(model: ExchangeModel, conditions: Mapping[str, float]) -> str:
    """Takes the model to a state at which variables have given values; says how it was found.

    Named states and inputs take their values. Where another variable is named, such as an output, those states that
    are not named change as little as they must, measured by their nominal sizes.

    Raises:
        InputError: an unknown name; no state has these values.
    """
    names = list(conditions)
    model.check(names)
    _set_known(model, conditions)
    implied = [n for n in names if n not in model.states and n not in model.interface.inputs]
    if not implied:
        return "at the given state"
    size = np.array([max(abs(conditions[n]), model.scale(n)) for n in implied])
    wanted = np.array([conditions[n] for n in implied])
    _move_loose(model, [n for n in model.states if n not in conditions], implied, wanted, size)
    reached = model.values(implied)
    if not np.all(np.abs(wanted - reached) <= STILL * size):
        worst = int(np.argmax(np.abs(wanted - reached) / size))
        name, unit = implied[worst], model.unit(implied[worst])
        aim, nearest = (
            format_quantity(float(values[worst]), unit, 6) for values in (wanted, reached)
        )
        raise InputError(
            f"no state was found at which {name} is {aim}: nearest is {nearest}; "
            f"states: {', '.join(model.states) or 'none'}"
        )
    return "at the state nearest to the start at which " + ", ".join(
        _said(model, n, conditions[n]) for n in implied
    )


def _move_loose(
    model: ExchangeModel, loose: Sequence[str], implied: Sequence[str], wanted: Array, size: Array
) -> None:
    """Moves the loose states, as little as they must over their nominal sizes, to where other variables are wanted."""
    scale = np.array([model.scale(n) for n in loose])
    positions = [model.states.index(n) for n in loose]
    for _ in range(50):
        miss = (wanted - model.values(implied)) / size
        if np.abs(miss).max() <= STILL * 1e-4:
            return
        slope = model.jacobian(implied, loose)[0] * scale / size[:, None]
        step = np.linalg.lstsq(slope, miss, rcond=1e-10)[0] * scale if loose else np.zeros(0)
        state = model.state()
        state[positions] += step
        model.set(state=state)


def _said(model: ExchangeModel, name: str, value: float) -> str:
    return f"{name} = {format_quantity(value, model.unit(name), 6)}"


def _set_known(model: ExchangeModel, conditions: Mapping[str, float]) -> None:
    state, inputs = model.state(), model.inputs()
    for i, name in enumerate(model.states):
        state[i] = conditions.get(name, state[i])
    for i, name in enumerate(model.interface.inputs):
        inputs[i] = conditions.get(name, inputs[i])
    model.set(state=state, inputs=inputs)


def go_to_rest(model: ExchangeModel, conditions: Mapping[str, float], free: Sequence[str]) -> str:
    """Takes the model to a state at which nothing changes; says how it was found.

    The model runs with constant inputs until it hardly changes; from there, or from the start where it does not
    settle, the equations are solved.

    Args:
        model: initialised.
        conditions: values that variables shall have there.
        free: inputs that are found along with the states.

    Raises:
        InputError: an unknown name; there is no rest, or none was found: says what goes on changing.
    """
    model.check(list(conditions))
    model.check(list(free), "input")
    for name in free:
        if name in conditions:
            raise InputError(f"'{name}' is given and free; keep one of them")
    _set_known(model, conditions)
    start, inputs = model.state(), model.inputs()
    settled, duration = _settle(model, start, inputs)
    problem = _Rest(model, conditions, free)
    starts = [s for s in (settled, start) if s is not None]
    for state in starts:
        model.set(state=state, inputs=inputs)
        moved = problem.solve()
        if problem.is_met():
            what = "at rest"
            if free:
                values = zip(free, model.values(free).tolist(), strict=True)
                what += " with " + ", ".join(_said(model, n, v) for n, v in values)
            if state is settled and moved < 0.01:
                return f"{what}, where a run with constant inputs settles within {duration:g} s"
            origin = (
                f"the end of a run of {duration:g} s" if state is settled else "the start values"
            )
            return f"{what}, found from {origin}"
    raise InputError(_no_rest(model, problem, free, duration))


def _no_rest(model: ExchangeModel, problem: _Rest, free: Sequence[str], duration: float) -> str:
    name, text = problem.worst()
    inputs = ", ".join(n for n in model.interface.inputs if n not in free) or "none"
    return (
        f"no rest was found: after {duration:g} s and from there by solving the equations, {text}. "
        f"Hold the inputs at other values, or let the solver choose one of them (free: {inputs}); "
        f"or linearise at a given state or at a time of a run"
    )


def _settle(model: ExchangeModel, start: Array, inputs: Array) -> tuple[Array | None, float]:
    """The state after a run long enough for it to settle, and how long that was; None where it runs away."""
    state, duration, end = start, model.interface.stop_time, 0.0
    first = model.time
    scale = np.array([model.scale(n) for n in model.states])
    try:
        while end < _LONGEST * duration:
            span = max(end, duration)
            state = flow(
                model, state, np.array([first + end, first + end + span]), constant_course(inputs)
            )[:, -1]
            end += span
            model.set(first, state, inputs)
            if np.all(np.abs(model.rates()) <= _NEARLY_STILL * np.maximum(np.abs(state), scale)):
                break
        return state, end
    except SimulationFailure:
        model.set(first, start, inputs)
        return None, end
    finally:
        model.set(time=first)


class _Rest:
    """The equations of a rest: no rate, and the conditions; unknown are the states and the free inputs."""

    def __init__(
        self, model: ExchangeModel, conditions: Mapping[str, float], free: Sequence[str]
    ) -> None:
        self.model, self.free = model, list(free)
        self.held = {n: v for n, v in conditions.items() if n not in model.interface.inputs}
        self.names = [*model.rate_names, *self.held]
        self.unknowns = [*model.states, *self.free]
        self.scale = np.array([model.scale(n) for n in self.unknowns])
        self.size = np.array(
            [model.scale(n) for n in model.states]
            + [max(abs(v), model.scale(n)) for n, v in self.held.items()]
        )
        self.target = np.array([0.0] * len(model.states) + list(self.held.values()))
        self._places = [list(model.interface.inputs).index(n) for n in self.free]

    def _go(self, z: Array) -> None:
        n = len(self.model.states)
        inputs = self.model.inputs()
        inputs[self._places] = z[n:] * self.scale[n:]
        self.model.set(state=z[:n] * self.scale[:n], inputs=inputs)

    def residual(self, z: Array) -> Array:
        self._go(z)
        return np.asarray((self.model.values(self.names) - self.target) / self.size)

    def slope(self, z: Array) -> Array:
        self._go(z)
        return np.asarray(
            self.model.jacobian(self.names, self.unknowns)[0] * self.scale / self.size[:, None]
        )

    def solve(self) -> float:
        """Solves from where the model is; how far it moved, in nominal sizes."""
        model = self.model
        if not self.unknowns:
            return 0.0
        begin = np.append(model.state(), model.values(self.free)) / self.scale
        low, high = self._bounds()
        begin = np.clip(begin, low, high)
        try:
            point = least_squares(
                self.residual,
                begin,
                self.slope,
                (low, high),
                x_scale="jac",
                xtol=1e-14,
                ftol=1e-14,
                gtol=1e-14,
            ).x
        except (SimulationFailure, ValueError):  # a trial beyond what the model can say
            point = begin
        self._go(point)
        return float(np.abs(point - begin).max())

    def _bounds(self) -> tuple[Array, Array]:
        low, high = [], []
        for name in self.unknowns:
            variable = self.model.variable(name)
            low.append(-np.inf if variable is None or variable.min is None else variable.min)
            high.append(np.inf if variable is None or variable.max is None else variable.max)
        return np.array(low) / self.scale, np.array(high) / self.scale

    def _misses(self) -> Array:
        z = np.append(self.model.state(), self.model.values(self.free))
        present = np.maximum(
            np.abs(z[: len(self.model.states)]), self.scale[: len(self.model.states)]
        )
        size = np.append(present, self.size[len(self.model.states) :])
        return np.asarray(np.abs(self.model.values(self.names) - self.target) / size)

    def is_met(self) -> bool:
        return bool(np.all(self._misses() <= STILL)) if self.names else True

    def worst(self) -> tuple[str, str]:
        """The name of what is furthest from its aim, and a text that says so."""
        at = int(np.argmax(self._misses()))
        value = float(self.model.values([self.names[at]])[0])
        if at < len(self.model.states):
            name = self.model.states[at]
            unit = self.model.unit(name)
            return name, f"{name} still changes by {format_quantity(value, quotient(unit, 's'))}"
        name = self.names[at]
        wanted = format_quantity(float(self.target[at]), self.model.unit(name))
        return name, f"{name} is {format_quantity(value, self.model.unit(name))}, not {wanted}"
