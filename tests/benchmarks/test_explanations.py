"""The score of an explanation: what counts as the right balance and the right variables."""

from __future__ import annotations

import pytest

from benchmarks.explanations.cases import CASES, Truth
from benchmarks.explanations.one import _named, _names
from benchmarks.explanations.table import table
from blind_cases.cases import case_of, outline


def test_variables_are_read_off_a_formula() -> None:
    text = "missing force = 2 N x p_gauge, where x stands for x/(40 mm); p_gauge stands for p_gauge/(1 bar)"
    assert _names(text) == ["x", "p_gauge"]


@pytest.mark.parametrize(
    ("law", "names", "right"),
    [
        ({"x"}, {"eps", "v"}, True),
        ({"x", "p_gauge"}, {"x"}, False),
        ({"v"}, {"x"}, False),
        (set(), {"x"}, None),
    ],
)
def test_a_formula_is_right_with_all_variables_of_the_law(
    law: set[str], names: set[str], right: bool | None
) -> None:
    assert _named(Truth("tuning3", 0, "force", frozenset(law)), names) is right


def test_sums_count_balances_formulas_and_what_is_left() -> None:
    one = {
        "case": "a", "form": "f", "balance": "mass", "before": {"fit": 11.0, "holdout": 21.0}, "failing": ["mass"],
        "same": [], "seconds": {"fit": 1.0, "ledger": 1.0, "formula": 2.0}, "simulations": 9, "in": "mass",
        "variables": ["p"], "right": True, "after": {"fit": 1.0, "holdout": 2.0},
    }  # fmt: skip
    other = {k: v for k, v in one.items() if k not in ("in", "variables", "right", "after")}
    text = table(
        [
            one,
            other | {"failing": ["force", "mass"]},
            {"case": "b", "balance": "force", "error": "no"},
        ]
    )
    assert "the right balance alone: 1; among others: 2" in text and "cases 2 of 3" in text
    assert "formulas 1; in the right balance 1; with all variables of the law 1 of 1" in text
    assert "that is left with the formula, median: 0.050" in text
    assert "| 21 → 2 (holdout) |" in text and "| 21 → no formula (holdout) |" in text


def test_every_case_hides_what_can_be_seen() -> None:
    for truth in CASES:
        assert all(h["target"] >= 4 for h in outline(case_of(truth.which, truth.number))["hidden"])
