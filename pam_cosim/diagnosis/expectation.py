"""What models are expected to leave that nobody fitted yet: reckoned from the slopes of those that were.

A model with effect A, fitted, and what effect B does to the samples beside the base model are enough to say, to first
order, what a model with both would leave when all parameters are fitted: a linear least squares problem. That is
microseconds against the seconds of a fit, so all combinations are asked and the fits kept for those that promise most.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import lsq_linear

from pam_cosim.arrays import Array
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.trial import Probe
from pam_cosim.fitting import Linear

_NOTHING_NEW = 1e-4  # of a column's length: what is left of it beside others, below which it says nothing new
_WEAK = 1e-6  # of the longest column


@dataclass(frozen=True)
class Addition:
    """What an effect can add to a model.

    Attributes:
        effect, family: its names.
        columns: (m, c) orthonormal directions in which it moves the samples.
        cost: number of its parameters.
    """

    effect: str
    family: str
    columns: Array
    cost: int


class Additions:
    """All that effects can add, and how alike that is."""

    def __init__(self, every: Sequence[Addition]) -> None:
        self.every = list(every)
        self.columns = np.column_stack([a.columns for a in every]) if every else np.zeros((0, 0))
        ends = np.cumsum([0, *(a.columns.shape[1] for a in every)]).tolist()
        self.at = [np.arange(a, b) for a, b in itertools.pairwise(ends)]
        self.gram = self.columns.T @ self.columns


def addition(base: Linear, probe: Probe, fitted: Candidate | None = None) -> Addition | None:
    """What an effect can add; None where it does not move a sample.

    Its directions are those of its parameters, and of the effect as a whole beside the base model, where it was probed
    and where a model with this effect alone was fitted.
    """
    columns: list[Array] = []
    for linear in (probe.linear, fitted.fit.linear if fitted else None):
        if linear is not None:
            columns += [linear.columns(probe.own_parameters), _whole(base, linear)[:, None]]
    columns += [(base.residual - r)[:, None] for r in probe.further]
    basis = _orthonormal(np.column_stack(columns))
    return Addition(probe.effect, probe.family, basis, len(probe.own_parameters)) if basis.shape[1] else None


def _whole(base: Linear, linear: Linear) -> Array:
    """(m,) what the effect does to the samples: its model less the base model at the same base parameters."""
    values = dict(zip(linear.names, linear.values, strict=True))
    change = np.array([values.get(n, v) - v for n, v in zip(base.names, base.values, strict=True)])
    moved: Array = base.residual - base.slopes @ change - linear.residual
    return moved


def _orthonormal(columns: Array) -> Array:
    size = np.linalg.norm(columns, axis=0)
    kept = columns[:, size > _WEAK * max(size.max(initial=0.0), 1e-300)]
    kept = kept / np.linalg.norm(kept, axis=0)
    left, singular, _ = np.linalg.svd(kept, full_matrices=False)
    return np.asarray(left[:, singular > _NOTHING_NEW * max(singular.max(initial=0.0), 1e-300)])


def reduction(linear: Linear) -> float:
    """By how much the sum of squares falls, to first order, when the parameters go where they like within bounds."""
    size = np.linalg.norm(linear.slopes, axis=0)
    felt = size > 0
    if not felt.any():
        return 0.0
    rows = linear.slopes[:, felt] / size[felt]
    low = np.minimum((linear.low - linear.values)[felt] * size[felt], -1e-12)
    high = np.maximum((linear.high - linear.values)[felt] * size[felt], 1e-12)
    triangle: Array = np.asarray(np.linalg.qr(np.column_stack([rows, linear.residual]), mode="r"))
    n = rows.shape[1]
    solution = lsq_linear(triangle[:n, :n], triangle[:n, n], (low, high), method="bvls")
    before = float(triangle[:n, n] @ triangle[:n, n])
    return max(before - 2 * float(solution.cost), 0.0)


@dataclass(frozen=True)
class Expected:
    """A model that nobody fitted: one that was, with further effects, or with one exchanged for another.

    Attributes:
        start: effects of the fitted model that it starts from.
        added: what is added.
        reduction: of the sum of squares, beyond what that leaves.
        exchanged: the effect of ``start`` that makes place; empty: none.
    """

    start: tuple[str, ...]
    added: tuple[Addition, ...]
    reduction: float
    exchanged: str = ""

    @property
    def effects(self) -> tuple[str, ...]:
        """All effects."""
        return (*(e for e in self.start if e != self.exchanged), *(a.effect for a in self.added))


class Beside:
    """What effects can do beside a fitted model, all of whose parameters move along.

    Args:
        effects: of the model.
        linear: the model about its optimum.
        family: of every effect there is.
        additions: what can be added.
    """

    def __init__(
        self, effects: tuple[str, ...], linear: Linear, family: Mapping[str, str], additions: Additions
    ) -> None:
        self.effects, self.family, self.additions = effects, family, additions
        own = _orthonormal(linear.slopes)
        left = linear.residual - own @ (own.T @ linear.residual)
        shared, self._along = own.T @ additions.columns, additions.columns.T @ left
        self._gram = additions.gram - shared.T @ shared + _NOTHING_NEW * np.eye(len(self._along))

    def _gain(self, at: Array) -> float:
        return float(self._along[at] @ np.linalg.solve(self._gram[np.ix_(at, at)], self._along[at]))

    def _single(self, own_family: bool) -> list[tuple[float, Addition, Array]]:
        taken = {self.family[e] for e in self.effects}
        some = zip(self.additions.every, self.additions.at, strict=True)
        return [
            (self._gain(at), a, at)
            for a, at in some
            if (a.family in taken) is own_family and a.effect not in self.effects
        ]

    def with_one(self) -> list[Expected]:
        """One further effect of another family."""
        return [Expected(self.effects, (a,), gain) for gain, a, _ in self._single(False)]

    def with_two(self, first: int) -> list[Expected]:
        """Two further effects of other families, one of them among so many that do most by themselves."""
        best = sorted(self._single(False), key=lambda entry: (-entry[0], entry[1].effect))
        return [
            Expected(self.effects, (a, b), self._gain(np.concatenate([at, bt])))
            for n, (_, a, at) in enumerate(best[:first])
            for _, b, bt in best[n + 1 :]
            if b.family != a.family
        ]

    def with_another_form(self) -> list[Expected]:
        """An effect exchanged for another of its family, as if that could do all that the first one does."""
        of = {self.family[e]: e for e in self.effects}
        return [Expected(self.effects, (a,), gain, of[a.family]) for gain, a, _ in self._single(True)]
