"""How many runs drawn at random does it take, until the verdict leaves no choice?

    python -m benchmarks.deciding_run.random_runs --cases 150 --most 4 --results FILE.jsonl

The cases of the set "muscle" of this benchmark, and the same limits. Where the first verdict is ambiguous, runs that
are drawn at random follow, each with noise of its own, as long as rivals are left. To be read beside the one designed
run of the same cases. Ends with the shares that are right after so many runs.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.deciding_run import muscle
from benchmarks.deciding_run.one import DRAWS, RANDOM, _diagnosis, _summary
from benchmarks.deciding_run.scene import Scene
from benchmarks.results import append_result, read_results
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.planning import plan
from pam_cosim.diagnosis.planning.members import members
from pam_cosim.diagnosis.planning.moves import Moves
from pam_cosim.diagnosis.planning.rivals import Rivals
from pam_cosim.measurement import Run, further_run


def solve(number: int, most: int) -> dict[str, Any]:
    """Outcomes after each random run, and after one designed run, where the first verdict is ambiguous."""
    scene = muscle.scene(number)
    before = _diagnosis(scene.data)
    result: dict[str, Any] = {"number": number, "before": before.verdict.kind}
    if before.verdict.kind != "ambiguous":
        return result
    planned = plan(before, scene.limits).runs[0]
    blank = further_run(before.data, planned.time, planned.inputs, planned.parameters)
    data = replace(before.data, runs=(*before.data.runs, scene.play(blank)))
    result["designed"] = _summary(scene, _diagnosis(data))["outcome"]
    rng, outcomes = np.random.default_rng([scene.seed, RANDOM]), list[str]()
    moves = Moves(scene.limits, before.data.runs)
    now, data = before, before.data
    while now.verdict.kind in ("ambiguous", "unknown") and len(outcomes) < most:
        run = replace(_drawn(scene, before, moves, rng, len(outcomes)), name=f"r{len(outcomes)}")
        data = replace(data, runs=(*data.runs, run))
        now = _diagnosis(data)
        outcomes.append(_summary(scene, now)["outcome"])
    return result | {"random": outcomes}


def _drawn(
    scene: Scene, first: Diagnosis, moves: Moves, rng: np.random.Generator, done: int
) -> Run:
    """A run that the rig can play; the first one is that of ``one.solve``, noise included."""
    with Rivals(members(first), first.data, scene.limits) as rivals:
        for _ in range(DRAWS):
            run = rivals.run_of(moves.drawn(rng))
            with suppress(RuntimeError):
                return scene.play(run, *([done] if done else []))
    raise RuntimeError("the rig can play none of the courses that were drawn")


def main(arguments: Sequence[str] | None = None) -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--cases", type=int, default=0)
    parser.add_argument("--most", type=int, default=4, help="random runs of a case")
    parser.add_argument("--results", type=Path, required=True)
    options = parser.parse_args(arguments)
    results = list(read_results(options.results).values())
    for number in range(len(results), options.cases):
        results.append(solve(number, options.most))
        append_result(options.results, results[-1])
        print(results[-1], flush=True)
    asked = [r for r in results if r.get("random")]
    print("designed 1", dict(Counter(r["designed"] for r in asked)))
    for count in range(1, options.most + 1):
        print("random", count, dict(Counter(r["random"][:count][-1] for r in asked)))


if __name__ == "__main__":
    main()
