"""Profile likelihood: how much worse the fit gets as one parameter is moved and all others make up for it.

Where a profile rises by the 95 % point of the chi-square distribution with one degree of freedom, the interval ends
(Raue and others 2009, Bioinformatics 25, 1923-1929); where it never does, the data do not determine the parameter.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.exports import Columns, Tabular
from pam_cosim.files import plain
from pam_cosim.fitting.estimate import standard_deviations
from pam_cosim.fitting.levenberg_marquardt import levenberg_marquardt
from pam_cosim.fitting.objective import Objective
from pam_cosim.wording import Printed

INTERVAL_RISE = 3.84  # of chi-square at the ends of a 95 % interval (chi-square distribution)
_FLAT_RISE = 0.1  # rise of chi-square, below which other parameters compensate fully
_STEP = 0.7  # sd: three or four steps reach the end of the interval
_POINTS = 8  # on each side, at most
_EVALUATIONS = 12  # of each point, which starts at the fit of the point before
_LEAST_POWER = 0.1  # of one parameter that another follows along a flat profile
_SCATTER = 0.1  # of its range, by which the other parameter may deviate from that power


@dataclass(frozen=True)
class Profile:
    """The profile of one parameter.

    Attributes:
        name: of the parameter.
        unit: its SI unit.
        best: value at the optimum [unit].
        values: (n,) at which all other parameters were fitted again [unit], increasing.
        rise: (n,) of chi-square over its minimum, in the same measure as the intervals of the fit: noise beyond the
            stated one, or correlated in time, makes it smaller.
        low, high: ends of the 95 % interval [unit]; infinite where the profile does not rise so far within the bounds,
            or does so only since another parameter, which made up for it till then, came to its own bound.
        others: (n,) what each other parameter was fitted to, by name [its unit].
    """

    json_keys = "unit best values rise low high determined others sentence"

    name: str
    unit: str
    best: float
    values: Array
    rise: Array
    low: float
    high: float
    others: dict[str, Array]

    @property
    def determined(self) -> bool:
        """Whether the data bound the parameter on one side at least."""
        return bool(np.isfinite(self.low) or np.isfinite(self.high))

    def followers(self) -> dict[str, float]:
        """Other parameters that follow a power of this one along its profile, with the power; by their logarithms."""
        powers = {}
        flat = self.rise < INTERVAL_RISE
        x = self.values[flat]
        if len(x) > 2 and np.all(x > 0) and np.ptp(np.log(x)) > 0:
            for name, y in self.others.items():
                if np.all(y[flat] > 0):
                    power, start = np.polyfit(np.log(x), np.log(y[flat]), 1)
                    off = np.log(y[flat]) - start - power * np.log(x)
                    if abs(power) > _LEAST_POWER and np.ptp(off) < _SCATTER * np.ptp(
                        np.log(y[flat])
                    ):
                        powers[name] = float(power)
        return powers

    def sentence(self) -> str:
        """What the data determine of it, in words."""
        unit = "" if self.unit == "1" else f" {self.unit}"
        low = f"{self.low:.4g}" if np.isfinite(self.low) else "its lower bound"
        high = f"{self.high:.4g}" if np.isfinite(self.high) else "its upper bound"
        if self.determined:
            text = f"{self.name} lies between {low} and {high}{unit} (95 %)"
            sides = [
                s for s, v in (("below", self.low), ("above", self.high)) if not np.isfinite(v)
            ]
            return text + (f"; these data do not limit it {sides[0]}" if sides else "")
        fitting = self.values[self.rise < INTERVAL_RISE]
        span = f"{fitting[0]:.4g} to {fitting[-1]:.4g}{unit}"
        text = f"these data do not determine {self.name}: anything from {span} fits"
        follows = [f"{name} as its power {power:.2g}" for name, power in self.followers().items()]
        return text + (
            f", where others follow: {', '.join(follows)}; hold one of them fixed"
            if follows
            else ""
        )


@dataclass(frozen=True)
class Profiles(Printed, Tabular):
    """The profiles of all parameters of a fit, by name."""

    model: str
    profiles: dict[str, Profile]

    def frame_columns(self) -> Columns:
        """A row for each point of each profile, its value in the SI unit of the column "unit"."""
        rows = [
            (profile.name, profile.unit, value, rise)
            for profile in self.profiles.values()
            for value, rise in zip(profile.values, profile.rise, strict=True)
        ]
        names, units, values, rises = zip(*rows, strict=True)
        return {
            "parameter": (names, None),
            "unit": (units, None),
            "value": (values, None),
            "rise": (rises, ""),
        }

    def as_dict(self) -> dict[str, Any]:
        """Plain data for JSON, SI units."""
        return dict(plain(self.profiles))

    def __str__(self) -> str:
        return "\n".join(f"  {p.sentence()}" for p in self.profiles.values())


def profiles(
    objective: Objective, best: Mapping[str, float], spread: float, model: str
) -> Profiles:
    """Profiles about an optimum.

    Args:
        objective: of the fit.
        best: fitted parameters by name [SI].
        spread: factor on the standard deviations, as for ``estimates``.
        model: its name.
    """
    z = np.array([f.to_z(best[f.name]) for f in objective.free])
    lowest, linear = objective.squares(z), objective.triangle(z)
    deviation = spread * standard_deviations(np.where(linear[:, :-1] == 0, 1e-300, linear[:, :-1]))
    profiles_by_name = {}
    for i, free in enumerate(objective.free):
        sides = [_side(objective, z, i, sign, deviation[i], lowest, spread) for sign in (-1.0, 1.0)]
        points = [*reversed(sides[0]), (z, 0.0), *sides[1]]
        at = np.array(
            [
                [f.to_value(float(c)) for f, c in zip(objective.free, p, strict=True)]
                for p, _ in points
            ]
        )
        rise = np.array([r for _, r in points])
        ends = [_end(objective, z, i, side) for side in sides]
        other_parameters = {f.name: at[:, k] for k, f in enumerate(objective.free) if k != i}
        low, high = (
            (-np.inf if ends[0] is None else ends[0]),
            (np.inf if ends[1] is None else ends[1]),
        )
        profiles_by_name[free.name] = Profile(
            free.name, free.unit, best[free.name], at[:, i], rise, low, high, other_parameters
        )
    return Profiles(model, profiles_by_name)


def _side(
    objective: Objective,
    z: Array,
    i: int,
    sign: float,
    deviation: float,
    lowest: float,
    spread: float,
) -> list[tuple[Array, float]]:
    """Points away from the optimum on one side, with the rise at each, until the interval or the bounds end."""
    low, high = objective.bounds
    room = (high[i] - z[i]) if sign > 0 else (z[i] - low[i])
    step = min(_STEP * deviation, room / _POINTS)
    points: list[tuple[Array, float]] = []
    at, before = z, 0.0
    for _ in range(_POINTS):
        room = (high[i] - at[i]) if sign > 0 else (at[i] - low[i])
        if step <= 0 or room <= 0:
            break
        at = _refitted(objective, at, i, float(at[i] + sign * min(step, room)))
        rise = max(objective.squares(at) - lowest, 0.0) / spread**2
        if not np.isfinite(rise):
            break
        points.append((at, rise))
        if rise > INTERVAL_RISE:
            break
        step *= 2 if rise - before < INTERVAL_RISE / _POINTS else 1
        before = rise
    return points


def _refitted(objective: Objective, at: Array, i: int, value: float) -> Array:
    """All other parameters fitted where parameter i is held."""
    low, high = objective.bounds
    is_other = np.arange(len(at)) != i

    def whole(other_values: Array) -> Array:
        z = np.empty(len(at))
        z[is_other], z[i] = other_values, value
        return z

    if not is_other.any() or not np.isfinite(objective.squares(whole(at[is_other]))):
        return whole(at[is_other])
    columns = np.append(is_other, True)
    solution = levenberg_marquardt(
        lambda other_values: objective.squares(whole(other_values)),
        lambda other_values: np.asarray(
            np.linalg.qr(objective.triangle(whole(other_values))[:, columns], mode="r")
        ),
        at[is_other],
        (low[is_other], high[is_other]),
        CRITERIA.fit.precision,
        _EVALUATIONS,
    )
    return whole(solution.z)


def _end(
    objective: Objective, z: Array, i: int, side: Sequence[tuple[Array, float]]
) -> float | None:
    """Where the rise passes the limit; None: nowhere, or only since another parameter that made up came to its bound.

    Between two points the root of the rise is taken as straight, which it is for a parabola.
    """
    limit = float(np.sqrt(INTERVAL_RISE))
    points = [(z, 0.0), *side]
    for (a, low), (b, high) in zip(points[:-1], points[1:], strict=True):
        if np.sqrt(high) >= limit > np.sqrt(low):
            free = [
                rise for p, rise in side if rise < high and not _at_new_bound(objective, z, p, i)
            ]
            if _at_new_bound(objective, z, b, i) and free and max(free) < _FLAT_RISE:
                return None
            share = (limit - np.sqrt(low)) / (np.sqrt(high) - np.sqrt(low))
            return objective.free[i].to_value(float(a[i] + (b[i] - a[i]) * share))
    return None


def _at_new_bound(objective: Objective, best: Array, z: Array, i: int) -> bool:
    """Whether another parameter is at a bound at ``z`` that was not at one at ``best``."""
    low, high = objective.bounds
    margins = CRITERIA.fit.at_bound * (high - low)
    bound, before = ((p - low <= margins) | (high - p <= margins) for p in (z, best))
    return bool(np.any((bound & ~before)[np.arange(len(z)) != i]))


def correlations(jacobian: Array) -> Array:
    """(k, k) correlation matrix of the estimates; NaN in the row and column of a parameter without influence.

    Args:
        jacobian: (m, k) of the weighted residuals.
    """
    k = jacobian.shape[1]
    matrix = np.full((k, k), np.nan)
    alive = np.flatnonzero(np.linalg.norm(jacobian, axis=0) > 0)
    if alive.size:
        _, s, vt = np.linalg.svd(
            jacobian[:, alive] / np.linalg.norm(jacobian[:, alive], axis=0), full_matrices=False
        )
        deviations = (
            vt / np.maximum(s, CRITERIA.fit.seen * s[0])[:, None]
        )  # an unobserved direction is very uncertain
        covariance = deviations.T @ deviations
        size = np.sqrt(np.diag(covariance))
        matrix[np.ix_(alive, alive)] = np.clip(covariance / np.outer(size, size), -1, 1)
    return matrix
