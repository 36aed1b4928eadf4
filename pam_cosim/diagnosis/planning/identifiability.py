"""What data can tell, and what they cannot, before any model is fitted to them.

The model at its start values is taken for the rig. To first order, its slopes say how exactly each free parameter will
be known; what an effect does at its stated strength, beyond what the free parameters could do, says whether the data
show it; and what the effects of another family could do of that, whether they tell the two apart. All is asked of one
set of rows, in which everything stands that could be measured: each further signal or run is a choice of rows.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.planning.hypothetical_measurements import AS_MEASURED, REST_RANGE, Option
from pam_cosim.diagnosis.search.probing import StatedEffect, Strengths, detectable_strength
from pam_cosim.fitting import Linear
from pam_cosim.fitting.fit import STRONG_CORRELATION

Confused = tuple[str, str, float]
WEAKEST = 1e-3  # stated strengths; what is weaker does not matter, whether the data show it or not


@dataclass(frozen=True)
class ParameterPrecision:
    """How exactly a free parameter will be known.

    Attributes:
        name, unit: of the parameter.
        start: where it was asked [unit].
        deviation: standard deviation that is expected of its estimate [unit].
        span: between its bounds [unit].
    """

    json_keys = "name unit start deviation span determined"

    name: str
    unit: str
    start: float
    deviation: float
    span: float

    @property
    def determined(self) -> bool:
        """Whether the data tell at least as much as the bounds do, between which any value is as likely."""
        return self.deviation < self.span / math.sqrt(24)


@dataclass(frozen=True)
class DetectableEffect:
    """How well the data show an effect.

    Attributes:
        effect, family: as its class declares them.
        size: what it does at its stated strength beyond what the free parameters could, in standard deviations of the
            noise: root of the sum of squares.
        least: the strength from which the data show it, in stated strengths, ``WEAKEST`` at least; infinite: they do
            not, as strong as its bounds allow.
        values: of its parameters at that strength, within their bounds; absent: where they do nothing; units: theirs.
    """

    effect: str
    family: str
    size: float
    least: float
    values: dict[str, float]
    absent: dict[str, float]
    units: dict[str, str]


@dataclass(frozen=True)
class ConfusedPair:
    """Two families that the data do not tell apart at the stated strength.

    Attributes:
        effect, family: what is there. other, other_family: what it may be taken for.
        least: the strength from which they are told apart, in stated strengths.
    """

    effect: str
    family: str
    other: str
    other_family: str
    least: float


@dataclass(frozen=True)
class Identifiability:
    """What some choice of samples can tell.

    Attributes:
        parameters: the free ones.
        confused: pairs of parameters that are hardly told apart, with the correlation of their estimates.
        effects: every effect that was simulated, the one that is shown best first.
        alike: families that are shown but not told apart, the worst first.
    """

    parameters: tuple[ParameterPrecision, ...]
    confused: tuple[Confused, ...]
    effects: tuple[DetectableEffect, ...]
    alike: tuple[ConfusedPair, ...]

    @cached_property
    def families(self) -> dict[str, DetectableEffect]:
        """By family, the effect of it that is shown best."""
        best: dict[str, DetectableEffect] = {}
        for effect in self.effects:
            best.setdefault(effect.family, effect)
        return best

    @property
    def visible(self) -> frozenset[str]:
        """Families of which one effect is shown at its stated strength."""
        return frozenset(name for name, effect in self.families.items() if effect.least <= 1)

    @property
    def hidden(self) -> tuple[str, ...]:
        """Families of which no effect is shown, however strong."""
        return tuple(name for name, effect in self.families.items() if math.isinf(effect.least))

    @property
    def pairs(self) -> frozenset[frozenset[str]]:
        """Pairs of families that are shown and told apart."""
        visible, alike = (
            sorted(self.visible),
            {frozenset((a.family, a.other_family)) for a in self.alike},
        )
        return frozenset(frozenset((a, b)) for a in visible for b in visible if a < b) - alike


class Rows:
    """Everything that could be measured, linearised once.

    Args:
        base: the model at the start values.
        units: of its parameters.
        probes: each effect at its stated strength.
        option: (m,) what each row belongs to.
        samples: number of samples by option.
    """

    def __init__(
        self,
        base: Linear,
        units: Mapping[str, str],
        probes: Sequence[StatedEffect],
        option: Sequence[Option],
        samples: Mapping[Option, int],
    ) -> None:
        self.base, self.units, self.option, self.samples = base, units, list(option), samples
        self.probes = list(probes)
        # a parameter is known beforehand as well as its bounds say, between which any value is as likely
        self._bounds = np.diag(math.sqrt(12) / (base.high - base.low))

    @property
    def further(self) -> list[Option]:
        """What could be measured beyond what was."""
        return [option for option in dict.fromkeys(self.option) if option != AS_MEASURED]

    def identifiability(self, *options: Option) -> Identifiability:
        """What can be told by what was measured, and by something further."""
        chosen = {AS_MEASURED, *options}
        at = np.array([option in chosen for option in self.option])
        samples = sum(self.samples[option] for option in chosen)
        price = math.log(max(samples, CRITERIA.evidence.least_samples))
        slopes = np.vstack([self.base.slopes[at], self._bounds])
        basis = np.linalg.qr(slopes)[0]
        moves = {
            p.effect: _orthogonal_part(basis, self._among(at, self._moves(p))) for p in self.probes
        }
        sizes = {
            p.effect: _sizes(_orthogonal_part(basis, self._among(at, p.courses(self.base))))
            for p in self.probes
        }
        detectable_effects = sorted(
            (_detectability(p, sizes[p.effect], price) for p in self.probes),
            key=lambda s: (s.least, s.effect),
        )
        parameters, confused = self._known(slopes)
        result = Identifiability(parameters, confused, tuple(detectable_effects), ())
        return replace(result, alike=tuple(self._alike(result, moves, price)))

    def _among(self, at: NDArray[np.bool_], columns: Array) -> Array:
        """Some rows, and what bounds say, which no effect changes."""
        return np.vstack([columns[at], np.zeros((len(self._bounds), columns.shape[1]))])

    def _moves(self, probe: StatedEffect) -> Array:
        """(rows, 1 + k) what an effect does as a whole at its stated strength, and by each of its parameters."""
        return np.column_stack([probe.courses(self.base)[:, 0], probe.linear.slopes])

    def _known(self, slopes: Array) -> tuple[tuple[ParameterPrecision, ...], tuple[Confused, ...]]:
        covariance = np.linalg.inv(slopes.T @ slopes)
        deviation = np.sqrt(np.diag(covariance))
        names, base = self.base.names, self.base
        parameters = [
            ParameterPrecision(
                name,
                self.units[name],
                float(base.values[i]),
                float(deviation[i]),
                float(base.high[i] - base.low[i]),
            )
            for i, name in enumerate(names)
        ]
        correlation = covariance / np.outer(deviation, deviation)
        pairs = zip(*np.triu_indices(len(names), 1), strict=True)
        confused = [(names[i], names[j], float(correlation[i, j])) for i, j in pairs]
        return tuple(parameters), tuple(c for c in confused if abs(c[2]) > STRONG_CORRELATION)

    def _alike(
        self, result: Identifiability, moves: Mapping[str, Array], price: float
    ) -> list[ConfusedPair]:
        """Pairs of visible families of which one may be taken for the other, the worse way round."""
        strengths_of_effect = {p.effect: p.strengths for p in self.probes}
        count = {name: len(strengths.parameters) for name, strengths in strengths_of_effect.items()}
        spaces = {p.effect: _orthonormal(moves[p.effect]) for p in self.probes}
        worst: dict[frozenset[str], ConfusedPair] = {}
        for family, best in result.families.items():
            if family not in result.visible:
                continue
            slopes_of_best = moves[best.effect][:, 0]
            for p in self.probes:
                if p.family == family or p.family not in result.visible:
                    continue
                remaining_size = float(
                    np.linalg.norm(_orthogonal_part(spaces[p.effect], slopes_of_best))
                )
                required_evidence = CRITERIA.evidence.very_strong - price * (
                    count[p.effect] - count[best.effect]
                )
                least = _detectable_at(required_evidence, remaining_size)
                pair = frozenset((family, p.family))
                if least > 0 and not strengths_of_effect[best.effect].within_bounds(least):
                    least = math.inf
                if least > 1 and (pair not in worst or least > worst[pair].least):
                    worst[pair] = ConfusedPair(best.effect, family, p.effect, p.family, least)
        return sorted(worst.values(), key=lambda a: (-a.least, a.effect, a.other))


def _sizes(courses: Array) -> list[float]:
    return [float(size) for size in np.linalg.norm(courses, axis=0)]


def _detectability(probe: StatedEffect, sizes: Sequence[float], price: float) -> DetectableEffect:
    """How well an effect is shown that has these sizes, as ``probing.detectable_strength`` takes them."""
    required_size = math.sqrt(
        CRITERIA.evidence.very_strong + price * len(probe.strengths.parameters)
    )
    least = max(detectable_strength(sizes, required_size), WEAKEST)
    if not probe.strengths.within_bounds(least):
        least = math.inf
    values, absent = _strength_parameters(probe.strengths, least), probe.strengths.at(0.0)
    return DetectableEffect(
        probe.effect,
        probe.family,
        sizes[0],
        least,
        values,
        absent,
        {f.name: f.unit for f in probe.strengths.parameters},
    )


def _strength_parameters(strengths: Strengths, strength: float) -> dict[str, float]:
    """The parameters that tell of an effect's strength, at one."""
    if not math.isfinite(strength):
        return {}
    values, stated, null_value = strengths.at(strength), strengths.at(1.0), strengths.at(0.0)
    return {name: value for name, value in values.items() if stated[name] != null_value[name]}


def _orthogonal_part(basis: Array, columns: Array) -> Array:
    """The part (m, k) of columns (m, k) that is orthogonal to orthonormal columns (m, j)."""
    return np.asarray(columns - basis @ (basis.T @ columns))


def _orthonormal(columns: Array) -> Array:
    """(m, j) orthonormal directions of columns (m, k); directions much shorter than the longest are left out."""
    directions, singular, _ = np.linalg.svd(columns, full_matrices=False)
    return np.asarray(directions[:, singular > REST_RANGE * singular.max(initial=0.0)])


def _detectable_at(required_evidence: float, size: float) -> float:
    """The strength at which something of this size (root of a sum of squares) is so much evidence."""
    if required_evidence <= 0:
        return 0.0
    return math.sqrt(required_evidence) / size if size > 0 else math.inf
