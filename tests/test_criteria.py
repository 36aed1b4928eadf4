"""Every number that decides stands in one place, and what documents say of it is true."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from pam_cosim.criteria import VERDICT, every_criterion
from pam_cosim.reporting.criteria_page import criteria_page

ROOT = Path(__file__).parents[1]
FITTING = ("combinations", "estimate", "fit", "solve")
DECIDING = (
    *sorted((ROOT / "pam_cosim/comparison").glob("*.py")),
    *sorted((ROOT / "pam_cosim/diagnosis").glob("*.py")),
    *(
        file
        for room in ("judgement", "search", "description")
        for file in sorted((ROOT / "pam_cosim/diagnosis" / room).glob("*.py"))
    ),
    *(ROOT / "pam_cosim/fitting" / f"{name}.py" for name in FITTING),
    *(
        ROOT / "pam_cosim/ledger" / f"{name}.py"
        for name in ("estimate", "smoothed_models", "sensor")
    ),
    ROOT / "pam_cosim/measurement/noise.py",
    ROOT / "pam_cosim/measurement/white_noise.py",
)
DECIDE_NOTHING = {
    "_CLIPPED_VARIANCE": "follows from the clip",
    "_IDLE": "how long a process without work stays",
    "_BETWEEN": "how often tasks are interrupted",
    "_GRACE": "how long interrupted tasks may take to clean up",
    "_LOOK": "how often a worker looks whether its study still lives",
    "_REACH": "bounds that a learned coefficient is given",
    "_SPEEDS": "forms on the shelf",
    "_GROWTHS": "forms on the shelf",
    "_WAVES": "forms on the shelf",
    "_NOTHING_NEW": "rank of a matrix, far from what noise leaves",
    "_WEAK": "the same",
    "_ZEROS": "the atmosphere and the ice point",
    "_ROUNDS": "how often a linear problem is solved again from where it led",
    "_INSIDE": "keeps a step off the samples beside it",
    "_FINE": "accuracy of a table",
    "_CENTRE": "keeps a quotient off nought by nought",
    "_TAIL": "the end of a sum",
    "_SHARES": "anywhere between bounds will do",
    "_NODES": "accuracy of a table",
    "_MOST_LISTED": "length of a line",
    "STEP": "a difference, far below what noise shows",
    "_ELSEWHERE": "where the same is seen from",
    "_CORRECTIONS": "rounds of a linear problem",
    "MEDIAN_TO_SIGMA": "a property of the normal distribution",
    "_SAME": "digits in which two values of a run are one condition of a table",
}
BY_NAME = {c.name: c for c in every_criterion()}
LINK = re.compile(r"\[([^\]]+)\]\(criteria\.md#([\w.]+)\)")


def test_every_number_has_a_reason() -> None:
    assert len(BY_NAME) > 90
    for c in BY_NAME.values():
        assert c.unit and c.reason and c.source, c.name


def test_a_verdict_depends_on_fewer_than_a_hundred() -> None:
    assert {c.group for c in BY_NAME.values()} > {*VERDICT}
    assert sum(c.group in VERDICT for c in BY_NAME.values()) < 100


@pytest.mark.parametrize("file", DECIDING, ids=lambda f: f"{f.parent.name}/{f.stem}")
def test_no_number_decides_elsewhere(file: Path) -> None:
    """No module that judges has a constant of its own, nor compares with a number that is not plain arithmetic."""
    tree = ast.parse(file.read_text())
    for node in tree.body:
        if isinstance(node, ast.Assign) and any(
            isinstance(n, ast.Constant) and _number(n) for n in ast.walk(node)
        ):
            names = [t.id for t in node.targets if isinstance(t, ast.Name)]
            if not any(
                isinstance(n, ast.Name) and n.id == "CRITERIA" for n in ast.walk(node.value)
            ):
                assert set(names) <= set(DECIDE_NOTHING), f"{file.name}:{node.lineno}"
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare):
            for side in (node.left, *node.comparators):
                value = (
                    side.operand.value
                    if isinstance(side, ast.UnaryOp) and _number(side.operand)
                    else None
                )
                value = side.value if isinstance(side, ast.Constant) and _number(side) else value
                assert value in (None, 0, 1, 2, 3), (
                    f"{file.name}:{node.lineno} compares with {value}"
                )


def _number(node: ast.AST) -> bool:
    return (
        isinstance(node, ast.Constant)
        and isinstance(node.value, (int, float))
        and not isinstance(node.value, bool)
    )


def test_page_is_made_from_the_code() -> None:
    assert (ROOT / "docs/criteria.md").read_text() == criteria_page()


def test_documents_quote_the_numbers_in_force() -> None:
    quoted = 0
    for page in sorted((ROOT / "docs").glob("*.md")):
        for text, name in LINK.findall(page.read_text()):
            assert text == BY_NAME[name].text, f"{page.name} says {text} for {name}"
            quoted += 1
    assert quoted > 10
