"""One rig: generate it, or take it as it is there; diagnose it; print what came out as a line of JSON, for `score`.

python -m benchmarks.strangers.one RIGS --rig 3 [--workers 2] [--time-limit 600] [--told FILE]
"""

from __future__ import annotations

import argparse
import json
import sys
import time
import traceback
from collections.abc import Mapping, Sequence
from contextlib import redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from benchmarks.hidden_effects.one import memory, processor_seconds
from benchmarks.strangers.rivals import rival_errors
from strangers.__main__ import make
from strangers.rigs import rig as stranger

Errors = dict[str, float]


def solve(
    folder: Path,
    number: int,
    workers: int,
    limit: float | None = None,
    told: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """The result of a rig, of which `folder` has the files; an exception of the software is `error`."""
    rig = folder / f"rig-{number:02d}"
    if not rig.exists():
        make(stranger(number), rig)
    truth = json.loads((rig / "truth.json").read_text())
    result: dict[str, Any] = {
        "number": number,
        "half": truth["half"],
        "rig": f"{truth['load']}, {truth['drive']}",
        "departures": {d["family"]: d["counts"] for d in truth["departures"]},
        "error_of_truth": truth["error_of_truth"]["holdout"],
    }
    start, spent = time.perf_counter(), processor_seconds()
    try:
        result |= _diagnosed(rig, workers, limit)
    except Exception:
        result["error"] = traceback.format_exc()
    result["seconds"] = round(time.perf_counter() - start, 1)
    result["processor_seconds"] = round(processor_seconds() - spent, 1)
    result["megabytes"] = memory()
    try:
        result["rivals"] = _rivals(rig)
        if told is not None:
            result["told"] = _told(rig, told)
    except Exception:
        result["error_of_rivals"] = traceback.format_exc()
    return result


def _diagnosed(rig: Path, workers: int, limit: float | None) -> dict[str, Any]:
    from pam_cosim import study  # here, so that a broken installation is a result as well

    diagnosis = study.diagnose(study.read(rig), workers=workers, explain=False, time_limit=limit)
    verdict = diagnosis.verdict.as_dict()
    return {
        "kind": verdict["kind"],
        "named": verdict["families"],
        "effects": verdict["effects"],
        "families": verdict["posterior"]["families"],
        "table": verdict["family_table"],
        "base": _holdout(diagnosis.base.comparison),
        "final": _holdout(diagnosis.final.comparison),
        "simulations": diagnosis.simulations,
    }


def _told(rig: Path, told: Mapping[str, Any]) -> Errors:
    """Held-out errors of the truth told by hand: `effects`, and the parameters `free` that are fitted besides."""
    from pam_cosim import study

    data = study.read(rig)
    with TemporaryDirectory() as scratch:
        model = Path(scratch) / "Told.mo"
        base = rig / data.model if data.model.endswith(".mo") else data.model
        study.add(told["effects"], to=str(base), output=model)
        fit = study.fit(data, str(model), free=[*data.free_names, *told["free"]])
    return _holdout(fit.comparison)


def _holdout(comparison: Any) -> Errors:
    return {s: float(score.rmse) for s, score in comparison.scores["holdout"].items()}


def _rivals(rig: Path) -> dict[str, Errors]:
    from pam_cosim import study

    data = study.read(rig)
    return rival_errors(data.fit_runs, data.holdout_runs)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rig", type=int, required=True)
    parser.add_argument("--workers", type=int, default=0)
    parser.add_argument("--time-limit", type=float, help="of the diagnosis [s]")
    parser.add_argument("--told", type=Path)
    options = parser.parse_args(arguments)
    told = None
    if options.told:
        told = json.loads(options.told.read_text()).get(f"rig-{options.rig:02d}")
    with redirect_stdout(sys.stderr):
        result = solve(options.folder, options.rig, options.workers, options.time_limit, told)
    print(json.dumps(result))
    return 0


if __name__ == "__main__":
    sys.exit(main())
