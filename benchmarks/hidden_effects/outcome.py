"""What counts as right."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Result = Mapping[str, Any]
OUTCOMES = ("right", "ambiguous", "unknown", "missed", "wrong", "error")
"""right: as it should be. ambiguous: the truth is among the families named as not separable. unknown: "something else
is missing". missed: "nothing is missing". wrong: other families are claimed. error: no verdict."""


def size(result: Result) -> float:
    """The projected size of what is hidden on the signal that shows it most; of a pair, that of the weaker effect."""
    case = result.get("case", {})
    if "size" not in case:
        return float("nan")
    if len(case["hidden"]) > 1:
        return min(float(h["size"]) for h in case["hidden"])
    return max(float(v) for v in case["size"]["projected"].values())


def judged(result: Result) -> str:
    """One of OUTCOMES.

    One family or a pair: right is identified with exactly these. Nothing hidden: right is none_missing; unknown claims
    no effect either, and is counted by its own name. An effect in no family: unknown and ambiguous are right, an
    identified family is wrong.
    """
    if "error" in result:
        return "error"
    verdict = result["diagnosis"]["verdict"]
    kind, named = verdict["kind"], set(verdict["families"])
    group, true = result["case"]["group"], set(result["case"]["families"])
    if group == "none_of_these":
        return {"unknown": "right", "ambiguous": "right", "none_missing": "missed"}.get(kind, "wrong")
    if group == "null":
        if kind == "none_missing":
            return "right"
        return "unknown" if kind == "unknown" and not named else "wrong"
    if kind == "none_missing":
        return "missed"
    if kind == "unknown":
        return "unknown"
    if kind == "ambiguous":
        return "ambiguous" if true <= named else "wrong"
    return "right" if named == true else "wrong"


def claims_effect(result: Result) -> bool:
    """Whether the verdict names a family, as missing or as one that may be."""
    return "error" not in result and bool(result["diagnosis"]["verdict"]["families"])


def leaves_remainder(result: Result) -> bool:
    """Whether a family is identified by a verdict which says itself that what remains has structure."""
    return "error" not in result and bool(result["diagnosis"]["verdict"].get("remainder"))


def excess(result: Result) -> float | None:
    """Holdout chi-square of the final model over that of the truth's own noise, minus one; None without a verdict."""
    if "error" in result:
        return None
    chi2 = result["diagnosis"]["chi2"]["holdout"]
    return float(chi2["final"] / chi2["noise"] - 1)
