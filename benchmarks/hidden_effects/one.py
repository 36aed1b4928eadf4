"""One case: generate it, or take it as prepared; diagnose it; print what came out as a line of JSON, for `score`.

python -m benchmarks.hidden_effects.one --set tuning3 --number 7 [--keep FOLDER] [--workers 2]
"""

from __future__ import annotations

import argparse
import json
import resource
import sys
import tempfile
import time
import traceback
from collections.abc import Collection, Mapping, Sequence
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

from blind_cases.cases import SEEDS, case_of, outline
from blind_cases.prepared import made_case

_RANKS = 5


def solve(
    which: str,
    number: int,
    folder: Path,
    workers: int,
    without: Sequence[str] = (),
    note_stages: bool = False,
) -> dict[str, Any]:
    """The result of one case. An exception of the generator or of the software becomes `error` with its place.

    Stages of the diagnosis can be switched off (`stages`), and noted where they do anything, which takes time itself.
    """
    result: dict[str, Any] = {
        "set": which,
        "number": number,
        "case": outline(case_of(which, number)),
    }
    start = time.perf_counter()
    try:
        description = result["case"] = made_case(which, number, folder)
    except Exception:
        return result | {"error": {"where": "generator", "text": traceback.format_exc()}}
    result["generation_seconds"] = round(time.perf_counter() - start, 2)
    from benchmarks.hidden_effects import stages

    active = stages.note() if note_stages else None
    stages.leave_out(without)
    before, start, spent = memory(), time.perf_counter(), processor_seconds()
    try:
        result["diagnosis"] = _diagnosis(folder, description, workers)
    except Exception:
        result["error"] = {"where": "diagnosis", "text": traceback.format_exc()}
    result["seconds"] = round(time.perf_counter() - start, 2)
    used = {"processor_seconds": round(processor_seconds() - spent, 2)}
    if active is not None:
        result["stages"] = sorted(active)
    return result | used | {"megabytes": memory(), "megabytes_before": before}


def processor_seconds() -> float:
    """Processor time of this process, and of those that it started and saw end, so far [s]."""
    use = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in use)


def memory() -> float:
    """The most memory that this process, or one that it started and saw end, has had so far [MB].

    Workers are counted by the largest of them: Linux keeps no sum.
    """
    peaks = [
        resource.getrusage(who).ru_maxrss
        for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    ]
    return round(max(peaks) / 1024, 1)


def _diagnosis(folder: Path, description: Mapping[str, Any], workers: int) -> dict[str, Any]:
    from pam_cosim import study  # here, so that a broken installation is a result as well

    diagnosis = study.diagnose(study.read(folder), workers=workers, explain=False)
    verdict = diagnosis.verdict
    noise = description["noise"]
    signals = {name: diagnosis.data.signals[name] for name in noise["fit"]}
    sigma = {name: signal.sigma for name, signal in signals.items()}
    coarse = {name for name, signal in signals.items() if signal.step}
    final = diagnosis.final.comparison
    return {
        "verdict": verdict.as_dict(),
        "probability": _probability(verdict.as_dict()),
        "sigma": sigma,
        "chi2": {
            role: {
                "base": diagnosis.base.comparison.chi2_reduced(role),
                "final": final.chi2_reduced(role),
                "noise": _floor(noise[role], sigma, coarse),
            }
            for role in noise
        },
        "simulations": diagnosis.simulations,
        "path": [c.effect for c in diagnosis.path],
        "ranks": [[c.effect, c.family, c.delta_bic] for c in diagnosis.candidates[:_RANKS]],
        "parameters": {
            name: estimate.value for name, estimate in diagnosis.final.parameters.items()
        },
    }


def _floor(
    noise: Mapping[str, Mapping[str, float]],
    sigma: Mapping[str, float],
    coarse: Collection[str] = (),
) -> float:
    """The reduced chi-square that the truth itself would have: recorded minus true, weighed as the software weighs.

    Readings in coarse steps are counted by what rounding leaves of the truth: one.
    """
    squares = {
        n: 1.0 if n in coarse else one["mean_square"] / sigma[n] ** 2 for n, one in noise.items()
    }
    total = sum(squares[n] * one["samples"] for n, one in noise.items())
    return total / sum(one["samples"] for one in noise.values())


def _probability(verdict: Mapping[str, Any]) -> float | None:
    """What the verdict says of its families: that just these are missing; None where it says nothing."""
    value = verdict.get("probability")
    return None if value is None else float(value)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--set", dest="which", choices=SEEDS, required=True)
    parser.add_argument("--number", type=int, required=True)
    parser.add_argument("--workers", type=int, default=0)
    parser.add_argument("--without", nargs="*", default=[], help="stages to switch off")
    parser.add_argument("--note-stages", action="store_true", help="which stages did anything")
    parser.add_argument("--keep", type=Path, help="folder in which the data set stays")
    options = parser.parse_args(arguments)
    with redirect_stdout(sys.stderr), tempfile.TemporaryDirectory() as scratch:
        folder = options.keep or Path(scratch) / "data"
        result = solve(
            options.which,
            options.number,
            folder,
            options.workers,
            options.without,
            options.note_stages,
        )
    print(json.dumps(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())
