"""Diagnosis -> HTML."""

from __future__ import annotations

from itertools import compress
from operator import not_

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.diagnosis.judgement.verdict_sentences import (
    compared_sentence,
    error_sentence,
    family_cells,
    headline,
    kind_name,
    meaning,
    not_tried_sentence,
    probability_rows,
    probability_sentence,
    small_effects,
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
from pam_cosim.reporting.style import HALO, balance_colours

_MOST_BARS = 20
_MOST_ROWS = 12


def diagnosis_report(diagnosis: Diagnosis) -> str:
    """A self-contained HTML page: verdict, evidence, parameters, equations. Same diagnosis, same bytes."""
    d, verdict, domain = diagnosis, diagnosis.verdict, diagnosis.data.domain
    signals, layers = list(d.data.signals.values()), layers_of(d)
    acting = [*d.balance, *(candidate.balance for candidate in d.candidates)]
    palette = balance_colours(domain.balances, acting) | {STATED: HALO}
    balances, rules = balance_shares(d), d.base.comparison.where
    rows = [candidate_row(d.base, c, d.path) for c in d.candidates]
    is_shown = [row["added"] or i < _MOST_ROWS for i, row in enumerate(rows)]
    bars = [
        CandidateBar(
            f"{row['effect']} ({row['family']})",
            explained(d.base, c.fit),
            place_of(c),
            row["added"],
        )
        for row, c in zip(rows[:_MOST_BARS], d.candidates, strict=False)
    ]
    probabilities = probability_rows(verdict)
    return render(
        "diagnosis.html",
        d=d,
        title=d.data.title,
        kind_name=kind_name(verdict.kind),
        headline=headline(verdict, domain),
        glossary=glossary_entries(),
        error=error_sentence(d.base, d.final),
        compared=compared_sentence(d.base, d.final),
        not_tried=not_tried_sentence(d.not_tried_by_reason),
        probability=probability_sentence(verdict),
        probabilities=probability_picture(probabilities) if probabilities else None,
        families=family_cells(verdict),
        small=small_effects(verdict),
        meaning=meaning(verdict, domain),
        summary=summary_rows(d),
        ladder=ladder_picture(rungs_of(d), signals),
        curves=curve_pictures(layers),
        residuals=residual_pictures(layers),
        where=where_picture(rules) if rules else None,
        rules=rule_rows(rules),
        ranking=ranking_picture(
            bars,
            palette,
            max(len(rows) - _MOST_BARS, 0),
            "holdout" if d.base.residuals["holdout"].samples else "fitted",
        )
        if bars
        else None,
        very_strong=number(CRITERIA.evidence.very_strong, 2),
        candidates=list(compress(rows, is_shown)),
        others=list(compress(rows, map(not_, is_shown))),
        parameters=parameter_rows(d),
        added=bool(d.path),
        balance=balance_picture(balances, palette) if any(balances.values()) else None,
        map=residual_map(layers, signals),
        ledger=ledger_part(d),
        learned=learned_part(d),
        next_experiment=next_run(d.next_experiment),
        missing_term=missing_rows(d),
        signals=signal_rows(d.data),
        scores=score_rows(d.final.comparison),
        runs_in_words=[run.describe() for run in d.data.runs],
        notes=[*d.changes_of_data, *d.data.notes()],
        provenance=provenance(d.data, d.model),
    )


def layers_of(diagnosis: Diagnosis) -> tuple[Layer, ...]:
    """The base model and, where effects were added, the final one."""
    final = diagnosis.final.comparison if diagnosis.path else None
    return before_and_after(
        diagnosis.base.comparison, final, "with " + " + ".join(c.effect for c in diagnosis.path)
    )


def rungs_of(diagnosis: Diagnosis) -> list[Rung]:
    """The base model, then each effect as it was added."""
    added = [Rung(f"+ {c.effect}", c.fit.comparison.scores) for c in diagnosis.path]
    return [Rung("base model", diagnosis.base.comparison.scores), *added]
