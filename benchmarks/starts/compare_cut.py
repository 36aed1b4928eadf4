"""Fits models to whole recordings, to the same without their beginning, and to their pieces.

python -m benchmarks.starts.compare_cut build/starts.jsonl --set tuning2 --numbers 5 15 24
"""

from __future__ import annotations

import argparse
import json
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pam_cosim as pam
from benchmarks.hidden_effects import many
from benchmarks.starts.cutting import in_pieces, without_beginning

WAYS: dict[str, Callable[[Path, Path, int], Path]] = {
    "whole": lambda source, folder, seed: source,
    "cut": without_beginning,
    "pieces": in_pieces,
}


def fitted(folder: Path) -> dict[str, Any]:
    """What a fit of the base model leaves, and how it began."""
    began = time.process_time()
    fit = pam.fit(pam.read(folder))
    left = {role: s.chi2_reduced for role, s in fit.residuals.items() if s.samples}
    starts = [run.run.start.mode for run in fit.comparison.runs]
    return {
        "chi2": left,
        "parameters": {n: [e.value, e.low, e.high] for n, e in fit.parameters.items()},
        "starts": {mode: starts.count(mode) for mode in dict.fromkeys(map(str, starts))},
        "seconds": time.process_time() - began,
        "evaluations": fit.evaluations,
    }


def verdict(folder: Path) -> dict[str, Any]:
    """What a diagnosis says."""
    diagnosis = pam.diagnose(pam.read(folder), explain=False, workers=1)
    return {"kind": diagnosis.verdict.kind, "families": list(diagnosis.verdict.families),
            "chi2": diagnosis.final.residuals["fit"].chi2_reduced}  # fmt: skip


def one(which: str, number: int, diagnosed: bool) -> dict[str, Any]:
    """A case in each way."""
    case = many.case_of(which, number)
    outline = many.outline(case)
    result: dict[str, Any] = {"number": number, "bench": outline["bench"], "signals": outline["signals"],
                              "hidden": [h["family"] for h in outline["hidden"]]}  # fmt: skip
    with tempfile.TemporaryDirectory() as name:
        source = Path(name) / "whole"
        many.write(many.make(case), source)
        for way, make in WAYS.items():
            folder = make(source, Path(name) / way, number)
            try:
                result[way] = fitted(folder)
                if diagnosed and way != "pieces":
                    result[way]["verdict"] = verdict(folder)
            except Exception as problem:  # a failure is a result
                result[way] = {"failed": f"{type(problem).__name__}: {problem}"}
    return result


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--set", default="tuning2")
    parser.add_argument("--numbers", type=int, nargs="+", required=True)
    parser.add_argument("--diagnose", action="store_true", help="also the verdicts of the whole and the cut recordings")
    options = parser.parse_args()
    options.out.parent.mkdir(parents=True, exist_ok=True)
    for number in options.numbers:
        with options.out.open("a") as file:
            file.write(json.dumps(one(options.set, number, options.diagnose)) + "\n")


if __name__ == "__main__":
    main()
