"""Tables and figures from the results of `score`.

    python -m benchmarks.hidden_effects.report build/hidden-effects-score.jsonl --out FOLDER

Writes report.md and its figures into OUT: hit-rate.png, confusion.png, outcomes.png, and where the results have them
breakdown.png (by bench, signals, rate and runs) and calibration.png (stated probabilities).

`--sums` names neither forms nor single cases, so that those of a score that is not done stay unknown.
"""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Sequence
from math import isfinite
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from benchmarks.hidden_effects.breakdown import (
    KEYS,
    breakdown_table,
    combination_table,
    draw_breakdown,
    instrument_table,
    time_table,
)
from benchmarks.hidden_effects.calibration import calibration_table, draw_calibration
from benchmarks.hidden_effects.goals import VISIBLE, goals_table, rate, single, visible, wilson
from benchmarks.hidden_effects.outcome import (
    INSTRUMENTS,
    OUTCOMES,
    excess,
    judged,
    size,
    stated_probability,
)
from benchmarks.hidden_effects.score import default_file
from benchmarks.results import read_results
from blind_cases.table import FAMILIES

plt.switch_backend("Agg")

Result = dict[str, Any]
EDGES = (0.0, 0.3, 1.0, 3.0, 10.0, 30.0, float("inf"))  # standard deviations of the noise
GROUPS = {
    "catalogue": "one effect, form in the catalogue",
    "new_form": "one effect, form not in the catalogue",
    "pair": "two effects",
    "triple": "three effects",
    "instrument": "a faulty instrument",
    "null": "nothing hidden",
    "none_of_these": "an effect in no family",
}
_COLOURS = {
    "right": "#2a7f4f", "ambiguous": "#8fbf6a", "unknown": "#d9c25b", "missed": "#b8bec6", "wrong": "#c0504d",
    "error": "#3b3b3b",
}  # fmt: skip


def outcome_table(results: Sequence[Result]) -> list[str]:
    """Markdown: outcomes by group."""
    lines = [
        "| hidden | cases | " + " | ".join(OUTCOMES) + " |",
        "|---|---|" + "---|" * len(OUTCOMES),
    ]
    for group, text in GROUPS.items():
        chosen = [r for r in results if r["case"].get("group") == group]
        if not chosen:
            continue
        count = Counter(judged(r) for r in chosen)
        lines.append(
            f"| {text} | {len(chosen)} | " + " | ".join(str(count[o]) for o in OUTCOMES) + " |"
        )
    return lines


def strength_table(results: Sequence[Result]) -> list[str]:
    """Markdown: share of right verdicts by size, for groups that hide something."""
    names = [_bin_name(low, high) for low, high in zip(EDGES[:-1], EDGES[1:], strict=True)]
    lines = [
        "| size in noise standard deviations | " + " | ".join(names) + " |",
        "|---|" + "---|" * len(names),
    ]
    for group, text in GROUPS.items():
        if group == "null" or not any(r["case"].get("group") == group for r in results):
            continue
        cells = []
        for chosen in _binned(results, group):
            cells.append(
                rate(sum(judged(r) == "right" for r in chosen), len(chosen)) if chosen else ""
            )
        lines.append(f"| {text} | " + " | ".join(cells) + " |")
    return lines


def _bin_name(low: float, high: float) -> str:
    if low == 0:
        return f"below {high:g}"
    return f"{low:g} to {high:g}" if isfinite(high) else f"above {low:g}"


def _binned(results: Sequence[Result], group: str) -> list[list[Result]]:
    chosen = [r for r in results if r["case"].get("group") == group]
    return [
        [r for r in chosen if low <= size(r) < high]
        for low, high in zip(EDGES[:-1], EDGES[1:], strict=True)
    ]


