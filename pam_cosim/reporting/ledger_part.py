"""The ledger in a report: its picture and its words."""

from __future__ import annotations

from typing import Any

from pam_cosim.diagnosis import Diagnosis
from pam_cosim.ledger import Ledger
from pam_cosim.reporting.account.ledger_words import ledger_words
from pam_cosim.reporting.figures.ledger import ledger_figure
from pam_cosim.reporting.style import Picture, drawing, picture


def ledger_part(diagnosis: Diagnosis) -> dict[str, Any] | None:
    """What the section "Which balance fails" shows; None without a ledger."""
    ledger = diagnosis.ledger
    if ledger is None:
        return None
    return {
        "picture": _picture(ledger),
        **ledger_words(ledger),
    }


def _picture(ledger: Ledger) -> Picture:
    with drawing():
        return picture(
            ledger_figure(ledger),
            "Share of each balance in the error, and the missing term of each balance over time and against its "
            "variables",
            "Above: what would be lost without each balance in the best explanation. Below, a row for each balance: "
            "the term that is missing in it, as the samples ask for it, in time with two standard deviations; the same "
            "against the variables it may depend on (dots: instants, line: means with two standard deviations); and "
            "over a plane, in standard deviations. A flat line at zero: nothing is missing there.",
        )
