"""Every number that decides stands in one place, and what documents say of it is true."""

from __future__ import annotations

import ast
import importlib
import re
from pathlib import Path

import pytest

from pam_cosim.reporting.criteria_page import criteria_page, criteria_table

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
    *(ROOT / "pam_cosim/ledger" / f"{name}.py" for name in ("estimate", "smoothed_models")),
    ROOT / "pam_cosim/measurement/noise.py",
    ROOT / "pam_cosim/measurement/white_noise.py",
)
DECIDE_NOTHING = {
    "comparison/coloured_noise": (
        "accuracy of a likelihood, a spectrum and a maximum",
        "_MEMORIES _RATIOS _AROUND _SEARCH _UNLIKELY _SINGLE _BAND _TINY",
    ),
    "comparison/condition_table": ("digits of a condition in a table", "_SAME"),
    "comparison/error_regions": (
        "describes where the error sits",
        "_FEWEST_SAMPLES _LEAST_VALUE _MOST_RULES",
    ),
    "comparison/conventions": (
        "advice to look at the data first; physical constants",
        "_MOST_RUNS _LATEST _PRICE_OF_DELAY _GAIN _NEAR_NOISE _LARGE_ERROR _REMAINING _REMAINING_ERROR _SAME_FACTOR "
        "_LEAST_VARIANCE _SIZES _PRICE_OF_SIZE _MOST_UNEXPLAINED _NEGLIGIBLE _EXPLAINED _ZEROS ATMOSPHERES "
        "STANDARD_ATMOSPHERE",
    ),
    "comparison/plausibility": (
        "advice to look at the data first; physical constants",
        "_LARGE_ERROR _NOISE_LIMIT _QUIET _STUCK BEYOND_LIMIT _OPPOSITE_CHANGE _SAME_INPUTS "
        "_MOST_SAMPLES _LEAST FEWEST_SAMPLES STANDARD_ATMOSPHERE",
    ),
    "comparison/rounding": ("accuracy of a table", "_FINE _CENTRE _TAIL _NODES"),
    "comparison/sample_conditions": (
        "describes where the error sits",
        "_BANDS _REST_RATE _ZERO_EDGE",
    ),
    "comparison/outliers": ("a property of the normal distribution", "MEDIAN_TO_SIGMA"),
    "diagnosis/description/explanation": ("describes the missing term", "_PARTS _PART"),
    "diagnosis/description/forms": (
        "describes the missing term",
        "_ROUNDING _BENDS _SIGNED_SHARE _EXTREME_QUANTILE _CONSTANT_RANGE _SAME_CORRELATION",
    ),
    "diagnosis/description/learning": (
        "describes the missing term",
        "_REST_SPAN _BLOCKS LEAST_GAIN",
    ),
    "diagnosis/description/selection": (
        "describes the missing term",
        "_MOST_FORMS LEAST_GAIN _LEAST_GAIN_OF_TERM _DESCRIBED_ERROR",
    ),
    "diagnosis/description/learning_text": ("bounds of a learned coefficient", "_REACH"),
    "diagnosis/judgement/family_table": ("rows of a table", "_LISTED _SURE _EXCLUSIVE"),
    "diagnosis/judgement/fitted_models": ("proposes a run", "MOST_RIVALS"),
    "diagnosis/judgement/missing_term": ("length of a list", "_MOST_RULES"),
    "diagnosis/judgement/next_experiment": ("proposes a run", "FACTORS _PACES _MOST_JOINED"),
    "diagnosis/judgement/verdict_sentences": (
        "length of a line; of a table",
        "_MOST_LISTED _SMALL_SHARE",
    ),
    "diagnosis/search/full_model": (
        "how far a continuation goes in a step",
        "_TURNS _SETTLED _EVALUATIONS _PRECISION _TOLERANCE _BEGIN _WIDE",
    ),
    "diagnosis/search/predicted_evidence": ("keeps a quotient finite", "_TINY"),
    "diagnosis/search/probing": ("any place between the bounds will do", "_SHARE"),
    "diagnosis/search/selection": ("how many moves are tried at once", "_FEW"),
    "diagnosis/search/trial": ("time of a compiler", "MOST_ROWS_UNCOMPILED"),
    "fitting/combinations": (
        "names parameters that the data confuse",
        "_PARALLEL_SLOPES _EXCHANGE_FACTOR _UNCHANGED_RMS INTERVAL",
    ),
    "fitting/estimate": ("an interval that is printed", "INTERVAL"),
    "fitting/fit": ("names parameters that the data confuse", "STRONG_CORRELATION"),
    "ledger/estimate": ("the ledger describes; the verdict is the same without it", "_NOISE_LEVEL"),
    "measurement/white_noise": (
        "properties of the normal distribution",
        "MEDIAN_TO_SIGMA _CLIPPED_VARIANCE",
    ),
}
"""The constants of each module that decides, own or imported, on which no verdict depends: why, and their names."""
TABLE = criteria_table()
LINK = re.compile(r"\[([^\]]+)\]\(criteria\.md#([\w.]+)\)")


def name_of(file: Path) -> str:
    return file.relative_to(ROOT / "pam_cosim").with_suffix("").as_posix()


def test_every_number_has_a_reason() -> None:
    for name, texts in TABLE.items():
        assert len(texts) == 4 and all(texts), name


def test_a_verdict_depends_on_fewer_than_a_hundred() -> None:
    assert 90 < len(TABLE) < 100


@pytest.mark.parametrize("file", DECIDING, ids=name_of)
def test_no_number_decides_elsewhere(file: Path) -> None:
    """No module that judges has a constant that is not listed."""
    tree = ast.parse(file.read_text())
    names = sorted([*constants(tree), *imported_numbers(tree)])
    assert names == sorted(DECIDE_NOTHING.get(name_of(file), ("", ""))[1].split())


def constants(tree: ast.Module) -> list[str]:
    """Constants of a module that have a number and do not follow from a criterion."""
    found = []
    for node in tree.body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and not isinstance(node.value, ast.Lambda):
            inside = [] if node.value is None else [*ast.walk(node.value)]
            names = {n.id for n in inside if isinstance(n, ast.Name)}
            if any(_number(n) for n in inside) and "CRITERIA" not in names:
                found += _names(node)
    return found


def imported_numbers(tree: ast.Module) -> list[str]:
    """Numbers, or tuples of them, that a module imports from another of the package."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("pam_cosim."):
            for name in (alias.name for alias in node.names if alias.name.lstrip("_").isupper()):
                value = getattr(importlib.import_module(node.module or ""), name)
                values = value if isinstance(value, tuple) and value else (value,)
                if all(isinstance(v, int | float) for v in values):
                    found.append(name)
    return found


def _names(node: ast.Assign | ast.AnnAssign | ast.NamedExpr) -> list[str]:
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    return [n.id for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]


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
            assert text == TABLE[name][0], f"{page.name} says {text} for {name}"
            quoted += 1
    assert quoted > 10
