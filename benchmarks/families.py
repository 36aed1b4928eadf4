"""The blind score: every effect of the independent rig, hidden once per seed, diagnosed, and counted.

    python benchmarks/families.py                      every form, one seed, six runs of 10 s each
    python benchmarks/families.py --seeds 1,2,3 --light
    python benchmarks/families.py --forms none,leak:orifice,creep:linear+leak:orifice --random

``--light`` takes the two short runs that the tests use; ``--random`` a random plan for each seed. Several effects are
joined by a plus sign. The last column of the table says whether the verdict is right: identified with exactly the
hidden families, or none_missing; an ambiguous verdict that holds them all counts as half right.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from pam_cosim import Diagnosis, study  # noqa: E402
from tests.reference.effects import EFFECTS, effect_name, effect_of  # noqa: E402
from tests.reference.plan import default_plan, random_plan  # noqa: E402
from tests.reference.rig import measure, write_data_set  # noqa: E402
from tests.systems.rig import write_light_data  # noqa: E402


@dataclass(frozen=True)
class Score:
    """One diagnosis: 1 right, 0.5 ambiguous with the hidden families among those named, 0 wrong."""

    hidden: str
    value: float
    false_alarm: bool


def main(arguments: Sequence[str] | None = None) -> None:
    """Runs the benchmark and prints its table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--forms", default=",".join(["none", *(effect_name(e) for e in EFFECTS[1:])]))
    parser.add_argument("--seeds", default="1")
    parser.add_argument("--light", action="store_true")
    parser.add_argument("--random", action="store_true")
    parser.add_argument("--workers", type=int, default=None)
    options = parser.parse_args(arguments)
    print(
        f"{'hidden':30} {'seed':>4} {'time':>6}  {'verdict':12} {'base':>8} {'fit':>6} {'hold':>6}  found", flush=True
    )
    scores = []
    for hidden in options.forms.split(","):
        for seed in map(int, options.seeds.split(",")):
            with tempfile.TemporaryDirectory() as name:
                folder = Path(name) / "data"
                _write(folder, hidden, seed, options)
                start = time.perf_counter()
                found = study.diagnose(study.read(folder), workers=options.workers)
                scores.append(_report(hidden, seed, time.perf_counter() - start, found))
    right = sum(s.value == 1 for s in scores)
    half = sum(s.value == 0.5 for s in scores)
    alarms = sum(s.false_alarm for s in scores)
    print(f"{right} of {len(scores)} right, {half} ambiguous with the truth named, {alarms} named a wrong family")


def _effects(hidden: str) -> list:  # type: ignore[type-arg]
    return [] if hidden == "none" else [effect_of(name) for name in hidden.split("+")]


def _write(folder: Path, hidden: str, seed: int, options: argparse.Namespace) -> None:
    if options.light:
        write_light_data(folder, _effects(hidden), seed)
    else:
        plan = random_plan(seed) if options.random else default_plan()
        write_data_set(folder, measure(plan, _effects(hidden), seed))


def _report(hidden: str, seed: int, seconds: float, found: Diagnosis) -> Score:
    verdict = found.verdict
    true = sorted(e.family for e in _effects(hidden))
    exact = sorted(verdict.families) == true and verdict.kind in ("identified", "none_missing")
    among = verdict.kind == "ambiguous" and all(f in verdict.families for f in true)
    wrong = verdict.kind == "identified" and not all(f in true for f in verdict.families)
    base, final = found.base.comparison, found.final.comparison
    mark = "right" if exact else "ambiguous" if among else "WRONG" if wrong else "missed"
    parameters = ", ".join(f"{n}={e.value:.4g}" for c in found.path for n, e in c.parameters.items())
    print(
        f"{hidden:30} {seed:4d} {seconds:5.0f}s  {verdict.kind:12} {base.chi2_reduced('fit'):8.2f} "
        f"{final.chi2_reduced('fit'):6.3f} {final.chi2_reduced('holdout'):6.3f}  {mark:9} "
        f"{'+'.join(verdict.effects) or '-'} {parameters}",
        flush=True,
    )
    return Score(hidden, 1.0 if exact else 0.5 if among else 0.0, wrong)


if __name__ == "__main__":
    main()
