"""What one effect does to the samples beside the fitted base model, at the strength at which it does most good."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Free, Linear, linearised, residual_rows
from pam_cosim.fitting.objective import Objective

_SHARE = 0.3  # of the way between bounds: anywhere but at an end will do


@dataclass(frozen=True)
class EffectProbe:
    """What an effect does to the samples.

    Attributes:
        effect, family: as its class declares them.
        linear: the model with it about the fitted base model and the strength that does most good, by the parameters
            that it brought.
        strength_shows: samples depend on how strong it is, of the strengths that were looked at.
        elsewhere: the same between their bounds, of points at rest: a parameter may move nothing where another is zero,
            as the reach of a force that has no size.
    """

    effect: str
    family: str
    linear: Linear
    strength_shows: bool = False
    elsewhere: Linear | None = None

    @property
    def idle_parameters(self) -> tuple[str, ...]:
        """Names of its parameters that change no sample."""
        looks = [self.linear, *([self.elsewhere] if self.elsewhere else [])]
        return tuple(
            name
            for at, name in enumerate(self.linear.names)
            if all(_is_idle(x.slopes[:, at] * (x.high - x.low)[at], self.linear) for x in looks)
        )

    @property
    def silent(self) -> bool:
        """Whether no sample depends on the effect: neither on its parameters, nor on how strong it is."""
        return not self.strength_shows and self.idle_parameters == self.linear.names


def _is_idle(move: Array, base: Linear) -> bool:
    """Whether samples move by next to nothing, compared with what a model leaves of them."""
    return float(move @ move) < CRITERIA.search.idle * float(base.residual @ base.residual)


@dataclass(frozen=True)
class Strengths:
    """How the own parameters of an effect follow its strength: 0, it vanishes; 1, its stated values.

    A parameter that is larger where the effect is away, as a ceiling or a stiffness in series, is inverse to it.

    Args:
        parameters: at their stated values.
        absent: values at which the effect vanishes, by name; others stay as they are. Empty: every parameter is
            multiplied by the strength.
    """

    parameters: tuple[Free, ...]
    absent: Mapping[str, float]

    def at(self, strength: float) -> dict[str, float]:
        """The own parameters by name, within their bounds."""
        return {f.name: min(max(self._value(f, strength), f.low), f.high) for f in self.parameters}

    def place(self, strength: float) -> Array:
        """Their search coordinates."""
        values = self.at(strength)
        return np.array([f.to_z(values[f.name]) for f in self.parameters])

    def _value(self, f: Free, strength: float) -> float:
        if not self.absent:
            return strength * f.start
        null_value = self.absent.get(f.name)
        if null_value is None or null_value == f.start:
            return f.start
        if abs(null_value) > abs(f.start) and null_value * f.start > 0:
            inverse = 1 / null_value + strength * (1 / f.start - 1 / null_value)
            return 1 / inverse if inverse * null_value > 0 else null_value
        return null_value + strength * (f.start - null_value)

    def within_bounds(self, strength: float) -> bool:
        """Whether the effect can be as strong as that: not all of its parameters are held by a bound before."""
        return math.isfinite(strength) and self.at(strength) != self.at(2 * strength)

    @property
    def signed(self) -> bool:
        """Whether there is anything at a negative strength."""
        return bool(self.absent) and self.at(-1.0) != self.at(0.0)


@dataclass(frozen=True)
class StatedEffect:
    """An effect at its stated strength.

    Attributes:
        effect, family: as its class declares them.
        strengths: how its parameters follow its strength.
        linear: the model with it, about the start values.
        weaker: residuals (m,) when it is ever weaker, ``CRITERIA.search.weaker`` times from one to the next.
    """

    effect: str
    family: str
    strengths: Strengths
    linear: Linear
    weaker: tuple[Array, ...] = ()

    def courses(self, base: Linear) -> Array:
        """(m, 1 + weaker) what it does to the samples at its stated strength and when it is weaker."""
        return np.column_stack(
            [base.residual - residual for residual in (self.linear.residual, *self.weaker)]
        )


def detectable_strength(sizes: Sequence[float], needed: float) -> float:
    """The strength, in stated ones, from which an effect is as large as need be.

    What it does is taken for proportional to its strength, from the weakest look at which it is large enough; unless it
    does next to nothing at the next, so that it begins at a threshold: then that look is the answer.

    Args:
        sizes: of what it does at its stated strength, and ``CRITERIA.search.weaker`` times from one to the next.
        needed: the size that is asked for.
    """
    factor = CRITERIA.search.weaker
    enough = max((n for n, size in enumerate(sizes) if size >= needed), default=0)
    size, strength = sizes[enough], factor**enough
    if size <= 0:
        return math.inf
    following = sizes[enough + 1] if enough + 1 < len(sizes) else factor * size
    if following**2 < CRITERIA.search.little * (factor * size) ** 2:
        return strength if size >= needed else math.inf
    return strength * needed / size


@dataclass(frozen=True)
class _StrengthTrial:
    """The model at one strength: (m,) residuals, ``moved`` what the effect does that no base parameter could.

    remaining: the sum of squares that the base parameters leave.
    """

    strength: float
    residual: Array
    moved: Array
    remaining: float

    @property
    def size(self) -> float:
        """Sum of squares of what the effect does."""
        return float(self.moved @ self.moved)


@dataclass(frozen=True)
class Look:
    """Looks at a model with an effect beside the fitted base model.

    Runs begin where those of the base model do; what other starts would take away is taken away to first order.

    Attributes:
        objective: the model by the effect's own parameters, the others where the base model was fitted.
        base: the base model there.
        strengths: how the own parameters follow the effect's strength.
        rows: of the linear models, about.
    """

    objective: Objective
    base: Linear
    strengths: Strengths
    rows: int

    def residual(self, strength: float) -> Array | None:
        """(m,) at a strength; None: the model breaks down."""
        residual = residual_rows(self.objective, self.strengths.place(strength), self.rows)
        return None if residual is None else self._with_other_starts(residual)

    def linear(self, z: Array) -> Linear | None:
        """The model about search coordinates; None: it breaks down."""
        linear = linearised(self.objective, z, self.rows)
        if linear is None:
            return None
        slopes = self.base.left_by_starts(linear.slopes)
        return replace(linear, residual=self._with_other_starts(linear.residual), slopes=slopes)

    def _with_other_starts(self, residual: Array) -> Array:
        return self.base.residual + self.base.left_by_starts(residual - self.base.residual)


def probe_effect(effect: str, family: str, look: Look) -> EffectProbe:
    """Looks at some strengths of an effect and linearises the model at the one that does most good.

    Args:
        effect, family: its names.
        look: at the model with it.

    Raises:
        SimulationFailure: the model breaks down.
    """
    base, strengths = look.base, look.strengths
    tried = _strength_trials(look.residual, base, strengths.signed)
    linear = None
    for one in sorted(tried, key=lambda one: (_is_idle(one.moved, base), one.remaining)):
        linear = look.linear(strengths.place(one.strength))
        if linear is not None:
            break
    if linear is None:
        raise SimulationFailure(look.objective.first_failure)
    strength_shows = any(not _is_idle(linear.residual - one.residual, linear) for one in tried)
    elsewhere = None
    if look.objective.data.is_static:
        between = [f.to_z(f.low + _SHARE * (f.high - f.low)) for f in strengths.parameters]
        elsewhere = look.linear(np.array(between))
    return EffectProbe(effect, family, linear, strength_shows, elsewhere)


def _strength_trials(
    residual: Callable[[float], Array | None], base: Linear, signed: bool
) -> list[_StrengthTrial]:
    """Residuals at the stated strength, and where those so far say that it does most good."""
    basis = np.linalg.qr(base.movable)[0]
    target = base.residual - basis @ (basis.T @ base.residual)
    looks: list[_StrengthTrial] = []

    def look(strength: float) -> bool:
        rows = residual(strength)
        if rows is None:
            return False
        moved = base.residual - rows
        moved = moved - basis @ (basis.T @ moved)
        remaining = target - moved
        looks.append(_StrengthTrial(strength, rows, moved, float(remaining @ remaining)))
        return True

    strength = 1.0
    for _ in range(CRITERIA.search.looks):
        if look(strength):
            following = _next_strength(looks, target, signed)
        else:  # the model breaks down
            following = None if looks else strength * CRITERIA.search.weaker
        if following is None:
            break
        strength = following
    return looks


def _next_strength(looks: Sequence[_StrengthTrial], target: Array, signed: bool) -> float | None:
    """The strength to look at next; None: it is known where the effect does most good, as well as need be.

    What an effect does is taken for proportional to its strength, from the look that leaves least. Where that is the
    wrong way, weaker ones are looked at until it does little; and if it came to nothing sooner than in proportion, as
    beyond a threshold, those between.
    """
    goal, best = float(target @ target), min(looks, key=lambda look: look.remaining)
    tried = [look.strength for look in looks]
    if best.size == 0.0 and len(looks) == 1:
        return best.strength / CRITERIA.search.weaker
    strength = best.strength * float(best.moved @ target) / max(best.size, 1e-300)
    weakest = CRITERIA.search.weaker * min(abs(s) for s in tried)
    wrong_way = strength < 0 and not signed
    does_good = best.remaining < goal and best.size > CRITERIA.search.idle * goal
    if not does_good and (abs(strength) < weakest or best.remaining < goal or wrong_way):
        positive = [look for look in looks if look.strength > 0]
        return _weaker_strength(sorted(positive, key=lambda look: look.strength), goal)
    is_known = any(abs(strength - s) < CRITERIA.search.same_strength * abs(s) for s in tried)
    return None if is_known or wrong_way else strength


def _weaker_strength(looks: Sequence[_StrengthTrial], goal: float) -> float | None:
    """The next strength of an effect that does harm where it does anything; the looks by strength, all positive."""
    weakest = looks[0]
    if weakest.size > CRITERIA.search.little * goal:
        return weakest.strength * CRITERIA.search.weaker
    for weak, strong in itertools.pairwise(looks):
        in_proportion = strong.size * (weak.strength / strong.strength) ** 2
        if (
            weak.size < CRITERIA.search.little * in_proportion
            and strong.size > CRITERIA.search.little * goal
        ):
            return math.sqrt(weak.strength * strong.strength)
    return None
