"""Diagnosis -> HTML."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Candidate, Diagnosis, Verdict
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.diagnosis.judgement.verdict_sentences import (
    compared_sentence,
    error_sentence,
    headline,
    kind_name,
    meaning,
    not_tried_sentence,
    probability_rows,
    probability_sentence,
)
from pam_cosim.reporting.account.diagnosis_rows import (
    STATED,
    balance_shares,
    candidate_row,
    missing_rows,
    parameter_rows,
    place_of,
    rule_rows,
    summary_rows,
    was_added,
)
from pam_cosim.reporting.account.learned_part import learned_part
from pam_cosim.reporting.account.next_run import next_run
from pam_cosim.reporting.account.wording import number
from pam_cosim.reporting.figures.bars import (
    CandidateBar,
    balance_picture,
    probability_picture,
    ranking_picture,
    where_picture,
)
from pam_cosim.reporting.figures.curves import curve_pictures
from pam_cosim.reporting.figures.ladder import Rung, ladder_picture
from pam_cosim.reporting.figures.layer import Layer, before_and_after
from pam_cosim.reporting.figures.residual_map import residual_map
from pam_cosim.reporting.figures.residuals import residual_pictures
from pam_cosim.reporting.glossary import glossary_entries
from pam_cosim.reporting.ledger_part import ledger_part
from pam_cosim.reporting.page import provenance, render, score_rows, signal_rows
from pam_cosim.reporting.style import HALO, Picture, balance_colours
from pam_cosim.wording import words

_MOST_BARS = 20
_MOST_ROWS = 12


def diagnosis_report(diagnosis: Diagnosis) -> str:
    """A self-contained HTML page: verdict, evidence, parameters, equations. Same diagnosis, same bytes."""
    signals = list(diagnosis.data.signals.values())
    layers = layers_of(diagnosis)
    fitted = diagnosis.candidates
    rows, further = _candidate_rows(diagnosis)
    acting = [*diagnosis.balance, *(candidate.balance for candidate in fitted)]
    palette = balance_colours(diagnosis.data.domain.balances, acting) | {STATED: HALO}
    balances = balance_shares(diagnosis)
    rules = diagnosis.base.comparison.where
    return render(
        "diagnosis.html",
        title=diagnosis.data.title,
        model=diagnosis.model,
        kind=diagnosis.verdict.kind,
        kind_name=kind_name(diagnosis.verdict.kind),
        headline=headline(diagnosis.verdict, diagnosis.data.domain),
        glossary=glossary_entries(),
        error=error_sentence(diagnosis.base, diagnosis.final),
        compared=compared_sentence(diagnosis.base, diagnosis.final),
        not_tried=not_tried_sentence(diagnosis.not_tried_by_reason),
        starts=diagnosis.data.starts,
        doubts=[doubt.text for doubt in diagnosis.final.comparison.doubts],
        reason=diagnosis.verdict.reason,
        probability=probability_sentence(diagnosis.verdict),
        probabilities=_probability_picture(diagnosis.verdict),
        meaning=meaning(diagnosis.verdict, diagnosis.data.domain),
        summary=summary_rows(diagnosis),
        ladder=ladder_picture(rungs_of(diagnosis), signals),
        curves=curve_pictures(layers),
        residuals=residual_pictures(layers),
        where=where_picture(rules) if rules else None,
        rules=rule_rows(rules),
        ranking=_ranking_picture(diagnosis, fitted, palette),
        very_strong=number(CRITERIA.evidence.very_strong, 2),
        candidates=rows,
        others=further,
        failed=[
            {
                "effect": " + ".join(c.effects),
                "family": words(c.family),
                "reason": c.failure or "no reason was given",
            }
            for c in diagnosis.failed
        ],
        parameters=parameter_rows(diagnosis),
        added=bool(diagnosis.path),
        balance=balance_picture(balances, palette) if any(balances.values()) else None,
        map=residual_map(layers, signals),
        ledger=ledger_part(diagnosis),
        learned=learned_part(diagnosis),
        next_experiment=next_run(diagnosis.next_experiment),
        missing_term=missing_rows(diagnosis),
        signals=signal_rows(diagnosis.data),
        scores=score_rows(diagnosis.final.comparison),
        runs_in_words=[run.describe() for run in diagnosis.data.runs],
        notes=[*_sample_notes(diagnosis), *diagnosis.data.notes()],
        failures=diagnosis.final.failures,
        equations=diagnosis.path[-1].equations if diagnosis.path else "",
        provenance=provenance(diagnosis.data, diagnosis.model),
    )


def _candidate_rows(diagnosis: Diagnosis) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Of the best candidates and those that were added, and of the others."""
    rows: list[dict[str, Any]] = []
    further: list[dict[str, Any]] = []
    for i, candidate in enumerate(diagnosis.candidates):
        is_shown = i < _MOST_ROWS or was_added(diagnosis.path, candidate)
        row = candidate_row(diagnosis.base, candidate, diagnosis.path)
        (rows if is_shown else further).append(row)
    return rows, further


def layers_of(diagnosis: Diagnosis) -> tuple[Layer, ...]:
    """The base model and, where effects were added, the final one."""
    final = diagnosis.final.comparison if diagnosis.path else None
    return before_and_after(diagnosis.base.comparison, final, f"with {_effects(diagnosis)}")


def rungs_of(diagnosis: Diagnosis) -> list[Rung]:
    """The base model, then each effect as it was added."""
    added = [Rung(f"+ {c.effect}", c.fit.comparison.scores) for c in diagnosis.path]
    return [Rung("base model", diagnosis.base.comparison.scores), *added]


def _effects(diagnosis: Diagnosis) -> str:
    return " + ".join(c.effect for c in diagnosis.path)


def _probability_picture(verdict: Verdict) -> Picture | None:
    rows = probability_rows(verdict)
    return probability_picture(rows) if rows else None


def _ranking_picture(
    diagnosis: Diagnosis, fitted: Sequence[Candidate], palette: Mapping[str, str]
) -> Picture | None:
    if not fitted:
        return None
    base, path = diagnosis.base, diagnosis.path
    bars = [
        CandidateBar(
            f"{' + '.join(c.effects)} ({words(c.family)})",
            explained(base, c.fit),
            place_of(c),
            was_added(path, c),
        )
        for c in fitted
    ]
    runs = "holdout" if diagnosis.base.residuals["holdout"].samples else "fitted"
    return ranking_picture(bars[:_MOST_BARS], palette, max(len(bars) - _MOST_BARS, 0), runs)


def _sample_notes(diagnosis: Diagnosis) -> list[str]:
    """What was done about commands between samples and about outliers."""
    steps = [diagnosis.said_of_steps] if diagnosis.step_times else []
    return steps + [
        f"{count} {'sample' if count == 1 else 'samples'} of {name}, far off the neighbours, "
        f"{'was' if count == 1 else 'were'} set aside as {'an outlier' if count == 1 else 'outliers'}"
        for name, count in diagnosis.outliers.items()
        if count
    ]
