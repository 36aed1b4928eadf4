"""Why a verdict was not right: the classes, by numbers written down, and their table."""

from __future__ import annotations

from dataclasses import replace

import pytest

from benchmarks.hidden_effects.misses import CLASSES, Facts, explained, reason, table
from pam_cosim.criteria import CRITERIA

WORTH = CRITERIA.evidence.very_strong
BETTER = Facts(
    ("leak",), ("LaminarLeak",), ("DeadVolume",), "identified", gap=-5 * WORTH, structure=False
)


@pytest.mark.parametrize(
    ("facts", "expected"),
    [
        (Facts(("leak",)), "no member"),
        (replace(BETTER, gap=-0.9 * WORTH), "not distinguishable"),
        (replace(BETTER, gap=-0.9 * WORTH, structure=True), "not distinguishable"),
        (replace(BETTER, structure=True), "no member"),
        (BETTER, "never fitted"),
        (replace(BETTER, searched=2 * WORTH), "never fitted"),
        (replace(BETTER, searched=2 * WORTH, same_effects=True), "optimiser"),
        (replace(BETTER, searched=0.5 * WORTH), "not chosen"),
        (replace(BETTER, searched=-WORTH, same_effects=True), "not chosen"),
    ],
)
def test_reasons(facts: Facts, expected: str) -> None:
    assert expected in CLASSES
    assert reason(facts) == expected


def test_what_needs_no_fit() -> None:
    assert explained("tuning2", 1, {"error": {}})["class"] == "error"
    for group, expected in (("null", "noise"), ("none_of_these", "no family")):
        assert explained("tuning2", 1, {"case": {"group": group}})["class"] == expected


def test_the_table_counts_by_group_and_names_no_case() -> None:
    results = {n: {"case": {"group": "pair" if n < 3 else "null"}} for n in range(5)}
    lines = [
        {"number": 0, "class": "optimiser"},
        {"number": 2, "class": "not chosen"},
        {"number": 4, "class": "noise"},
    ]
    head, _, null, pair = table(lines, results).splitlines()
    assert head.split(" | ")[3:] == [*CLASSES[:-1], f"{CLASSES[-1]} |"]
    assert pair == "| pair | 3 | 2 | 0 | 0 | 0 | 1 | 1 | 0 | 0 | 0 |"
    assert null == "| null | 2 | 1 | 0 | 0 | 0 | 0 | 0 | 1 | 0 | 0 |"
