"""The point about which a model is linearised: a given state, a rest that is looked for, a time of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.analysis.exchange import ExchangeModel
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed

# A state rests that changes by less than this part of its size in a second; a condition holds within the same part.
STILL = 1e-6

# The kinds of points: as given, found at rest, met on a run.
GIVEN, REST, RUN = "given", "rest", "run"


@dataclass(frozen=True)
class OperatingPoint(Printed):
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

    json_keys = "kind how time states inputs outputs rates parameters"

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
    """Takes the model to a state at which variables have given values; returns how it was found.

    Named states and inputs take their values. Where another variable is named, such as an output, those states that
    are not named change as little as they must, measured by their nominal sizes.

    Raises:
        InputError: an unknown name; no state has these values.
    """
    names = list(conditions)
    model.check(names)
    set_known(model, conditions)
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
        stated_value(model, n, conditions[n]) for n in implied
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


def stated_value(model: ExchangeModel, name: str, value: float) -> str:
    """A value as text, in its unit."""
    return f"{name} = {format_quantity(value, model.unit(name), 6)}"


def set_known(model: ExchangeModel, conditions: Mapping[str, float]) -> None:
    """Sets the states and inputs whose values are stated."""
    state, inputs = model.state(), model.inputs()
    for i, name in enumerate(model.states):
        state[i] = conditions.get(name, state[i])
    for i, name in enumerate(model.interface.inputs):
        inputs[i] = conditions.get(name, inputs[i])
    model.set(state=state, inputs=inputs)
