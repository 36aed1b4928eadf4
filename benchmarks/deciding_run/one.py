"""One case: diagnosed from a recording that says little, then with one run more, designed or drawn at random."""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import replace
from math import nan
from typing import Any

import numpy as np

from benchmarks.deciding_run import muscle
from benchmarks.deciding_run.scene import Scene
from benchmarks.hidden_effects.outcome import judged
from pam_cosim import study
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.planning import plan
from pam_cosim.diagnosis.planning.members import members
from pam_cosim.diagnosis.planning.moves import Moves
from pam_cosim.diagnosis.planning.rivals import Rivals
from pam_cosim.measurement import DataSet, Run, further_run

TIME_LIMIT = 60.0  # s, of a diagnosis
RANDOM = 78  # stream of random numbers
DRAWS = 20  # until the rig can play one


def solve(number: int) -> dict[str, Any]:
    """What came of a case; ``further`` where the first verdict left rivals."""
    start = time.perf_counter()
    scene = muscle.scene(number)
    result: dict[str, Any] = {"number": number, "case": scene.description}
    first = _diagnosis(scene.data)
    result["first"] = _summary(scene, first)
    if len(first.rival_models) > 1:
        result["rivals"] = [list(effects) for effects in first.rivals]
        result["further"] = _further(scene, first)
    return result | {"seconds": round(time.perf_counter() - start, 1)}


def _further(scene: Scene, first: Diagnosis) -> dict[str, Any]:
    """Verdicts with one run more, and what each run was expected to bring."""
    data, begun = first.data, time.perf_counter()
    planned = plan(first, scene.limits).runs[0]
    seconds = time.perf_counter() - begun
    designed = scene.play(further_run(data, planned.time, planned.inputs, planned.parameters))
    chance, expected = _at_random(scene, first)
    result: dict[str, Any] = {"design_seconds": round(seconds, 1), "median_chi2": planned.at_random}
    for name, run, chi2 in (("designed", designed, planned.chi2), ("random", chance, expected)):
        again = _diagnosis(replace(data, runs=(*data.runs, run)))
        result[name] = _summary(scene, again) | {"expected_chi2": chi2}
    return result


def _at_random(scene: Scene, first: Diagnosis) -> tuple[Run, float]:
    """A run drawn within the same limits that the rig can play, and the chi-square that was expected of it."""
    moves, rng = Moves(scene.limits, first.data.runs), np.random.default_rng([scene.seed, RANDOM])
    with Rivals(members(first), first.data, scene.limits) as rivals:
        for _ in range(DRAWS):
            run = rivals.run_of(moves.drawn(rng))
            with suppress(RuntimeError):
                predictions = rivals.predictions(run)
                chi2 = nan if predictions is None else float(rivals.separations(predictions).min())
                return scene.play(run), chi2
    raise RuntimeError("the rig can play none of the courses that were drawn")


def _diagnosis(data: DataSet) -> Diagnosis:
    return study.diagnose(data, workers=0, explain=False, time_limit=TIME_LIMIT)


def _summary(scene: Scene, diagnosis: Diagnosis) -> dict[str, Any]:
    verdict = diagnosis.verdict.as_dict()
    outcome = judged({"case": scene.description, "diagnosis": {"verdict": verdict}})
    return {"verdict": verdict, "outcome": outcome, "untried": len(diagnosis.untried)}
