"""The next experiment as a person at the rig needs it: what to set, what to drive, what it will show."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import NextExperiment
from pam_cosim.reporting.account.wording import number, quantity_text
from pam_cosim.units import readable_factor, readable_unit
from pam_cosim.wording import enumeration, words

_MOST_ROWS = 40


def next_run(plan: NextExperiment | None) -> dict[str, Any] | None:
    """Rows of words and the run's table in readable units; None where there is none."""
    if plan is None:
        return None
    rows = [("Start from run", plan.run), ("Change", plan.change)]
    if plan.parameters:
        rows.append(("Set", _settings(plan)))
    rows.append(("To tell apart", enumeration([words(family) for family in plan.between])))
    rows.append(("Expected", expectation(plan)))
    return {
        "rows": rows,
        "heads": [_head(n, plan.units) for n in plan.table],
        "table": _lines(plan.table, plan.units)[:_MOST_ROWS],
        "left_out": max(len(next(iter(plan.table.values()))) - _MOST_ROWS, 0),
        "course": "each row a point at rest"
        if "time" not in plan.table
        else "each value holds until the next row"
        if plan.interpolation == "previous"
        else "straight between the rows",
    }


def expectation(plan: NextExperiment) -> str:
    """What the run is expected to show, however the rivals bend to it."""
    text = (
        f"{number(plan.separation)} noise standard deviations between the two (root mean square over all samples), "
        "after each is also refitted to this run"
    )
    decisive = number(CRITERIA.evidence.very_strong, 2)
    if not plan.decides:
        return (
            f"{text}; that is not enough to decide (chi-square {number(plan.evidence)}, very strong from {decisive} "
            "on): no variation of the recorded runs separates them, so measure another signal"
        )
    return f"{text} (chi-square {number(plan.evidence)}; {decisive} is very strong evidence)"


def next_run_line(plan: NextExperiment) -> str:
    """The next experiment in one line of plain text."""
    between = enumeration([words(family) for family in plan.between])
    settings = f"with {_settings(plan)}; " if plan.parameters else ""
    return f"run {plan.run}, {plan.change}; {settings}to separate {between}: {expectation(plan)}"


def _settings(plan: NextExperiment) -> str:
    return ", ".join(
        f"{n} = {quantity_text(v, plan.units[n], 4)}" for n, v in plan.parameters.items()
    )


def _head(name: str, units: Mapping[str, str]) -> str:
    unit = readable_unit("s" if name == "time" else units.get(name, ""))
    return f"{name} [{unit}]" if unit else name


def _lines(table: Mapping[str, list[float]], units: Mapping[str, str]) -> list[list[str]]:
    factors = [1.0 if n == "time" else readable_factor(units.get(n, "")) for n in table]
    return [
        [f"{v * f:.5g}" for v, f in zip(row, factors, strict=True)]
        for row in zip(*table.values(), strict=True)
    ]
