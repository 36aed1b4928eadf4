"""Benchmarks go on where they were stopped, also within a line, and do nothing twice."""

from __future__ import annotations

from pathlib import Path

from benchmarks.results import append_result


def test_a_whole_line_without_its_end_counts(tmp_path: Path) -> None:
    file = tmp_path / "results.jsonl"
    append_result(file, {"number": 4})
    file.write_text(file.read_text().rstrip("\n"))
    append_result(file, {"number": 5})
    assert file.read_text() == '{"number": 4}\n{"number": 5}\n'
