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
        credibility: what it takes away as a share of that and of what remains unexplained, as squares, in the signal
            where it is largest: what takes away little beside much that remains may only stand in for a part of that.
    """

    rms: Mapping[str, float]
    share: float
    credibility: float = 1.0

    def matters(self, times: float = 1.0) -> bool:
        """Whether it is as large as a missing effect must be, or so many times that."""
        numbers = CRITERIA.evidence
        largest = max(self.rms.values(), default=0.0)
        large = largest >= times * numbers.least_rms or self.share >= times * numbers.least_share
        return large and self.credibility >= numbers.visible


def size_of_effect(base: Fit, without: Fit, with_it: Fit) -> EffectSize:
    """The size of the effect by which two models differ, of all runs; the share as the evidence counts these.

    Args:
        base: the model without effects. without: the model without this effect. with_it: the model with it.
    """
    after, before = with_it.comparison.scores["all"], without.comparison.scores["all"]
    signals = [n for n in with_it.comparison.data.fitted_signals if n in after]
    noise = max(with_it.residuals["fit"].noise_floor, 1.0)
    taken = {n: max(before[n].chi2_reduced - after[n].chi2_reduced, 0.0) / noise for n in signals}
    left = {n: max(after[n].chi2_reduced / noise - 1.0, 0.0) for n in signals}
    squares = [
        sum(s.chi2 for s in fit.residuals_beyond_uncertainty.values())
        for fit in (base, without, with_it)
    ]
    excess = squares[0] - squares[2]
    return EffectSize(
        {n: sqrt(square) for n, square in taken.items()},
        (squares[1] - squares[2]) / excess if excess > 0 else 0.0,
        max((w / (w + left[n]) for n, w in taken.items() if w + left[n] > 0), default=1.0),
    )
