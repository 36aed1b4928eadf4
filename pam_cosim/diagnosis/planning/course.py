"""Input courses of a run, as few numbers: levels between knots, held or joined by lines, and sines on top of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.diagnosis.planning.limits import Limits

LEVELS = (2, 12)  # of the inputs in a drawn course, fewest and most: what a person can follow


@dataclass(frozen=True)
class Course:
    """One run that could be made.

    Attributes:
        knots: (m,) where the levels begin, as shares of the run; the first is 0.
        levels: (m, k) of the inputs that move [SI].
        is_stepped: each level is held until the next one; otherwise lines join them.
        waves: (k, 4) a sine on top of each input: its size as a share of half the range, its cycles a run at the
            beginning and at the end, and its phase in cycles.
        constants: inputs that keep one value [SI].
        parameters: what is set before the run [SI].
    """

    knots: Array
    levels: Array
    is_stepped: bool
    waves: Array
    constants: Mapping[str, float]
    parameters: Mapping[str, float]

    @property
    def complexity(self) -> int:
        """Number of levels; a sine counts as as many as a person can follow."""
        return len(self.knots) + LEVELS[1] * int(np.count_nonzero(self.waves[:, 0]))

    def table(
        self, limits: Limits, interval: float | None = None
    ) -> tuple[Array, dict[str, Array]]:
        """(n,) times [s] and (n,) values of each input [SI]; a step is two rows at one time.

        Args:
            limits: of the rig.
            interval: between two rows [s]; None: that of the samples.
        """
        interval = interval or limits.interval
        count = max(round(limits.seconds / interval), 1) + 1
        time = np.linspace(0.0, limits.seconds, count)
        at = np.round(self.knots * (count - 1)).astype(int)
        before = np.zeros(count, dtype=bool)
        rows = self._base(np.searchsorted(at, np.arange(count), side="right") - 1, time, limits)
        if self.is_stepped and len(at) > 1:
            values_before = self._base(
                np.maximum(np.searchsorted(at, np.arange(count), side="left") - 1, 0), time, limits
            )
            can_step = np.isinf([limits.rates[name] for name in limits.moving])
            jumps = (values_before != rows) & can_step
            before[1:] = jumps.any(axis=1)[1:]
        rows = _slewed(rows, limits, time[1] - time[0])
        if before.any():
            values_before = np.where(jumps, values_before, rows)[before]
            places = np.flatnonzero(before)
            rows = np.insert(rows, places, values_before, axis=0)
            time = np.insert(time, places, time[before])
        values = {name: rows[:, i] for i, name in enumerate(limits.moving)}
        values |= {name: np.full(len(time), value) for name, value in self.constants.items()}
        return time, {name: values[name] for name in limits.inputs}

    def _base(self, segment: NDArray[np.intp], time: Array, limits: Limits) -> Array:
        """(n, k) levels with their sines, within the ranges; k is 0 where nothing moves."""
        share = time / limits.seconds
        levels = self.levels[segment]
        if not self.is_stepped:
            columns = [np.interp(share, self.knots, column) for column in self.levels.T]
            levels = np.array(columns).reshape(-1, len(time)).T
        low, high = np.array([limits.inputs[name] for name in limits.moving]).reshape(-1, 2).T
        size, first, last, phase = self.waves.T
        cycles = share[:, None] * first + 0.5 * share[:, None] ** 2 * (last - first) + phase
        waves = 0.5 * (high - low) * size * np.sin(2 * np.pi * cycles)
        return np.asarray(np.clip(levels + waves, low, high))


def _slewed(rows: Array, limits: Limits, step: float) -> Array:
    """The same, no faster than the rig can follow, from where its inputs begin."""
    rows = rows.copy()
    for i, name in enumerate(limits.moving):
        most = limits.rates[name] * step
        if np.isinf(most):
            continue
        low, high = limits.inputs[name]
        value = min(max(limits.start[name], low), high)
        for j in range(len(rows)):
            value += min(max(rows[j, i] - value, -most), most) if j else 0.0
            rows[j, i] = value
    return rows
