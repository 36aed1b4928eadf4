"""Where it is right more often and less often: by bench, by what is measured, by rate and runs; and what it costs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from benchmarks.hidden_effects.goals import rate, right, visible, wilson
from benchmarks.hidden_effects.outcome import INSTRUMENTS, judged, names_instruments

Result = dict[str, Any]
Key = Callable[[dict[str, Any]], str]

_HIDES = ("catalogue", "new_form", "pair", "triple", "instrument", "none_of_these")
_RUNS = ((1, 1), (2, 3), (4, 6), (7, 12), (13, 20))


def _bench(case: dict[str, Any]) -> str:
    return str(case.get("bench", "Isotonic"))


def _signals(case: dict[str, Any]) -> str:
    return ", ".join(case.get("signals", ("p", "x", "T")))


def _rate(case: dict[str, Any]) -> str:
    return f"{case.get('rate', 100.0):g} Hz"


def _runs(case: dict[str, Any]) -> str:
    runs = int(case.get("runs", 6))
    low, high = next((a, b) for a, b in _RUNS if a <= runs <= b)
    return f"{low} to {high} runs" if high > low else f"{low} run"


def _start(case: dict[str, Any]) -> str:
    return {
        "stated": "in the middle, stated",
        "unstated": "in the middle, not stated",
    }.get(case.get("start", ""), "at rest")


KEYS: dict[str, Key] = {"bench": _bench, "measured": _signals, "rate": _rate, "runs": _runs}
_TABLES = {**KEYS, "start": _start}
"""With where recordings begin, of which only some sets have more than one kind."""


def _order(names: Sequence[str]) -> list[str]:
    """Numbers by size, the rest by the alphabet."""
    return sorted(
        names,
        key=lambda name: (float(first) if (first := name.split(" ")[0]).isdigit() else -1.0, name),
    )


def _by(results: Sequence[Result], key: Key) -> dict[str, list[Result]]:
    chosen: dict[str, list[Result]] = {}
    for r in results:
        chosen.setdefault(key(r["case"]), []).append(r)
    return {name: chosen[name] for name in _order(list(chosen))}


def _columns(chosen: Sequence[Result]) -> list[tuple[int, int]]:
    """Right and all: single effects, combinations, instruments (visible ones each), nothing hidden, no family."""
    parts = (
        ("catalogue", "new_form"),
        ("pair", "triple"),
        ("instrument",),
        ("null",),
        ("none_of_these",),
    )
    counted = []
    for groups in parts:
        some = [
            r
            for r in chosen
            if r["case"].get("group") in groups and (groups[0] not in _HIDES or visible(r))
        ]
        counted.append((sum(right(r) for r in some), len(some)))
    return counted


def breakdown_table(results: Sequence[Result], by: str) -> list[str]:
    """Markdown: right verdicts by one of KEYS or by `start`, hidden effects of at least 3 standard deviations."""
    lines = [
        f"| {by} | one effect | two or three | an instrument | nothing | in no family | time in the middle |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, chosen in _by(results, _TABLES[by]).items():
        cells = [rate(hits, count) if count else "" for hits, count in _columns(chosen)]
        times = [float(r["seconds"]) for r in chosen if "seconds" in r]
        middle = f"{np.median(times):.3g} s" if times else ""
        lines.append(f"| {name} | {' | '.join(cells)} | {middle} |")
    return lines


def time_table(results: Sequence[Result], groups: dict[str, str]) -> list[str]:
    """Markdown: seconds and megabytes of a diagnosis by group."""
    lines = [
        "| hidden | cases | median [s] | 95 % [s] | longest [s] | processor time in the middle [s] | "
        "memory in the middle [MB] | most [MB] |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for group, text in [*groups.items(), ("", "all")]:
        chosen = [r for r in results if not group or r["case"].get("group") == group]
        times = [float(r["seconds"]) for r in chosen if "seconds" in r]
        memory = [float(r["megabytes"]) for r in chosen if "megabytes" in r]
        busy = [float(r["processor_seconds"]) for r in chosen if "processor_seconds" in r]
        if times:
            processor = f"{np.median(busy):.3g}" if busy else ""
            spent = f"{np.median(times):.3g} | {np.quantile(times, 0.95):.3g} | {max(times):.3g}"
            used = f"{np.median(memory):.0f} | {max(memory):.0f}" if memory else " | "
            lines.append(f"| {text} | {len(chosen)} | {spent} | {processor} | {used} |")
    return lines


def combination_table(results: Sequence[Result]) -> list[str]:
    """Markdown: of combinations, how often each hidden family was named, and each that is not hidden."""
    lines = [
        "| family | hidden in | named there | named where it is not hidden |",
        "|---|---|---|---|",
    ]
    chosen = [r for r in results if r["case"].get("group") in ("pair", "triple")]
    named = {
        id(r): set(r.get("diagnosis", {}).get("verdict", {}).get("families", [])) for r in chosen
    }
    families = sorted(
        {f for r in chosen for f in r["case"]["families"]} | set().union(*named.values(), set())
    )
    for family in families:
        inside = [r for r in chosen if family in r["case"]["families"]]
        seen = sum(family in named[id(r)] for r in inside)
        false = sum(family in named[id(r)] for r in chosen if family not in r["case"]["families"])
        lines.append(f"| {family} | {len(inside)} | {seen} | {false} |")
    return lines


def instrument_table(results: Sequence[Result]) -> list[str]:
    """Markdown: faults of instruments by family: outcomes, and how many were named as any instrument."""
    lines = ["| instrument | cases | right | named as an instrument | ambiguous | unknown | missed | wrong or error |",
             "|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for family in INSTRUMENTS:
        some = [
            r
            for r in results
            if r["case"].get("group") == "instrument" and r["case"]["families"] == [family]
        ]
        if some:
            said = [judged(r) for r in some]
            counts = [said.count(o) for o in ("ambiguous", "unknown", "missed")]
            rest = said.count("wrong") + said.count("error")
            cells = [
                len(some),
                said.count("right"),
                sum(names_instruments(r) for r in some),
                *counts,
                rest,
            ]
            lines.append(f"| {family} | {' | '.join(str(c) for c in cells)} |")
    return lines


def draw_breakdown(results: Sequence[Result], file: Path) -> None:
    """Share of right verdicts, with Wilson's intervals, by bench, by what is measured, by rate and runs.

    What is hidden counts where it is visible; of cases that hide nothing all do.
    """
    counted = [r for r in results if r["case"].get("group") not in _HIDES or visible(r)]
    figure, axes = plt.subplots(2, 2, figsize=(10.5, 6.4), layout="constrained")
    for axis, (by, key) in zip(axes.flat, KEYS.items(), strict=True):
        chosen = _by(counted, key)
        for k, some in enumerate(chosen.values()):
            hits = sum(right(r) for r in some)
            share, ends = hits / len(some), wilson(hits, len(some))
            axis.barh(k, share, color="#8fb4d6")
            axis.errorbar(
                share,
                k,
                xerr=np.maximum([[share - ends[0]], [ends[1] - share]], 0.0),
                color="0.3",
                capsize=3,
            )
            axis.text(0.01, k, str(len(some)), va="center", fontsize=8)
        axis.set_yticks(range(len(chosen)), list(chosen))
        axis.invert_yaxis()
        axis.set(xlim=(0, 1), title=f"by {by}")
    figure.supxlabel("right verdicts")
    figure.savefig(file, dpi=150)
    plt.close(figure)
