"""Modelica that asks for too much gets an answer in seconds: a sentence with file and line, or a model."""

from __future__ import annotations

from typing import Any

import pytest

from pam_cosim.compiler import elementwise
from pam_cosim.errors import ModelError
from tests.hostile.corpora.models import REFUSED, TAKEN
from tests.hostile.judged import judged
from tests.tiers import of_this_tier, quick_but

ONE = 30.0  # s of processor time
MEMORY = 1000.0  # MB


LONG = (
    "a function that calls itself twice",
    "nested sums",
    "loops in loops",
    "2^40 empty instances",
    "2^40 instances",
    "2^18 instances",
    "arrays of arrays",
    "elseif 3000",
    "too many unknowns",
    "a product of four matrices of unknowns",
    "a dense loop of 100 unknowns",
)  # a second and more each


@pytest.fixture(scope="module")
def outcomes(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> dict[str, dict[str, Any]]:
    """What compiling came to, in one process with limits."""
    folder, every = tmp_path_factory.mktemp("models"), REFUSED | TAKEN
    names = of_this_tier(every, LONG, request.config)
    for number, name in enumerate(names):
        (folder / f"{number:03}.mo").write_text(every[name])
    return dict(zip(names, judged("compiling", folder), strict=True))


@pytest.mark.parametrize("name", quick_but(REFUSED, LONG))
def test_what_asks_for_too_much_is_refused_with_its_place(
    outcomes: dict[str, dict[str, Any]], name: str
) -> None:
    told = outcomes[name]
    assert told["end"] in ("refused", "compiled"), told
    assert told["seconds"] < ONE and told["peak"] < MEMORY, told
    if told["end"] == "refused":
        assert told["line"] >= 1 and told["file"].endswith(".mo"), told
        assert told["message"].isprintable() and 10 < len(told["message"]) < 500, told


def test_few_of_them_can_be_compiled_after_all(outcomes: dict[str, dict[str, Any]]) -> None:
    """What is legal and small once it is understood."""
    compiled = {
        name for name in REFUSED if name in outcomes and outcomes[name]["end"] == "compiled"
    }
    assert compiled <= {"annotation 5000 deep", "String of an array", "redeclared by itself"}


@pytest.mark.parametrize("name", quick_but(TAKEN, LONG))
def test_what_is_large_and_can_be_taken_is(outcomes: dict[str, dict[str, Any]], name: str) -> None:
    assert outcomes[name]["end"] == "compiled" and outcomes[name]["seconds"] < ONE, outcomes[name]


@pytest.mark.parametrize(
    "text",
    ["(" * 5000 + "x" + ")" * 5000, "-(" * 300 + "x" + ")" * 300, "9" * 5000, "x" + "+x" * 20000],
)
def test_formulas_of_data_have_limits_too(text: str) -> None:
    try:
        assert elementwise(text, {"x": 1.0}) == 20001
    except ModelError as error:
        assert error.message
