"""What counts as right."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Result = Mapping[str, Any]
INSTRUMENTS = (
    "pressure_offset", "thermocouple_lag", "position_sensor", "force_sensor", "pressure_sensor_lag",
    "temperature_sensor", "clock_offset", "wrong_parameter", "saturation", "quantisation",
)  # fmt: skip
"""Families of which a verdict counts as having named an instrument."""
OUTCOMES = ("right", "ambiguous", "unknown", "missed", "wrong", "error")
"""right: as it should be. ambiguous: the truth is among the families named as not separable. unknown: "something else
is missing". missed: "nothing is missing". wrong: other families are claimed. error: no verdict."""


def size(result: Result) -> float:
    """What free parameters leave of what is hidden, on the signal that shows it most; of several the smallest."""
    case = result.get("case", {})
    if "size" not in case:
        return float("nan")
    each = [float(h.get("refitted", h["size"])) for h in case["hidden"]]
    if len(each) > 1 or any("refitted" in h for h in case["hidden"]):
        return min(each)
    return max(float(v) for v in case["size"]["projected"].values())


def judged(result: Result) -> str:
    """One of OUTCOMES.

    One family or several: right is identified with exactly these, or with others that the case says give the very same
    data; if the base model does, right is none_missing too, as for readings in steps and nothing else. Nothing hidden:
    right is none_missing; unknown claims no effect either, and is counted by its own name. An effect in no family:
    unknown and ambiguous are right, and so is what names instruments alone; another identified family is wrong.
    """
    if "error" in result:
        return "error"
    verdict = result["diagnosis"]["verdict"]
    kind, named = verdict["kind"], set(verdict["families"])
    group, true = result["case"]["group"], set(result["case"]["families"])
    if group == "none_of_these":
        right = kind in ("unknown", "ambiguous") or names_instruments(result)
        return "right" if right else "missed" if kind == "none_missing" else "wrong"
    if group == "null":
        if kind == "none_missing":
            return "right"
        return "unknown" if kind == "unknown" and not named else "wrong"
    same = [true, *(set(families) for families in result["case"].get("same_as", []))]
    if kind == "none_missing":
        return "right" if true == {"quantisation"} or set() in same else "missed"
    if kind == "unknown":
        return "unknown"
    if kind == "ambiguous":
        meant = [families for families in same if families and families <= named]
        if len(meant) > 1 and named == set().union(*meant):
            return "right"  # these data cannot tell them apart, and the verdict says just that
        return "ambiguous" if meant else "wrong"
    return "right" if named in same else "wrong"


def names_instruments(result: Result) -> bool:
    """Whether the verdict blames faults of instruments, of whichever family, and nothing else."""
    if "error" in result:
        return False
    verdict = result["diagnosis"]["verdict"]
    return (
        verdict["kind"] in ("identified", "ambiguous")
        and bool(verdict["families"])
        and (set(verdict["families"]) <= set(INSTRUMENTS))
    )


def stated_probability(result: Result) -> tuple[float, bool] | None:
    """What the verdict gave as the probability of what it says, and whether that is so; None where it gave none.

    An ambiguous verdict is so where the truth is among what it names, which an effect in no family never is, whatever
    the verdict is worth. `unknown` states nothing that could be so.
    """
    if "error" in result or result["diagnosis"]["verdict"]["kind"] == "unknown":
        return None
    value = result["diagnosis"].get("probability")
    if value is None:
        return None
    if result["diagnosis"]["verdict"]["kind"] != "ambiguous":
        return float(value), judged(result) == "right"
    known = result["case"]["group"] != "none_of_these"
    return float(value), known and judged(result) in ("right", "ambiguous")


def claims_effect(result: Result) -> bool:
    """Whether the verdict names a family, as missing or as one that may be."""
    return "error" not in result and bool(result["diagnosis"]["verdict"]["families"])


def leaves_remainder(result: Result) -> bool:
    """Whether a family is identified by a verdict which says itself that what remains has structure."""
    return "error" not in result and bool(result["diagnosis"]["verdict"].get("remainder"))


def excess(result: Result) -> float | None:
    """Holdout chi-square of the final model over that of the truth's own noise, minus one.

    None without a verdict, or without a run to judge by.
    """
    chi2 = None if "error" in result else result["diagnosis"]["chi2"].get("holdout")
    return None if chi2 is None else float(chi2["final"] / chi2["noise"] - 1)
