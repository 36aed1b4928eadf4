"""What an unknown error was described by: a formula, how good it is, and that it is no cause."""

from __future__ import annotations

from typing import Any

from pam_cosim.diagnosis import Candidate, Diagnosis
from pam_cosim.measurement import ROLES
from pam_cosim.reporting.account.wording import (
    NOTHING,
    estimate_texts,
    number,
    percent,
    quantity_text,
    remark,
    unit_text,
)
from pam_cosim.wording import enumeration

CAUTION = (
    "This is a description, not a cause: another formula may describe the same measurement as well, and beyond the "
    "range of states that was measured it means nothing. Use it to interpolate, and as a hint at what to look for: "
    "in which balance, with which variable, of which sign and size."
)


def learned_part(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """What the section on the learned term shows; None without one."""
    if diagnosis.learned is None:
        return None
    term, candidate = diagnosis.learned.term, diagnosis.learned.model
    parameters = []
    for name, estimate in candidate.parameters.items():
        value, interval = estimate_texts(estimate)
        parameters.append(
            {
                "name": name,
                "value": value,
                "interval": interval,
                "unit": unit_text(estimate.unit),
                "remark": remark(estimate),
            }
        )
    return {
        "formula": term.formula,
        "beside": enumeration(candidate.effects[:-1]),
        "balance": term.balance,
        "score": percent(term.score),
        "fit_score": percent(term.fit_score),
        "caution": CAUTION,
        "rows": _rows(diagnosis, candidate),
        "parameters": parameters,
        "source": term.modelica_source,
        "name": term.name,
    }


def _rows(diagnosis: Diagnosis, candidate: Candidate) -> list[dict[str, str]]:
    learned = candidate.fit.comparison.scores
    rows = []
    for role in ROLES:
        for name, before in diagnosis.final.comparison.scores[role].items():
            after, signal = learned[role].get(name), diagnosis.data.signals[name]
            rows.append(
                {
                    "role": role,
                    "name": name if signal.fitted else f"{name} (not fitted)",
                    "before": quantity_text(before.rmse, signal.unit),
                    "after": NOTHING if after is None else quantity_text(after.rmse, signal.unit),
                    "noise": quantity_text(before.noise_rmse, signal.unit),
                    "chi2_before": number(before.chi2_reduced),
                    "chi2_after": NOTHING if after is None else number(after.chi2_reduced),
                }
            )
    return rows
