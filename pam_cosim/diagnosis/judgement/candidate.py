"""A hypothesis: the model with some effects added, fitted and judged."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from pam_cosim.comparison import SignalScore
from pam_cosim.fitting import Estimate, Fit, WithoutPriors, without_priors
from pam_cosim.measurement import ROLES
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed


@dataclass(frozen=True)
class Candidate(Printed):
    """The model with one more effect, fitted to the data.

    Attributes:
        effect: name of the effect that was tried.
        family, balance: as the effect's class declares them.
        effects: all effects in the model, in the order in which they were added, ``effect`` last.
        own_parameters: names of the parameters that the tried effect brought.
        fit: the fitted model.
        delta_bic: Bayesian information criterion of all runs, held-out ones beyond the parameters' uncertainty, minus
            that of the model without ``effect``; negative is better.
        probability: weight among all candidates and the model without any, by that criterion alone: the probability of
            a verdict is the verdict's.
        equations: the Modelica text of the model.
        brief: it was fitted in a few steps only, and might still come nearer.
        general: the effect is the general member of its family, which contains its laws.
        without_priors: what the fit would come to without them, once its slopes are gone.
        parameters_before: names of the parameters that the effects before the tried one brought.
        general_before: one of these is a general member.
    """

    failure = None  # in the place of that of a ``FailedTrial``
    json_keys = (
        "effect family balance effects delta_bic probability failure *_roles "
        "parameters=fit.parameters own_parameters"
    )

    effect: str
    family: str
    balance: str
    effects: tuple[str, ...]
    own_parameters: tuple[str, ...]
    fit: Fit
    delta_bic: float = float("nan")
    probability: float = 0.0
    equations: str = ""
    brief: bool = False
    general: bool = False
    without_priors: WithoutPriors = WithoutPriors()
    parameters_before: tuple[str, ...] = ()
    general_before: bool = False

    def __str__(self) -> str:
        return f"{' + '.join(self.effects)}: {describe_fit(self.fit)}"

    @property
    def parameters(self) -> dict[str, Estimate]:
        """Estimates of the effect's own parameters."""
        return {n: self.fit.parameters[n] for n in self.own_parameters}

    @property
    def effect_parameters(self) -> dict[str, Estimate]:
        """Estimates of the parameters of all effects."""
        return {n: self.fit.parameters[n] for n in (*self.parameters_before, *self.own_parameters)}

    @property
    def has_general_member(self) -> bool:
        """Whether one of its effects is a general member, whichever was added last."""
        return self.general or self.general_before

    @property
    def without_slopes(self) -> Candidate:
        """The same without the linear model, which only a search needs."""
        if self.fit.linear is None:
            return self
        return replace(self, fit=self.fit.without_linear(), without_priors=without_priors(self.fit))

    @property
    def _roles(self) -> dict[str, object]:
        return {role: role_summary(self.fit, role) for role in ROLES}


@dataclass(frozen=True)
class FailedTrial:
    """An effect that could not be fitted.

    Attributes:
        effect, family, balance, effects: as in ``Candidate``.
        failure: why not.
    """

    delta_bic, probability = None, 0.0  # in the place of those of a ``Candidate``
    json_keys = "effect family balance effects delta_bic probability failure"

    effect: str
    family: str
    balance: str
    effects: tuple[str, ...]
    failure: str


Attempt = Candidate | FailedTrial
"""What comes of trying an effect."""


def role_summary(fit: Fit, role: str) -> dict[str, object] | None:
    """Scores of a fitted model on the runs of one role; None where there are none."""
    scores: dict[str, SignalScore] = fit.comparison.scores[role]
    if not scores:
        return None
    chi2 = fit.comparison.chi2_reduced(role)
    return {"chi2_reduced": chi2, "signals": scores}


def describe_fit(fit: Fit) -> str:
    """Root mean square errors of a fit in units a person reads, and the reduced chi-square of the runs of each role."""
    scores = fit.comparison.scores["fit"]
    signals = fit.comparison.data.signals
    errors = ", ".join(f"{n} {format_quantity(s.rmse, signals[n].unit)}" for n, s in scores.items())
    text = f"rms error {errors}, chi2 {fit.comparison.chi2_reduced('fit'):.4g}"
    holdout = fit.comparison.chi2_reduced("holdout")
    return text if math.isnan(holdout) else f"{text} (holdout {holdout:.4g})"
