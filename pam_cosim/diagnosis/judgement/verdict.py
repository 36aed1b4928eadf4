"""What the evidence adds up to."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isnan
from types import MappingProxyType
from typing import Literal

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import (
    best_of_each,
    dominant_effect,
    has_structure,
    information_criterion,
    leaves_structure,
    missed_signals,
    noise_scale,
    refuted_by_unfitted_signals,
)
from pam_cosim.diagnosis.judgement.implausible import implausible
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.diagnosis.judgement.posterior import Posterior, doubts_of, posterior
from pam_cosim.files import Plain
from pam_cosim.fitting import Fit
from pam_cosim.units import format_quantity
from pam_cosim.wording import Printed, listed

MOST_RIVALS = 4  # models that a run is designed for: six pairs

Kind = Literal["none_missing", "identified", "ambiguous", "unknown"]


@dataclass(frozen=True)
class Verdict(Printed, Plain):
    """The answer to "which effect is missing?".

    Attributes:
        kind: none_missing, identified, ambiguous or unknown.
        families: missing families, in the order in which they were added; for an ambiguous verdict, those that
            the data cannot tell apart are all listed. For an unknown one, those that explain a part, without rivals.
        effects: the effect classes, likewise.
        reason: the verdict in a sentence or two.
        remainder: a family is identified, and still what remains has structure: its form is not listed.
        probability: that these families, and no others, are what is missing; of an ambiguous verdict, some of them.
        off: signals that were compared but not fitted, and that the model misses by more than their noise.
        refuted: effects of other families that fit as well, but not those signals.
        bending: effects of other families that fit as well because they say whatever their families can.
        implausible: a sentence for each model that would fit as well with parameters that nobody expects.
        posterior: how probable it is of every set of families, of nothing and of something else.
    """

    kind: Kind
    families: tuple[str, ...]
    effects: tuple[str, ...]
    reason: str
    remainder: bool = False
    probability: float = float("nan")
    off: tuple[str, ...] = ()
    refuted: tuple[str, ...] = ()
    bending: tuple[str, ...] = ()
    implausible: tuple[str, ...] = ()
    posterior: Posterior = Posterior()

    @property
    def summary(self) -> str:
        """Kind, families, effects and probability in a line."""
        what = f": {' and '.join(self.families)} ({', '.join(self.effects)})"
        probability = (
            "" if isnan(self.probability) else f", probability {100 * self.probability:.0f} %"
        )
        return f"{self.kind}{what * bool(self.families)}{probability}"

    @property
    def sentences(self) -> list[str]:
        """The reason, models that nobody expects, and what else may be missing."""
        otherwise = [f"Otherwise: {self.otherwise}"] * bool(self.otherwise)
        return [self.reason, *self.implausible, *otherwise]

    def __str__(self) -> str:
        return "\n  ".join([self.summary, *self.sentences])

    def names(self, families: Collection[str]) -> bool:
        """Whether it says that just these families are missing, or may be."""
        if self.kind == "ambiguous":
            return bool(families) and set(families) <= set(self.families)
        if self.kind == "unknown" and not self.families:
            return False  # something is missing, and it is none of the families
        return set(families) == set(self.families)

    @property
    def otherwise(self) -> str:
        """What else may be missing, with probabilities, the most probable first; "" where they are not known."""
        if isnan(self.posterior.something_else):
            return ""
        others = [one for one in self.posterior.explanations if not self.names(one.families)]
        shares = [(" and ".join(one.families) or "nothing", one.probability) for one in others]
        texts = [
            f"{what} {100 * share:.0f} %"
            for what, share in shares[:_MOST_LISTED]
            if round(100 * share)
        ]
        other = (
            "something that these data do not show"
            if self.kind == "none_missing"
            else "something else"
        )
        return ", ".join([*texts, f"{other} {100 * self.posterior.something_else:.0f} %"])


_MOST_LISTED = 3  # sets of families
_ALL_RUNS_SEARCHED = (
    " The model found from the fitted runs failed on the held-out runs, so the search was repeated with all runs: no "
    "run is left to check this verdict. The parameters are those of the fitted runs alone; fit all runs before you use "
    "them."
)
_FORM_OPEN = (
    "and no other family comes near. What remains has structure that no second effect explains: the family is what "
    "was found, in a form that no listed law has, or something smaller is missing besides."
)


_TAKEN_FOR_NOISE = {
    "stated": "the stated noise",
    "assumed": "the noise that was assumed",
    "estimated from the samples": "the noise that was estimated from the samples",
    "stated repeatability": "the stated repeatability",
    "of repeated runs": "the repeatability of repeated runs",
}


def rivals(
    base: Fit,
    best: Candidate,
    tried: Sequence[Candidate],
    family: Mapping[str, str],
    model_space: ModelSpace,
) -> list[Candidate]:
    """Models with other families that the data hardly distinguish from the best, one of each set of families.

    Neither the evidence nor signals that were compared but not fitted may tell them apart. The same families and one
    more are no rival: as few as do are enough. A general member is a rival only of
    general members, not of laws.

    Args:
        base: the model without effects, fitted.
        best: the model with all that was selected.
        tried: all models.
        family: of every effect there is.
        model_space: what a choice among them costs.
    """
    alike = [
        c
        for c in tried
        if (best.has_general_member or not c.has_general_member)
        and not refuted_by_unfitted_signals(c.fit, best.fit)
    ]
    return _close_alternatives(base, best, tried, alike, family, model_space)


def _close_alternatives(
    base: Fit,
    best: Candidate,
    tried: Sequence[Candidate],
    among: Sequence[Candidate],
    family: Mapping[str, str],
    model_space: ModelSpace,
) -> list[Candidate]:
    """Models with other families whose evidence is hardly less than that of the best, one of each set of families."""
    scale = noise_scale([base, *(c.fit for c in tried)])
    own = frozenset(family[e] for e in best.effects)
    limit = (
        information_criterion(best.fit, scale, best.effects, model_space, best)
        + CRITERIA.evidence.very_strong
    )
    each = best_of_each(among, scale, family, model_space).items()
    near = [(score, c) for theirs, (score, c) in each if not theirs >= own and score < limit]
    return [c for _, c in sorted(near, key=lambda entry: (entry[0], entry[1].effects))]


def nearest(
    base: Fit, tried: Sequence[Candidate], family: Mapping[str, str], model_space: ModelSpace
) -> list[Candidate]:
    """The models with most evidence, one of each set of families, best first: what is left where none leaves noise.

    Args:
        base: the model without effects, fitted.
        tried: all models.
        family: of every effect there is.
        model_space: what a choice among them costs.
    """
    scale = noise_scale([base, *(c.fit for c in tried)])
    fitted = [c for c in tried if not c.brief]
    each = sorted(
        best_of_each(fitted, scale, family, model_space).values(),
        key=lambda entry: (entry[0], entry[1].effects),
    )
    return [c for _, c in each[:MOST_RIVALS]]


def with_facts(
    verdict: Verdict,
    base: Fit,
    best: Candidate | None,
    tried: Sequence[Candidate],
    family: Mapping[str, str],
    model_space: ModelSpace,
) -> Verdict:
    """The verdict with what its sentences speak of besides: signals that nobody fitted, and models that come as near.

    Args:
        verdict: the answer.
        base, best, tried, family, model_space: as for ``rivals``; ``best`` None: nothing was selected.
    """
    fit = best.fit if best else base
    off = missed_signals(fit)
    if best is None:
        return replace(verdict, off=off)
    against = [c for c in tried if refuted_by_unfitted_signals(c.fit, fit)]
    bent = [
        c
        for c in tried
        if c.has_general_member
        and not best.has_general_member
        and not refuted_by_unfitted_signals(c.fit, fit)
    ]
    wrong, bending = (
        tuple(
            " + ".join(c.effects)
            for c in _close_alternatives(base, best, tried, some, family, model_space)
        )
        for some in (against, bent)
    )
    own = frozenset(family[e] for e in best.effects)
    others = [
        c
        for c in tried
        if not {family[e] for e in c.effects} >= own
        and (best.has_general_member or not c.has_general_member)
    ]
    unusual = implausible(best, others, noise_scale([base, *(c.fit for c in tried)]), model_space)
    return replace(verdict, off=off, refuted=wrong, bending=bending, implausible=unusual)


def with_posterior(
    verdict: Verdict,
    base: Fit,
    selected: Sequence[Candidate],
    tried: Sequence[Candidate],
    family: Mapping[str, str],
    model_space: ModelSpace,
) -> Verdict:
    """The verdict with the probabilities of what may be missing, and of what it says itself.

    Args:
        verdict: the answer.
        selected: models that add one effect after another.
        base, tried, family, model_space: as for ``rivals``.
    """
    doubts = doubts_of(selected, verdict.kind == "unknown", verdict.remainder)
    known = posterior(base, selected[-1] if selected else None, tried, family, model_space, doubts)
    named = sum(one.probability for one in known.explanations if verdict.names(one.families))
    if verdict.kind == "unknown" and not verdict.families:
        named = known.something_else
    return replace(verdict, posterior=known, probability=named)


def judge(
    base: Fit,
    selected: Sequence[Candidate],
    others: Sequence[Candidate],
    tried: Sequence[Candidate] = (),
    family: Mapping[str, str] = MappingProxyType({}),
    all_runs_searched: bool = False,
) -> Verdict:
    """Turns the effects that were ``selected``, rivals of the model with them and all that were tried into a verdict.

    What leaves structure is unknown, whatever its rivals: that two families fail alike does not make one of them the
    answer.

    Args:
        base: the model without effects, fitted.
        selected: models that add one effect after another.
        others: rivals of the last of them.
        tried: all models.
        family: of the effects of rivals with several.
        all_runs_searched: all runs were fitted, for those that were held out contradicted what the others came to.
    """
    if not selected:
        if leaves_structure(base):
            return Verdict(
                "unknown", (), (), "The residual has structure, and no listed effect explains it."
            )
        return Verdict(
            "none_missing",
            (),
            (),
            "The residual is noise: nothing is missing that these data could show.",
        )
    last = selected[-1]
    families = tuple(c.family for c in selected)
    effects = tuple(c.effect for c in selected)
    removed = 100 * explained(base, last.fit)
    text = f"{' + '.join(effects)} removes {removed:.1f} % of the squared error beyond the noise"
    known = {**family, **{c.effect: c.family for c in (*selected, *others)}}
    caution = _caution(last.fit, all_runs_searched)
    if leaves_structure(last.fit):
        dominant = dominant_effect(base, tried)
        if dominant is not None and dominant.effects == last.effects and not others:
            return Verdict(
                "identified", families, effects, f"{text}, {_FORM_OPEN}{caution}", remainder=True
            )
        text += ", but what remains has structure: something else is missing."
        if others:
            named = _alternatives(effects, last, others, known)
            text += f" Nor can these data separate {named}, and none of them is the answer."
        return Verdict("unknown", families, effects, text)
    if others:
        instead = [e for part in _instead(effects, others) for e in part]
        all_effects = tuple(dict.fromkeys((*effects, *instead)))
        all_families = tuple(dict.fromkeys((*families, *(known[e] for e in instead))))
        reason = f"These data cannot separate {_alternatives(effects, last, others, known)}."
        return Verdict(
            "ambiguous", all_families, all_effects, reason + _ALL_RUNS_SEARCHED * all_runs_searched
        )
    remains = f"what remains {_of_fitted_signals(last.fit)}is noise{_noise_excess(last.fit)}.{_exceptions(last.fit)}"
    return Verdict(
        "identified", families, effects, f"{text}; {remains}{_open_form(selected)}{caution}"
    )


def _instead(effects: Sequence[str], others: Sequence[Candidate]) -> list[tuple[str, ...]]:
    """What each rival has that the answer has not."""
    return [tuple(e for e in c.effects if e not in effects) or (c.effect,) for c in others]


def _alternatives(
    effects: Sequence[str], last: Candidate, others: Sequence[Candidate], family: Mapping[str, str]
) -> str:
    """The families that stand for each other: those of the answer that no rival has, and those of each rival."""
    shared = {e for c in others for e in c.effects}
    ours = [e for e in effects if e not in shared] or [last.effect]
    families = [
        dict.fromkeys(family[e] for e in part) for part in (ours, *_instead(effects, others))
    ]
    return " and ".join(" + ".join(names) for names in families)


def _of_fitted_signals(fit: Fit) -> str:
    """Which signals are spoken of, where others were compared but not fitted and are off."""
    signals = fit.comparison.data.signals
    return (
        f"of {listed([n for n, s in signals.items() if s.fitted])} " if missed_signals(fit) else ""
    )


def _noise_excess(fit: Fit) -> str:
    """That the noise is more than it was thought to be, and by whom."""
    loud = fit.residuals["fit"].chi2_reduced
    if loud <= CRITERIA.residuals.loud:
        return ""
    signals = fit.comparison.data.signals.values()
    sources = {s.source.partition(":")[0] for s in signals if s.fitted}
    taken = (
        _TAKEN_FOR_NOISE[next(iter(sources))] if len(sources) == 1 else "what was taken for noise"
    )
    return f"; it is {loud**0.5:.2g} times {taken}"


def _exceptions(fit: Fit) -> str:
    """Where what remains is no noise all the same: signals that were not fitted, and runs that are far off."""
    comparison = fit.comparison
    text = ""
    for name in missed_signals(fit):
        score, unit = comparison.scores["all"][name], comparison.data.signals[name].unit
        text += (
            f" {name}, compared but not fitted, is {format_quantity(score.rmse, unit)} off "
            f"(noise {format_quantity(score.noise_rmse, unit)}): something that acts on it is missing besides, or its "
            "instrument is at fault."
        )
    far = [
        f"{run} ({format_quantity(rmse, unit)} of {name})"
        for run, name, rmse, unit in _far_runs(fit)
    ]
    return text + (
        f" But not in every run: {listed(far)} {'is' if len(far) == 1 else 'are'} off."
        if far
        else ""
    )


def _far_runs(fit: Fit) -> list[tuple[str, str, float, str]]:
    """Runs in which a fitted signal is off by more than its noise and that of the others: run, signal, error, unit."""
    far = []
    for name, signal in fit.comparison.data.signals.items():
        if not signal.fitted or not signal.sigma:
            continue
        runs = [r for r in fit.comparison.runs if r.run.sample_count(name)]
        errors = [float(np.sqrt(np.nanmean(r.residual(name) ** 2))) for r in runs]
        usual = max(sorted(errors)[(len(errors) - 1) // 2], signal.sigma) if errors else 0.0
        limit = CRITERIA.evidence.refuted * usual
        far += [
            (r.run.name, name, e, signal.unit)
            for r, e in zip(runs, errors, strict=True)
            if e > limit
        ]
    return far


def _open_form(selected: Sequence[Candidate]) -> str:
    """What a general member of a family leaves open."""
    names = [c.effect for c in selected if c.general]
    if not names:
        return ""
    says, kind = ("say", "their families") if len(names) > 1 else ("says", "its family")
    return (
        f" {' and '.join(names)} {says} whatever {kind} can: "
        "the family is what was found, no listed law fits as well."
    )


def _caution(fit: Fit, all_runs_searched: bool) -> str:
    """What keeps an explanation from being beyond doubt: runs that do not check it, or a fit that ends at a bound."""
    held = fit.residuals["holdout"]
    text = (
        "" if held.samples else " No run was held out: nothing but what was fitted speaks for it."
    )
    text = _ALL_RUNS_SEARCHED if all_runs_searched else text
    if has_structure(held) and not leaves_structure(fit):
        text = " Held-out runs are met only as far as the fitted ones determine the parameters: they check little."
    names = [n for n, e in fit.parameters.items() if e.at_bound and e.determined]
    if names:
        text += f" Caution: {', '.join(names)} ended at a bound; the model may stand in for something else."
    return text


def explained(before: Fit, after: Fit) -> float:
    """Share of the squared error beyond the noise that is gone, on holdout runs where there are any; at most 1."""
    role = "holdout" if before.residuals["holdout"].samples else "fit"
    a, b = before.residuals[role], after.residuals[role]
    excess = a.chi2 - a.samples
    return min((a.chi2 - b.chi2) / excess, 1.0) if excess > 0 else 0.0
