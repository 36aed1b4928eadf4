"""A diagnosis in plain text, for a terminal."""

from __future__ import annotations

from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.judgement.verdict_sentences import instrument_sentence
from pam_cosim.reporting.account.ledger_words import ledger_line
from pam_cosim.reporting.account.next_run import next_run_line
from pam_cosim.reporting.account.wording import number, percent

_MOST_RULES = 3


def diagnosis_text(diagnosis: Diagnosis) -> str:
    """The verdict, its steps, where the base model is wrong, its ledger and what to do next."""
    parts = [str(diagnosis)]
    fault = instrument_sentence(diagnosis.verdict, diagnosis.data.domain)
    if fault:
        parts.append(f"  {fault}")
    parts += [f"  note: {note}" for note in diagnosis.data.steps()]
    if diagnosis.path:
        parts.append(f"  Step by step: {_way(diagnosis)}")
    rules = (
        diagnosis.base.comparison.where[:_MOST_RULES]
        if diagnosis.verdict.kind != "none_missing"
        else ()
    )
    parts += [
        f"  Where the base model is wrong: {r.signal}, {r.rule}: {percent(r.error_share)} of its error in "
        f"{percent(r.time_share)} of the samples"
        for r in rules
    ]
    if diagnosis.ledger is not None:
        parts.append(f"  Ledger of the base model: {ledger_line(diagnosis.ledger)}")
        parts += [f"    note: {n}" for n in diagnosis.ledger.notes]
    if diagnosis.next_experiment is not None:
        parts.append(f"  Next experiment: {next_run_line(diagnosis.next_experiment)}")
    return "\n".join(parts).replace("\u00a0", " ")


def _way(diagnosis: Diagnosis) -> str:
    role = "holdout" if diagnosis.base.comparison.scores["holdout"] else "fit"
    steps = [f"base model {number(diagnosis.base.comparison.chi2_reduced(role))}"]
    for c in diagnosis.path:
        steps.append(f"+ {c.effect} {number(c.fit.comparison.chi2_reduced(role))}")
    return f"{' → '.join(steps)} (reduced chi-square, {role} runs)"
