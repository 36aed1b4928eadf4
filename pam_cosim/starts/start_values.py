"""Start values of single runs as parameters that a fit does not see: what they can take away is taken away, run by run.

For given parameters the start values of a run are those that leave least of its own residuals: a small linear least
squares problem of one run, solved again where the model bends. What is left, and its slopes by the parameters with the
start values following, are then those of a fit of everything together (variable projection: Golub and Pereyra, SIAM J.
Numer. Anal. 10, 1973; for dynamic systems with local parameters e.g. Schloeder, 1988). Twenty runs cost twenty small
blocks, and a search over the parameters has no more of them than before.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import Run

LinearisedRun = Callable[[], tuple[Any, Array, Array]]
"""Gives a result, the residuals (n,) and their slopes (n, k) for the present start values."""

_SETTLED = 0.01  # variances of the noise, that a further step must take away to be made
_FARTHER = 4.0  # times as far as the step before, that a step may go


@dataclass
class StartValues:
    """The start values of one run.

    Attributes:
        run: the run.
        names: of the k states.
        mean, sd: (k,) what is known of them beforehand [SI]: where the first samples and the equilibrium with them
            say that it begins, and how far the runs take them.
        values: (k,) the present ones [SI]; ``low`` and ``high`` (k,) their range in the model.
        still: states that no run moves, where they are [SI].
        slopes: (n, k) of the run's residuals by them, where they were last eliminated; of all rows those of what is
            known beforehand come last.
        begin: (k,) where they are looked for first [SI], or were as a descent was last linearised; ``follow``:
            (k, parameters) how they move from there with the search coordinates.
    """

    run: Run
    names: tuple[str, ...]
    mean: Array
    sd: Array
    values: Array
    low: Array
    high: Array
    still: dict[str, float] = field(default_factory=dict)
    slopes: Array = field(default_factory=lambda: np.zeros((0, 0)))
    follow: Array | None = None

    def __post_init__(self) -> None:
        self.begin = self.values

    def named(self) -> dict[str, float]:
        """The present values of all states by name."""
        return dict(zip(self.names, self.values.tolist(), strict=True)) | self.still

    def settings(self) -> dict[str, float]:
        """The present values by name, each with that of the run."""
        return settings_of(self.run, dict(zip(self.names, self.values.tolist(), strict=True)))

    def clipped(self, values_by_name: Mapping[str, float]) -> Array:
        """(k,) values by name in their order, within the bounds of the model."""
        return np.clip([values_by_name[name] for name in self.names], self.low, self.high)

    def prior_rows(self) -> Array:
        """(k,) how far the present values are from what is known beforehand, in standard deviations."""
        return np.asarray((self.mean - self.values) / self.sd)

    def with_prior_slopes(self, slopes: Array) -> Array:
        """(n + k, k) slopes of the residuals by the start values, and below them those of ``prior_rows``."""
        return np.vstack([slopes, -np.diag(1.0 / self.sd)])

    def step(self, slopes: Array, rows: Array) -> Array:
        """(k,) by how much the start values move to leave least of rows, by their slopes (``with_prior_slopes``)."""
        return np.asarray(np.linalg.lstsq(slopes * self.sd, -rows, rcond=None)[0] * self.sd)

    def within_reach(self, step: Array, reach: float) -> Array:
        """(k,) a step, shortened to the given number of standard deviations of the prior."""
        farthest = float(np.max(np.abs(step) / self.sd))
        return step * (reach / max(farthest, reach))

    def following(self, columns: Array) -> Array:
        """(k, m) by how much the start values move along with what moves the residuals of the run by (n, m) columns."""
        below = np.zeros((len(self.names), columns.shape[1]))
        return np.asarray(-np.linalg.lstsq(self.slopes, np.vstack([columns, below]), rcond=None)[0])

    def deviations(self) -> Array:
        """(k,) standard deviations [SI] of the start values at given parameters."""
        # no singular value is below one, of the rows of what is known; their squares would be lost next to large ones
        _, sizes, directions = np.linalg.svd(self.slopes * self.sd, full_matrices=False)
        return np.asarray(self.sd * np.linalg.norm(directions.T / sizes, axis=1))

    def determined(self) -> NDArray[np.bool_]:
        """(k,) which of them the data determine, and not the prior alone."""
        return np.asarray((self.deviations() / self.sd) ** 2 < CRITERIA.starts.informed)


def settings_of(run: Run, states: Mapping[str, float]) -> dict[str, float]:
    """Start values of a run by state, as parameters by "state@run"."""
    return {f"{name}@{run.name}": value for name, value in states.items()}


def eliminate(of: StartValues, simulate: LinearisedRun) -> tuple[Any, Array]:
    """Moves the start values to the minimum of the squared residuals of their run, or close to it.

    For a model that fits badly, the last hundredth of the reduction is not worth a run: the next point repeats the
    search. Returns the result of a simulation there, and (n,) the residuals without what the start values can take
    away.

    Args:
        of: the start values, which are changed.
        simulate: the run about the present start values.

    Raises:
        SimulationFailure: the run does not reach its end wherever it begins.
    """
    point = _tried(of, simulate)
    if point is None:
        of.values = of.mean
        point = _Point(of, *simulate())
    reach = 1.0  # standard deviations of what is known beforehand, that a step may go; farther once that served
    for _ in range(CRITERIA.starts.steps):
        if point.is_settled:
            break
        before = point
        step = of.within_reach(point.step, reach)
        for _ in range(1 if point.is_level else CRITERIA.starts.steps):
            of.values = np.clip(point.values + step, of.low, of.high)
            next_point = _tried(of, simulate)
            if next_point is not None and next_point.cost < point.cost:
                break
            step, reach = step / 2.0, reach / 2.0
        else:
            break
        point, reach = next_point, _FARTHER * reach
        if before.is_little(before.cost - point.cost):
            break
    of.values = (
        np.clip(point.values + point.step, of.low, of.high) if point.is_settled else point.values
    )
    last, of.slopes = of.values - point.values, point.slopes
    return point.result, point.residuals + point.slopes[: len(point.residuals)] @ last


def _tried(of: StartValues, simulate: LinearisedRun) -> _Point | None:
    """The run from the present start values; None where it does not reach its end."""
    try:
        return _Point(of, *simulate())
    except SimulationFailure:
        return None


class _Point:
    """A run about some start values, linearised."""

    def __init__(self, of: StartValues, result: Any, residuals: Array, slopes: Array) -> None:
        self.result, self.residuals, self.values = result, residuals, of.values
        rows = np.append(residuals, of.prior_rows())
        self.slopes = of.with_prior_slopes(slopes)
        self.cost = float(rows @ rows)
        self.step = of.step(self.slopes, rows)
        remaining = rows + self.slopes @ self.step
        gain = self.cost - float(remaining @ remaining)
        # little is left to gain; where a step does not gain it, a shorter one will not do so either
        self.is_level = self.is_little(gain)
        # ... and that by the slopes alone
        self.is_settled = self.is_level and bool(
            np.all(np.abs(self.step) <= CRITERIA.starts.near * of.sd)
        )

    def is_little(self, gain: float) -> bool:
        """Whether it is not worth a further run to make the squares that much smaller."""
        return gain <= max(_SETTLED, CRITERIA.starts.linear * self.cost)
