"""Curves of a comparison for a screen: in shown units, long ones thinned to the lowest and highest of each part."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import DataSet, Run
from pam_cosim.units import readable_factor
from pam_cosim.workbench.frames import PlottedCurve

MOST_POINTS = 4000  # of a curve, one for each pixel of the widest screens


Part = tuple[float, float]
"""Times [s] of a run between which its samples are drawn."""


def measured_curves(data: DataSet, part: Part | None = None) -> list[PlottedCurve]:
    """Times from the first one on and measured signals of all runs; of points at rest, what they are drawn over instead
    of times, rising."""
    curves = []
    for run in data.runs:
        factor = readable_factor(run.along.unit) if run.along else 1.0
        begin = 0.0 if run.is_static else float(run.time[0])
        rows = _rows(run, part)
        time = shown_times(_rising(run, run.time * factor - begin)[rows])
        for name, values in run.measurements.items():
            thinned_values = thinned(_rising(run, values * _factor(data, name))[rows])
            curves.append(
                PlottedCurve(run.name, name, {"time": time, "values": thinned_values}, begin)
            )
    return curves


def model_curves(
    runs: Sequence[RunComparison], recordings: DataSet, part: Part | None = None
) -> list[PlottedCurve]:
    """Modelled signals and residuals of all runs at all times that were recorded, NaN where a run was cut."""
    curves, recorded = [], {run.name: run for run in recordings.runs}
    for r in runs:
        room, rows = _room(r.run, recorded[r.run.name]), _rows(recorded[r.run.name], part)
        for name in r.run.measurements:
            factor = _factor(recordings, name)
            model, residual = (
                thinned(_rising(r.run, np.pad(values * factor, room, constant_values=np.nan))[rows])
                for values in (r.model[name], r.residual(name))
            )
            curves.append(PlottedCurve(r.run.name, name, {"values": model, "residual": residual}))
    return curves


def _room(run: Run, recording: Run) -> tuple[int, int]:
    """Rows that were recorded before and after those of a run."""
    before = int(np.searchsorted(recording.time, run.time[0], side="left")) if run.recorded else 0
    return before, len(recording.time) - before - len(run.time)


def _rows(recording: Run, part: Part | None) -> slice:
    """Rows of a recording that lie in a part of it, with one more at each end; None: all."""
    if part is None:
        return slice(None)
    first, last = np.searchsorted(recording.time, part)
    return slice(max(int(first) - 1, 0), int(last) + 1)


def _rising(run: Run, values: Array) -> Array:
    """Points at rest in the order in which they are drawn; a recording as it is."""
    return values[np.argsort(run.time, kind="stable")] if run.is_static else values


def _factor(data: DataSet, name: str) -> float:
    return readable_factor(data.signals[name].unit)


def shown_times(time: Array) -> Array:
    """Times [s] that belong to ``thinned`` values of times (n,): two in each part, evenly spaced."""
    parts = _parts(len(time))
    if parts is None:
        return time
    first, last = time[parts[:-1]], time[parts[1:] - 1]
    return np.stack([first + (last - first) / 4, first + 3 * (last - first) / 4], axis=1).ravel()


def thinned(values: Array) -> Array:
    """Values (n,) to draw: all, or the lowest and the highest of each part in their order, ``MOST_POINTS`` in all."""
    parts = _parts(len(values))
    if parts is None:
        return values
    finite = np.isfinite(values)
    low, high = np.where(finite, values, np.inf), np.where(finite, values, -np.inf)
    bottom, top = np.minimum.reduceat(low, parts[:-1]), np.maximum.reduceat(high, parts[:-1])
    first = [
        np.argmin(low[a:b]) <= np.argmax(high[a:b])
        for a, b in zip(parts[:-1], parts[1:], strict=True)
    ]
    pairs = np.where(
        np.array(first)[:, None], np.stack([bottom, top], 1), np.stack([top, bottom], 1)
    )
    return np.where(np.isfinite(pairs), pairs, np.nan).ravel()


def _parts(count: int) -> np.ndarray | None:
    """Edges of the parts; None: all are shown."""
    if count <= MOST_POINTS:
        return None
    return np.linspace(0, count, MOST_POINTS // 2 + 1).round().astype(int)
