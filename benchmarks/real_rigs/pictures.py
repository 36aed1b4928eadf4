"""Draws one picture a rig: python -m benchmarks.real_rigs.pictures FOLDER. Writes into docs/pictures/real-rigs."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from benchmarks.real_rigs.folders import Array
from benchmarks.real_rigs.rows import Course, Rows, overall, read_rows
from benchmarks.real_rigs.table import RIVALS

PICTURES = Path(__file__).resolve().parents[2] / "docs" / "pictures" / "real-rigs"
COLOURS = {"verdict": "#0072b2", "learned": "#009e73", "base": "0.6"}
RIVAL = "#d55e00"
SHOWN = {
    "hose": ("within/l8-p3-fill-a", "outside/l8-p7-fill-a", "outside/l8-p7-vent-a"),
    "robot": ("within/0p09-65", "outside/0p06-80", "outside/0p12-80"),
    "muscle": ("within/x13-test3", "outside/x33-test3"),
    "muscle-leak-5": ("outside/whole",),
    "chamber-leak": ("outside/whole",),
    "vessel": ("within/discharge", "outside/filling"),
    "tunnel-in": ("outside/steps",),
    "tunnel-out": ("outside/steps",),
    "map-20": ("within/between", "outside/above"),
    "map-398": ("within/x36", "outside/x70"),
}
UNITS = {
    "hose": "bar",
    "muscle": "N",
    "map-20": "N",
    "map-398": "N",
    "tunnel-in": "rad/s",
    "tunnel-out": "rad/s",
}
QUANTITIES = {"N": "force", "rad/s": "speed"}
TITLES = {"verdict": "verdict", "learned": "verdict + learned", "base": "base model"}


def best_rival(folder: Path, rig: str, role: str) -> str:
    """The rival with the smallest error in a role."""
    errors = {}
    for method in RIVALS:
        path = folder / "results" / f"{rig}.{method}.json"
        if path.is_file():
            scores = json.loads(path.read_text(encoding="utf-8"))["scores"].get(role)
            if scores:
                errors[method] = overall(scores)
    return min(errors, key=lambda m: errors[m])


def predicted(folder: Path, rig: str, method: str, key: str) -> Array | None:
    """What a method said of a course; None where it said nothing."""
    path = folder / "results" / f"{rig}.{method}.npz"
    if not path.is_file():
        return None
    with np.load(path) as kept:
        return np.asarray(kept[key]) if key in kept else None


def draw_course(axis: Axes, folder: Path, rows: Rows, course: Course, key: str) -> None:
    """Measured and predicted, over time or over pressure."""
    role = key.split("/")[0]
    at = course.inputs[:, 0] if rows.static else course.time
    order = np.argsort(at, kind="stable")
    every = max(1, len(at) // 400)
    axis.plot(
        at[order][::every],
        course.measured[order][::every],
        ".",
        color="0.25",
        ms=4,
        label="measured",
        zorder=1,
    )
    rival = best_rival(folder, rows.name, role)
    for method in ("base", rival, "verdict", "learned"):
        values = predicted(folder, rows.name, method, key)
        if values is None:
            continue
        style: dict[str, Any] = {
            "color": COLOURS.get(method, RIVAL),
            "label": TITLES.get(method, "best rival"),
        }
        if rows.static:
            marker = {"base": "x", "verdict": "o"}.get(method, "+")
            axis.plot(at[order], values[order], marker, mfc="none", ms=6, **style)
        else:
            axis.plot(at, values, lw=1.4, ls="--" if method == "base" else "-", **style)
    if np.isfinite(course.score_from) and course.score_from > course.time[0]:
        axis.axvspan(course.time[0], course.score_from, color="0.92", zorder=0, label="fitted")
    span = np.nanmax(course.measured) - np.nanmin(course.measured)
    axis.set_ylim(
        np.nanmin(course.measured) - 0.15 * span, np.nanmax(course.measured) + 0.25 * span
    )
    axis.set_title(f"{role}: {course.name} (best rival: {rival})", fontsize=9)
    axis.set_xlabel("pressure [kPa]" if rows.static else "time [s]")
    axis.grid(alpha=0.3)


def draw(folder: Path, rig: str) -> None:
    """The picture of one rig."""
    rows = read_rows(folder / rig)
    keys = SHOWN[rig]
    figure, axes = plt.subplots(
        1, len(keys), figsize=(4.2 * len(keys) + 1, 3.4), layout="constrained", squeeze=False
    )
    for axis, key in zip(axes[0], keys, strict=True):
        role, name = key.split("/")
        draw_course(axis, folder, rows, next(c for c in rows.courses[role] if c.name == name), key)
    unit = UNITS.get(rig, "kPa")
    axes[0, 0].set_ylabel(f"{QUANTITIES.get(unit, 'pressure')} [{unit}]")
    axes[0, -1].legend(fontsize=7)
    PICTURES.mkdir(parents=True, exist_ok=True)
    figure.savefig(PICTURES / f"{rig.removesuffix('-5')}.png", dpi=90)
    plt.close(figure)


def main(folder: Path) -> None:
    """All pictures."""
    for rig in SHOWN:
        draw(folder, rig)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