def confusion(results: Sequence[Result]) -> tuple[list[str], list[str], np.ndarray]:
    """Rows: what is hidden; columns: what was found; counts. Combinations are left out.

    An ambiguous verdict stands in its own column, whether or not it holds the truth; an identified combination in
    "several".
    """
    families = list(FAMILIES)
    if any(r["case"].get("group") in ("instrument", "triple") for r in results):
        families += [family for family in INSTRUMENTS if family not in families]
    # a family that nobody knew of when this was written stands in a column of its own as well
    named = {
        f for r in results for f in r.get("diagnosis", {}).get("verdict", {}).get("families", [])
    }
    rows = [*families, "none_of_these", "nothing"]
    columns = [
        *families,
        *sorted(named - set(families)),
        "several",
        "ambiguous",
        "unknown",
        "none_missing",
        "error",
    ]
    counts = np.zeros((len(rows), len(columns)), dtype=int)
    for r in results:
        group = r["case"].get("group")
        if group in ("pair", "triple"):
            continue
        row = (
            "nothing"
            if group == "null"
            else group
            if group == "none_of_these"
            else r["case"]["families"][0]
        )
        counts[rows.index(row), columns.index(_found(r))] += 1
    return rows, columns, counts


def _found(result: Result) -> str:
    if "error" in result:
        return "error"
    verdict = result["diagnosis"]["verdict"]
    if verdict["kind"] != "identified":
        return str(verdict["kind"])
    return str(verdict["families"][0]) if len(verdict["families"]) == 1 else "several"


def confusion_table(results: Sequence[Result]) -> list[str]:
    """Markdown: the confusion matrix; zeros are left out."""
    rows, columns, counts = confusion(results)
    lines = ["| hidden \\ found | " + " | ".join(columns) + " |", "|---|" + "---|" * len(columns)]
    for name, row in zip(rows, counts, strict=True):
        lines.append(f"| {name} | " + " | ".join(str(v) if v else "" for v in row) + " |")
    return lines


def family_table(results: Sequence[Result]) -> list[str]:
    """Markdown: right verdicts by family and form, all sizes and visible ones."""
    lines = ["| family | form | all sizes | at least 3 |", "|---|---|---|---|"]
    groups: dict[tuple[str, str], list[Result]] = {}
    for r in results:
        if r["case"].get("group") in ("catalogue", "new_form", "instrument", "none_of_these"):
            hidden = r["case"]["hidden"][0]
            listed = hidden.get("in_catalogue", r["case"]["group"] != "new_form")
            star = "" if listed or hidden["family"] == "none_of_these" else " *"
            groups.setdefault((hidden["family"], hidden["form"] + star), []).append(r)
    for family, form in sorted(groups):
        chosen = groups[family, form]
        seen = [r for r in chosen if visible(r)]
        right = [sum(judged(r) == "right" for r in some) for some in (chosen, seen)]
        lines.append(
            f"| {family} | {form} | {right[0]} of {len(chosen)} | {right[1]} of {len(seen)} |"
        )
    return lines


def failures_table(results: Sequence[Result]) -> list[str]:
    """Markdown: every case of the goals that was not right, for the reader who wants to look."""
    lines = ["| case | bench | hidden | size | verdict | named |", "|---|---|---|---|---|---|"]
    for r in sorted(results, key=lambda r: int(r["number"])):
        if judged(r) == "right" or (
            (single(r) or r["case"].get("group") == "instrument") and not visible(r)
        ):
            continue
        hidden = (
            " + ".join(f"{h['family']}:{h['form']}" for h in r["case"].get("hidden", []))
            or "nothing"
        )
        verdict = r.get("diagnosis", {}).get(
            "verdict", {"kind": f"error: {r.get('error', {}).get('where')}"}
        )
        named = " + ".join(verdict.get("effects", []))
        bench = r["case"].get("bench", "Isotonic")
        lines.append(
            f"| {r['number']} | {bench} | {hidden} | {size(r):.1f} | {verdict['kind']} | {named} |"
        )
    return lines


