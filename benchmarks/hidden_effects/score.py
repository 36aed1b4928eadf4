"""The blind score: generates and diagnoses the first cases of a set, one line of JSON for each.

    python -m benchmarks.hidden_effects.score --set score2 --cases 300 --jobs 2

Results are added to OUT (default build/hidden-effects-SET.jsonl) as they come; a second call goes on where the first
was stopped. A case that crashes or takes longer than --time-limit has that as its result; --again tries those anew.
Each case runs in a process of its own with --workers. `report.py` makes the tables and figures.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import suppress
from pathlib import Path

from benchmarks.hidden_effects.outcome import judged
from benchmarks.results import Result, append_result, read_results
from blind_cases.cases import APART, SEEDS, case_of, outline

ROOT = Path(__file__).resolve().parents[2]


def default_file(which: str) -> Path:
    """Where the results of a set go."""
    return ROOT / "build" / f"hidden-effects-{which}.jsonl"


def run_case(which: str, number: int, limit: float, workers: int = 0) -> Result:
    """One case in a process of its own, with all that it starts ended after `limit` seconds."""
    start = time.perf_counter()
    command = [
        sys.executable,
        "-m",
        "benchmarks.hidden_effects.one",
        "--set",
        which,
        "--number",
        str(number),
    ]
    command += ["--workers", str(workers)]
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    process = subprocess.Popen(
        command,
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    _RUNNING[process.pid] = process
    try:
        out, err = process.communicate(timeout=limit)
        return dict(json.loads(out))
    except subprocess.TimeoutExpired:
        error = {"where": "time limit", "text": f"not done after {limit:g} s"}
    except ValueError:
        error = {"where": "process", "text": f"exit status {process.returncode}: {err[-2000:]}"}
    finally:
        _end(process)
    known = outline(case_of(which, number))
    seconds = round(time.perf_counter() - start, 2)
    return {"set": which, "number": number, "case": known, "error": error, "seconds": seconds}


_RUNNING: dict[int, subprocess.Popen[str]] = {}


def _stop(*_: object) -> None:
    raise KeyboardInterrupt


def _end(process: subprocess.Popen[str]) -> None:
    _RUNNING.pop(process.pid, None)
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.communicate()


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--set", dest="which", choices=SEEDS, default="score2")
    parser.add_argument("--cases", type=int, default=300, help="how many, from --first on")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument(
        "--workers", type=int, default=0, help="processes of one diagnosis; times: 2, with --jobs 1"
    )
    parser.add_argument("--time-limit", type=float, default=900.0, help="seconds for one case")
    parser.add_argument("--out", type=Path)
    parser.add_argument(
        "--again", action="store_true", help="repeat cases that ended with an error"
    )
    options = parser.parse_args(arguments)
    file = options.out or default_file(options.which)
    file.parent.mkdir(parents=True, exist_ok=True)
    done = read_results(file)
    numbers = [
        n for n in range(options.first, options.first + options.cases)
        if n not in done or (options.again and "error" in done[n])
    ]  # fmt: skip
    signal.signal(signal.SIGTERM, _stop)
    print(f"{len(numbers)} cases to do, results in {file}", flush=True)
    begin = time.perf_counter()
    with ThreadPoolExecutor(options.jobs) as pool:
        waiting = [
            pool.submit(run_case, options.which, n, options.time_limit, options.workers)
            for n in numbers
        ]
        try:
            for count, future in enumerate(as_completed(waiting), start=1):
                result = future.result()
                append_result(file, result)
                left = (time.perf_counter() - begin) / count * (len(numbers) - count)
                print(
                    f"{_line(result)}   {count}/{len(numbers)}, {left / 60:.0f} min left",
                    flush=True,
                )
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            for process in list(
                _RUNNING.values()
            ):  # they have sessions of their own, which Ctrl-C does not reach
                with suppress(ProcessLookupError):
                    os.killpg(process.pid, signal.SIGKILL)
            print("stopped; the same command goes on", flush=True)
            return 130
    return 0


def _line(result: Result) -> str:
    """One case for the console; of a set whose forms lie apart only what gives none of them away."""
    if result["set"] in APART:
        group = result.get("case", {}).get("group", "?")
        return f"{result['number']:4d} {group:16} {judged(result):10}"
    case = result.get("case", {})
    hidden = "+".join(f"{h['family']}:{h['form']}" for h in case.get("hidden", [])) or case.get(
        "group", "?"
    )
    size = max(case["size"]["projected"].values()) if "size" in case else float("nan")
    if "error" in result:
        said = f"ERROR in the {result['error']['where']}"
    else:
        verdict = result["diagnosis"]["verdict"]
        said = f"{verdict['kind']} {'+'.join(verdict['effects'])}"
    return f"{result['number']:4d} {hidden:44} {size:7.2f}  {judged(result):10} {said}"


if __name__ == "__main__":
    sys.exit(main())
