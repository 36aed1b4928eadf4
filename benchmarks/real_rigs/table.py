"""Collects the results of a folder and writes the table: python -m benchmarks.real_rigs.table [FOLDER].

With a folder, ``results.json`` beside this file is made anew from ``FOLDER/results``; ``TABLE.md`` is made from that.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.real_rigs.rows import overall, read_rows

HERE = Path(__file__).resolve().parent
KEPT = HERE / "results.json"
OURS = ("base", "verdict", "learned")
RIVALS = ("formula", "NARX", "network", "SINDy", "polynomial", "boosting")
DYNAMIC = ("hose", "robot", "muscle", "muscle-leak", "chamber-leak", "vessel", "tunnel")
STATIC = ("map-20", "map-398")
LEAKS = tuple(f"muscle-leak-{n}" for n in (1, 2, 4, 5, 6, 7))
MEMBERS = {"muscle-leak": LEAKS, "tunnel": ("tunnel-in", "tunnel-out")}
RIGS = tuple(m for rig in (*DYNAMIC, *STATIC) for m in MEMBERS.get(rig, (rig,)))
REPEATS = {
    "hoses of 2 to 8 m": ("hose", *(f"hose-{n}m" for n in range(7, 1, -1))),
    "muscle, tests 3 and 7, or 4 and 8": ("muscle", "muscle-repeat"),
    "leak of the muscle, experiments 4 to 7": LEAKS[2:],
    "jumps of the robot, three pairs": ("robot", "robot-80", "robot-80-others"),
}
NAMES = {"base": "**base**", "verdict": "**verdict**", "learned": "**+ learned**"}
AS_GOOD = (
    1.05  # of the best rival's error within the range that still counts as no worse; the protocol
)

Result = dict[str, Any]


def collect(folder: Path) -> dict[str, Result]:
    """All results by "rig.method", with what repeats of the rig differ by.

    Rivals that were not run in this folder keep the results that they had.
    """
    kept = _of_rivals()
    for path in sorted((folder / "results").glob("*.json")):
        said = json.loads(path.read_text(encoding="utf-8"))
        said["repeatability"] = read_rows(folder / said["rig"]).repeatability
        said["scores"] = {
            role: {k: round(v, 6) for k, v in own.items()} for role, own in said["scores"].items()
        }
        said["seconds"] = round(said["seconds"], 2)
        kept[path.stem] = said
    return kept


def _of_rivals() -> dict[str, Result]:
    """What is kept of the rivals."""
    results = json.loads(KEPT.read_text(encoding="utf-8"))
    return {name: r for name, r in results.items() if r["method"] in RIVALS}


def members(rig: str) -> Sequence[str]:
    """The rigs that a line of the table is the root mean square of."""
    return MEMBERS.get(rig, (rig,))


def error(results: Mapping[str, Result], rig: str, method: str, role: str) -> float | None:
    """In ranges; None where there is nothing to score."""
    found = [results.get(f"{m}.{method}") for m in members(rig)]
    scores = [r["scores"].get(role) for r in found if r is not None]
    if not scores or not all(scores) or len(scores) < len(found):
        return None
    return float(np.sqrt(np.mean([overall(s) ** 2 for s in scores if s])))


def line(results: Mapping[str, Result], rig: str, method: str) -> list[str] | None:
    """One row of the table; None where the method was not run on the rig."""
    own = [r for m in members(rig) if (r := results.get(f"{m}.{method}")) is not None]
    if not own:
        return (
            ["", NAMES[method], "-", "-", "-", "-", "nothing is written"]
            if method == "learned"
            else None
        )
    cells = []
    for role in ("within", "outside"):
        value = error(results, rig, method, role)
        cells.append(_percent(value, own[0]["repeatability"]))
    counts = [r["coefficients"] for r in own if r.get("coefficients") is not None]
    seconds = sum(r["seconds"] for r in own) / len(own)
    reading = own[0].get("reading") or own[0].get("size") or own[0].get("failed", "")
    if len(own) > 1 and method in OURS:
        reading = "; ".join(dict.fromkeys(r["reading"] for r in own if r["reading"]))
    if len(own) < len(members(rig)):
        reading = f"written for {len(own)} of {len(members(rig))}: {reading}"
    count = f"{np.mean(counts):.0f}" if counts else "-"
    return ["", NAMES.get(method, method), *cells, f"{seconds:.2g}", count, _short(str(reading))]


def _percent(value: float | None, repeatability: float | None) -> str:
    if value is None:
        return "-"
    if value >= 1:
        return "lost" if value >= 5 else f"{100 * value:.0f}"
    text = f"{100 * value:.2f}"
    return text + (f" ({value / repeatability:.1f})" if repeatability else "")


def _short(text: str, most: int = 110) -> str:
    text = text.replace("|", "/")
    return text if len(text) <= most else text[: most - 3] + "..."


def best(
    results: Mapping[str, Result], rig: str, methods: Sequence[str], role: str
) -> tuple[float, str] | None:
    """The smallest error of some methods, and whose it is."""
    found = [(e, m) for m in methods if (e := error(results, rig, m, role)) is not None]
    return min(found, default=None)


def goal(results: Mapping[str, Result], rig: str) -> tuple[list[str], bool]:
    """How this software stands to the best rival within and outside, and whether the goal is met on the rig."""
    cells, met = [rig], True
    for role, bound in (("within", AS_GOOD), ("outside", 0.5)):
        ours, rival = (best(results, rig, m, role) for m in (("verdict", "learned"), RIVALS))
        if ours is None or rival is None:
            cells.append("-")
            continue
        ratio = ours[0] / rival[0]
        repeatability = results[f"{members(rig)[0]}.verdict"]["repeatability"]
        met &= ratio <= bound or (
            role == "within" and repeatability is not None and ours[0] <= repeatability
        )
        cells.append(f"{ratio:.2f} ({rival[1]})")
    return [*cells, "yes" if met else "no"], met


def verdicts(results: Mapping[str, Result]) -> list[list[str]]:
    """How many verdicts of repeats agree with the commonest, how many name the same families, and the verdicts."""
    rows = []
    for title, rigs in REPEATS.items():
        own = [results[f"{r}.verdict"] for r in rigs if f"{r}.verdict" in results]
        said, families = [_said(r) for r in own], [_families(r) for r in own]
        if said:
            listed = "; ".join(dict.fromkeys(f"{said.count(v)} {v}" for v in said))
            rows.append([title, _alike(said), _alike(families), listed])
    return rows


def _alike(said: Sequence[str]) -> str:
    return f"{max(said.count(v) for v in said)} of {len(said)}"


def _families(result: Result) -> str:
    """The families of the model that the diagnosis ends with, also where the verdict is ``unknown``."""
    return str(result["reading"].split(": ")[1])


def _said(result: Result) -> str:
    kind = result["reading"].split(":")[0]
    return "unknown" if kind == "unknown" else f"{kind}: {' or '.join(sorted(result['named']))}"


def markdown(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(row) + " |" for row in lines)


def page(results: Mapping[str, Result]) -> str:
    """TABLE.md."""
    head = [
        "rig",
        "method",
        "within [%]",
        "outside [%]",
        "time [s]",
        "numbers",
        "what one can read",
    ]
    parts = []
    for title, rigs in (("Over time", DYNAMIC), ("At rest", STATIC)):
        rows = []
        for rig in rigs:
            lines = [own for m in (*OURS, *RIVALS) if (own := line(results, rig, m)) is not None]
            if lines:
                lines[0][0] = f"`{rig}`"
                rows += lines
        parts.append(f"## {title}\n\n{markdown(head, rows)}")
    judged = [goal(results, rig) for rig in DYNAMIC if f"{members(rig)[0]}.verdict" in results]
    goals = markdown(["rig", "within", "outside", "goal"], [cells for cells, _ in judged])
    same = verdicts(results)
    agreeing, every = (sum(int(row[1].split(" of ")[i]) for row in same) for i in (0, 1))
    same_families = sum(int(row[2].split(" of ")[0]) for row in same)
    versions = sorted({r["version"] for r in results.values()})
    return f"""# Rigs of others: results