def draw_hit_rate(results: Sequence[Result], file: Path) -> None:
    """Share of right verdicts over size, with Wilson's intervals, for what is hidden alone and for combinations."""
    figure, axes = plt.subplots(figsize=(7.0, 4.2), layout="constrained")
    marks = (
        ("catalogue", "o"),
        ("new_form", "s"),
        ("pair", "^"),
        ("triple", "v"),
        ("instrument", "D"),
    )
    shown = [
        (group, marker)
        for group, marker in marks
        if any(r["case"].get("group") == group for r in results)
    ]
    for k, (group, marker) in enumerate(shown):
        shift = 1.04 ** (k - len(shown) // 2)
        x, y, low, high = [], [], [], []
        for chosen in _binned(results, group):
            if chosen:
                hits = sum(judged(r) == "right" for r in chosen)
                ends = wilson(hits, len(chosen))
                x.append(
                    shift * float(np.exp(np.mean(np.log([max(size(r), 0.05) for r in chosen]))))
                )
                y.append(hits / len(chosen))
                low.append(y[-1] - ends[0])
                high.append(ends[1] - y[-1])
        # rounding may leave an interval's end a hair on the wrong side
        bars = np.maximum([low, high], 0.0) if x else None
        axes.errorbar(x, y, bars, marker=marker, capsize=3, label=GROUPS[group])
    axes.axhline(0.95, color="0.6", linestyle=":")
    axes.axvline(VISIBLE, color="0.6", linestyle=":")
    axes.set(xscale="log", ylim=(-0.03, 1.03), ylabel="right verdicts",
             xlabel="size of the effect that no base parameter makes up for, in noise standard deviations")  # fmt: skip
    if shown:
        figure.legend(loc="outside upper center", ncols=2, frameon=False)
    figure.savefig(file, dpi=150)
    plt.close(figure)


def draw_confusion(results: Sequence[Result], file: Path) -> None:
    """The confusion matrix of cases with a size of at least 3, and of those without a size."""
    chosen = [r for r in results if visible(r) or r["case"].get("group") == "null"]
    rows, columns, counts = confusion(chosen)
    shares = counts / np.maximum(counts.sum(axis=1, keepdims=True), 1)
    size_of = (3.0 + 0.32 * len(columns), 2.0 + 0.28 * len(rows))
    figure, axes = plt.subplots(figsize=size_of, layout="constrained")
    axes.imshow(shares, cmap="Blues", vmin=0, vmax=1)
    for (i, j), count in np.ndenumerate(counts):
        if count:
            axes.text(
                j,
                i,
                str(count),
                ha="center",
                va="center",
                color="white" if shares[i, j] > 0.6 else "black",
            )
    axes.set_xticks(range(len(columns)), columns, rotation=60, ha="right")
    axes.set_yticks(range(len(rows)), rows)
    axes.set(xlabel="found", ylabel="hidden (visible at 3 standard deviations or more)")
    figure.savefig(file, dpi=150)
    plt.close(figure)


def draw_outcomes(results: Sequence[Result], file: Path) -> None:
    """Outcomes by group, as shares."""
    figure, axes = plt.subplots(figsize=(7.5, 2.8), layout="constrained")
    groups = [group for group in GROUPS if any(r["case"].get("group") == group for r in results)]
    for k, group in enumerate(groups):
        chosen = [r for r in results if r["case"].get("group") == group]
        count, left = Counter(judged(r) for r in chosen), 0.0
        for outcome in OUTCOMES:
            share = count[outcome] / max(len(chosen), 1)
            axes.barh(
                k, share, left=left, color=_COLOURS[outcome], label=outcome if k == 0 else None
            )
            left += share
    axes.set_yticks(range(len(groups)), [GROUPS[group] for group in groups])
    axes.invert_yaxis()
    axes.set(xlim=(0, 1), xlabel="share of cases, all sizes")
    figure.legend(loc="outside upper center", ncols=len(OUTCOMES), frameon=False)
    figure.savefig(file, dpi=150)
    plt.close(figure)


def report(results: Sequence[Result], note: str = "", *, sums: bool = False) -> str:
    """The page as Markdown, with a note at its top; of ``sums`` alone, it names neither forms nor single cases."""
    times = [float(r["seconds"]) for r in results if "seconds" in r]
    middle = (
        f"{np.median(times):.0f} s in the middle, {max(times):.0f} s at most"
        if times
        else "not known"
    )
    away = [
        e
        for r in results
        if (e := excess(r)) is not None and r["diagnosis"]["verdict"]["kind"] == "identified"
    ]
    spread = (
        f"Holdout chi-square of identified cases over that of the truth's own noise: {1 + np.median(away):.3f} in the "
        f"middle, {1 + np.quantile(away, 0.9):.3f} at the 90 % quantile."
        if away
        else "No case was identified."
    )
    lines = [
        "# Hidden effects: the blind score", "",
        f"{len(results)} cases of the set `{'`, `'.join(sorted({str(r['set']) for r in results}))}`. The data come "
        "from a simulator that shares no code with the software (`rig`). "
        "Size means: root mean square of what the effect changes, on the signal that shows it most, in standard "
        "deviations of that signal's noise, after the free base parameters moved to make up for it; of several "
        "effects the smallest one. Right means: identified with exactly the hidden families, or with others that give "
        "the very same data.", "",
        f"Time of one diagnosis: {middle}. {spread}", "",
        *([note, ""] if note else []),
        "## Goals", "", *goals_table(results), "",
        "## Outcomes", "", *outcome_table(results), "",
        "*Unknown* under \"nothing hidden\": the noise was taken for structure, but no effect was claimed.", "",
        "![Outcomes](outcomes.png)", "",
        "## Hit rate by size", "", *strength_table(results), "",
        "![Hit rate by size](hit-rate.png)", "",
        *_broken_down(results),
        "## Stated probabilities", "", *calibration_table(results), "",
        *(["![Calibration](calibration.png)", ""] if any(stated_probability(r) for r in results) else []),
        "## What is taken for what", "", "All sizes; the figure shows those of at least 3.", "",
        *confusion_table(results), "",
        "![Confusion](confusion.png)", "",
        *([] if sums else _singled_out(results)),
    ]  # fmt: skip
    return "\n".join(lines)


def _singled_out(results: Sequence[Result]) -> list[str]:
    """Forms and cases by their names."""
    return [
        "## By form", "", "A star marks forms that the catalogue lacks.", "", *family_table(results), "",
        "## Cases that were not right", "", "Single effects below 3 standard deviations are left out here.", "",
        *failures_table(results), "",
    ]  # fmt: skip


def _broken_down(results: Sequence[Result]) -> list[str]:
    """What only several benches, combinations and instruments have to tell; and the time."""
    lines = ["## Time and memory", "", *time_table(results, GROUPS), ""]
    if any("bench" in r["case"] for r in results):
        begins = ("start",) if any("start" in r["case"] for r in results) else ()
        for by in (*KEYS, *begins):
            lines += [f"## By {by}", "", *breakdown_table(results, by), ""]
        lines += ["![By bench, signals, rate and runs](breakdown.png)", ""]
        lines += ["## Faulty instruments", "", *instrument_table(results), ""]
    if any(r["case"].get("group") in ("pair", "triple") for r in results):
        lines += ["## Families of combinations", "", *combination_table(results), ""]
    return lines


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("results", type=Path, nargs="?", default=default_file("score"))
    parser.add_argument(
        "--out", type=Path, default=None, help="folder; default: beside the results"
    )
    parser.add_argument(
        "--note", default="", help="what else must be known, such as how times were measured"
    )
    parser.add_argument("--sums", action="store_true", help="name neither forms nor single cases")
    options = parser.parse_args(arguments)
    results = list(read_results(options.results).values())
    if not results:
        parser.error(f"{options.results} holds no results; run score.py first")
    out = options.out or options.results.with_suffix("")
    out.mkdir(parents=True, exist_ok=True)
    (out / "report.md").write_text(report(results, options.note, sums=options.sums))
    draw_hit_rate(results, out / "hit-rate.png")
    draw_confusion(results, out / "confusion.png")
    draw_outcomes(results, out / "outcomes.png")
    draw_calibration(results, out / "calibration.png")
    if any("bench" in r["case"] for r in results):
        draw_breakdown(results, out / "breakdown.png")
    print("\n".join([*goals_table(results), "", *outcome_table(results)]))
    print(f"\n{out / 'report.md'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
