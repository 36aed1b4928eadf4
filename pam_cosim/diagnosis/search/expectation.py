"""What models are expected to leave that nobody fitted yet: reckoned from the slopes of those that were.

A model with effect A, fitted, and what effect B does to the samples beside the base model are enough to say, to first
order, what a model with both would leave when all parameters are fitted: a linear least squares problem. That is
microseconds against the seconds of a fit, so many combinations are ranked and those fitted that promise most.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.fitting import Linear, bounded_minimum, prior_rows
from pam_cosim.measurement import Prior

_NOTHING_NEW = (
    1e-4  # of a column's length: what is left of it beside others, below which it says nothing new
)
_WEAK = 1e-6  # of the longest column


@dataclass(frozen=True)
class EffectDirections:
    """What an effect can add to a model.

    Attributes:
        effect, family: its names.
        columns: (m, c) orthonormal directions in which it moves the samples.
        cost: number of its parameters.
        shapes: what it does about some values of its parameters, where it was looked at and where it was fitted.
    """

    effect: str
    family: str
    columns: Array
    cost: int
    shapes: tuple[EffectShape, ...] = ()


@dataclass(frozen=True)
class EffectShape:
    """What an effect does to the samples about some values of its own k parameters.

    Attributes:
        names: of the parameters; ``values``, ``low`` and ``high`` (k,) [SI].
        total: (m,) what it does at these values. slopes: (m, k).
        priors: what is known of parameters beforehand, by name.
    """

    names: tuple[str, ...]
    values: Array
    low: Array
    high: Array
    total: Array
    slopes: Array
    priors: Mapping[str, Prior] = field(default_factory=dict)


class Additions:
    """All that effects can add, and how alike that is.

    Args:
        directions: what each can add. rows: m, of the linear models.
    """

    def __init__(self, directions: Sequence[EffectDirections], rows: int) -> None:
        self.directions = list(directions)
        self.columns = np.column_stack([np.zeros((rows, 0)), *(a.columns for a in directions)])
        ends = np.cumsum([0, *(a.columns.shape[1] for a in directions)]).tolist()
        self.at = [np.arange(a, b) for a, b in itertools.pairwise(ends)]
        self.gram = self.columns.T @ self.columns
        shapes = [shape for a in directions for shape in a.shapes]
        parts = [np.column_stack([s.slopes, s.total]) for s in shapes]
        self.moves = np.column_stack([np.zeros((rows, 0)), *parts])
        self.gram_of_moves = self.moves.T @ self.moves
        begin = np.cumsum([0, *(part.shape[1] for part in parts)]).tolist()
        self.begin = {id(shape): at for shape, at in zip(shapes, begin[:-1], strict=True)}


def addition(
    probed_beside: Linear, probe: EffectProbe, fitted: tuple[Linear, Linear] | None = None
) -> EffectDirections | None:
    """What an effect can add; None where it does not move a sample.

    Its directions are those of its parameters, and of the effect as a whole beside a model, where it was probed and
    where it was fitted.

    Args:
        probed_beside: the model that it was probed beside, of the samples of then.
        probe: what it does there.
        fitted: the base model and that with this effect alone, where it was fitted, of the samples of now.
    """
    pairs = [(probed_beside, probe.linear), *([fitted] if fitted else [])]
    shapes = tuple(_shape(beside, linear, probe.own_parameters) for beside, linear in pairs)
    columns = [part for shape in shapes for part in (shape.slopes, shape.total[:, None])]
    columns += [(probed_beside.residual - r)[:, None] for r in probe.other_residuals]
    basis = _orthonormal(np.column_stack(columns))
    cost = max(len(probe.own_parameters) - len(probe.inactive_parameters), 1)
    return (
        EffectDirections(probe.effect, probe.family, basis, cost, shapes)
        if basis.shape[1]
        else None
    )


def _shape(base: Linear, linear: Linear, own_parameters: Sequence[str]) -> EffectShape:
    """What an effect does by itself: its model less the base model at the same base parameters."""
    values = dict(zip(linear.names, linear.values, strict=True))
    change = np.array([values.get(n, v) - v for n, v in zip(base.names, base.values, strict=True)])
    total: Array = base.residual - base.slopes @ change - linear.residual
    at = [i for i, name in enumerate(linear.names) if name in own_parameters]
    names = tuple(linear.names[i] for i in at)
    priors = {name: linear.priors[name] for name in names if name in linear.priors}
    return EffectShape(
        names,
        linear.values[at],
        linear.low[at],
        linear.high[at],
        total,
        linear.slopes[:, at],
        priors,
    )


def _orthonormal(columns: Array) -> Array:
    size = np.linalg.norm(columns, axis=0)
    kept = columns[:, size > _WEAK * max(size.max(initial=0.0), 1e-300)]
    kept = kept / np.linalg.norm(kept, axis=0)
    vectors, singular, _ = np.linalg.svd(kept, full_matrices=False)
    return np.asarray(vectors[:, singular > _NOTHING_NEW * max(singular.max(initial=0.0), 1e-300)])


class PredictedFit(NamedTuple):
    """What a model is expected to come to when all parameters keep to their bounds, and to what is known of them.

    Attributes:
        reduction: of the sum of squares.
        values: of the parameters then [SI].
        chi2_priors: what they are off what is known of them beforehand, in variances.
        residual: (m,) what is left then.
    """

    reduction: float
    values: Mapping[str, float]
    chi2_priors: float
    residual: Array


@dataclass(frozen=True)
class PredictedModel:
    """A model that nobody fitted: one that was, with a further effect.

    Attributes:
        beside: the fitted model that it starts from.
        added: what is added.
        reduction: of the sum of squares, beyond what that leaves, if effects were free to bend.
    """

    beside: LinearisedNeighbourhood
    added: EffectDirections
    reduction: float

    @cached_property
    def effects(self) -> tuple[str, ...]:
        """All effects."""
        return (*self.beside.effects, self.added.effect)

    @cached_property
    def set_of_effects(self) -> frozenset[str]:
        """All effects, in no order."""
        return frozenset(self.effects)

    @cached_property
    def within_bounds(self) -> PredictedFit:
        """What is expected when all parameters keep to their bounds."""
        fits = map(self.beside.within_bounds, self.added.shapes)
        return max(fits, key=lambda fit: fit.reduction - fit.chi2_priors)


class LinearisedNeighbourhood:
    """What effects can do beside a fitted model, all of whose parameters move along.

    Args:
        effects: of the model.
        linear: the model about its optimum.
        family: of every effect there is.
        additions: what can be added.
    """

    def __init__(
        self,
        effects: tuple[str, ...],
        linear: Linear,
        family: Mapping[str, str],
        additions: Additions,
    ) -> None:
        self.effects, self.family, self.additions = effects, family, additions
        self._linear = linear
        columns = np.column_stack([linear.slopes, linear.residual])
        self._known, self._cross = columns.T @ columns, columns.T @ additions.moves
        basis = _orthonormal(linear.movable)
        unreachable = linear.residual - basis @ (basis.T @ linear.residual)
        shared, self._along = basis.T @ additions.columns, additions.columns.T @ unreachable
        self._gram = additions.gram - shared.T @ shared + _NOTHING_NEW * np.eye(len(self._along))

    def _gains(self, places: Sequence[Array]) -> list[float]:
        """What the columns at each of these places can do; those of one number are solved for at once."""
        gains = [0.0] * len(places)
        of_size: dict[int, list[int]] = {}
        for n, at in enumerate(places):
            of_size.setdefault(len(at), []).append(n)
        for numbers in of_size.values():
            at = np.array([places[n] for n in numbers])
            along = self._along[at]
            steps = np.linalg.solve(self._gram[at[:, :, None], at[:, None, :]], along[:, :, None])[
                :, :, 0
            ]
            for n, gradient, step in zip(numbers, along, steps, strict=True):
                gains[n] = float(gradient @ step)
        return gains

    def within_bounds(self, shape: EffectShape) -> PredictedFit:
        """With an effect of this shape."""
        linear, k = self._linear, len(self._linear.names)
        begin = self.additions.begin[id(shape)]
        end = begin + len(shape.names)
        slopes = slice(begin, end)
        gram, cross = self.additions.gram_of_moves, self._cross
        square = np.block(
            [
                [self._known[:k, :k], cross[:k, slopes]],
                [cross[:k, slopes].T, gram[slopes, slopes]],
            ]
        )
        along = np.append(self._known[:k, k] - cross[:k, end], cross[k, slopes] - gram[slopes, end])
        values = np.concatenate([linear.values, shape.values])
        low = np.concatenate([linear.low, shape.low]) - values
        high = np.concatenate([linear.high, shape.high]) - values
        names, priors = (*linear.names, *shape.names), {**linear.priors, **shape.priors}
        weights, pull = prior_rows(names, values, priors)
        step = bounded_minimum(
            square + np.diag(weights**2), along + weights * pull, low, high, _NOTHING_NEW**2
        )
        gained = 2 * float(cross[k, end]) - float(gram[end, end])
        gained += float(step @ (2 * along - square @ step))
        by_name = dict(zip(names, (values + step).tolist(), strict=True))
        off = sum(prior.surprise(by_name[n]) ** 2 for n, prior in priors.items())
        moves = self.additions.moves
        moved = linear.slopes @ step[:k] + moves[:, slopes] @ step[k:] + moves[:, end]
        return PredictedFit(max(gained, 0.0), by_name, off, linear.residual - moved)

    @cached_property
    def with_one(self) -> list[PredictedModel]:
        """One further effect of another family."""
        taken = {self.family[e] for e in self.effects}
        additions = zip(self.additions.directions, self.additions.at, strict=True)
        of_other_families = [(a, at) for a, at in additions if a.family not in taken]
        gains = self._gains([at for _, at in of_other_families])
        return [
            PredictedModel(self, a, gain)
            for gain, (a, _) in zip(gains, of_other_families, strict=True)
        ]
