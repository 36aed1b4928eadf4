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
    "_LEAST": "a vacuum and absolute zero",
    "_MEMORIES": "finer than a likelihood tells",
    "_AROUND": "accuracy of a grid",
    "_UNLIKELY": "accuracy of a grid",
    "_SINGLE": "accuracy of a spectrum",
    "_BAND": "accuracy of a spectrum",
    "_RATIOS": "all that two variances may be",
    "_SEARCH": "accuracy of a maximum",
    "_TINY": "keeps a logarithm off nought",
    "_SAME": "digits in which two values of a run are one condition of a table",
}
# 12: a rectangular distribution has a twelfth of its squared width as variance, as that of rounding
ARITHMETIC = (0, 0.5, 1, 2, 3, 12)
ROUNDING = 1e-9  # what is smaller is about the last digits of numbers, and divisions by zero
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
    assert numbers_that_decide(ast.parse(file.read_text())) == []


@pytest.mark.parametrize(
    ("text", "decides"),
    [
        ("def f(s):\n    return s > 0.37", True),
        ("def f(s, noise):\n    return s > 0.37 * noise", True),
        ("def f(s):\n    return min(s, 0.37) < s", True),
        ("def f(s):\n    return -0.37 < s < 1", True),
        ("def f(s):\n    limit = 0.37\n    return s > limit", True),
        ("def f(s):\n    limit: float = 0.37\n    return s > 2 * limit", True),
        ("def f(s):\n    low, high = 0.37, 1\n    return low < s", True),
        ("def f(s, limit=0.37):\n    return s > limit", True),
        ("def f(s, *, limit=0.37):\n    return s > limit", True),
        ("f = lambda s, limit=0.37: s > limit", True),
        (
            "class A:\n    limit: float = 0.37\n    def f(self, s):\n        return s > self.limit",
            True,
        ),
        ("LIMIT = 0.37", True),
        ("LIMIT: float = 0.37", True),
        ("def f(s, n):\n    return s > 2 * n - 0.5 and s[7] > 0", False),
        ("def f(s):\n    return s > 1 + 1e-12", False),
        ("def f(s):\n    width = 0.37 * s\n    return width", False),
        ("LIMIT = CRITERIA.fit.dead / 7", False),
        ("_NODES = 7", False),
    ],
)
def test_a_number_that_decides_is_seen(text: str, decides: bool) -> None:
    assert bool(numbers_that_decide(ast.parse(text))) is decides


def numbers_that_decide(tree: ast.Module) -> list[str]:
    """Constants of a module, and numbers that something is compared with, be it by a name of the same function."""
    found = []
    for node in tree.body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and not isinstance(node.value, ast.Lambda):
            inside = [] if node.value is None else [*ast.walk(node.value)]
            asked = any(isinstance(n, ast.Name) and n.id == "CRITERIA" for n in inside)
            if (
                any(_number(n) for n in inside)
                and not asked
                and not {*_names(node)} <= {*DECIDE_NOTHING}
            ):
                found.append(f"line {node.lineno}: {', '.join(_names(node))}")
    compared = [node for node in ast.walk(tree) if isinstance(node, ast.Compare)]
    found += [f"line {c.lineno} compares with {n}" for c in compared for n in _limits(*_sides(c))]
    for scope in ast.walk(tree):
        if isinstance(scope, ast.FunctionDef | ast.Lambda):
            inside = [n for side in _sides(*ast.walk(scope)) for n in ast.walk(side)]
            used = {n.id for n in inside if isinstance(n, ast.Name)}
            given = [*_assigned(*ast.walk(scope)), *_defaults(scope.args)]
        elif isinstance(scope, ast.ClassDef):
            inside = [n for side in _sides(*compared) for n in ast.walk(side)]
            used = {n.attr for n in inside if isinstance(n, ast.Attribute)}
            given = _assigned(*scope.body)
        else:
            continue
        found += [
            f"{name}, compared, has {n}" for name, v in given if name in used for n in _limits(v)
        ]
    return found


def _sides(*nodes: ast.AST) -> list[ast.expr]:
    return [s for n in nodes if isinstance(n, ast.Compare) for s in (n.left, *n.comparators)]


def _names(node: ast.Assign | ast.AnnAssign | ast.NamedExpr) -> list[str]:
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    return [n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]


def _assigned(*nodes: ast.AST) -> list[tuple[str, ast.expr]]:
    """Each name with what it is given."""
    given = [n for n in nodes if isinstance(n, ast.Assign | ast.AnnAssign | ast.NamedExpr)]
    return [(name, n.value) for n in given if n.value is not None for name in _names(n)]


def _defaults(of: ast.arguments) -> list[tuple[str, ast.expr]]:
    """Each argument with its default."""
    last = [*of.posonlyargs, *of.args][-len(of.defaults) :] if of.defaults else []
    pairs = [*zip(last, of.defaults, strict=True), *zip(of.kwonlyargs, of.kw_defaults, strict=True)]
    return [(argument.arg, value) for argument, value in pairs if value is not None]


def _limits(*nodes: ast.AST) -> list[float]:
    """Numbers of expressions that are no plain arithmetic; places in arrays are not looked at."""
    found: list[float] = []
    for node in nodes:
        if isinstance(node, ast.Constant):
            v = node.value
            if isinstance(v, int | float) and v not in ARITHMETIC and not 0 < v <= ROUNDING:
                found.append(v)
        elif isinstance(node, ast.Subscript):
            found += _limits(node.value)
        elif not isinstance(node, ast.Compare | ast.Lambda):  # these are looked at themselves
            found += _limits(*ast.iter_child_nodes(node))
    return found


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
