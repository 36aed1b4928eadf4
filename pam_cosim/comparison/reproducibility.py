"""Does the residual of one run tell that of another? Noise does not, whatever its colour; a missing effect does.

The residual of each signal is regressed (ridge) on functions of the model's own signals and inputs in all runs but
one, and the regression predicts the run left out. What it predicts there is systematic: the rig does the same thing
again in the same circumstances. A slow drift of an instrument, or noise that is correlated in time, is not.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.rounding import expected_squares, standardized_residuals
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import Signal


@dataclass(frozen=True)
class Reproducibility:
    """How much of a residual other runs predict.

    Attributes:
        variance: mean square that is predicted, in noise variances; negative where the regression only does harm.
        score: ``variance`` in standard errors over the parts that were left out in turn.
    """

    variance: float
    score: float


def reproducibility(
    runs: Sequence[RunComparison], signals: Mapping[str, Signal]
) -> Reproducibility:
    """Judges the residuals of all runs together.

    Args:
        runs: more tell more; NaN where they are too few to tell.
        signals: by name; those that are fitted count.
    """
    unknown = Reproducibility(float("nan"), float("nan"))
    if not runs:
        return unknown
    gains: dict[int, float] = {}
    total = 0.0
    tables, parts = _features(runs), _left_out_parts(runs)
    for signal in signals.values():
        seen = [r if r.run.sample_count(signal.name) else None for r in runs]
        pieces = _pieces(tables, seen, parts, signal) if signal.fitted else {}
        if len(pieces) < 2:
            continue
        total += sum(
            _effective_samples(r.residual(signal.name), signal) for r in seen if r is not None
        )
        for number, gain in _gains(pieces).items():
            gains[number] = gains.get(number, 0.0) + gain
    if total == 0 or len(gains) < 2:
        return unknown
    by_piece = np.array([gains[k] for k in sorted(gains)])
    error = float(np.std(by_piece, ddof=1)) * np.sqrt(len(by_piece))
    return Reproducibility(
        float(by_piece.sum()) / total, float(by_piece.sum()) / error if error > 0 else 0.0
    )


def _pieces(
    tables: Sequence[Array],
    runs: Sequence[RunComparison | None],
    parts: Sequence[tuple[int, slice]],
    signal: Signal,
) -> dict[int, tuple[Array, Array]]:
    """Features and weighted residuals of each part that has samples, by its number."""
    name = signal.name
    residuals = [
        None
        if r is None
        else standardized_residuals(r.residual(name), signal, r.run.measurements[name])
        for r in runs
    ]
    pieces = {number: _piece(tables, residuals, where) for number, where in enumerate(parts)}
    return {number: piece for number, piece in pieces.items() if piece is not None}


def _gains(pieces: Mapping[int, tuple[Array, Array]]) -> dict[int, float]:
    """By how much each piece's sum of squares falls, where the others predict it (ridge regression)."""
    gram = sum(x.T @ x for x, _ in pieces.values())
    moment = sum(x.T @ e for x, e in pieces.values())
    samples = sum(len(e) for _, e in pieces.values())
    gains = {}
    for number, (x, e) in pieces.items():
        ridge = CRITERIA.residuals.ridge * (samples - len(e)) * np.eye(x.shape[1])
        weights = np.linalg.solve(gram - x.T @ x + ridge, moment - x.T @ e)
        gains[number] = float(np.sum(e**2) - np.sum((e - x @ weights) ** 2))
    return gains


def _effective_samples(error: Array, signal: Signal) -> float:
    """How many samples an error counts for, missing ones aside."""
    return float(np.sum(expected_squares(error[np.isfinite(error)], signal)))


def _left_out_parts(runs: Sequence[RunComparison]) -> list[tuple[int, slice]]:
    """What is left out in turn: whole runs, or thirds of the few there are."""
    if len(runs) >= CRITERIA.residuals.runs_to_leave_out:
        return [(i, slice(None)) for i in range(len(runs))]
    cuts = [(i, np.linspace(0, len(r.run.time), 4).astype(int)) for i, r in enumerate(runs)]
    return [(i, slice(int(c[k]), int(c[k + 1]))) for i, c in cuts for k in range(3)]


def _piece(
    tables: Sequence[Array], residuals: Sequence[Array | None], where: tuple[int, slice]
) -> tuple[Array, Array] | None:
    run, rows = where
    residual = residuals[run]
    if residual is None:
        return None
    e, x = residual[rows], tables[run][rows]
    kept = np.isfinite(e)
    return (x[kept], e[kept]) if kept.any() else None


def _features(runs: Sequence[RunComparison]) -> list[Array]:
    """Per run (n, features): the model's outputs and the inputs, their rates, what went before, products of two."""
    outputs = _scaled([np.column_stack(list(r.model.values())) for r in runs], centred=True)
    rates = _scaled([_rates(r) for r in runs])
    varied = [n for n in runs[0].run.inputs if any(np.ptp(r.run.inputs[n]) > 0 for r in runs)]
    inputs = [
        np.column_stack([np.ones(len(r.run.time)), *(r.run.inputs[n] for n in varied)])
        for r in runs
    ]
    past = _scaled([_past(r, varied) for r in runs])
    tables = []
    for now, rate, given, before in zip(outputs, rates, inputs, past, strict=True):
        factors = np.column_stack([now, rate, np.tanh(2 * rate)])
        pairs = [
            factors[:, i] * factors[:, j] for i in range(factors.shape[1]) for j in range(i + 1)
        ]
        tables.append(np.column_stack([given, factors, before, *pairs]))
    return _scaled(tables)


def _rates(r: RunComparison) -> Array:
    """(n, outputs) of the model; of points at rest, in their place, what is imposed."""
    if r.run.is_static:
        return np.column_stack(list(r.run.inputs.values()))
    return _column_by_column(_rate, r.run.time, list(r.model.values()))


def _past(r: RunComparison, inputs: Sequence[str]) -> Array:
    columns = [*r.model.values(), *(r.run.inputs[n] for n in inputs)]
    if r.run.is_static:
        return np.zeros((len(r.run.time), len(columns) * len(CRITERIA.residuals.memories)))
    return np.column_stack(
        [
            v - _lagged(r.run.time, v, memory)
            for v in columns
            for memory in CRITERIA.residuals.memories
        ]
    )


def _column_by_column(
    function: Callable[[Array, Array], Array], time: Array, columns: Sequence[Array]
) -> Array:
    return np.column_stack([function(time, v) for v in columns])


def _scaled(tables: Sequence[Array], centred: bool = False) -> list[Array]:
    """Columns of mean square one over all runs."""
    every = np.vstack(tables)
    middle = every.mean(axis=0) if centred else np.zeros(every.shape[1])
    size = np.sqrt(np.mean((every - middle) ** 2, axis=0))
    size[size == 0] = 1.0
    return [(t - middle) / size for t in tables]


def _rate(time: Array, values: Array) -> Array:
    """Central difference; zero where two rows share a time."""
    step = np.gradient(time)
    change = np.gradient(values)
    return np.divide(change, step, out=np.zeros_like(values), where=step > 0)


def _lagged(time: Array, values: Array, memory: float) -> Array:
    """Exponential average of the past, beginning at the first value."""
    present, *later = values.tolist()  # Python reckons with its own numbers several times as fast
    lagged = [present]
    for d, value in zip(np.exp(-np.diff(time) / memory).tolist(), later, strict=True):
        present = d * present + (1 - d) * value
        lagged.append(present)
    return np.array(lagged)
