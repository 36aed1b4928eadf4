"""The sentences about a verdict, for the terminal, the report, the page, the notebook and JSON."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isinf, isnan
from typing import TYPE_CHECKING, NamedTuple

from pam_cosim.comparison import SignalScore
from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting import Fit
from pam_cosim.model.domain import Domain
from pam_cosim.units import format_quantity
from pam_cosim.wording import enumeration, listed, words

if TYPE_CHECKING:
    from pam_cosim.diagnosis.judgement.family_table import FamilyRow
    from pam_cosim.diagnosis.judgement.verdict import SignalError, UnusualParameter, Verdict

_MOST_LISTED = 3  # sets of families
_SMALL_SHARE = 0.01  # what is less probable is one row
_NOTHING = "nothing is missing"
_UNSEEN = "something that these data do not show"
_KIND_NAMES = {
    "none_missing": "Nothing missing",
    "identified": "Identified",
    "ambiguous": "Ambiguous",
    "unknown": "Unknown",
}
_MEANINGS = {
    "none_missing": (
        "The residual of the base model looks like noise: it is uncorrelated in time and no larger than the stated "
        "noise. That does not prove that the model is complete. These runs, with these instruments, do not show "
        "another effect; faster, larger or longer tests may show one."
    ),
    "identified": (
        "One explanation stands out: the added effects remove the error of the fitted signals, and their residual is "
        "noise. {others} Add the effect to the model, and use the fitted parameters below within the range of {tested} "
        "that was tested."
    ),
    "ambiguous": (
        "An effect is missing, but several families explain these data about equally well. Do not choose one by its "
        "small lead in the ranking: their predictions differ in other tests. The next experiment named below is the "
        "variation of the recorded runs in which their predictions differ most."
    ),
    "unknown": (
        "The error has a structure that no effect of the catalogue explains entirely. The added effects help, "
        "but their parameters may compensate for the missing effect: do not trust them as physical values. "
        "The description of the residual shows where to look."
    ),
    "remainder": (
        "One family stands out: its effect removes nearly all of the error, and no effect of another family comes "
        "close. The residual still has structure, and no second effect explains it: either the family acts at "
        "your rig in a form that no listed law has, or a second, smaller effect is missing. Look for the family at the "
        "rig; use the fitted parameters as a description within the tested range."
    ),
    "noise": (
        "The residual of the base model is uncorrelated in time, but far larger than the noise. "
        "Look at the noise level of each signal, at the clock of the recorder, and at the order of the samples."
    ),
    "limits": (
        "The noise is as large as any effect could be in these runs, so they cannot test the model. Make faster, "
        "larger or longer tests, or use instruments with less noise."
    ),
}
_CHECKS = {
    "held_out": "",
    "none": "No run was held out: the answer rests on the fitted runs alone.",
    "weak": (
        "The held-out runs agree only within the parameter uncertainty of the fit, so they are a weak check."
    ),
}
_NOISE = {
    "": "what was taken for noise",
    "stated": "the stated noise",
    "assumed": "the noise that was assumed",
    "estimated from the samples": "the noise that was estimated from the samples",
    "stated repeatability": "the stated repeatability",
    "of repeated runs": "the repeatability of repeated runs",
}


def summary(verdict: Verdict) -> str:
    """Kind, families, effects and probability in a line."""
    effects = f": {' and '.join(verdict.families)} ({', '.join(verdict.effects)})"
    probability = f", probability {_percent(verdict.probability)}"
    return f"{verdict.kind}{effects * bool(verdict.families)}{probability * (not isnan(verdict.probability))}"


def verdict_lines(verdict: Verdict) -> list[str]:
    """The summary, the families, the reason, models that nobody expects, and what else may be missing."""
    other = otherwise(verdict)
    return [
        summary(verdict),
        *table_lines(verdict),
        verdict.reason,
        *verdict.implausible,
        *[f"Otherwise: {other}"] * bool(other),
    ]


class FamilyCells(NamedTuple):
    """A row of the table of families, as text."""

    families: str
    probability: str
    worth: str


def family_cells(verdict: Verdict) -> list[FamilyCells]:
    """The families that may be missing, and what is unexplained, if there is any."""
    table = verdict.table
    rows = [
        FamilyCells(" or ".join(row.families), _percent(row.probability), _worth(verdict, row))
        for row in table.rows
    ]
    if rows and table.unexplained >= _SMALL_SHARE:
        rows.append(FamilyCells("unexplained", "", f"{_percent(table.unexplained)} of the error"))
    return rows


def small_effects(verdict: Verdict) -> str:
    """The effects that are measurable, but small; "" where there are none."""
    small = [f"{row.effects[0]} ({_worth(verdict, row)})" for row in verdict.table.small]
    return f"Measurable, but small: {listed(small)}." * bool(small)


def table_lines(verdict: Verdict) -> list[str]:
    """A line for each family that may be missing: its probability, and what it is worth."""
    rows = family_cells(verdict)
    width = max((len(row.families) for row in rows), default=0)
    lines = [f"{r.families.ljust(width)}  {r.probability:>5}  {r.worth}".rstrip() for r in rows]
    return [*lines, *filter(None, [small_effects(verdict)])]


def _worth(verdict: Verdict, row: FamilyRow) -> str:
    """What families are worth in the units of the signals, and of the error; "" where that is not known."""
    if row.share is None:
        return ""
    parts = [
        f"{format_quantity(rms, verdict.units[name])} of {name}"
        for name, rms in row.rms.items()
        if rms > 0 and name in verdict.units
    ]
    return ", ".join([*parts, f"{100 * row.share:.3g} % of the error"])


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def otherwise(verdict: Verdict) -> str:
    """What else may be missing, with probabilities, the most probable first; "" where they are not known."""
    posterior = verdict.posterior
    if isnan(posterior.something_else):
        return ""
    explanations = [e for e in posterior.explanations if not verdict.names(e.families)][
        :_MOST_LISTED
    ]
    texts = [
        f"{' and '.join(e.families) or 'nothing'} {_percent(e.probability)}"
        for e in explanations
        if round(100 * e.probability)
    ]
    other = _UNSEEN if verdict.kind == "none_missing" else "something else"
    return ", ".join([*texts, f"{other} {_percent(posterior.something_else)}"])


def reason(verdict: Verdict) -> str:
    """The verdict in a sentence or two."""
    return " ".join(filter(None, [*_fold_sentences(verdict), *_reasons(verdict)]))


def _reasons(v: Verdict) -> list[str]:
    removed = f"{' + '.join(v.effects)} removes {100 * v.explained:.1f} % of the squared error beyond the noise"
    apart = enumeration(dict.fromkeys(" + ".join(map(words, f)) for f in v.alternatives))
    if v.kind == "none_missing":
        return ["The residual is noise: these data show no missing effect.", _limits(v)]
    if v.kind == "ambiguous":
        return [f"These data cannot separate {apart}."]
    if v.doubt == "noise":
        cause = "the noise level is wrong, or the samples do not belong to their times"
        return [f"The residuals are white, but {_noise_factor(v)}: {cause}."]
    if v.doubt:
        return ["These data cannot show anything.", _limits(v)]
    if v.kind == "unknown" and not v.effects:
        return ["The residual has structure, and no listed effect explains it."]
    if v.kind == "unknown":
        nor = f"These data cannot separate {apart} either, and none of them is the answer."
        return [
            f"{removed}, but the residual has structure: something else is missing.",
            nor * bool(apart),
        ]
    if v.remainder:
        return [
            f"{removed}, and no other family comes close. The residual has structure that no second effect explains: "
            "either the law of the family is not in the catalogue, or a second, smaller effect is missing.",
            *_cautions(v),
        ]
    fitted = f"of {listed(v.units)} " * bool(v.missed)
    return [
        f"{removed}; the residual {fitted}is noise{_noise_excess(v)}.",
        *_exceptions(v),
        *_cautions(v),
    ]


def _noise_excess(v: Verdict) -> str:
    if v.noise_variance <= CRITERIA.residuals.loud:
        return ""
    return f"; it is {_noise_factor(v)}"


def _noise_factor(v: Verdict) -> str:
    return f"{v.noise_variance**0.5:.2g} times {_NOISE[v.noise_source]}"


def _limits(v: Verdict) -> str:
    """The smallest error that would have been found."""
    limits = [
        f"{limit.signal} "
        + (
            "has no more samples than there are parameters"
            if isinf(limit.rmse)
            else f"{format_quantity(limit.rmse, limit.unit)} rms "
            f"(standard deviation of the model {format_quantity(limit.movement, limit.unit)})"
        )
        for limit in v.limits
    ]
    return f"The smallest error that would have been found: {listed(limits)}." * bool(limits)


def _exceptions(v: Verdict) -> list[str]:
    """Signals, runs and laws for which what remains is not noise, or the answer is open."""
    far = listed(f"{error.run} ({_error(error)} of {error.signal})" for error in v.far)
    subject = (
        f"families ({', '.join(v.general)}) are identified: their general forms fit"
        if len(v.general) > 1
        else f"family ({''.join(v.general)}) is identified: its general form fits"
    )
    return [
        *(
            f"{error.signal}, compared but not fitted, is {_error(error)} off "
            f"(noise {format_quantity(error.noise, error.unit)}): "
            f"another effect on {error.signal} is missing, or its instrument is at fault."
            for error in v.missed
        ),
        f"But not in every run: {far} {'are' if len(v.far) > 1 else 'is'} off." * bool(v.far),
        f"Only the {subject} better than any listed law." * bool(v.general),
    ]


def _error(error: SignalError) -> str:
    return format_quantity(error.rmse, error.unit)


def _cautions(v: Verdict) -> list[str]:
    """What keeps an explanation from being beyond doubt."""
    bound = f"Caution: {', '.join(v.at_bound)} ended at a bound; the effect may compensate for another one."
    return [_CHECKS[v.check], bound * bool(v.at_bound)]


def _fold_sentences(v: Verdict) -> list[str]:
    """The use of a model that leaves structure, by what leaving out runs showed."""
    folds = v.folds
    if folds is None:
        return []
    good = "; ".join(_good_to(v, name) for name in folds.rmse if name in v.units)
    counts = {folds.needed[e] for e in folds.named}
    by_count = {n: [e for e in folds.named if folds.needed[e] == n] for n in counts}
    sentences = [
        f"{listed(names)} {'are' if len(names) > 1 else 'is'} needed in "
        f"{'every one' if n == folds.count else n} of {folds.count} folds of runs."
        for n, names in sorted(by_count.items(), reverse=True)
    ]
    dropped = [
        f"{e} ({n} of {folds.count} folds)"
        for e, n in folds.needed.items()
        if e not in folds.named and e not in folds.unbelievable
    ]
    dropped += [f"{e} ({r:.3g} times what is stated)" for e, r in folds.unbelievable.items()]
    return [
        f"Good to {good} on runs that were never fitted." * bool(good),
        *(sentences or [f"No effect is needed in most of {folds.count} folds of runs."]),
        f"Helpful, but not named: {listed(dropped)}." * bool(dropped),
    ]


def _good_to(v: Verdict, name: str) -> str:
    """The error of a signal, and the runs of which it is much larger."""
    assert v.folds is not None
    typical, (most, runs) = v.folds.rmse[name], v.folds.worst[name]
    text = f"{format_quantity(typical, v.units[name])} of {name}"
    if most <= CRITERIA.folds.beyond * typical:
        return text
    first = listed([*runs[:2], *[f"{len(runs) - 2} more"] * (len(runs) > 2)])
    return f"{text} (but {format_quantity(most, v.units[name])} of {first}, when left out)"


def unusual_sentence(parameter: UnusualParameter) -> str:
    """The value that a parameter would need."""
    value, low, high = (
        format_quantity(v, parameter.unit) for v in (parameter.value, parameter.low, parameter.high)
    )
    return (
        f"{' + '.join(parameter.effects)} would fit as well, but {parameter.name} would have to be about {value}; "
        f"the usual range is {low} to {high}."
    )


def kind_name(kind: str) -> str:
    """The kind of a verdict as a short label."""
    return _KIND_NAMES[kind]


def headline(verdict: Verdict, domain: Domain) -> str:
    """The verdict in a sentence."""
    families, folds = enumeration(map(words, verdict.families)), verdict.folds
    if verdict.kind == "none_missing":
        return "These data show no missing effect: the residual is noise."
    if verdict.kind == "identified":
        form = ", in a form that is open" * verdict.remainder
        return f"{_fault(verdict, domain)} ({' + '.join(verdict.effects)}){form}."
    if verdict.kind == "ambiguous":
        return f"An effect is missing, but these data cannot separate {families}."
    if verdict.doubt == "noise":
        return f"The residual is white, but {_noise_factor(verdict)}."
    if verdict.doubt:
        return "These data cannot show anything."
    if not families:
        return "Something is missing, and no effect of the catalogue explains it."
    if folds is not None and folds.rmse:
        good = ", ".join(
            f"{format_quantity(e, verdict.units[n])} of {n}"
            for n, e in folds.rmse.items()
            if n in verdict.units
        )
        return f"With {families} the model is good to {good} on runs that were never fitted; the rest is unknown."
    verb = "explain" if len(verdict.families) > 1 else "explains"
    return f"{families.capitalize()} {verb} a part of the error; the rest is unknown."


def _fault(verdict: Verdict, domain: Domain) -> str:
    """What the model lacks, or which instrument is at fault, or both."""
    faults = domain.faults(verdict.families)
    physics = [words(family) for family in verdict.families if family not in faults]
    parts = [f"the model lacks {enumeration(physics)}"] * bool(physics)
    parts += [f"an instrument is at fault: {enumeration(faults.values())}"] * bool(faults)
    text = ", and ".join(parts)
    return text[0].upper() + text[1:]


def meaning(verdict: Verdict, domain: Domain) -> str:
    """What a verdict says and does not say, in the words of the field."""
    text = _MEANINGS["remainder" if verdict.remainder else verdict.doubt or verdict.kind]
    faults = _faults(verdict, domain)
    if faults:
        text += (
            f" The fault is in an instrument, not in the physics: {faults}. Look at the instrument, its adjustment and "
            "its record before the model; the base model may be complete. A missing effect that acts on this "
            "reading alone would look the same."
        )
    return text.replace("{tested}", domain.tested).replace("{others}", _others(verdict))


def _others(verdict: Verdict) -> str:
    """Which effects of other families fit as well, and why they are not the answer."""
    off = enumeration(verdict.off) or "what was compared but not fitted"
    sentences = [
        f"{enumeration(verdict.refuted)} would fit it as well, but misses {off} by far more."
        * bool(verdict.refuted),
        f"{enumeration(verdict.bending)} fits as well, but only as a general form of its family."
        * bool(verdict.bending),
        *verdict.implausible,
    ]
    return " ".join(filter(None, sentences)) or "No effect of another family comes close."


def _faults(verdict: Verdict, domain: Domain) -> str:
    faults = domain.faults(verdict.families).items()
    return "; ".join(f"{words(family)}: {text}" for family, text in faults)


def instrument_sentence(verdict: Verdict, domain: Domain) -> str:
    """Which of the families named are instruments, and what that says of them; "" where none is."""
    faults = domain.faults(verdict.families)
    among = "Among these an" if len(faults) < len(set(verdict.families)) else "An"
    return f"{among} instrument, not physics: {_faults(verdict, domain)}." * bool(faults)


def probability_sentence(verdict: Verdict) -> str:
    """How sure the verdict is; "" where it does not say."""
    if isnan(verdict.probability):
        return ""
    missing_effects, exclusion = "this is missing", ", and nothing else"
    if verdict.kind == "none_missing":
        missing_effects, exclusion = _NOTHING, ""
    elif verdict.kind == "ambiguous":
        missing_effects = "one of these is missing"
    elif not verdict.families:
        missing_effects, exclusion = "something is missing that is not listed", ""
    uncounted = f" What acts on {enumeration(verdict.off)}, which was not fitted and is off, is not counted."
    off = bool(verdict.off)
    probability = _percent(verdict.probability)
    return f"Probability that {missing_effects}{exclusion * (not off)}: {probability}.{uncounted * off}"


class ProbabilityRow(NamedTuple):
    """A part of the bar of a verdict: what may be missing, how probable that is, and whether the verdict names it."""

    what: str
    probability: float
    named: bool = False


def probability_rows(verdict: Verdict) -> list[ProbabilityRow]:
    """What may be missing, the most probable first; the probabilities sum to one. None where they are not known.

    Improbable sets of families are one row. What no effect describes, or no sample shows, comes last.
    """
    posterior = verdict.posterior
    if isnan(posterior.something_else):
        return []
    rows = [
        ProbabilityRow(
            enumeration(map(words, e.families)) or _NOTHING,
            e.probability,
            verdict.names(e.families),
        )
        for e in posterior.explanations
        if e.probability >= _SMALL_SHARE
    ]
    probability_of_others = 1 - posterior.something_else - sum(row.probability for row in rows)
    rows += [ProbabilityRow("other families that were tried", probability_of_others)] * (
        probability_of_others >= _SMALL_SHARE / 2
    )
    other = _UNSEEN if verdict.kind == "none_missing" else "something no effect describes"
    return [*rows, ProbabilityRow(other, posterior.something_else)]


def error_sentence(base: Fit, final: Fit) -> str:
    """The error before and after, of the signal that gains most (without an added effect: that is worst)."""
    role, before, after = _scores(base, final)
    signals, added = base.comparison.data.signals, final is not base
    names = [n for n in before if n in after and signals[n].fitted and before[n].chi2_reduced >= 0]
    if not names:
        return ""
    name = max(names, key=lambda n: before[n].chi2_reduced - added * after[n].chi2_reduced)
    old, new, noise = (
        format_quantity(value, signals[name].unit)
        for value in (before[name].rmse, after[name].rmse, before[name].noise_rmse)
    )
    verb = "falls" if after[name].rmse < before[name].rmse else "goes"
    return (
        f"On {'runs that were never fitted' if role == 'holdout' else 'the fitted runs'} the rms error of {name} "
        f"{f'{verb} from {old} to {new}' if added else f'is {old}'}; the {signals[name].scatter} is {noise}."
    )


def _scores(base: Fit, final: Fit) -> tuple[str, dict[str, SignalScore], dict[str, SignalScore]]:
    """The role that counts, and the scores of both models on its runs."""
    role = "holdout" if base.comparison.scores["holdout"] else "fit"
    return role, base.comparison.scores[role], final.comparison.scores[role]


def compared_sentence(base: Fit, final: Fit) -> str:
    """The error of the signals that decide only where the others do not; "" where there are none."""
    _, before, after = _scores(base, final)
    parts = []
    for name, signal in base.comparison.data.signals.items():
        if not signal.fitted and name in before and name in after:
            old, new = (format_quantity(s[name].rmse, signal.unit) for s in (before, after))
            change = f"{old} before and {new} after" if final is not base else old
            parts.append(f"{name}, with an rms error of {change}")
    role_of_it = "so that it decides only between explanations that are as good without it"
    return f"Compared but not fitted, {role_of_it}: {enumeration(parts)}." * bool(parts)


def not_tried_sentence(by_reason: Mapping[str, Sequence[str]]) -> str:
    """Families that were not looked for, by reason; "" where there are none."""
    parts = [f"{enumeration(map(words, families))} ({why})" for why, families in by_reason.items()]
    return f"Not looked for, and perhaps missing all the same: {'; '.join(parts)}." * bool(parts)
