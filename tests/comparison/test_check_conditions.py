"""Whether a table can be made is known before anything is simulated."""

from __future__ import annotations

import pytest

from pam_cosim.comparison import check_conditions
from pam_cosim.errors import InputError
from tests.comparison.fake import run

RUNS = [
    run("a", [0.0, 1.0], parameters={"load.m": 1.0, "frequency": 2.0}, inputs={"p": [0.0, 1.0]}),
    run("b", [0.0, 1.0], parameters={"load.m": 2.0}, inputs={"p": [0.0, 1.0]}),
]


@pytest.mark.parametrize(
    ("columns", "words"),
    [
        ("frequency", "the run b has no parameter 'frequency'"),
        ("load.n", "did you mean 'load.m'?"),
        ("p", "'p' is an input, which moves during the run a: a table is by parameters"),
        ("p", "load.m, tank.V"),
        ("load.m", "on both sides"),
    ],
)
def test_a_table_that_cannot_be_made_is_refused(columns: str, words: str) -> None:
    with pytest.raises(InputError) as refused:
        check_conditions(RUNS, "load.m", columns, {"tank.V": 1.0})
    assert words in " ".join([str(refused.value).replace("tank.V, load.m", "load.m, tank.V")])


def test_values_of_all_runs_count() -> None:
    with pytest.raises(InputError, match="no parameter 'tank.V'"):
        check_conditions(RUNS, "load.m", "tank.V", {})
    assert check_conditions(RUNS, "load.m", "tank.V", {"tank.V": 1.0}) is None  # type: ignore[func-returns-value]
