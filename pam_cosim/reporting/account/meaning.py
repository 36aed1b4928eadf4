"""What a verdict means, in words for the person who has to act on it."""

from __future__ import annotations

from math import isnan
from typing import NamedTuple

from pam_cosim.diagnosis import Diagnosis, Verdict
from pam_cosim.model.domain import Domain
from pam_cosim.reporting.account.wording import listed, quantity_text, words

_NOTHING = "nothing is missing"
_SMALL_SHARE = 0.01  # what is less probable is one row
_NAMES = {
    "none_missing": "Nothing missing",
    "identified": "Identified",
    "ambiguous": "Ambiguous",
    "unknown": "Unknown",
}
_MEANING = {
    "none_missing": (
        "What the base model leaves looks like noise: it has no course in time that could be followed, and it is no "
        "larger than the noise allows. That does not prove the model complete. It says that these runs, with these "
        "instruments, could not show a further effect. Faster, larger or longer tests might."
    ),
    "identified": (
        "One explanation stands out: the added effects remove the error of what was fitted, and what remains of it is "
        "noise. {rivals} Add the effect to the model, and use the fitted parameters below "
        "within the range of {tested} that was tested."
    ),
    "ambiguous": (
        "An effect is missing, but several families explain these data about equally well. Do not choose one by its "
        "small lead in the ranking: their predictions part elsewhere. The next experiment named below is the "
        "one, among variations of the runs at hand, in which they differ most."
    ),
    "unknown": (
        "The error has a structure that no effect of the catalogue explains entirely. Effects that were added help, "
        "but their parameters may be bent to stand in for what is missing: do not trust them as physical values. "
        "The description of what is left says where to look."
    ),
}
_FORM_OPEN = (
    "One family stands out: its effect removes nearly all of the error, and no effect of another family comes close. "
    "What remains has structure all the same, and no second effect explains it: either the family acts at your rig in "
    "a form that no listed law has, or something smaller is missing besides. Look for the family at the rig; use the "
    "fitted parameters as a description within the tested range."
)
_INSTRUMENT = (
    "This is said of an instrument, not of the physics: {faults}. Look at the instrument, its adjustment and its "
    "record before the model; the base model may be complete. A missing effect that shows in this one reading alone "
    "would look the same."
)


def kind_name(kind: str) -> str:
    """The kind of a verdict as a short label."""
    return _NAMES[kind]


def meaning(verdict: Verdict, domain: Domain) -> str:
    """What a verdict says and does not say, in the words of the field."""
    text = _FORM_OPEN if verdict.remainder else _MEANING[verdict.kind]
    faults = domain.faults(verdict.families)
    if faults:
        text += " " + _INSTRUMENT.replace(
            "{faults}", "; ".join(f"{words(f)}: {said}" for f, said in faults.items())
        )
    return text.replace("{tested}", domain.tested).replace("{rivals}", _rivals(verdict))


def _rivals(verdict: Verdict) -> str:
    """Which effects of other families fit as well, and why they are not the answer."""
    said = []
    if verdict.refuted:
        off = listed(list(verdict.off)) if verdict.off else "what was compared but not fitted"
        said.append(
            f"{listed(list(verdict.refuted))} would fit it as well, but misses {off} by far more."
        )
    if verdict.bending:
        said.append(
            f"{listed(list(verdict.bending))} comes as near, because it says whatever its family can."
        )
    return " ".join([*said, *verdict.implausible]) or "No effect of another family comes close."


def instrument_sentence(verdict: Verdict, domain: Domain) -> str:
    """Which of the families named are instruments, and what that says of them; "" where none is."""
    faults = domain.faults(verdict.families)
    said = "; ".join(f"{words(family)}: {text}" for family, text in faults.items())
    which = (
        "An instrument"
        if len(faults) == len(set(verdict.families))
        else "Among these an instrument"
    )
    return f"{which}, not physics: {said}." if faults else ""


def headline(diagnosis: Diagnosis) -> str:
    """The verdict in a sentence."""
    verdict = diagnosis.verdict
    families = listed([words(f) for f in verdict.families])
    several = len(verdict.families) > 1
    if verdict.kind == "none_missing":
        return "These data show no missing effect: what the model leaves is noise."
    if verdict.kind == "identified":
        form = ", in a form that is open" if verdict.remainder else ""
        return f"{_lacking(diagnosis)} ({' + '.join(verdict.effects)}){form}."
    if verdict.kind == "ambiguous":
        return f"An effect is missing, but these data cannot tell {families} apart."
    if verdict.families and diagnosis.folds is not None and diagnosis.folds.rmse:
        good = ", ".join(
            f"{quantity_text(e, diagnosis.data.signals[n].unit)} of {n}"
            for n, e in diagnosis.folds.rmse.items()
            if diagnosis.data.signals[n].fitted
        )
        return f"With {families} the model is good to {good} on runs that were never fitted; the rest is unknown."
    if verdict.families:
        verb = "explain" if several else "explains"
        return f"{families.capitalize()} {verb} a part of the error; the rest is unknown."
    return "Something is missing, and no effect of the catalogue explains it."


