"""The verdict: what the evidence adds up to, as facts."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import compress
from math import nan
from operator import not_
from typing import Literal

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement import verdict_sentences
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.detection_limits import DetectionLimit, detection_limits
from pam_cosim.diagnosis.judgement.evidence import (
    dominant_effect,
    has_structure,
    leaves_structure,
    missed_signals,
)
from pam_cosim.diagnosis.judgement.family_table import FamilyTable, credibility, family_table
from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.judgement.folds import Folds
from pam_cosim.diagnosis.judgement.posterior import Posterior, doubts_of, posterior
from pam_cosim.files import Plain
from pam_cosim.fitting import Fit
from pam_cosim.wording import Printed

Kind = Literal["none_missing", "identified", "ambiguous", "unknown"]
Doubt = Literal["", "noise", "limits"]
Check = Literal["held_out", "weak", "none"]


@dataclass(frozen=True)
class SignalError:
    """The error of a signal that is larger than its noise.

    Attributes:
        signal, unit: its name and unit.
        rmse, noise: root mean square of the error and of the noise [unit].
        run: name of the run; "": in all runs.
    """

    signal: str
    unit: str
    rmse: float
    noise: float
    run: str = ""


@dataclass(frozen=True)
class UnusualParameter:
    """A model that would fit as well as the answer if nothing were known of its parameters beforehand.

    Attributes:
        effects: of the model.
        name, unit: of the parameter that would be farthest from what is known of it.
        value: that it would need [unit]. low, high: between which it is expected [unit].
    """

    effects: tuple[str, ...]
    name: str
    unit: str
    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Verdict(Printed, Plain):
    """The answer to "which effect is missing?". Sentences about it are made in ``verdict_sentences``.

    Attributes:
        kind: none_missing, identified, ambiguous or unknown.
        families: missing families, in the order in which they were added; for an ambiguous verdict, those that
            the data cannot tell apart are all listed. For an unknown one, those that explain a part, without rivals.
        effects: the effect classes, likewise.
        remainder: a family is identified, and still the residual has structure: its form is not listed.
        probability: that these families, and no others, are what is missing; of an ambiguous verdict, some of them.
        refuted: effects of other families that fit as well, but not the signals that are ``off``.
        bending: effects of other families that fit as well because they are general members of these.
        unusual: models that would fit as well with parameters that nobody expects.
        posterior: how probable it is of every set of families, of nothing and of something else.
        explained: share of the squared error beyond the noise that the effects remove.
        alternatives: families of the answer and of each rival that the data cannot separate.
        units: of the fitted signals, by name.
        missed: signals that were compared but not fitted, and that the model misses by more than their noise.
        far: runs in which the error of a fitted signal is larger than in the others.
        noise_variance: mean square of the residual in the fitted runs [noise variances].
        noise_source: where the noise levels of the fitted signals come from; "": from several sources.
        general: the families whose general member is in the answer: their law is open.
        at_bound: parameters that ended at a bound, and are determined.
        check: whether held-out runs check the answer.
        folds: where the residual has structure: which effects are needed whichever runs are left out.
        limits: where no effect was added, the smallest errors that would have been found.
        doubt: why it is unknown although the residual is white: "noise", it is far above the noise level; "limits", no
            error that matters would have been found.
        table: the families that may be missing, each whatever else is.
    """

    json_keys = (
        "kind families effects reason remainder probability off refuted bending implausible posterior "
        "family_table=table"
    )

    kind: Kind
    families: tuple[str, ...] = ()
    effects: tuple[str, ...] = ()
    remainder: bool = False
    probability: float = nan
    refuted: tuple[str, ...] = ()
    bending: tuple[str, ...] = ()
    unusual: tuple[UnusualParameter, ...] = ()
    posterior: Posterior = Posterior()
    explained: float = 0.0
    alternatives: tuple[tuple[str, ...], ...] = ()
    units: dict[str, str] = field(default_factory=dict)
    missed: tuple[SignalError, ...] = ()
    far: tuple[SignalError, ...] = ()
    noise_variance: float = 1.0
    noise_source: str = ""
    general: tuple[str, ...] = ()
    at_bound: tuple[str, ...] = ()
    check: Check = "held_out"
    folds: Folds | None = None
    limits: tuple[DetectionLimit, ...] = ()
    doubt: Doubt = ""
    table: FamilyTable = FamilyTable()

    @property
    def leaves_structure(self) -> bool:
        """Whether the residual has structure that no effect explains."""
        return (self.kind == "unknown" and not self.doubt) or self.remainder

    @property
    def off(self) -> tuple[str, ...]:
        """Names of the signals that are ``missed``."""
        return tuple(error.signal for error in self.missed)

    @property
    def reason(self) -> str:
        """The verdict in a sentence or two."""
        return verdict_sentences.reason(self)

    @property
    def implausible(self) -> tuple[str, ...]:
        """A sentence for each of the ``unusual`` models."""
        return tuple(map(verdict_sentences.unusual_sentence, self.unusual))

    def __str__(self) -> str:
        return "\n  ".join(verdict_sentences.verdict_lines(self))

    def names(self, families: Collection[str]) -> bool:
        """Whether it says that just these families are missing, or may be."""
        if self.kind == "ambiguous":
            return bool(families) and set(families) <= set(self.families)
        if self.kind == "unknown" and not self.families:
            return False  # something is missing, and it is none of the families
        return set(families) == set(self.families)


def judge(models: FittedModels, rivals: Sequence[Candidate] = ()) -> Verdict:
    """The verdict on fitted models.

    What leaves structure is unknown, whatever its rivals: that two families fail alike does not make one of them the
    answer.

    Args:
        models: the answer is the last of their path.
        rivals: of the answer.
    """
    fit, path = models.last, models.path
    effects, families = tuple(c.effect for c in path), tuple(c.family for c in path)
    structure, remainder = leaves_structure(fit), False
    if path and structure and not rivals:
        dominant = dominant_effect(models.base, models.tried)
        remainder = dominant is not None and dominant.effects == path[-1].effects
    kind: Kind = "identified"
    limits = () if path else detection_limits(fit)
    doubt = "" if path or structure else _doubt(fit, limits)
    if (structure and not remainder) or doubt:
        kind = "unknown"
    elif rivals:
        kind = "ambiguous"
    elif not path:
        kind = "none_missing"
    instead = [tuple(e for e in c.effects if e not in effects) or (c.effect,) for c in rivals]
    shared = {e for c in rivals for e in c.effects}
    apart = [e for e in effects if e not in shared] or list(effects[-1:])
    verdict = Verdict(
        kind,
        families,
        effects,
        remainder,
        explained=explained(models.base, fit),
        alternatives=tuple(
            tuple(dict.fromkeys(models.family[e] for e in part)) for part in (apart, *instead)
        )
        if rivals
        else (),
        units={n: s.unit for n, s in fit.comparison.data.signals.items() if s.fitted},
        missed=_missed(fit),
        far=_far(fit),
        noise_variance=fit.residuals["fit"].chi2_reduced,
        noise_source=_noise_source(fit),
        general=tuple(c.family for c in path if c.general),
        at_bound=tuple(n for n, e in fit.parameters.items() if e.at_bound and e.determined),
        check=_check(fit),
        limits=limits,
        doubt=doubt,
    )
    if kind == "ambiguous":
        effects_instead = [e for part in instead for e in part]
        verdict = replace(
            verdict,
            effects=tuple(dict.fromkeys((*effects, *effects_instead))),
            families=tuple(
                dict.fromkeys((*families, *(models.family[e] for e in effects_instead)))
            ),
        )
    return verdict if doubt else _with_probability(_with_near_models(verdict, models), models)


def _doubt(fit: Fit, limits: Sequence[DetectionLimit]) -> Doubt:
    """Why white residuals of the base model do not say that nothing is missing."""
    if fit.residuals["fit"].chi2_reduced > CRITERIA.residuals.far_above:
        return "noise"
    return "limits" if limits and not any(limit.is_useful for limit in limits) else ""


def _with_near_models(verdict: Verdict, models: FittedModels) -> Verdict:
    """The verdict with the models that come as near, and why they are not the answer."""
    if not models.path:
        return verdict
    other_models, best = models.of_other_families, models.path[-1]
    refuted = models.close_to_answer(filter(models.is_refuted, other_models))
    general = [c.has_general_member and not best.has_general_member for c in other_models]
    bending = models.close_to_answer(
        c for c in compress(other_models, general) if not models.is_refuted(c)
    )
    return replace(
        verdict,
        refuted=tuple(" + ".join(c.effects) for c in refuted),
        bending=tuple(" + ".join(c.effects) for c in bending),
        unusual=_unusual(models, compress(other_models, map(not_, general))),
    )


def _with_probability(verdict: Verdict, models: FittedModels) -> Verdict:
    probabilities = posterior(
        models, doubts_of(models.path, verdict.kind == "unknown", verdict.remainder)
    )
    if verdict.leaves_structure:
        probabilities = replace(probabilities, credibility=credibility(models))
    probability = sum(
        e.probability for e in probabilities.explanations if verdict.names(e.families)
    )
    if verdict.kind == "unknown" and not verdict.families:
        probability = probabilities.something_else
    return replace(
        verdict,
        posterior=probabilities,
        probability=probability,
        table=family_table(models, probabilities),
    )


def _unusual(
    models: FittedModels, other_models: Iterable[Candidate]
) -> tuple[UnusualParameter, ...]:
    """What only priors of parameters keep from being a rival, with the parameter farthest from its prior."""
    limit = models.criterion(models.path[-1]) + CRITERIA.evidence.very_strong
    unusual_parameters = []
    for c in other_models:
        values_without_priors, with_priors = c.without_priors.values, models.criterion(c)
        without = (
            with_priors - c.fit.chi2_priors - c.without_priors.reduction / models.scale.divisor
        )
        if not values_without_priors or not without < limit <= with_priors:
            continue
        priors = {
            n: prior
            for n in values_without_priors
            if (prior := c.fit.parameters[n].prior) is not None
        }
        name = max(
            values_without_priors, key=lambda n: abs(priors[n].surprise(values_without_priors[n]))
        )
        unit, prior = c.fit.parameters[name].unit, priors[name]
        parameter = UnusualParameter(
            c.effects, name, unit, values_without_priors[name], prior.low, prior.high
        )
        unusual_parameters.append((without, parameter))
    unusual_parameters.sort(key=lambda entry: (entry[0], entry[1].effects))
    return tuple(parameter for _, parameter in unusual_parameters)


def _check(fit: Fit) -> Check:
    """How held-out runs check a model: weakly if only the uncertainty of the parameters covers their error."""
    held = fit.residuals["holdout"]
    if not held.samples:
        return "none"
    return "weak" if has_structure(held) and not leaves_structure(fit) else "held_out"


def _noise_source(fit: Fit) -> str:
    """Where the noise levels of the fitted signals come from; "" if from several sources."""
    signals = fit.comparison.data.signals.values()
    sources = {s.source.partition(":")[0] for s in signals if s.fitted}
    return sources.pop() if len(sources) == 1 else ""


def _missed(fit: Fit) -> tuple[SignalError, ...]:
    scores, signals = fit.comparison.scores, fit.comparison.data.signals
    return tuple(
        SignalError(n, signals[n].unit, scores["all"][n].rmse, scores["all"][n].noise_rmse)
        for n in missed_signals(fit)
    )


def _far(fit: Fit) -> tuple[SignalError, ...]:
    """Runs in which a fitted signal is off by more than its noise and that of the others."""
    far = []
    for name, signal in fit.comparison.data.signals.items():
        if not signal.fitted or not signal.sigma:
            continue
        runs = [r for r in fit.comparison.runs if r.run.sample_count(name)]
        errors = [float(np.sqrt(np.nanmean(r.residual(name) ** 2))) for r in runs]
        usual = max(sorted(errors)[(len(errors) - 1) // 2], signal.sigma) if errors else 0.0
        far += [
            SignalError(name, signal.unit, error, signal.sigma, r.run.name)
            for r, error in zip(runs, errors, strict=True)
            if error > CRITERIA.evidence.refuted * usual
        ]
    return tuple(far)


def explained(before: Fit, after: Fit) -> float:
    """Share of the squared error beyond the noise that is gone, on holdout runs where there are any; at most 1.

    But for what the parameters' uncertainty explains of these runs, as in the evidence.
    """
    role = "holdout" if before.residuals["holdout"].samples else "fit"
    a, b = (fit.residuals_beyond_uncertainty[role] for fit in (before, after))
    excess = a.chi2 - a.samples
    return min((a.chi2 - b.chi2) / excess, 1.0) if excess > 0 else 0.0
