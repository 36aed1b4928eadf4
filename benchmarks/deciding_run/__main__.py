"""Right after one more run: designed against drawn at random.

    python -m benchmarks.deciding_run --cases 200          # goes on where it was stopped
    python -m benchmarks.deciding_run --table FILE.md

One muscle, every effect that the simulator knows by name, three seconds recorded with 50 samples. Where the verdict
leaves rivals, a run of the same length and as many samples is designed within the limits of the rig, played on the
simulator with the hidden effect and the noise, and added; and so is one that is drawn at random.
"""

from __future__ import annotations

import argparse
import sys
import traceback
from collections.abc import Sequence
from pathlib import Path

from benchmarks.deciding_run import muscle
from benchmarks.deciding_run.one import solve
from benchmarks.deciding_run.table import RUNS, table
from benchmarks.results import append_result, read_results

FOLDER = Path(__file__).resolve().parents[2] / "build"


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument(
        "--cases", type=int, default=0, help="numbers of cases that are looked at, from --first on"
    )
    parser.add_argument("--results", type=Path, help="default: a file in build/")
    parser.add_argument("--table", type=Path, help="write what came out as Markdown")
    options = parser.parse_args(arguments)
    file = options.results or FOLDER / "deciding-run-muscle.jsonl"
    file.parent.mkdir(parents=True, exist_ok=True)
    done = read_results(file)
    for number in range(options.first, options.first + options.cases):
        if number in done or not muscle.is_asked(number):
            continue
        try:
            result = solve(number)
        except Exception:
            result = {"number": number, "error": traceback.format_exc()}
        append_result(file, result)
        print(_line(result), flush=True)
    if options.table:
        options.table.write_text(table(list(read_results(file).values())))
    return 0


def _line(result: dict) -> str:
    if "error" in result:
        return f"{result['number']}: {result['error'].splitlines()[-1]}"
    first, further = result["first"], result.get("further")
    text = f"{result['number']}: {first['verdict']['kind']} ({first['outcome']})"
    if further:
        parts = (
            f"{name} {further[name]['outcome']} ({further[name]['expected_chi2']:.3g})"
            for name in RUNS
        )
        text += f" -> {', '.join(parts)}"
    return f"{text}, {result['seconds']} s"


if __name__ == "__main__":
    sys.exit(main())
