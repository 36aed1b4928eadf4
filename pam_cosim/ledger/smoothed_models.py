"""The smoothed models of a ledger, and the one that explains the samples best."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.ledger.augmented import AugmentedModel, UnknownInput
from pam_cosim.ledger.smoother import Smoothed, with_some
from pam_cosim.ledger.smoothing_problem import SmoothingProblem
from pam_cosim.ledger.unaugmented import Unaugmented


@dataclass(frozen=True)
class SmoothedModel:
    """A smoothed augmented model.

    Attributes:
        augmented: the model.
        problem: of smoothing.
        unknown_inputs: those that act.
        free: names of the parameters that are estimated along.
        smoothed: the estimate.
    """

    augmented: AugmentedModel
    problem: SmoothingProblem
    unknown_inputs: tuple[UnknownInput, ...]
    free: tuple[str, ...]
    smoothed: Smoothed

    def with_only(self, unknown_input: UnknownInput) -> tuple[float, float]:
        """Deviance and chi-square where this one alone acts."""
        return with_some(self.problem, self.smoothed, [self.unknown_inputs.index(unknown_input)])

    def without(self, unknown_input: UnknownInput) -> tuple[float, float]:
        """Deviance and chi-square where all others act."""
        return with_some(
            self.problem,
            self.smoothed,
            [i for i, u in enumerate(self.unknown_inputs) if u is not unknown_input],
        )


@dataclass(frozen=True)
class SmoothedModels:
    """All smoothed models of the samples; None where there is none.

    Attributes:
        unaugmented: the model as it is.
        augmented: an unknown input in each balance.
        replaced: a law replaced by an unknown input.
        samples: how many there are.
    """

    unaugmented: Unaugmented
    augmented: SmoothedModel | None
    replaced: SmoothedModel | None
    samples: int

    @property
    def fitted(self) -> dict[str, SmoothedModel | None]:
        """Those with unknown inputs by their names."""
        return {"augmented": self.augmented, "replaced": self.replaced}

    @property
    def deviances(self) -> dict[str, float]:
        """Of each explanation by its name; infinite where there is none."""
        smoothed = {n: m.smoothed.deviance if m else np.inf for n, m in self.fitted.items()}
        return {"none": self.unaugmented.deviance, **smoothed}

    @property
    def best(self) -> str:
        """The name of the most probable one; "none" where none is beyond doubt more so than the model as it is."""
        deviances = self.deviances
        best = min(deviances, key=lambda name: deviances[name])
        doubtful = deviances[best] > self.unaugmented.deviance - CRITERIA.evidence.very_strong
        return "none" if doubtful else best

    @property
    def winner(self) -> SmoothedModel | None:
        """The best one, where it has unknown inputs."""
        return self.fitted.get(self.best)

    @property
    def is_confused(self) -> bool:
        """Whether an unknown input in addition to a law, and one in its place, explain the samples about as well."""
        rival = {"augmented": "replaced", "replaced": "augmented"}.get(self.best)
        deviances = self.deviances
        return (
            rival is not None
            and deviances[rival] < deviances[self.best] + CRITERIA.evidence.very_strong
        )

    @property
    def chi2(self) -> float:
        """Of the best one."""
        return self.winner.smoothed.chi2 if self.winner else self.unaugmented.chi2

    def explained(self, chi2: float) -> float:
        """Part of the error beyond the noise that an explanation with this chi-square takes away, 0 to 1."""
        excess = max(self.unaugmented.chi2 - self.samples, 1e-9)
        return float(np.clip((self.unaugmented.chi2 - max(chi2, self.samples)) / excess, 0.0, 1.0))
