"""Results as a table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any

import numpy as np

from benchmarks.hidden_effects.outcome import OUTCOMES

Result = Mapping[str, Any]
RUNS = ("designed", "random")


def table(results: Sequence[Result]) -> str:
    """Markdown: verdicts after one run more, by the verdict before."""
    asked = [r for r in results if "first" in r]
    lines = [
        f"{len(asked)} cases were diagnosed from their first recording; {sum('further' in r for r in asked)} "
        f"verdicts left rivals; {len(results) - len(asked)} cases could not be run.",
        "",
        "| verdict before | the truth among those named | one run more | cases | "
        + " | ".join(OUTCOMES)
        + " |",
        "|---|---|---|---|" + "---|" * len(OUTCOMES),
    ]
    for kind in ("ambiguous", "unknown"):
        for named in (True, False):
            chosen = [r for r in asked if "further" in r and _before(r) == (kind, named)]
            for run in RUNS if chosen else ():
                counts = [sum(r["further"][run]["outcome"] == o for r in chosen) for o in OUTCOMES]
                said = "yes" if named else "no"
                lines.append(
                    f"| {kind} | {said} | {run} | {len(chosen)} | {' | '.join(map(str, counts))} |"
                )
    lines += ["", *_summary([r for r in asked if "further" in r])]
    return "\n".join(lines) + "\n"


def _before(result: Result) -> tuple[str, bool]:
    """Kind of the first verdict, and whether what is hidden is among what it names or is left."""
    first = result["first"]
    true = set(result["case"]["families"])
    return first["verdict"]["kind"], true <= set(first["verdict"]["families"])


def _summary(further: Sequence[Result]) -> list[str]:
    if not further:
        return []
    lines = []
    for run in RUNS:
        right = sum(r["further"][run]["outcome"] == "right" for r in further)
        chi2 = [r["further"][run]["expected_chi2"] for r in further]
        known = [c for c in chi2 if c is not None and isfinite(c)]
        lines.append(
            f"- {run}: right in {right} of {len(further)}; expected chi-square of the nearest pair "
            f"{np.median(known):.3g} in the median."
        )
    seconds = np.median([r["further"]["design_seconds"] for r in further])
    return [*lines, f"- A design took {seconds:.1f} s in the median."]
