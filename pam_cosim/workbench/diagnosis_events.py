"""What a diagnosis tells, as the events that a page shows: the same numbers and words as in the report."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pam_cosim import diagnosis as rooms
from pam_cosim.diagnosis import (
    BaseFitted,
    CandidateTried,
    Diagnosis,
    FailedTrial,
    Judged,
    LedgerKept,
    SearchRestarted,
)
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.fitting import Fit
from pam_cosim.ledger import BalanceEntry, binned
from pam_cosim.ledger import Ledger as KeptLedger
from pam_cosim.measurement import DataSet
from pam_cosim.model.domain import Domain
from pam_cosim.reporting.account import (
    acting_balances,
    against_of,
    balance_shares,
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
    percent,
    place_of,
    probability_rows,
    probability_sentence,
    summary_rows,
    telling_entries,
    unit_text,
    words,
)
from pam_cosim.units import readable_factor
from pam_cosim.workbench.curves import shown_instants
from pam_cosim.workbench.protocol import (
    CandidateEvent,
    Json,
    LedgerEvent,
    PageEvent,
    RankingEvent,
    VerdictEvent,
)

MOST_POINTS = 400  # of a missing term, each run
_AGAINST = 2  # variables that a missing term is drawn over


class Following:
    """Follows a diagnosis: keeps what was tried, and ranks it as it comes.

    Args:
        data: the measurement.
    """

    def __init__(self, data: DataSet) -> None:
        self.data = data
        self.base: Fit | None = None
        self.tried: dict[tuple[str, ...], rooms.Candidate] = {}
        self.failed: list[FailedTrial] = []

    def events(self, event: object) -> list[PageEvent]:
        """What is to be shown of something that happened."""
        if isinstance(event, BaseFitted):
            self.base = event.fit
        elif isinstance(event, SearchRestarted):
            self.tried.clear()
            self.failed.clear()
        elif isinstance(event, CandidateTried):
            return [self._candidate(event), self.ranking()]
        elif isinstance(event, Judged):
            return [
                ranking(event.base, event.candidates, event.path, self.failed, final=True),
                _judged(event, self.data.domain),
            ]
        elif isinstance(event, LedgerKept):
            return [ledger_event(event.ledger, ())]
        return []

    def ranking(self) -> RankingEvent:
        """What was fitted so far, best first."""
        assert self.base is not None
        return ranking(self.base, rank(self.base, list(self.tried.values())), (), self.failed)

    def _candidate(self, event: CandidateTried) -> CandidateEvent:
        c, base = event.attempt, self.base
        common: dict[str, Any] = {
            "effects": c.effects,
            "family": words(c.family),
            "balance": words(place_of(c)),
            "text": str(event),
        }
        if isinstance(c, FailedTrial) or base is None:
            reason = c.failure if isinstance(c, FailedTrial) else ""
            if isinstance(c, FailedTrial):
                self.failed.append(c)
            return CandidateEvent(
                **common,
                explained=None,
                explained_text="",
                delta_bic=None,
                rms={},
                brief=False,
                state="failed",
                reason=reason,
            )
        before = self.tried.get(c.effects)
        if before is None or before.brief or not c.brief:
            self.tried[c.effects] = c
        share = explained(base, c.fit)
        ranked = rank(base, [c])[0]
        return CandidateEvent(
            **common,
            explained=share,
            explained_text=percent(share),
            delta_bic=ranked.delta_bic,
            rms=shown_rms(
                {n: s.rmse for n, s in c.fit.comparison.scores["fit"].items()}, self.data
            ),
            brief=c.brief,
            state="fitted",
            reason="",
        )


def shown_rms(rmse: dict[str, float], data: DataSet) -> dict[str, float]:
    """Root mean square errors in shown units."""
    return {n: value * readable_factor(data.signals[n].unit) for n, value in rmse.items()}


def ranking(
    base: Fit,
    candidates: Sequence[rooms.Candidate],
    path: Sequence[rooms.Candidate],
    failed: Sequence[FailedTrial],
    final: bool = False,
) -> RankingEvent:
    """All models that were fitted, as rows."""
    rows = []
    for place, c in enumerate(candidates):
        numbers = {
            "share": explained(base, c.fit),
            "bic": c.delta_bic,
            "number": place,
            "brief": c.brief,
        }
        rows.append({**candidate_row(base, c, path), "effects": list(c.effects), **numbers})
    reasons = {c.effects: c for c in failed}
    return RankingEvent(
        tuple(rows),
        tuple(
            {"effect": " + ".join(c.effects), "family": words(c.family), "reason": c.failure}
            for c in reasons.values()
        ),
        final,
    )


def _judged(event: Judged, domain: Domain) -> VerdictEvent:
    verdict = event.verdict
    return VerdictEvent(
        kind=verdict.kind,
        kind_name=kind_name(verdict.kind),
        headline="",
        reason=verdict.reason,
        probability=probability_sentence(verdict),
        probabilities=tuple(
            {
                "what": row.what,
                "share": row.probability,
                "percent": percent(row.probability),
                "named": row.named,
            }
            for row in probability_rows(verdict)
        ),
        meaning=meaning(verdict, domain),
        families=tuple(words(f) for f in verdict.families),
        effects=tuple(c.effect for c in event.path),
        instrument=instrument_sentence(verdict, domain),
        equations=event.path[-1].equations if event.path else "",
    )


def verdict_event(d: Diagnosis) -> VerdictEvent:
    """The whole answer."""
    base = Judged(d.verdict, d.base, d.candidates, d.path)
    return replace(
        _judged(base, d.data.domain),
        headline=headline(d.verdict, d.data.domain),
        error=error_sentence(d.base, d.final),
        compared=compared_sentence(d.base, d.final),
        not_tried=not_tried_sentence(d.not_tried_by_reason),
        doubts=tuple(doubt.text for doubt in d.final.comparison.doubts),
        summary=tuple(summary_rows(d)),
        parameters=tuple(parameter_rows(d)),
        next=next_run(d.next_experiment),
        learned=learned_part(d),
        missing=missing_rows(d),
        balance={words(name): share for name, share in balance_shares(d).items()},
        complete=True,
    )


def diagnosis_events(d: Diagnosis) -> list[PageEvent]:
    """All that there is to be shown of a finished diagnosis."""
    events: list[PageEvent] = [
        ranking(d.base, d.candidates, d.path, d.failed, final=True),
        verdict_event(d),
    ]
    if d.ledger is not None:
        events.append(ledger_event(d.ledger, acting_balances(d.path)))
    return events


def ledger_event(ledger: KeptLedger, added: Sequence[str]) -> LedgerEvent:
    """Which balance fails; ``added``: balances of the effects that were added."""
    said = ledger_words(ledger, added)
    return LedgerEvent(
        said["sentence"],
        tuple(said["rows"]),
        tuple(said["meanings"]),
        tuple(said["readings"]),
        tuple(said["notes"]),
        tuple(_courses(e, ledger.domain) for e in telling_entries(ledger)),
    )


def _courses(entry: BalanceEntry, domain: Domain) -> Json:
    factor = readable_factor(entry.unit)
    runs = []
    for c in entry.courses:
        kept = slice(None, None, math.ceil(len(c.time) / MOST_POINTS))
        value, reach = c.value[kept] * factor, 2 * c.deviation[kept] * factor
        runs.append(
            {
                "run": c.run,
                "time": shown_instants(c.time[kept]),
                "term": _list(value),
                "low": _list(value - reach),
                "high": _list(value + reach),
            }
        )
    against = [_against(entry, name, factor) for name in against_of(entry, domain)[:_AGAINST]]
    return {
        "balance": words(entry.balance),
        "unit": unit_text(entry.unit),
        "runs": runs,
        "against": against,
    }


def _against(entry: BalanceEntry, name: str, factor: float) -> Json:
    across = readable_factor(entry.units.get(name, ""))
    x = np.concatenate([c.against[name] for c in entry.courses]) * across
    y = np.concatenate([c.value for c in entry.courses]) * factor
    kept = slice(None, None, math.ceil(len(x) / (2 * MOST_POINTS)))
    bands = binned(entry, name)
    return {
        "name": name,
        "unit": unit_text(entry.units.get(name, "")),
        "points": [_list(x[kept]), _list(y[kept])],
        "at": [(b.low + b.high) / 2 * across for b in bands],
        "mean": [b.mean * factor for b in bands],
        "low": [(b.mean - 2 * b.deviation) * factor for b in bands],
        "high": [(b.mean + 2 * b.deviation) * factor for b in bands],
    }


def _list(values: Any) -> list[float]:
    return [float(f"{v:.5g}") for v in values]
