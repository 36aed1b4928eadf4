"""What the software wants to reach, and what it reached."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import isfinite, sqrt
from typing import Any

import numpy as np

from benchmarks.hidden_effects.outcome import (
    claims_effect,
    excess,
    judged,
    leaves_remainder,
    names_instruments,
    size,
)

Result = dict[str, Any]
VISIBLE = 3.0  # standard deviations of the noise


def wilson(hits: int, count: int, z: float = 1.96) -> tuple[float, float]:
    """The 95 % interval of a share (Wilson, 1927); (0, 1) without cases."""
    if not count:
        return 0.0, 1.0
    share, room = hits / count, z * z / count
    middle = (share + room / 2) / (1 + room)
    half = z * sqrt(share * (1 - share) / count + room / (4 * count)) / (1 + room)
    return max(0.0, middle - half), min(1.0, middle + half)


def rate(hits: int, count: int) -> str:
    """Share, its interval and the numbers, for a table."""
    if not count:
        return "no case"
    low, high = wilson(hits, count)
    return f"{100 * hits / count:.3g} % ({100 * low:.0f} to {100 * high:.0f}; {hits} of {count})"


@dataclass(frozen=True)
class Goal:
    """A share of cases that should be right, and which count for it; None where no share is asked for."""

    text: str
    share: float | None
    cases: Callable[[Result], bool]
    hit: Callable[[Result], bool]


def single(result: Result) -> bool:
    """Whether one effect of one of the families is hidden."""
    return result["case"].get("group") in ("catalogue", "new_form")


def group(name: str) -> Callable[[Result], bool]:
    """Whether a case is of a group."""
    return lambda result: bool(result["case"].get("group") == name)


def visible(result: Result) -> bool:
    """Whether what is hidden is large enough; a case that ended before its size was known counts as that."""
    return size(result) >= VISIBLE or not isfinite(size(result))


def right(result: Result) -> bool:
    """Whether the verdict is as it should be."""
    return judged(result) == "right"


def _identified_with_holdout(result: Result) -> bool:
    if "error" in result or result["diagnosis"]["verdict"]["kind"] != "identified":
        return False
    return "holdout" in result["diagnosis"]["chi2"]


GOALS = (
    Goal("one effect of at least 3 standard deviations: right family", 0.97, lambda r: single(r) and visible(r), right),
    Goal("... with a form of the catalogue", 0.97, lambda r: group("catalogue")(r) and visible(r), right),
    Goal("... with a form that the catalogue lacks", 0.95, lambda r: group("new_form")(r) and visible(r), right),
    Goal("... and with a verdict that leaves only noise, not just the form open", None,
         lambda r: group("new_form")(r) and visible(r), lambda r: right(r) and not leaves_remainder(r)),
    Goal("two effects of at least 3 standard deviations each: both found", 0.92,
         lambda r: group("pair")(r) and visible(r), right),
    Goal("three effects of at least 3 standard deviations each: all found", 0.75,
         lambda r: group("triple")(r) and visible(r), right),
    Goal("nothing hidden: no effect claimed", 0.99, group("null"), lambda r: "error" not in r and not claims_effect(r)),
    Goal("an effect in no family: unknown, ambiguous or named as an instrument", 0.93,
         lambda r: group("none_of_these")(r) and visible(r), right),
    Goal("a faulty instrument of at least 3 standard deviations: right family", None,
         lambda r: group("instrument")(r) and visible(r), right),
    Goal("... named as an instrument, of whichever family", None,
         lambda r: group("instrument")(r) and visible(r), names_instruments),
    Goal("identified cases: holdout chi-square within 10 % of the noise's own", 0.98, _identified_with_holdout,
         lambda r: (away := excess(r)) is not None and away <= 0.1),
)  # fmt: skip


@dataclass(frozen=True)
class Limit:
    """What a case may cost: a statistic of all that are known, and its bound."""

    text: str
    unit: str
    bound: float
    quantity: str
    statistic: Callable[[Sequence[float]], float]


LIMITS = (
    Limit("time of a diagnosis, in the middle", "s", 5.0, "seconds", lambda y: float(np.median(y))),
    Limit(
        "time of a diagnosis, 95 % of cases",
        "s",
        30.0,
        "seconds",
        lambda y: float(np.quantile(y, 0.95)),
    ),
    Limit("time of a diagnosis, longest", "s", 60.0, "seconds", max),
    Limit("memory, most", "MB", 1000.0, "megabytes", max),
)


def goals_table(results: Sequence[Result]) -> list[str]:
    """Markdown: every goal, what was reached, whether it is met."""
    lines = ["| goal | wanted | reached (95 % interval) | met |", "|---|---|---|---|"]
    for goal in GOALS:
        chosen = [r for r in results if goal.cases(r)]
        hits = sum(goal.hit(r) for r in chosen)
        wanted = "-" if goal.share is None else f"{100 * goal.share:.0f} %"
        met = (
            "-"
            if not chosen or goal.share is None
            else "yes"
            if hits >= goal.share * len(chosen)
            else "no"
        )
        lines.append(f"| {goal.text} | {wanted} | {rate(hits, len(chosen))} | {met} |")
    for limit in LIMITS:
        known = [float(r[limit.quantity]) for r in results if limit.quantity in r]
        if known:
            reached = limit.statistic(known)
            met = "yes" if reached <= limit.bound else "no"
            lines.append(
                f"| {limit.text} | {limit.bound:g} {limit.unit} | {reached:.3g} {limit.unit} | {met} |"
            )
    return lines
