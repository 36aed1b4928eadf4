"""What happens in a diagnosis as the events that a page shows: the same numbers and words as in the report."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pam_cosim.diagnosis import (
    Candidate,
    CandidateTried,
    Diagnosis,
    FailedTrial,
    Judged,
    LedgerKept,
)
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.diagnosis.judgement.verdict_sentences import family_cells, small_effects
from pam_cosim.fitting import Fit
from pam_cosim.ledger import BalanceEntry, Ledger, binned
from pam_cosim.model.domain import Domain
from pam_cosim.reporting.account import (
    against_of,
    candidate_row,
    compared_sentence,
    error_sentence,
    headline,
    instrument_sentence,
    kind_name,
    learned_part,
    ledger_words,
    meaning,
    missing_rows,
    next_run,
    not_tried_sentence,
    parameter_rows,
    probability_rows,
    probability_sentence,
    summary_rows,
    telling_entries,
    unit_text,
    words,
)
from pam_cosim.reporting.live import Tried
from pam_cosim.units import readable_factor
from pam_cosim.workbench.protocol import Json, event, selected
from pam_cosim.workbench.state import label_of
from pam_cosim.workbench.state_events import rung_of

MOST_POINTS = 800  # of a missing term over a variable
_AGAINST = 2  # variables that a missing term is drawn over


def events_of(happening: object, tried: Tried, domain: Domain) -> list[Json]:
    """The events of what a diagnosis reports; the models that were ``tried`` are ranked as they come."""
    tried.take(happening)
    if isinstance(happening, LedgerKept):
        return [ledger_event(happening.ledger)]
    if tried.base is None or not isinstance(happening, CandidateTried | Judged):
        return []
    final = isinstance(happening, Judged)
    ranked = ranking(tried.base, tried.ranked(), tried.path, tried.failed, final)
    if isinstance(happening, Judged):
        return [ranked, _judged(happening, domain)]
    return [event("candidate", effects=happening.attempt.effects), ranked]


def ranking(
    base: Fit,
    candidates: Sequence[Candidate],
    path: Sequence[Candidate],
    failed: Sequence[FailedTrial],
    final: bool = False,
) -> Json:
    """The event of all models that were fitted, as rows."""
    rows = [
        candidate_row(base, c, path)
        | selected(c, "effects brief probability", share=explained(base, c.fit))
        for c in candidates
    ]
    reasons = [
        selected(c, "reason=failure", effect=" + ".join(c.effects), family=words(c.family))
        for c in failed
    ]
    return event("ranking", candidates=rows, failed=reasons, final=final)


def _judged(judged: Judged, domain: Domain, **more: object) -> Json:
    verdict = judged.verdict
    return event(
        "verdict",
        **selected(verdict, "kind reason"),
        kind_name=kind_name(verdict.kind),
        probability=probability_sentence(verdict),
        probabilities=[row._asdict() for row in probability_rows(verdict)],
        table=[row._asdict() | {"families": words(row.families)} for row in family_cells(verdict)],
        small=small_effects(verdict),
        meaning=meaning(verdict, domain),
        families=[words(f) for f in verdict.families],
        effects=[c.effect for c in judged.path],
        instrument=instrument_sentence(verdict, domain),
        complete=bool(more),
        **more,
    )


def diagnosis_events(d: Diagnosis) -> list[Json]:
    """The events of a finished diagnosis."""
    verdict = _judged(
        Judged(d.verdict, d.base, d.candidates, d.path),
        d.data.domain,
        headline=headline(d.verdict, d.data.domain),
        error=error_sentence(d.base, d.final),
        compared=compared_sentence(d.base, d.final),
        disagreement=d.disagreement,
        not_tried=not_tried_sentence(d.not_tried_by_reason),
        doubts=[doubt.text for doubt in d.final.comparison.doubts],
        summary=summary_rows(d),
        parameters=parameter_rows(d),
        next=next_run(d.next_experiment),
        learned=learned_part(d),
        missing=missing_rows(d),
        found=rung_of(found_label(d), d.final.comparison) if d.path else None,
    )
    events = [ranking(d.base, d.candidates, d.path, d.failed, True), verdict]
    if d.ledger is not None:
        events.append(ledger_event(d.ledger))
    return events


def found_label(d: Diagnosis) -> str:
    """What the model that a diagnosis found is called on the ladder."""
    return f"found: {label_of(d.path[-1].effects)}"


def ledger_event(ledger: Ledger) -> Json:
    """The event of which balance fails."""
    courses = [_course(e, ledger.domain) for e in telling_entries(ledger)]
    return event("ledger", **ledger_words(ledger), courses=courses)


def _course(entry: BalanceEntry, domain: Domain) -> Json:
    names = against_of(entry, domain)[:_AGAINST]
    return {
        "balance": words(entry.balance),
        "unit": unit_text(entry.unit),
        "against": [_against(entry, name) for name in names],
    }


def _against(entry: BalanceEntry, name: str) -> Json:
    unit = entry.units.get(name, "")
    across, factor = readable_factor(unit), readable_factor(entry.unit)
    x = np.concatenate([c.against[name] for c in entry.courses]) * across
    y = np.concatenate([c.value for c in entry.courses]) * factor
    drawn_rows = slice(None, None, math.ceil(len(x) / MOST_POINTS))
    bands = binned(entry, name)
    mean, reach = (np.array([getattr(b, of) for b in bands]) for of in ("mean", "deviation"))
    return {
        "name": name,
        "unit": unit_text(unit),
        "points": [x[drawn_rows], y[drawn_rows]],
        "at": [(b.low + b.high) / 2 * across for b in bands],
        "mean": mean * factor,
        "low": (mean - 2 * reach) * factor,
        "high": (mean + 2 * reach) * factor,
    }
