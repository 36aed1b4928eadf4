"""A model and a point -> its linear model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pam_cosim.analysis.exchange import DIFFERENCES, ExchangeModel
from pam_cosim.analysis.linear import LinearModel
from pam_cosim.analysis.operating_point import GIVEN, REST, RUN, STILL, go_to_state, present
from pam_cosim.analysis.rest_point import go_to_rest

_BY_DIFFERENCES = (
    "The FMU gives no directional derivatives for all of this, so they are central differences: some eight digits are "
    "right where the model is smooth."
)


def linearise_at(
    model: ExchangeModel,
    parameters: Mapping[str, float],
    conditions: Mapping[str, float],
    at_rest: bool,
    free: Sequence[str],
    outputs: Sequence[str] | None,
) -> LinearModel:
    """The linear model at a given state, or at a rest; see ``go_to_state`` and ``go_to_rest``."""
    model.restart(parameters)
    how = go_to_rest(model, conditions, free) if at_rest else go_to_state(model, conditions)
    return linear_model(model, outputs, REST if at_rest else GIVEN, how, parameters)


def linearise_run(
    model: ExchangeModel,
    parameters: Mapping[str, float],
    points: Sequence[tuple[float, Mapping[str, float]]],
    outputs: Sequence[str] | None,
) -> list[LinearModel]:
    """The linear models at points of a run: times [s] with the values of all states and inputs there."""
    model.restart(parameters, points[0][0])
    linear_models = []
    for time, values in points:
        state = np.array([values[name] for name in model.states])
        inputs = np.array([values[name] for name in model.interface.inputs])
        model.set(time, state, inputs)
        linear_models.append(linear_model(model, outputs, RUN, "at a time of a run", parameters))
    return linear_models


def linear_model(
    model: ExchangeModel,
    outputs: Sequence[str] | None,
    kind: str,
    how: str,
    parameters: Mapping[str, float],
) -> LinearModel:
    """The linear model where ``model`` is now."""
    chosen = list(model.interface.outputs if outputs is None else outputs)
    model.check(chosen)
    inputs = list(model.interface.inputs)
    rows, columns = [*model.rate_names, *chosen], [*model.states, *inputs]
    matrix, method = model.jacobian(rows, columns)
    matrix = matrix + 0.0  # no negative zeros
    n = len(model.states)
    point = present(model, chosen, kind, how, parameters)
    notes = [_BY_DIFFERENCES] if method == DIFFERENCES else []
    sizes = {name: max(abs(value), model.scale(name)) for name, value in point.states.items()}
    moving = [name for name, rate in point.rates.items() if abs(rate) > STILL * sizes[name]]
    if moving:
        notes.append(
            f"Not at rest: {', '.join(moving)} changes there, and deviations count from that trajectory."
        )
    if model.event_indicators:
        notes.append("The FMU has events; its discrete states are those of the start.")
    return LinearModel(
        model.interface.model,
        matrix[:n, :n],
        matrix[:n, n:],
        matrix[n:, :n],
        matrix[n:, n:],
        tuple(model.states),
        tuple(inputs),
        tuple(chosen),
        {name: model.unit(name) for name in [*columns, *chosen]},
        point,
        method,
        tuple(notes),
    )
