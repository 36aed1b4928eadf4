"""Draws the bioreactor: python -m benchmarks.bioreactor_picture GROWTH.npz RESULTS.jsonl OUT.png.

GROWTH.npz is what ``diagnose --save`` wrote, RESULTS.jsonl what ``benchmarks.bioreactor`` wrote.
"""

from __future__ import annotations

import runpy
import sys
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

import pam_cosim as pam
from benchmarks.bioreactor import FOLDER, LIBRARY, LIMITS, MOST
from benchmarks.results import read_results

COLOURS = {"designed": "#0072b2", "random": "#d55e00"}


def draw(diagnosis: Path, results: Path, target: Path) -> None:
    """The designed run as the rivals predict it and as it came; and how often the law was found."""
    figure, axes = plt.subplots(1, 2, figsize=(10, 3.6))
    left = pam.load(diagnosis)
    assert isinstance(left, pam.Diagnosis)
    _run(axes[0], left)
    _shares(axes[1], list(read_results(results).values()))
    figure.tight_layout()
    figure.savefig(target, dpi=110)


def _run(axis: Axes, left: pam.Diagnosis) -> None:
    """One designed run: what each rival predicts, and the samples that were then taken."""
    run = pam.plan(left, limits=LIMITS, files=[LIBRARY]).runs[0]
    for name, values in run.predicted.items():
        axis.plot(run.time / 3600, values["C_S"], label=f"{name} predicts")
    rig = runpy.run_path(str(FOLDER / "rig.py"))
    feed = np.array(run.table["time"]) / 3600, np.array(run.table["Q_in"]) * rig["FLOWS"]["m3/s"]
    noise = rig["NOISE"] * np.random.default_rng((1, 2)).standard_normal(len(rig["HOURS"]))
    axis.plot(
        rig["HOURS"], rig["substrate"](rig["RATES"]["monod"], feed) + noise, "k.", label="samples"
    )
    axis.set_title("The run that was designed", fontsize=10)
    axis.set_xlabel("time [h]")
    axis.set_ylabel("substrate [g/l]")
    axis.grid(alpha=0.25)
    axis.legend(frameon=False)


def _shares(axis: Axes, results: list[dict[str, Any]]) -> None:
    asked = [r for r in results if r["designed"]]
    for kind, colour in COLOURS.items():
        right = [sum(r["before"]["outcome"] == "right" for r in asked)]
        right += [
            sum(r[kind][:n][-1]["outcome"] == "right" for r in asked) for n in range(1, MOST + 1)
        ]
        axis.plot(
            range(MOST + 1),
            100 * np.array(right) / len(asked),
            "o-",
            color=colour,
            label=f"{kind} feeds",
        )
    axis.set_xticks(range(MOST + 1))
    axis.set_xlabel("further runs")
    axis.set_ylabel(f"right law [% of {len(asked)} cases]")
    axis.set_ylim(0, 100)
    axis.grid(alpha=0.25)
    axis.legend(frameon=False)


if __name__ == "__main__":
    draw(*(Path(word) for word in sys.argv[1:4]))