def _lacking(diagnosis: Diagnosis) -> str:
    """What the model lacks, or which instrument is at fault, or both."""
    named = diagnosis.verdict.families
    faults = diagnosis.data.domain.faults(named)
    physics = [words(family) for family in named if family not in faults]
    parts = [f"the model lacks {listed(physics)}"] if physics else []
    parts += [f"an instrument is at fault: {listed(list(faults.values()))}"] if faults else []
    said = ", and ".join(parts)
    return said[0].upper() + said[1:]


def error_sentence(diagnosis: Diagnosis) -> str:
    """The error before and after, of the signal that gains most (without an added effect: that is worst)."""
    role = "holdout" if diagnosis.base.comparison.scores["holdout"] else "fit"
    before, after = (fit.comparison.scores[role] for fit in (diagnosis.base, diagnosis.final))
    signals = diagnosis.data.signals
    names = [n for n in before if n in after and signals[n].fitted and before[n].chi2_reduced >= 0]
    if not names:
        return ""
    final = diagnosis.final is not diagnosis.base
    left = {name: after[name].chi2_reduced if final else 0.0 for name in names}
    name = max(names, key=lambda one: before[one].chi2_reduced - left[one])
    unit = signals[name].unit
    runs = "runs that were never fitted" if role == "holdout" else "the fitted runs"
    noise = f"the {signals[name].scatter} is {quantity_text(before[name].noise_rmse, unit)}"
    if not final:
        return f"On {runs} the rms error of {name} is {quantity_text(before[name].rmse, unit)}; {noise}."
    old, new = before[name].rmse, after[name].rmse
    course = f"{'falls' if new < old else 'goes'} from {quantity_text(old, unit)} to {quantity_text(new, unit)}"
    return f"On {runs} the rms error of {name} {course}; {noise}."


def probability_sentence(verdict: Verdict) -> str:
    """How sure the verdict is; "" where it does not say."""
    p = verdict.probability
    if p != p:
        return ""
    what, rest = _what_is_probable(verdict)
    if verdict.off:
        return (
            f"Probability that {what}: {100 * p:.0f} %. What acts on {listed(list(verdict.off))}, which was "
            "not fitted and is off, is not counted."
        )
    return f"Probability that {what}{rest}: {100 * p:.0f} %."


def _what_is_probable(verdict: Verdict) -> tuple[str, str]:
    """What a verdict says to be so, and what it says beside that."""
    if verdict.kind == "none_missing":
        return _NOTHING, ""
    if verdict.kind == "ambiguous":
        return "one of these is missing", ", and nothing else"
    if not verdict.families:
        return "something is missing that is not listed", ""
    return "this is missing", ", and nothing else"


class ProbabilityRow(NamedTuple):
    """A part of the bar of a verdict: what may be missing, how probable that is, and whether the verdict names it."""

    what: str
    probability: float
    named: bool = False


def probability_rows(verdict: Verdict) -> list[ProbabilityRow]:
    """What may be missing, the most probable first; the probabilities sum to one. None where they are not known.

    Improbable sets of families are one row. What no effect describes, or no sample shows, comes last.
    """
    known = verdict.posterior
    if isnan(known.something_else):
        return []
    large = [one for one in known.explanations if one.probability >= _SMALL_SHARE]
    rows = [
        ProbabilityRow(
            listed([words(f) for f in one.families]) or _NOTHING,
            one.probability,
            verdict.names(one.families),
        )
        for one in large
    ]
    rest = 1 - known.something_else - sum(row.probability for row in rows)
    rows += [ProbabilityRow("other families that were tried", rest)] * (rest >= _SMALL_SHARE / 2)
    unseen = verdict.kind == "none_missing"
    other = "something these data do not show" if unseen else "something no effect describes"
    return [*rows, ProbabilityRow(other, known.something_else)]


def not_tried_sentence(diagnosis: Diagnosis) -> str:
    """Families that were not looked for, with the reason; "" where there are none."""
    by_reason = diagnosis.not_tried_by_reason.items()
    parts = [
        f"{listed([words(family) for family in families])} ({why})" for why, families in by_reason
    ]
    return f"Not looked for, and perhaps missing all the same: {'; '.join(parts)}." if parts else ""


def compared_sentence(diagnosis: Diagnosis) -> str:
    """The error of the signals that decide only where the others do not; "" where there are none."""
    role = "holdout" if diagnosis.base.comparison.scores["holdout"] else "fit"
    before, after = (fit.comparison.scores[role] for fit in (diagnosis.base, diagnosis.final))
    parts = []
    for name, signal in diagnosis.data.signals.items():
        if signal.fitted or name not in before or name not in after:
            continue
        old, new = (quantity_text(s[name].rmse, signal.unit) for s in (before, after))
        parts.append(
            f"{name}, with an rms error of {f'{old} before and {new} after' if diagnosis.path else old}"
        )
    role_of_it = "so that it decides only between explanations that are as good without it"
    return f"Compared but not fitted, {role_of_it}: {listed(parts)}." if parts else ""
