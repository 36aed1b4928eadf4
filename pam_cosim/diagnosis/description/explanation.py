"""The explanation of data that no effect explains: the ledger, and a learned formula for the missing term."""

from __future__ import annotations

import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from pam_cosim.diagnosis.description.learning import LearnedTerm, learn, refitted, try_learned
from pam_cosim.diagnosis.description.learning_direct import (
    RESIDUALS,
    learn_directly,
    with_coefficients,
)
from pam_cosim.diagnosis.judgement.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit
from pam_cosim.ledger import Ledger, keep_ledger

_FACTORS = (1.0, 0.1)  # on the spline of first order; a model may break down with all of it


@dataclass(frozen=True)
class LearnedModel:
    """A formula for a missing term, and the model with it, refitted: a description, no cause."""

    json_keys = "*term model"

    term: LearnedTerm
    model: Candidate


def ledger_of(search: Search, effects: Sequence[str], present: Fit) -> Ledger | None:
    """The ledger of the model with these effects; None where it has no balances to open."""
    try:
        values = present.values_and_starts
        return keep_ledger(
            search.data, values, search.model, effects=effects, files=search.files, tree=search.tree
        )
    except (
        InputError,
        ArithmeticError,
        ValueError,
    ) as problem:  # numpy reports a singular system as a ValueError
        search.say(Remark(f"no ledger could be kept: {problem}").message)
        return None


def learned_term(
    search: Search, ledger: Ledger | None, effects: Sequence[str], present: Fit
) -> LearnedModel | None:
    """A formula for the missing term, and the model with it refitted; None where there is no term to describe."""
    if ledger is None:
        return None
    try:
        term = learn(ledger, search.tree)
        if not term.terms:
            why = f"nothing explains the {term.balance} term"
            search.say(Remark(f"no formula could be found for what is missing: {why}").message)
            return None
        attempt = _fitted(search, term, effects, present)
    except (InputError, ArithmeticError, ValueError) as problem:
        search.say(Remark(f"no formula could be found for what is missing: {problem}").message)
        return None
    if isinstance(attempt, FailedTrial):
        why = (
            f"the model with the formula for what is missing could not be fitted: {attempt.failure}"
        )
        search.say(Remark(why).message)
        return None
    entry = ledger.entry(term.balance)
    assert entry is not None, "the term was learned from it"
    term = refitted(term, entry, attempt, search.tree)
    search.say(Remark(f"described, not explained: {term}").message)
    return LearnedModel(term, rank(present, [attempt])[0])


def directly_learned(search: Search, effects: Sequence[str], present: Fit) -> LearnedModel | None:
    """The same from sensitivities of the samples to a term, without a ledger; None where it reduces nothing."""
    direct = learn_directly(search, effects, present)
    if direct is None:
        return None
    for part in _FACTORS:
        term = with_coefficients(direct, search.tree, part)
        attempt = _fitted(search, term, effects, present)
        if isinstance(attempt, FailedTrial):
            continue
        best = rank(present, [attempt])[0]
        if best.delta_bic < 0:
            term = refitted(term, direct.entry, attempt, search.tree, RESIDUALS)
            search.say(Remark(f"described, not explained: {term}").message)
            return LearnedModel(term, best)
    return None


def _fitted(
    search: Search, term: LearnedTerm, effects: Sequence[str], present: Fit
) -> Candidate | FailedTrial:
    """The model with effects and a learned term, fitted from the present values."""
    with tempfile.TemporaryDirectory(prefix="pam-cosim-") as folder:
        return try_learned(
            term,
            search.data,
            Path(folder),
            search.model,
            effects=effects,
            start=present.values,
            files=search.files,
        )
