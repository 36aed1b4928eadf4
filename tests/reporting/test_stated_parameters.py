"""A stated value that is wrong is in no balance: a length of a muscle is not called a sensor."""

from __future__ import annotations

import pytest

from pam_cosim.fitting import Estimate
from pam_cosim.model.domain import WRONG_PARAMETER
from pam_cosim.reporting import diagnosis_report
from pam_cosim.reporting.account.diagnosis_rows import STATED, balance_shares, candidate_row
from pam_cosim.workbench.diagnosis_events import diagnosis_events
from tests.reporting.synthetic import make_candidate, make_data, make_diagnosis

RATIO = "muscle.L0/stated"


def test_it_has_a_name_of_its_own(without_pictures: pytest.MonkeyPatch) -> None:
    data = make_data()
    own = {RATIO: Estimate(1.1, 1.0, 1.2, "1")}
    wrong = make_candidate(data, RATIO, WRONG_PARAMETER, "sensor", 0.5, own)
    leak = make_candidate(data, "SmallHole", "leak", "mass", 8.0)
    balance = {"sensor": 0.8, "mass": 0.2}
    made = make_diagnosis(
        "identified", data, candidates=(wrong, leak), path=(wrong,), balance=balance
    )
    rows = [candidate_row(made.base, c, ()) for c in (wrong, leak)]
    assert [row["balance"] for row in rows] == ["stated parameter", "mass"]
    assert [row["place"] for row in rows] == ["stated parameter", "mass balance"]
    assert balance_shares(made) == {STATED: 0.8, "mass": 0.2}
    assert "<td>sensor</td>" not in diagnosis_report(made)
    ranking, _ = diagnosis_events(made)
    assert [row["place"] for row in ranking["candidates"]] == ["stated parameter", "mass balance"]
