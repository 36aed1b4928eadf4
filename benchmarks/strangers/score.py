"""Scores strangers' rigs: diagnoses each drafted data set in a process of its own, one line of JSON for each.

    python -m benchmarks.strangers.score --half tuning [--rig 0 1] [--rigs FOLDER] [--told FILE]

Rigs that are not there are generated. Results are added to OUT (default build/strangers-HALF.jsonl) as they come; a
second call goes on where the first was stopped, --again repeats rigs that ended with an error. `report` makes tables.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from benchmarks.results import Result, append_result, read_results
from benchmarks.strangers.report import line
from strangers.rigs import HALVES

ROOT = Path(__file__).resolve().parents[2]


def run_rig(options: argparse.Namespace, number: int) -> Result:
    """One rig in a process of its own, with all that it starts ended after twice the limit."""
    command = [sys.executable, "-m", "benchmarks.strangers.one", str(options.rigs)]
    command += ["--rig", str(number), "--workers", str(options.workers)]
    command += ["--time-limit", str(options.time_limit)]
    if options.told:
        command += ["--told", str(options.told)]
    process = subprocess.Popen(
        command,
        cwd=ROOT,
        env=os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"},
        stdout=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    patience = 2 * options.time_limit + 600
    try:
        out, _ = process.communicate(timeout=patience)
        return dict(json.loads(out))
    except subprocess.TimeoutExpired:
        return {"number": number, "error": f"not done after {patience:g} s"}
    except ValueError:
        return {"number": number, "error": f"exit status {process.returncode}"}
    finally:
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--half", choices=HALVES, default="tuning")
    parser.add_argument("--rig", type=int, nargs="+", help="only these of the half")
    parser.add_argument("--rigs", type=Path, default=ROOT / "build" / "strangers")
    parser.add_argument("--workers", type=int, default=2, help="processes of one diagnosis")
    parser.add_argument("--time-limit", type=float, default=600.0, help="of one diagnosis [s]")
    parser.add_argument("--told", type=Path, help="effects and free parameters by rig (JSON)")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--again", action="store_true", help="repeat rigs that ended in an error")
    options = parser.parse_args(arguments)
    file = options.out or ROOT / "build" / f"strangers-{options.half}.jsonl"
    file.parent.mkdir(parents=True, exist_ok=True)
    options.rigs = options.rigs.resolve()
    options.told = options.told and options.told.resolve()
    done = read_results(file)
    for number in HALVES[options.half]:
        if options.rig and number not in options.rig:
            continue
        if number in done and not (options.again and "error" in done[number]):
            continue
        result = run_rig(options, number)
        append_result(file, result)
        print(line(result), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
