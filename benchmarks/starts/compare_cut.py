"""Fits models to whole recordings, to the same without their beginning, to their pieces, and to one period of a sine.

python -m benchmarks.starts.compare_cut build/starts.jsonl --set tuning2 --numbers 5 15 24

A second call goes on where the first was stopped: numbers that the file has are left out.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import pam_cosim as pam
from benchmarks.results import append_result, read_results
from benchmarks.starts.cutting import in_pieces, without_beginning
from benchmarks.starts.sines import in_sines, last_period
from blind_cases import cases

WAYS: dict[str, Callable[[Path, Path, int], Path]] = {
    "whole": lambda source, folder, seed: source,
    "cut": without_beginning,
    "pieces": in_pieces,
}
DIAGNOSED = ("whole", "cut", "sine")


def fitted(folder: Path) -> dict[str, Any]:
    """What a fit of the base model leaves, and how it began."""
    began = time.process_time()
    fit = pam.fit(pam.read(folder))
    left = {role: s.chi2_reduced for role, s in fit.residuals.items() if s.samples}
    starts = [str(run.run.start.mode) for run in fit.comparison.runs]
    return {
        "chi2": left,
        "parameters": {n: [e.value, e.low, e.high] for n, e in fit.parameters.items()},
        "starts": {mode: starts.count(mode) for mode in dict.fromkeys(starts)},
        "seconds": time.process_time() - began,
        "evaluations": fit.evaluations,
    }


def verdict(folder: Path) -> dict[str, Any]:
    """What a diagnosis says."""
    began = time.process_time()
    diagnosis = pam.diagnose(pam.read(folder), explain=False, workers=1)
    said, residuals = diagnosis.verdict, diagnosis.final.residuals
    return {"kind": said.kind, "families": list(said.families), "effects": list(said.effects),
            "probability": said.probability, "reason": said.reason,
            "chi2": {role: s.chi2_reduced for role, s in residuals.items() if s.samples},
            "seconds": time.process_time() - began}  # fmt: skip


def one(which: str, number: int, diagnosed: bool) -> dict[str, Any]:
    """A case in each way."""
    case = cases.case_of(which, number)
    outline = cases.outline(case)
    result: dict[str, Any] = {"set": which, "number": number, "bench": outline["bench"], "signals": outline["signals"],
                              "group": outline["group"], "families": outline["families"],
                              "same_as": outline["same_as"]}  # fmt: skip
    with tempfile.TemporaryDirectory() as name:
        base = Path(name)
        made = cases.make(case)
        cases.write(made, base / "whole")
        result["size"] = made.description["size"]["projected"]
        for way, make in WAYS.items():
            result[way] = _result(way, partial(make, base / "whole", base / way, number), diagnosed)
        result["sine"] = _result("sine", partial(_one_period, case, base, number), diagnosed)
    return result


def _one_period(case: cases.Case, base: Path, number: int) -> Path:
    cases.write(cases.make(case, in_sines), base / "sines")
    return last_period(base / "sines", base / "sine", number)


def _result(way: str, make: Callable[[], Path], diagnosed: bool) -> dict[str, Any]:
    try:
        folder = make()
        result = fitted(folder)
        if diagnosed and way in DIAGNOSED:
            result["verdict"] = verdict(folder)
    except Exception as problem:  # a failure is a result
        return {"failed": f"{type(problem).__name__}: {problem}"}
    return result


def main(arguments: Sequence[str] | None = None) -> None:
    """Command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("out", type=Path)
    parser.add_argument("--set", default="tuning2")
    parser.add_argument("--numbers", type=int, nargs="+", required=True)
    parser.add_argument(
        "--diagnose", action="store_true", help="also the verdicts, but of the pieces"
    )
    options = parser.parse_args(arguments)
    options.out.parent.mkdir(parents=True, exist_ok=True)
    done = read_results(options.out)
    for number in dict.fromkeys(options.numbers):
        if number not in done:
            append_result(options.out, one(options.set, number, options.diagnose))


if __name__ == "__main__":
    main()
