"""The model by itself on the grid of a ledger: Radau IIA of order 3, all runs side by side."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pam_cosim.ledger.grid import STAGE, Grid
from pam_cosim.ledger.model import Model

Array = NDArray[np.float64]

_ITERATIONS = 12
_CLOSE = 1e-7  # change of a state, over its size, at which an iteration ends


def march(model: Model, grid: Grid, parameters: Array) -> tuple[Array, Array]:
    """States at the nodes (N, n) and inside the steps (M, n), holes closed, (R, P) parameters [SI].

    Where the iteration breaks down, a state stays what it was: what follows is a start for the smoother, no more.
    """
    count = np.diff(grid.first)
    x = model.initial(parameters)
    nodes, stages = np.empty((grid.first[-1], x.shape[1])), np.empty((len(grid.left), x.shape[1]))
    nodes[grid.first[:-1]] = x
    first_step = grid.first[:-1] - np.arange(len(count))
    size = np.maximum(np.abs(x), 1e-3)
    for k in range(int(count.max()) - 1):
        live = np.flatnonzero(k < count - 1)
        step = first_step[live] + k
        s, x[live] = _step(model, grid, parameters[live], x[live], step, size[live])
        size = np.maximum(size, np.abs(x))
        stages[step], nodes[grid.left[step] + 1] = s, x[live]
    return nodes, stages


def _step(model: Model, grid: Grid, p: Array, x: Array, step: NDArray[np.intp], size: Array) -> tuple[Array, Array]:
    h = grid.step[step][:, None]
    r, n = x.shape
    at = grid.time[grid.left[step]]
    t = np.concatenate([at + STAGE * h[:, 0], at + h[:, 0]])
    u = np.concatenate([grid.stage_inputs[step], grid.node_inputs[grid.left[step] + 1]])
    d = np.concatenate([grid.stage_delayed[step], grid.node_delayed[grid.left[step] + 1]])
    both = np.concatenate([p, p])
    s, y = x.copy(), x.copy()
    eye = np.eye(n)
    for _ in range(_ITERATIONS):
        f = model.rates(t, np.concatenate([s, y]), u, d, both)
        f1, f2, a1, a2 = f.value[:r], f.value[r:], f.by_state[:r], f.by_state[r:]
        hh = h[:, :, None]
        residual = np.concatenate([s - x - h * (5 * f1 - f2) / 12, y - x - h * (3 * f1 + f2) / 4], axis=1)
        top = np.concatenate([eye - hh * a1 * 5 / 12, hh * a2 / 12], axis=2)
        bottom = np.concatenate([-hh * a1 * 3 / 4, eye - hh * a2 / 4], axis=2)
        change = np.linalg.solve(np.concatenate([top, bottom], axis=1), residual[:, :, None])[:, :, 0]
        if not np.isfinite(change).all():
            return x, x
        s, y = s - change[:, :n], y - change[:, n:]
        if (np.abs(change) <= _CLOSE * np.concatenate([size, size], axis=1)).all():
            break
    return s, y
