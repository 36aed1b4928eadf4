"""Benchmarks go on where they were stopped, also within a line, and do nothing twice."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from benchmarks import bioreactor
from benchmarks.deciding_run import __main__ as deciding_run
from benchmarks.deciding_run import random_runs
from benchmarks.predictive_bands import __main__ as predictive_bands
from benchmarks.results import append_result, read_results
from benchmarks.starts import compare_cut
from blind_cases import many

Started = Callable[[Path, int], Any]


def solved(number: int, *_: object) -> dict[str, Any]:
    """A result that every benchmark can sum up."""
    return {
        "number": number,
        "first": {"verdict": {"kind": "identified"}, "outcome": "right"},
        "before": {"outcome": "right"},
        "random": [],
        "seconds": 1.0,
    }


@pytest.fixture(params=["deciding_run", "predictive_bands", "random_runs", "bioreactor", "starts"])
def start(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Started:
    """Runs a benchmark for so many cases, which take no time."""
    case = SimpleNamespace(group="null", design=SimpleNamespace(runs=2))
    monkeypatch.setattr(deciding_run, "solve", lambda which, number: solved(number))
    monkeypatch.setattr(
        deciding_run, "SETS", {"muscle": SimpleNamespace(is_asked=lambda number: True)}
    )
    monkeypatch.setattr(predictive_bands, "solve", solved)
    monkeypatch.setattr(many, "case_of", lambda which, number: case)
    monkeypatch.setattr(random_runs, "solve", solved)
    monkeypatch.setattr(bioreactor, "solve", solved)
    monkeypatch.setattr(compare_cut, "one", lambda which, number, diagnosed: solved(number))

    def words(file: Path, cases: int) -> list[str]:
        if request.param == "starts":
            return [str(file), "--numbers", *map(str, range(cases))]
        return ["--cases", str(cases), "--results", str(file)]

    mains = {
        "deciding_run": deciding_run.main,
        "predictive_bands": predictive_bands.main,
        "random_runs": random_runs.main,
        "bioreactor": bioreactor.main,
        "starts": compare_cut.main,
    }
    return lambda file, cases: mains[request.param](words(file, cases))


def numbers(file: Path) -> list[int]:
    """Of the lines that are whole."""
    found = []
    for line in file.read_text().splitlines():
        try:
            found.append(json.loads(line)["number"])
        except ValueError:
            continue
    return found


def test_what_is_there_is_not_done_again(start: Started, tmp_path: Path) -> None:
    file = tmp_path / "results.jsonl"
    start(file, 2)
    start(file, 3)
    assert numbers(file) == [0, 1, 2]


def test_a_line_that_was_cut_off_is_done_again(start: Started, tmp_path: Path) -> None:
    file = tmp_path / "results.jsonl"
    start(file, 2)
    file.write_text(file.read_text()[:-9])
    start(file, 3)
    assert numbers(file) == [0, 1, 2] and list(read_results(file)) == [0, 1, 2]
    start(file, 3)
    assert numbers(file) == [0, 1, 2]


def test_a_whole_line_without_its_end_counts(tmp_path: Path) -> None:
    file = tmp_path / "results.jsonl"
    append_result(file, {"number": 4})
    file.write_text(file.read_text().rstrip("\n"))
    append_result(file, {"number": 5})
    assert file.read_text() == '{"number": 4}\n{"number": 5}\n'


def test_bands_with_and_without_a_hidden_effect_have_files_of_their_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    groups = ("null", "catalogue")
    monkeypatch.setattr(predictive_bands, "FOLDER", tmp_path, raising=False)
    monkeypatch.setattr(
        predictive_bands, "RESULTS", tmp_path / "predictive-bands.jsonl", raising=False
    )
    monkeypatch.setattr(predictive_bands, "solve", solved)
    monkeypatch.setattr(
        many,
        "case_of",
        lambda which, n: SimpleNamespace(group=groups[n], design=SimpleNamespace(runs=2)),
    )
    predictive_bands.main(["--cases", "2"])
    predictive_bands.main(["--cases", "2", "--hidden"])
    assert numbers(tmp_path / "predictive-bands.jsonl") == [0]
    assert numbers(tmp_path / "predictive-bands-hidden.jsonl") == [1]
    with pytest.raises(SystemExit):
        predictive_bands.main(["--table", "--results", str(tmp_path / "none.jsonl")])
