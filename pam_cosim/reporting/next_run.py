"""The next experiment as a person at the rig needs it: what to set, what to drive, what it will show."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pam_cosim.criteria import CRITERIA
from pam_cosim.quantities import readable_factor, readable_unit
from pam_cosim.reporting.wording import listed, number, quantity, words

_MOST_ROWS = 40


def next_run(found: Mapping[str, Any] | None) -> dict[str, Any] | None:
    """Rows of words and the run's table in readable units; None where there is none."""
    if not found:
        return None
    units: Mapping[str, str] = found.get("units") or {}
    rows = [("Start from run", str(found["run"])), ("Change", str(found["change"]))]
    settings = [f"{n} = {quantity(v, units.get(n, ''), 4)}" for n, v in (found.get("parameters") or {}).items()]
    if settings:
        rows.append(("Set", ", ".join(settings)))
    if found.get("between"):
        rows.append(("To tell apart", listed([words(str(f)) for f in found["between"]])))
    expected = expectation(found)
    if expected:
        rows.append(("Expected", expected))
    table: Mapping[str, list[float]] = found.get("table") or {}
    steps = found.get("interpolation") == "previous"
    return {
        "rows": rows,
        "heads": [_head(n, units) for n in table],
        "table": _lines(table, units)[:_MOST_ROWS],
        "left_out": max(len(table.get("time", ())) - _MOST_ROWS, 0),
        "course": "each value holds until the next row" if steps else "straight between the rows",
    }


def expectation(found: Mapping[str, Any]) -> str:
    """What the run is expected to show, however the rivals bend to it."""
    separation, evidence = found.get("separation"), found.get("evidence")
    if separation is None:
        return ""
    text = (
        f"{number(separation)} noise standard deviations between the two, root mean square over all samples, after "
        "either is refitted to this run as well"
    )
    if evidence is None:
        return text
    decisive = CRITERIA.evidence.very_strong
    if evidence < decisive:
        return (
            f"{text}; that is not enough to decide (chi-square {number(evidence)}, very strong from "
            f"{number(decisive, 2)} on): no variation of the runs at hand tells them apart, measure another signal"
        )
    return f"{text} (chi-square {number(evidence)}; {number(decisive, 2)} is very strong evidence)"


def next_run_line(found: Mapping[str, Any]) -> str:
    """The next experiment in one line of plain text."""
    settings = ", ".join(str(v) for k, v in next_run(found)["rows"] if k == "Set")  # type: ignore[index]
    between = listed([words(str(f)) for f in found.get("between") or ()])
    change = str(found["change"])
    where = f"with {settings}; " if settings else ""
    return f"run {found['run']}, {change}; {where}to tell {between} apart: {expectation(found)}"


def _head(name: str, units: Mapping[str, str]) -> str:
    unit = readable_unit("s" if name == "time" else units.get(name, ""))
    return f"{name} [{unit}]" if unit else name


def _lines(table: Mapping[str, list[float]], units: Mapping[str, str]) -> list[list[str]]:
    factors = [1.0 if n == "time" else readable_factor(units.get(n, "")) for n in table]
    return [[f"{v * f:.5g}" for v, f in zip(row, factors, strict=True)] for row in zip(*table.values(), strict=True)]
