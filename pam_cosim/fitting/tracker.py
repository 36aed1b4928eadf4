"""The progress of a fit, and its convergence."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.units import format_quantity


@dataclass(frozen=True)
class FitProgress:
    """Where a fit stands: the lowest point so far. It prints itself in a line.

    Attributes:
        evaluations: simulations of the set of fit runs so far.
        chi2_reduced: chi-square, with the priors' part, by the number of samples.
        rmse: rms error of each fitted signal [SI], by name.
        units: SI units of the signals, by name.
        values: of the parameters there [SI], by name.
    """

    evaluations: int
    chi2_reduced: float
    rmse: dict[str, float]
    units: dict[str, str]
    values: dict[str, float] = field(default_factory=dict)

    def __str__(self) -> str:
        errors = [
            f"{n} off by {format_quantity(e, self.units.get(n, ''))} rms"
            for n, e in self.rmse.items()
        ]
        return ", ".join(
            [f"{self.evaluations} simulations", *errors, f"chi2 {self.chi2_reduced:.4g}"]
        )


Progress = Callable[[FitProgress], object]


@dataclass(frozen=True)
class Convergence:
    """How a fit came down.

    Attributes:
        evaluations: (n,) simulations of the set of fit runs after which a lower point was known.
        chi2_reduced: (n,) the lowest from then on.
        descents: (d,) where each descent from a start ended, as they were made.
    """

    json_keys = "evaluations=_evaluations chi2_reduced descents"

    evaluations: Array = field(default_factory=lambda: np.zeros(0))
    chi2_reduced: Array = field(default_factory=lambda: np.zeros(0))
    descents: Array = field(default_factory=lambda: np.zeros(0))

    @property
    def _evaluations(self) -> Array:
        return self.evaluations.astype(int)


class Tracker:
    """Keeps the lowest point so far, and reports it.

    Args:
        units: SI units of the signals.
        progress: called after each simulation.
    """

    def __init__(
        self, units: dict[str, str] | None = None, progress: Progress | None = None
    ) -> None:
        self.units, self.progress = units or {}, progress
        self.descents: list[float] = []
        self._lowest: list[tuple[int, float]] = []
        self._rmse: dict[str, float] = {}
        self._values: dict[str, float] = {}

    def report(
        self,
        evaluations: int,
        chi2_reduced: float,
        rmse: Callable[[], dict[str, float]] | None,
        values: Callable[[], dict[str, float]] = dict,
    ) -> None:
        """A point was simulated; ``rmse`` None: it was known from before and is not reported."""
        if np.isfinite(chi2_reduced) and (not self._lowest or chi2_reduced < self._lowest[-1][1]):
            self._lowest.append((evaluations, chi2_reduced))
            if rmse is not None and self.progress is not None:
                self._rmse, self._values = rmse(), values()
        if rmse is not None and self.progress is not None and self._lowest:
            lowest = self._lowest[-1][1]
            self.progress(
                FitProgress(evaluations, lowest, dict(self._rmse), self.units, dict(self._values))
            )

    @property
    def convergence(self) -> Convergence:
        """All of it."""
        evaluations, lowest = np.array(self._lowest, dtype=float).reshape(-1, 2).T.copy()
        return Convergence(evaluations, lowest, np.array(self.descents))
