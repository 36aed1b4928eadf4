"""Results of benchmarks that go on where they were stopped: a line of JSON for each case."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

Result = dict[str, Any]


def read_results(file: Path) -> dict[int, Result]:
    """Results by case number, the last one of each; a line cut off by a stop is left out."""
    results: dict[int, Result] = {}
    if file.exists():
        for line in file.read_text().splitlines():
            try:
                result = json.loads(line)
            except ValueError:
                continue
            results[result["number"]] = result
    return results


def append_result(file: Path, result: Mapping[str, Any]) -> None:
    """Adds a line; one that was cut off by a stop is ended first, and ``read_results`` leaves it out."""
    before = file.read_text() if file.exists() else ""
    cut_off = before != "" and not before.endswith("\n")
    with file.open("a") as written:
        written.write("\n" * cut_off + json.dumps(result) + "\n")
