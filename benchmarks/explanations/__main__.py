"""Keeps the ledger of blind cases and describes what is missing by a formula, without a search; one line a case.

PYTHONPATH=refsim python -m benchmarks.explanations [--cases 5] [--jobs 2] [-o FILE.jsonl]
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

from benchmarks.explanations.cases import CASES
from benchmarks.explanations.one import explain
from benchmarks.explanations.table import table


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", type=int, default=len(CASES), help="how many, from the first on")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("-o", "--output", type=Path, help="a line of JSON for each case")
    options = parser.parse_args(arguments)
    results: list[dict[str, Any]] = []
    with ProcessPoolExecutor(options.jobs, max_tasks_per_child=1) as pool:
        for result in pool.map(explain, CASES[: options.cases]):
            results.append(result)
            print(json.dumps(result), file=sys.stderr, flush=True)
            if options.output:
                with options.output.open("a") as file:
                    file.write(json.dumps(result) + "\n")
    print(table(results))
    return 0


if __name__ == "__main__":
    sys.exit(main())
