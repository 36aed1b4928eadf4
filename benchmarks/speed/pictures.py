"""The pictures of ``docs/results.md``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.figure import Figure

_FOLDER = Path(__file__).resolve().parents[2] / "docs" / "pictures"
# Told apart by colour-blind readers.
_COLOURS = ("#0072b2", "#d55e00", "#cc79a7", "#009e73", "#56b4e9", "#e69f00")

plt.rcParams.update({"font.size": 8, "axes.grid": True, "grid.alpha": 0.3})


def draw_run(measured: Mapping[str, Mapping[str, Sequence[Mapping[str, float]]]]) -> Path:
    """Time against error: case to solver to points as ``run.measure`` returns them."""
    names = list(dict.fromkeys(solver for solvers in measured.values() for solver in solvers))
    picture, axes = plt.subplots(
        1, len(measured), figsize=(9.0, 3.4), layout="constrained", sharey=True, squeeze=False
    )
    shown = {}
    for ax, (case, solvers) in zip(axes[0], measured.items(), strict=True):
        for solver, points in solvers.items():
            number = names.index(solver)
            style = {
                "color": _COLOURS[number % len(_COLOURS)],
                "marker": "osv^Dx"[number % 6],
                "ms": 3.5,
                "lw": 1.2,
            }
            (shown[solver],) = ax.loglog(
                [p["error"] for p in points], [p["least"] * 1e3 for p in points], **style
            )
        ax.set_title(case, loc="left", fontweight="bold")
        ax.set_xlabel("error, part of the output's range [-]")
        ax.set_xlim(1e-1, 1e-9)
    axes[0, 0].set_ylabel("time of a run [ms]")
    picture.legend(shown.values(), shown.keys(), loc="outside lower center", ncols=6, frameon=False)
    return _save(picture, "speed-run")


def draw_precision(measured: Mapping[str, Sequence[Mapping[str, float]]]) -> Path:
    """Tolerance, error and time of each bench with states; points as ``precision.Point`` has them."""
    names = [name for name in measured if max(p["steps"] for p in measured[name]) > 0]
    columns = 3
    rows = -(-len(names) // columns)
    picture, axes = plt.subplots(
        rows, columns, figsize=(9.0, 2.3 * rows), layout="constrained", sharex=True, squeeze=False
    )
    for name, ax in zip(names, axes.flat, strict=False):
        points = measured[name]
        tolerances = [p["tolerance"] for p in points]
        ax.loglog(tolerances, tolerances, color="0.6", lw=1, label="error = tolerance")
        ax.loglog(
            tolerances,
            [p["outputs"] for p in points],
            "o-",
            ms=4,
            color="#0072b2",
            label="error, outputs",
        )
        ax.loglog(
            tolerances,
            [p["states"] for p in points],
            "s--",
            ms=4,
            color="#009e73",
            label="error, states",
        )
        ax.set_title(name, loc="left", fontweight="bold")
        ax.set_ylim(1e-11, 1e-3)
        time = ax.twinx()
        time.plot(
            tolerances,
            [p["seconds"] * 1e3 for p in points],
            "^:",
            ms=4,
            color="#d55e00",
            label="time of a run",
        )
        time.set_ylim(0, None)
        time.grid(False)
        time.tick_params(axis="y", colors="#d55e00")
        ax.set_ylabel("relative error [-]")
        time.set_ylabel("time [ms]", color="#d55e00")
        handles, labels = (
            a + b
            for a, b in zip(
                ax.get_legend_handles_labels(), time.get_legend_handles_labels(), strict=True
            )
        )
    axes[0, 0].invert_xaxis()
    for ax in axes.flat[len(names) :]:
        ax.set_axis_off()
    for ax in axes[-1]:
        ax.set_xlabel("tolerance asked for [-]")
    picture.legend(handles, labels, loc="outside lower center", ncols=4, frameon=False)
    return _save(picture, "speed-precision")


def _save(picture: Figure, name: str) -> Path:
    path = _FOLDER / f"{name}.png"
    picture.savefig(path, dpi=110)
    plt.close(picture)
    return path
