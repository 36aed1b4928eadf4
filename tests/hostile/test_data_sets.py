"""Hostile data sets: each gets one sentence with the file's name, or a result; in seconds, and nothing is written."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import pytest

from pam_cosim.files import read_file
from tests.hostile.corpora.data_sets import REFUSED, TAKEN
from tests.hostile.judged import judged
from tests.hostile.reading import make
from tests.tiers import of_this_tier, quick_but

ONE = 10.0  # s of processor time
MEMORY = 1000.0  # MB
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="limits of memory")


LONG = (
    "an unknown key of 2000 lines",
    "a header of 100000 columns",
    "10000 runs",
)  # a second and more each


@pytest.fixture(scope="module")
def outcomes(
    tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest
) -> dict[str, dict[str, Any]]:
    """What comparing came to, in one process with limits."""
    folder, every = tmp_path_factory.mktemp("data"), REFUSED | TAKEN
    names = of_this_tier(every, LONG, request.config)
    for number, name in enumerate(names):
        make(folder / f"set-{number:03}", every[name])
    return dict(zip(names, judged("reading", folder, "compare"), strict=True))


@pytest.mark.parametrize("name", quick_but(REFUSED, LONG))
def test_what_cannot_be_used_is_said_in_a_sentence(
    outcomes: dict[str, dict[str, Any]], name: str
) -> None:
    told = outcomes[name]
    assert told["status"] == 2 and not told["defect"] and not told["new"], told
    assert told["seconds"] < ONE and told["peak"] < MEMORY, told
    said = told["said"].strip()
    assert said.startswith("pam-cosim: ") and said.isprintable() and len(said) < 1000, said
    assert "experiment.toml" in said or "run-01.csv" in said, said


@pytest.mark.parametrize("name", TAKEN)
def test_what_is_only_strange_has_a_result(outcomes: dict[str, dict[str, Any]], name: str) -> None:
    told = outcomes[name]
    assert told["status"] in (0, 1) and not told["defect"] and not told["new"], told
    assert told["seconds"] < ONE and told["peak"] < MEMORY, told
    assert "Traceback" not in told["said"] and "Warning" not in told["said"], told


def test_a_file_that_grows_is_read_to_its_end(tmp_path: Path) -> None:
    """What a system tells of itself has no size that is known before."""
    assert read_file(Path("/proc/self/status")).startswith(b"Name:")
