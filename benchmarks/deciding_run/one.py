"""One case: diagnosed from a part of a recording, then again with one run more, designed or drawn at random."""

from __future__ import annotations

import tempfile
import time
from contextlib import suppress
from dataclasses import replace
from math import nan
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.deciding_run.play import played
from benchmarks.hidden_effects import many
from benchmarks.hidden_effects.outcome import judged
from pam_cosim import study
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.planning import Limits, limits_of, plan
from pam_cosim.diagnosis.planning.moves import Moves
from pam_cosim.diagnosis.planning.rivals import Rivals
from pam_cosim.measurement import DataSet, Run, further_run

SAMPLES = 30  # of the recording that there is
SHARE = 0.4  # of the first run, that was recorded
TIME_LIMIT = 60.0  # s, of a diagnosis
BENCHES = ("Isotonic", "Isometric", "TankFilling", "VerticalLoad")
GROUPS = ("catalogue", "new_form", "instrument")
LEAST = 3.0  # standard deviations that a hidden effect shows at least, in all runs of the case
RANDOM = 78  # stream of random numbers
DRAWS = 20  # until the rig can play one


def is_asked(case: many.Case) -> bool:
    """Whether a case is among those of this benchmark: one effect that shows, on a bench with inputs."""
    return case.group in GROUPS and case.design.bench in BENCHES and min(case.targets) >= LEAST


def solve(which: str, number: int) -> dict[str, Any]:
    """What came of a case; ``further`` where the first verdict left rivals."""
    case = many.case_of(which, number)
    result: dict[str, Any] = {"number": number, "case": many.outline(case)}
    start = time.perf_counter()
    made = many.make(case)
    with tempfile.TemporaryDirectory() as folder:
        many.write(made, Path(folder))
        whole = study.read(folder)
    result["case"] = made.description
    scarce = scarce_data(whole)
    first = _diagnosis(scarce)
    result["first"] = _summary(made, first)
    if len(first.rival_models) > 1:
        recorded = scarce.runs[0]
        seconds = float(recorded.time[-1] - recorded.time[0])
        limits = replace(limits_of(whole, seconds=seconds), interval=seconds / SAMPLES)
        result["rivals"] = [list(effects) for effects in first.rivals]
        result["further"] = _further(made, first, limits)
    return result | {"seconds": round(time.perf_counter() - start, 1)}


def scarce_data(whole: DataSet) -> DataSet:
    """The beginning of the first run, with few samples."""
    run = whole.runs[0]
    kept = run.time <= run.time[0] + SHARE * (run.time[-1] - run.time[0])
    count = int(kept.sum())
    at = np.zeros(count, dtype=bool)
    at[:: max(1, count // SAMPLES)] = True
    measurements = {name: np.where(at, values[kept], np.nan) for name, values in run.measurements.items()}
    inputs = {name: values[kept] for name, values in run.inputs.items()}
    return replace(
        whole, runs=(replace(run, role="fit", time=run.time[kept], inputs=inputs, measurements=measurements),)
    )


def _further(made: many.Made, first: Diagnosis, limits: Limits) -> dict[str, Any]:
    """Verdicts with one run more, and what each run was expected to bring."""
    data = first.data
    begun = time.perf_counter()
    planned = plan(first, limits).runs[0]
    seconds = time.perf_counter() - begun
    designed = played(made, further_run(data, planned.time, planned.inputs, planned.parameters))
    chance, expected = _at_random(made, first, limits)
    result: dict[str, Any] = {"design_seconds": round(seconds, 1), "median_chi2": planned.at_random}
    for name, run, chi2 in (("designed", designed, planned.chi2), ("random", chance, expected)):
        again = _diagnosis(replace(data, runs=(*data.runs, run)))
        result[name] = _summary(made, again) | {"expected_chi2": chi2}
    return result


def _at_random(made: many.Made, first: Diagnosis, limits: Limits) -> tuple[Run, float]:
    """A run drawn within the same limits that the rig can play, and the chi-square that was expected of it."""
    moves, rng = Moves(limits, [run for run in first.data.runs]), made.case.rng(RANDOM)
    with Rivals(first.rival_models, first.data, limits) as rivals:
        for _ in range(DRAWS):
            run = rivals.run_of(moves.drawn(rng))
            with suppress(RuntimeError):
                predictions = rivals.predictions(run)
                chi2 = nan if predictions is None else float(rivals.separations(predictions).min())
                return played(made, run), chi2
    raise RuntimeError("the rig can play none of the courses that were drawn")


def _diagnosis(data: DataSet) -> Diagnosis:
    return study.diagnose(data, workers=0, explain=False, time_limit=TIME_LIMIT)


def _summary(made: many.Made, diagnosis: Diagnosis) -> dict[str, Any]:
    verdict = diagnosis.verdict.as_dict()
    outcome = judged({"case": made.description, "diagnosis": {"verdict": verdict}})
    return {"verdict": verdict, "outcome": outcome, "untried": len(diagnosis.untried)}
