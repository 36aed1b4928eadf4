"""What an unknown error was described by: a formula, how good it is, and that it is no cause."""

from __future__ import annotations

from typing import Any

from pam_cosim.diagnosis import Diagnosis
from pam_cosim.reporting.account.diagnosis_rows import error_rows, estimate_rows
from pam_cosim.reporting.account.wording import percent
from pam_cosim.wording import enumeration

CAUTION = (
    "This is a description, not a cause: another formula may describe the same measurement as well, and beyond the "
    "measured range of states it is meaningless. Use it to interpolate, and as a hint at the missing effect: "
    "in which balance, with which variable, of which sign and size."
)


def learned_part(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """What the section on the learned term shows; None without one."""
    if diagnosis.learned is None:
        return None
    term, candidate = diagnosis.learned.term, diagnosis.learned.model
    return {
        "formula": term.formula,
        "beside": enumeration(candidate.effects[:-1]),
        "balance": term.balance,
        "score": percent(term.score),
        "fit_score": percent(term.fit_score),
        "caution": CAUTION,
        "rows": error_rows(diagnosis.final, candidate.fit),
        "parameters": list(estimate_rows(candidate.parameters).values()),
        "source": term.modelica_source,
        "name": term.name,
    }
