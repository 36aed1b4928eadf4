"""The conditions under which samples were taken: phase, time, run, imposed values, motion, parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.model.domain import Domain
from pam_cosim.model.interface import Variable
from pam_cosim.model.references import BRANCH
from pam_cosim.units import readable_factor, readable_unit

_BANDS = 4  # of each output, few enough to remember
_REST_RATE = 0.02  # of the fastest rate: slower samples are at rest
_ZERO_EDGE = 1e-3  # of the range: an edge of a band as near to zero is zero

Mask = NDArray[np.bool_]


class Present:
    """The samples of a signal that are there, of all runs one after the other."""

    def __init__(self, parts: Sequence[RunComparison], residuals: Sequence[Array]) -> None:
        self.parts, self.residuals = parts, residuals
        self.kept = [np.isfinite(error) for error in residuals]

    def of(self, values: Sequence[Array]) -> Array:
        """Values (samples,) at the present samples of all runs, from values (rows,) of each run."""
        return np.concatenate([v[k] for v, k in zip(values, self.kept, strict=True)])

    @property
    def run_numbers(self) -> Array:
        """Of which run each is."""
        return np.concatenate([np.full(int(k.sum()), i) for i, k in enumerate(self.kept)])


def phases(
    present: Present, outputs: Mapping[str, Variable], domain: Domain
) -> list[tuple[str, Mask]]:
    """The phases that the field divides a run into, by the slope of the output that has the unit for it."""
    dividing = next(
        ((n, row) for row in domain.phases for n, v in outputs.items() if v.unit == row[0]), None
    )
    if dividing is None:
        return []
    output, (_, rising, resting, falling) = dividing
    slope = present.of([_slope(r.run.time, r.model[output]) for r in present.parts])
    limit = _REST_RATE * float(np.max(np.abs(slope), initial=0.0))
    return [(rising, slope > limit), (resting, np.abs(slope) <= limit), (falling, slope < -limit)]


def times(present: Present) -> list[tuple[str, Mask]]:
    """Thirds of each run."""
    late = present.of([_relative_time(r.run.time) for r in present.parts])
    return [
        ("early", late < 1 / 3),
        ("middle", (late >= 1 / 3) & (late < 2 / 3)),
        ("late", late >= 2 / 3),
    ]


def by_run(present: Present) -> list[tuple[str, Mask]]:
    """Each run, where there are several, and runs that have a parameter's value in common."""
    numbers, parts = present.run_numbers, present.parts
    single = (
        [(f"in {r.run.name}", numbers == i) for i, r in enumerate(parts)] if len(parts) > 1 else []
    )
    return single + _by_parameter(parts, numbers)


def by_imposed(present: Present, inputs: Mapping[str, Variable]) -> list[tuple[str, Mask]]:
    """Bands of the inputs that all runs at rest have."""
    parts = present.parts
    names = [
        n for n in parts[0].run.inputs if n in inputs and all(n in r.run.inputs for r in parts)
    ]
    return [
        band
        for n in names
        for band in _given(n, inputs[n], present.of([r.run.inputs[n] for r in parts]))
    ]


def imposed_speed(r: RunComparison, output: str) -> Array:
    """How fast an output of the model changes at each row [its unit per second]."""
    return _slope(r.run.time, r.model[output])


def moving(name: str, speed: Array) -> list[tuple[str, Mask]]:
    """Direction, and fast or slow by the typical speed of what moves."""
    limit = _REST_RATE * float(np.max(np.abs(speed), initial=0.0))
    if not limit > 0:
        return []
    fast = float(np.median(np.abs(speed[np.abs(speed) > limit])))
    return [
        (f"{name} grows fast", speed > fast),
        (f"{name} grows slowly", (speed > limit) & (speed <= fast)),
        (f"{name} rests", np.abs(speed) <= limit),
        (f"{name} shrinks slowly", (speed < -limit) & (speed >= -fast)),
        (f"{name} shrinks fast", speed < -fast),
    ]


def _by_parameter(parts: Sequence[RunComparison], names: Array) -> list[tuple[str, Mask]]:
    """One condition for each value of a parameter that several runs share and others do not."""
    masks: list[tuple[str, Mask]] = []
    for parameter in parts[0].run.parameters:
        values = np.array([r.run.parameters.get(parameter, np.nan) for r in parts])
        for value in np.unique(values):
            members = np.flatnonzero(values == value)
            if 1 < len(members) < len(parts):
                masks.append((f"{parameter} = {value:.4g}", np.isin(names, members)))
    return masks


def _slope(time: Array, values: Array) -> Array:
    slope = np.zeros_like(values)
    step = np.diff(time)
    good = step > 0
    slope[1:][good] = np.diff(values)[good] / step[good]
    return slope


def _relative_time(time: Array) -> Array:
    span = float(time[-1] - time[0])
    return (time - time[0]) / span if span else np.zeros_like(time)


def _given(name: str, variable: Variable, values: Array) -> list[tuple[str, Mask]]:
    """Bands of an input; of the branch that points at rest lie on, its direction."""
    if name != BRANCH:
        return bands_of(name, variable, values)
    return [("inflating", values > 0), ("deflating", values < 0)] if np.ptp(values) > 0 else []


def bands_of(name: str, variable: Variable, values: Array) -> list[tuple[str, Mask]]:
    """Equal bands of a variable's range, each as text."""
    low, high = float(values.min()), float(values.max())
    if not high > low:
        return []
    edges = np.linspace(low, high, _BANDS + 1)
    factor, unit = readable_factor(variable.unit), readable_unit(variable.unit)
    bands: list[tuple[str, Mask]] = []
    for i in range(_BANDS):
        inside = (values >= edges[i]) & ((values < edges[i + 1]) | (i == _BANDS - 1))
        first, last = (
            0.0 if abs(e) < _ZERO_EDGE * (high - low) else e for e in (edges[i], edges[i + 1])
        )
        text = f"{first * factor:.3g} {unit} < {name} < {last * factor:.3g} {unit}"
        bands.append((text.replace("  ", " "), inside))
    return bands
