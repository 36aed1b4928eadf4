"""Regression without physics on the rows of a data set: ridge, and boosted trees where scikit-learn is installed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations_with_replacement
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Errors = dict[str, float]
Method = Callable[[Array, Array, Array], Array]  # fitted rows, their values, rows: predictions

_HORIZONS = (0.1, 0.3, 1.0, 3.0, 10.0)  # of the means of what was commanded before [s]
_PENALTIES = (1e-3, 1e-1, 1e1, 1e3)  # of ridge, beside rows that are scaled to one


def rival_errors(fitted: Sequence[Any], held_out: Sequence[Any]) -> dict[str, Errors]:
    """Root mean square error on held-out runs, by method and signal, in the units of the runs."""
    signals = sorted({s for run in fitted for s in run.measurements})
    names = sorted({n for run in [*fitted, *held_out] for n in run.parameters if "start" not in n})
    errors: dict[str, Errors] = {}
    for method, regression in methods().items():
        errors[method] = {}
        for signal in signals:
            rows, values = zip(*(_rows(r, signal, signals, names) for r in fitted), strict=True)
            tests = [_rows(r, signal, signals, names) for r in held_out]
            if not tests:
                continue
            predicted = [regression(np.vstack(rows), np.concatenate(values), x) for x, _ in tests]
            left = np.concatenate([p - y for p, (_, y) in zip(predicted, tests, strict=True)])
            errors[method][signal] = float(np.sqrt(np.mean(left**2)))
    return errors


def methods() -> dict[str, Method]:
    """What is compared with."""
    found: dict[str, Method] = {"ridge": _ridge}
    try:
        from sklearn.ensemble import HistGradientBoostingRegressor
    except ModuleNotFoundError:
        return found
    return found | {
        "trees": lambda x, y, at: (
            HistGradientBoostingRegressor(random_state=0).fit(x, y).predict(at)
        )
    }


def _rows(
    run: Any, signal: str, signals: Sequence[str], names: Sequence[str]
) -> tuple[Array, Array]:
    """Rows of a run where the signal was measured, and its values there."""
    t = run.time - run.time[0]
    columns = []
    for values in run.inputs.values():
        columns.append(values)
        integral = np.concatenate([[0.0], np.cumsum(np.diff(t) * values[:-1])])
        for horizon in _HORIZONS:
            before = np.interp(t - horizon, t, integral)
            before += np.minimum(t - horizon, 0.0) * values[0]  # as at first, before the first row
            columns.append((integral - before) / horizon)
    columns += [np.full(len(t), run.parameters.get(n, 0.0)) for n in names]
    for s in signals:
        measured = run.measurements.get(s, np.full(len(t), np.nan))
        present = measured[~np.isnan(measured)]
        columns.append(np.full(len(t), present[0] if len(present) else 0.0))
    columns.append(np.minimum(t, 10.0))
    kept = ~np.isnan(run.measurements[signal])
    return np.column_stack(columns)[kept], run.measurements[signal][kept]


def _ridge(x: Array, y: Array, at: Array) -> Array:
    """Ridge regression on features and their products; the penalty is chosen on the last fifth of the rows."""
    mean, scale = x.mean(0), x.std(0)
    scale[scale < 1e-12 * (1 + np.abs(mean))] = np.inf
    rows, others = _products((x - mean) / scale), _products((at - mean) / scale)
    cut = len(rows) * 4 // 5

    def weights(a: Array, b: Array, penalty: float) -> Array:
        centre = a - a.mean(0)
        normal = centre.T @ centre / len(a) + penalty * np.eye(a.shape[1])
        solved: Array = np.linalg.solve(normal, centre.T @ (b - b.mean()) / len(a))
        return solved

    def predicted(a: Array, b: Array, penalty: float, to: Array) -> Array:
        return b.mean() + (to - a.mean(0)) @ weights(a, b, penalty)

    def left(penalty: float) -> float:
        error = predicted(rows[:cut], y[:cut], penalty, rows[cut:]) - y[cut:]
        return float(np.mean(error**2))

    return predicted(rows, y, min(_PENALTIES, key=left), others)


def _products(x: Array) -> Array:
    x = np.clip(x, -4.0, 4.0)
    pairs = combinations_with_replacement(range(x.shape[1]), 2)
    return np.column_stack([x, *(x[:, i] * x[:, j] for i, j in pairs)])
