"""The explanation of data that no effect explains: the ledger, and a learned formula for the missing term."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.description.learning import LearnedTerm, learn, try_learned
from pam_cosim.diagnosis.judgement.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit, FitOptions
from pam_cosim.ledger import Ledger, keep_ledger
from pam_cosim.wording import enumeration, words

INSTRUMENT = "sensor"
"""The balance of effects that act in none: on an instrument, or on a value that a data set states."""

_PARTS = (1.0, 0.1)  # on the spline of first order; a model may break down with all of it
_PART = 0.1  # of the simulations of the search, which a formula may take at most


@dataclass(frozen=True)
class LearnedModel:
    """A formula for a missing term, and the model with it, refitted: a description, no cause."""

    json_keys = "*term model"

    term: LearnedTerm
    model: Candidate


def ledger_of(search: Search, present: Fit) -> Ledger | None:
    """The ledger of the base model; None where it has no balances to open, or the search's time is over."""
    try:
        return keep_ledger(
            search.data,
            present.values_and_starts,
            search.model,
            files=search.files,
            tree=search.tree,
            deadline=search.effort.deadline,
        )
    except (
        InputError,
        ArithmeticError,
        TimeoutError,
        ValueError,
    ) as problem:  # numpy reports a singular system as a ValueError
        search.say(Remark(f"no ledger could be kept: {problem}").message)
        return None


def described(
    search: Search, ledger: Ledger | None, base: Fit, effects: Sequence[str], present: Fit
) -> LearnedModel | None:
    """The model with a learned formula, in addition to effects or alone: the one with the smaller residual.

    Effects that leave structure may stand in for what is missing, and then hide how it changes: the formula is looked
    for alone too, unless the effects leave too little for that to be better. It is looked for where the ledger fails,
    if there is one, and takes at most a part of the effort of the search. None: none leaves less than the effects.

    Args:
        search: whose effort it is a part of.
        ledger: of the base model.
        base: the fit of the base model. effects: that were added to it. present: the fit of the model with these.
    """
    effort, balances = search.effort.part(_PART), suspected(ledger) if ledger else ()
    starts = [(effects, present)]
    if effects and explained(base, present) < 1 - CRITERIA.evidence.least_share:
        starts.append(((), base))
    learned = filter(None, (_learned(search, balances, *start, effort) for start in starts))
    best = min(learned, key=lambda d: remaining_chi2(d.model.fit), default=None)
    return best if best and remaining_chi2(best.model.fit) < remaining_chi2(present) else None


def suspected(ledger: Ledger) -> tuple[str, ...]:
    """The balances that fail, and those that the samples do not tell from them."""
    notes = {hidden for _, hidden, words in ledger.domain.confused if words in ledger.notes}
    return (*ledger.failing, *(notes - {*ledger.failing}))


def _learned(
    search: Search, balances: Sequence[str], effects: Sequence[str], present: Fit, effort: Effort
) -> LearnedModel | None:
    """A formula for what a model leaves, and the model with it; None where none reduces it."""
    description = learn(search, balances, effects, present, effort)
    if description is None:
        return None
    for part in _PARTS:
        if effort.spent:
            break
        term = description.with_part(part).term(search.tree)
        with effort.counting():
            attempt = try_learned(term, search, effects, present, effort.bounded(FitOptions()))
        if isinstance(attempt, FailedTrial):
            continue
        best = rank(present, [attempt])[0]
        if best.delta_bic < 0:
            term = description.with_values_of(attempt).term(search.tree)
            search.say(Remark(f"described, not explained: {term}").message)
            return LearnedModel(term, best)
    return None


def remaining_chi2(fit: Fit) -> float:
    """Reduced chi-square of a model in runs that were held out, if there are any."""
    return fit.residuals["holdout" if fit.residuals["holdout"].samples else "fit"].chi2_reduced


def disagreement(path: Sequence[Candidate], ledger: Ledger | None) -> str:
    """A sentence where effects act in none of the balances that a ledger says fail; "" where there are none such.

    An instrument and a stated value are in no balance of a ledger.
    """
    if ledger is None or not ledger.failing:
        return ""
    entries = [entry for entry in ledger.entries if entry.balance in ledger.failing]
    failing_balances = {
        *ledger.failing,
        *(equivalent for entry in entries for equivalent in entry.same_as),
    }
    elsewhere = [c for c in path if c.balance not in failing_balances]
    if not elsewhere:
        return ""
    failing = f"the {enumeration(map(words, ledger.failing))} balance{'s' * (len(entries) > 1)}"
    effects = enumeration(c.effect for c in elsewhere)
    if all(c.balance == INSTRUMENT for c in elsewhere):
        return f"The ledger has no instruments and no stated values: it enters what {effects} explains under {failing}."
    acting = enumeration(words(b) for b in dict.fromkeys(c.balance for c in elsewhere))
    return (
        f"The ledger disagrees: a free term in {failing} explains the same samples as {effects}, of the {acting} "
        "balance, which is a law with fewer numbers."
    )
