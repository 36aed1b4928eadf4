"""Where a model rests: Newton's method for states that do not change."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.optimize import least_squares

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.analysis.flow import constant_input, flow
from pam_cosim.analysis.operating_point import STILL, set_known, stated_value
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.units import format_quantity, quotient

# Runs towards a rest are prolonged until nothing changes by more than this part of its size in a second.
_NEARLY_STILL = 1e-4
_LONGEST = 64  # default durations of the model


def go_to_rest(model: ExchangeModel, conditions: Mapping[str, float], free: Sequence[str]) -> str:
    """Takes the model to a state at which nothing changes; returns how it was found.

    The model runs with constant inputs until it hardly changes; from there, or from the start where it does not
    settle, the equations are solved.

    Args:
        model: initialised.
        conditions: values that variables shall have there.
        free: inputs that are found along with the states.

    Raises:
        InputError: an unknown name; there is no rest, or none was found; the message names what still changes.
    """
    model.check(list(conditions))
    model.check(list(free), "input")
    for name in free:
        if name in conditions:
            raise InputError(f"'{name}' is given and free; keep one of them")
    set_known(model, conditions)
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
                what += " with " + ", ".join(stated_value(model, n, v) for n, v in values)
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
    begin = model.time
    scale = np.array([model.scale(n) for n in model.states])
    try:
        while end < _LONGEST * duration:
            span = max(end, duration)
            state = flow(
                model, state, np.array([begin + end, begin + end + span]), constant_input(inputs)
            )[:, -1]
            end += span
            model.set(begin, state, inputs)
            if np.all(np.abs(model.rates()) <= _NEARLY_STILL * np.maximum(np.abs(state), scale)):
                break
        return state, end
    except SimulationFailure:
        model.set(begin, start, inputs)
        return None, end
    finally:
        model.set(time=begin)


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
        """The name of the quantity that is furthest from its aim, and a message."""
        at = int(np.argmax(self._misses()))
        value = float(self.model.values([self.names[at]])[0])
        if at < len(self.model.states):
            name = self.model.states[at]
            unit = self.model.unit(name)
            return name, f"{name} still changes by {format_quantity(value, quotient(unit, 's'))}"
        name = self.names[at]
        wanted = format_quantity(float(self.target[at]), self.model.unit(name))
        return name, f"{name} is {format_quantity(value, self.model.unit(name))}, not {wanted}"