Made by `python -m benchmarks.real_rigs.table` by the rules of the [protocol](PROTOCOL.md). Errors are those of free
runs, in per cent of the range of the signal, and in brackets over what repeats differ by; *lost*: five ranges and more.
Time is processor time.
{", ".join(versions)}.

{parts[0]}

{parts[1]}

## Goal

Error of the better of *verdict* and *+ learned* over that of the best rival (its name in brackets). The goal asks for
no more than {AS_GOOD} within and 0.5 outside, on four of five rigs. **It is met on
{sum(met for _, met in judged)} of {len(judged)}.**

{goals}

## Verdicts on repeats

**{agreeing} of {every}** ({100 * agreeing / every:.0f} %) as the commonest of their kind; the goal is 90 %.
`unknown` counts as one verdict: models of the same families, whatever the verdict is, come out in
{same_families} of {every}.

{markdown(["repeats", "same verdict", "same families", "verdicts"], same)}
"""


def main(arguments: Sequence[str]) -> None:
    """Collects, where a folder is given, and writes the page."""
    if arguments:
        KEPT.write_text(json.dumps(collect(Path(arguments[0])), indent=1) + "\n", encoding="utf-8")
    results = json.loads(KEPT.read_text(encoding="utf-8"))
    (HERE / "TABLE.md").write_text(page(results), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
