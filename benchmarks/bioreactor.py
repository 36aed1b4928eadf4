"""Which law of growth, after one more run: designed, or with a feed that is drawn at random.

    python -m benchmarks.bioreactor --cases 32 --results FILE.jsonl     # goes on where it was stopped

Written before the first result. A bioreactor (``examples/bioreactor``) has one of four laws of growth, in turn; each
case has noise of its own. Sixteen samples were taken of a batch and of one that is fed with 0.1 l/h from the fifth hour
on. The base model grows at a constant rate while there is substrate. Where the verdict leaves rivals, one run is
designed for feeds of 0 to 10 l/h with the defaults of ``plan``, played on the simulator and added; and so is one with a
feed that is set anew every hour at random within the same limits. Right: the law that the simulator has is identified.
Wrong: another one is, or nothing is missing. Ambiguous and unknown verdicts count as what they are.

Added after the first 32 cases: where rivals are still left, a second and a third run follow in the same way. Added
after 80 cases: with ``--random 8`` random runs alone go on, to tell how many of them a designed one is worth; ``--law``
takes the cases of one law.
"""

from __future__ import annotations

import argparse
import runpy
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import pam_cosim as pam
from benchmarks.results import append_result, read_results
from pam_cosim.study.tables import write_planned_runs

FOLDER = Path(__file__).resolve().parents[1] / "examples" / "bioreactor"
LIBRARY = FOLDER / "Bioreactor"
MOST = 3  # further runs
LIMITS = {"Q_in": ("0 l/h", "10 l/h")}


def solve(number: int, most: dict[str, int]) -> dict[str, Any]:
    """The verdicts of one case: before, and after each further run, so many of a kind, as long as there are rivals."""
    rig = runpy.run_path(str(FOLDER / "rig.py"))
    law = list(rig["RATES"])[number % len(rig["RATES"])]
    rng = np.random.default_rng(number)
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)

        def diagnosed(feeds: Sequence[Any]) -> Any:
            rig["write"](place / "data", law, feeds, number)
            return pam.diagnose(
                pam.read(place / "data", files=[LIBRARY]), files=[LIBRARY], workers=1, explain=False
            )

        def designed(diagnosis: Any) -> Any:
            write_planned_runs(
                place / "next.csv", pam.plan(diagnosis, limits=LIMITS, files=[LIBRARY])
            )
            return rig["feed_of"](place / "next.csv")

        def followed(next_feed: Callable[[Any], Any], most: int) -> list[dict[str, Any]]:
            feeds, diagnosis, outcomes = list(known), before, []
            while diagnosis.verdict.kind in ("ambiguous", "unknown") and len(outcomes) < most:
                feeds.append(next_feed(diagnosis))
                diagnosis = diagnosed(feeds)
                outcomes.append(_outcome(diagnosis, law))
            return outcomes

        known = [rig["NO_FEED"], rig["CAREFUL"]]
        before = diagnosed(known)
        further = {
            "designed": followed(designed, most["designed"]),
            "random": followed(lambda _: rig["drawn"](rng), most["random"]),
        }
    return {"number": number, "law": law, "before": _outcome(before, law), **further}


def _outcome(diagnosis: Any, law: str) -> dict[str, Any]:
    verdict = diagnosis.verdict
    word = verdict.kind
    if word == "identified":
        word = "right" if list(verdict.families) == [law] else "wrong"
    if word == "none_missing":
        word = "wrong"
    return {"outcome": word, "kind": verdict.kind, "families": list(verdict.families)}


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cases", type=int, default=0)
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--random", type=int, metavar="RUNS", help="random runs alone, so many")
    parser.add_argument("--law", help="cases of this law alone")
    options = parser.parse_args(arguments)
    most = {"designed": MOST, "random": MOST}
    if options.random:
        most = {"designed": 0, "random": options.random}
    laws = list(runpy.run_path(str(FOLDER / "rig.py"))["RATES"])
    numbers = [n for n in range(options.cases) if options.law in (None, laws[n % len(laws)])]
    results = list(read_results(options.results).values())
    for number in numbers[len(results) :]:
        results.append(solve(number, most))
        append_result(options.results, results[-1])
        print(results[-1], flush=True)
    print("before", dict(Counter(r["before"]["outcome"] for r in results)))
    asked = [r for r in results if r["random"]]
    for kind in ("designed", "random"):
        for count in range(1, most[kind] + 1):
            print(kind, count, dict(Counter(r[kind][:count][-1]["outcome"] for r in asked)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
