"""Results of benchmarks that go on where they were stopped: a line of JSON for each case."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from benchmarks.hidden_effects.score import read_results

__all__ = ["append_result", "read_results"]


def append_result(file: Path, result: Mapping[str, Any]) -> None:
    """Adds a line; one that was cut off by a stop is ended first, and ``read_results`` leaves it out."""
    before = file.read_text() if file.exists() else ""
    cut_off = before != "" and not before.endswith("\n")
    with file.open("a") as written:
        written.write("\n" * cut_off + json.dumps(result) + "\n")
