"""The error that an effect removes in addition to the others of a model, and whether it is large enough to matter.

The evidence of many samples tells apart what nobody cares about: what such an effect takes away is what the form of
another one does not say. So a further effect is called missing only if it is large enough; else it is measurable, but
small.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import sqrt

from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class EffectSize:
    """What an effect takes away that the others cannot, after they were fitted again.

    Attributes:
        rms: by signal, root of the mean square that it takes away [standard deviations of the noise].
        share: of the error beyond the noise that the base model leaves.
    """

    rms: Mapping[str, float]
    share: float

    def credibility(self, unexplained: Mapping[str, float]) -> float:
        """The share of what it takes away in that and what remains unexplained, as squares, where it is largest.

        What takes away no more than remains may only stand in for a part of that.

        Args:
            unexplained: rms by signal, as ``unexplained_rms`` has it.
        """
        squares = ((rms**2, unexplained.get(n, 0.0) ** 2) for n, rms in self.rms.items())
        return max((own / (own + rest) for own, rest in squares if own > 0), default=0.0)

    def matters(self, times: float = 1.0) -> bool:
        """Whether it is as large as a missing effect must be, or so many times that."""
        numbers = CRITERIA.evidence
        largest = max(self.rms.values(), default=0.0)
        return largest >= times * numbers.least_rms or self.share >= times * numbers.least_share


def size_of_effect(base: Fit, without: Fit, with_it: Fit) -> EffectSize:
    """The size of the effect by which two models differ, of all runs; the share as the evidence counts these.

    Args:
        base: the model without effects. without: the model without this effect. with_it: the model with it.
    """
    after, before = with_it.comparison.scores["all"], without.comparison.scores["all"]
    signals = with_it.comparison.data.fitted_signals
    fewer = {n: before[n].chi2_reduced - after[n].chi2_reduced for n in signals if n in after}
    noise = _noise(with_it)
    rms = {n: sqrt(max(square, 0.0) / noise) for n, square in fewer.items()}
    squares = [
        sum(s.chi2 for s in fit.residuals_beyond_uncertainty.values())
        for fit in (base, without, with_it)
    ]
    excess = squares[0] - squares[2]
    return EffectSize(rms, (squares[1] - squares[2]) / excess if excess > 0 else 0.0)


def unexplained_rms(fit: Fit) -> dict[str, float]:
    """Root mean square beyond the noise that a model leaves of each fitted signal [standard deviations of it]."""
    scores, noise = fit.comparison.scores["all"], _noise(fit)
    signals = [n for n in fit.comparison.data.fitted_signals if n in scores]
    return {n: sqrt(max(scores[n].chi2_reduced / noise - 1.0, 0.0)) for n in signals}


def _noise(fit: Fit) -> float:
    """Mean square of the noise beside a model [noise variances]."""
    return max(fit.residuals["fit"].noise_floor, 1.0)
