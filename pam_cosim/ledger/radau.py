"""The model by itself integrated on the grid of a ledger: Radau IIA of order 3, all runs side by side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.ledger.grid import STAGE, Grid
from pam_cosim.ledger.model import Model

_ITERATIONS = 12
_MOST_PARTS = 8  # of a step
_CLOSE = 1e-7  # change of a state, over its size, at which an iteration ends


def integrate(model: Model, grid: Grid, parameters: Array) -> tuple[Array, Array]:
    """States at the nodes (N, n) and inside the steps (M, n), unknown inputs at zero, (R, P) parameters [SI].

    Where the iteration breaks down, a state stays what it was: what follows is a start for the smoother, no more.
    """
    count = np.diff(grid.first)
    x = model.initial(parameters, grid)
    nodes, stages = (
        np.empty((grid.first[-1], x.shape[1])),
        np.empty((len(grid.start_node), x.shape[1])),
    )
    nodes[grid.first[:-1]] = x
    first_step = grid.first[:-1] - np.arange(len(count))
    size = np.maximum(np.abs(x), 1e-3)
    for k in range(int(count.max()) - 1):
        live = np.flatnonzero(k < count - 1)
        step = first_step[live] + k
        s, x[live] = _step(model, grid, parameters[live], x[live], step, size[live])
        size = np.maximum(size, np.abs(x))
        stages[step], nodes[grid.start_node[step] + 1] = s, x[live]
    return nodes, stages


def further_nodes(
    model: Model, grid: Grid, parameters: Array, states: tuple[Array, Array], accuracy: float
) -> list[Array]:
    """Times inside steps (one array a run) that lower the error of a step to ``accuracy`` of the range of a state.

    The error is what two half steps make different.
    """
    x = states[0]
    size = np.maximum(np.ptp(x, axis=0), 1e-3 * np.max(np.abs(x), axis=0)) + 1e-300
    steps = np.arange(len(grid.start_node))
    run = grid.run_of_node[grid.start_node]
    middle = x[grid.start_node]
    for half in range(2):
        _, middle = _step(model, _halved(grid, half), parameters[run], middle, steps, size, half)
    error = np.max(np.abs(middle - x[grid.start_node + 1]) / size, axis=1)
    parts = np.minimum(
        np.ceil((np.nan_to_num(error, nan=1.0) / accuracy) ** 0.25), _MOST_PARTS
    ).astype(int)
    times = []
    for r in range(len(grid.runs)):
        split_intervals = np.flatnonzero((run == r) & (parts > 1))
        inside = [
            grid.time[grid.start_node[k]] + grid.step[k] * np.arange(1, parts[k]) / parts[k]
            for k in split_intervals.tolist()
        ]
        times.append(np.concatenate([np.zeros(0), *inside]))
    return times


def _halved(grid: Grid, half: int) -> Grid:
    """The grid with half of every step, and inputs between those that it knows: at a third and at the end."""
    u1, u2, d1, d2 = (
        grid.stage_inputs,
        grid.node_inputs[grid.start_node + 1],
        grid.stage_delayed,
        grid.node_delayed[grid.start_node + 1],
    )
    c1, c2 = (STAGE / 2, 0.5) if half == 0 else (0.5 + STAGE / 2, 1.0)

    def at(c: float, inner: Array, end: Array) -> Array:
        return inner + (c - STAGE) / (1 - STAGE) * (end - inner)

    node_u, node_d = grid.node_inputs.copy(), grid.node_delayed.copy()
    node_u[grid.start_node + 1], node_d[grid.start_node + 1] = at(c2, u1, u2), at(c2, d1, d2)
    return replace(
        grid,
        step=grid.step / 2,
        stage_inputs=at(c1, u1, u2),
        stage_delayed=at(c1, d1, d2),
        node_inputs=node_u,
        node_delayed=node_d,
    )


def _step(
    model: Model,
    grid: Grid,
    p: Array,
    x: Array,
    step: NDArray[np.intp],
    size: Array,
    offset: float = 0.0,
) -> tuple[Array, Array]:
    """One step of each of some runs; ``offset``, in steps, is where it starts after its node."""
    h = grid.step[step][:, None]
    r, n = x.shape
    size = np.broadcast_to(size, x.shape)
    at = grid.time[grid.start_node[step]] + offset * h[:, 0]
    t = np.concatenate([at + STAGE * h[:, 0], at + h[:, 0]])
    u = np.concatenate([grid.stage_inputs[step], grid.node_inputs[grid.start_node[step] + 1]])
    d = np.concatenate([grid.stage_delayed[step], grid.node_delayed[grid.start_node[step] + 1]])
    parameters_of_both = np.concatenate([p, p])
    s, y = x.copy(), x.copy()
    eye = np.eye(n)
    for _ in range(_ITERATIONS):
        f = model.rates(t, np.concatenate([s, y]), u, d, parameters_of_both)
        f1, f2, a1, a2 = f.value[:r], f.value[r:], f.by_state[:r], f.by_state[r:]
        hh = h[:, :, None]
        residual = np.concatenate(
            [s - x - h * (5 * f1 - f2) / 12, y - x - h * (3 * f1 + f2) / 4], axis=1
        )
        top = np.concatenate([eye - hh * a1 * 5 / 12, hh * a2 / 12], axis=2)
        bottom = np.concatenate([-hh * a1 * 3 / 4, eye - hh * a2 / 4], axis=2)
        change = np.linalg.solve(np.concatenate([top, bottom], axis=1), residual[:, :, None])[
            :, :, 0
        ]
        if not np.isfinite(change).all():
            return x, x
        s, y = s - change[:, :n], y - change[:, n:]
        if (np.abs(change) <= _CLOSE * np.concatenate([size, size], axis=1)).all():
            break
    return s, y
