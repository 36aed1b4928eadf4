"""What two versions say of the same cases."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks.hidden_effects.same import main

CASE = {
    "number": 3,
    "seconds": 1.0,
    "diagnosis": {"verdict": {"kind": "unknown"}, "chi2": [1.0, float("nan")]},
}


def _written(folder: Path, name: str, *results: dict[str, object]) -> str:
    file = folder / name
    file.write_text("".join(json.dumps(result) + "\n" for result in results))
    return str(file)


def test_times_do_not_count_and_nan_is_nan(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before, after = _written(tmp_path, "a", CASE), _written(tmp_path, "b", CASE | {"seconds": 9.0})
    assert main([before, after]) == 0
    assert "1 cases compared, 0 values differ" in capsys.readouterr().out


def test_the_last_bit_counts_and_is_placed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    other = {"verdict": {"kind": "identified"}, "chi2": [1.0000000000000002, float("nan")]}
    before, after = (
        _written(tmp_path, "a", CASE),
        _written(tmp_path, "b", CASE | {"diagnosis": other}),
    )
    assert main([before, after]) == 1
    said = capsys.readouterr().out
    assert "case 3: diagnosis.verdict.kind: unknown -> identified" in said
    assert "case 3: diagnosis.chi2[0]: 1.0 -> 1.0000000000000002" in said


def test_nothing_in_common(tmp_path: Path) -> None:
    assert main([_written(tmp_path, "a", CASE), _written(tmp_path, "b", CASE | {"number": 4})]) == 2
