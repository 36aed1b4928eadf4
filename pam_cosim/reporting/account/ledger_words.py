"""The ledger in words: which balance fails, by how much, and what must be known to read it."""

from __future__ import annotations

from typing import Any

from pam_cosim.ledger import BalanceEntry, Ledger
from pam_cosim.model.domain import Domain
from pam_cosim.reporting.account.wording import NOTHING, number, percent, quantity_text
from pam_cosim.wording import enumeration, words

_SHOWN = 0.005  # share that is worth a word


def ledger_words(ledger: Ledger) -> dict[str, Any]:
    """Sentences about a ledger next to its picture."""
    return {
        "sentence": ledger_sentence(ledger),
        "rows": [_row(e) for e in ledger.entries],
        "meanings": [_sign(e) for e in ledger.entries if e.meaning],
        "notes": [*ledger.notes],
    }


def ledger_sentence(ledger: Ledger) -> str:
    """Which balances fail, and whether that is all."""
    if not ledger.failing:
        return (
            "No balance is significantly violated: a free time-varying term in any balance does not improve the "
            "likelihood enough."
        )
    names = [f"the {words(balance)} balance" for balance in ledger.failing]
    errors = f"mean square error {number(ledger.before)} → {number(ledger.after)} noise variances"
    remainder = (
        "With what is missing there the model meets the samples to the noise"
        if ledger.closed
        else "What is missing there does not bring the model to the noise: something is missing elsewhere too"
    )
    return f"The base model fails in {enumeration(names)}. {remainder} ({errors})."


def ledger_line(ledger: Ledger) -> str:
    """The ledger in one line of plain text."""
    if not ledger.failing:
        return "no balance is significantly violated"
    large = [entry for entry in ledger.entries if entry.share >= _SHOWN]
    shares = ", ".join(f"the {words(part.balance)} balance {percent(part.share)}" for part in large)
    remainder = "" if ledger.closed else "; something is missing elsewhere too"
    return f"share of the error in {shares}{remainder}"


def _row(entry: BalanceEntry) -> dict[str, str]:
    equivalents = (
        f"the balance of {enumeration([words(b) for b in entry.same_as])} may be meant as well"
        if entry.same_as
        else ""
    )
    has_size = bool(entry.courses)
    return {
        "balance": words(entry.balance),
        "share": percent(entry.share),
        "explains": percent(entry.explains),
        "size": quantity_text(entry.size, entry.unit) if has_size else NOTHING,
        "outside": percent(entry.outside) if has_size else NOTHING,
        "note": equivalents,
    }


def _sign(entry: BalanceEntry) -> str:
    return f"{words(entry.balance).capitalize()}: {entry.meaning[:1].lower()}{entry.meaning[1:]}"


def telling_entries(ledger: Ledger) -> list[BalanceEntry]:
    """Entries with a term over time and a share of the error; all with a term if none has a share."""
    drawn = [e for e in ledger.entries if e.courses]
    return [e for e in drawn if e.balance in ledger.failing or e.share >= _SHOWN] or drawn


def against_of(entry: BalanceEntry, domain: Domain) -> list[str]:
    """What a term can be drawn against, the telling ones first."""
    names = list(entry.courses[0].against)
    return [n for n in domain.axes if n in names] + [n for n in names if n not in domain.axes]
