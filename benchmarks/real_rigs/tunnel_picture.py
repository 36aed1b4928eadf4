"""Draws the wind tunnel: python -m benchmarks.real_rigs.tunnel_picture FOLDER VERDICT.mo OUT.png.

FOLDER is that of ``benchmarks.real_rigs.tunnel``; VERDICT.mo what ``diagnose -o`` wrote for its fitted runs.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import pam_cosim as pam

LIBRARY = Path(__file__).resolve().parents[2] / "examples" / "wind-tunnel" / "WindTunnel"
RPM = 30 / np.pi
SIGNALS = {"w_in": ("speed of the intake [rpm]", RPM), "w_out": ("speed of the exhaust [rpm]", RPM)}
CURRENT = {"i_in": ("current of the intake [mA]", 1e3)}
COLUMNS = (
    ("fitted", "zero_load", "fitted: exhaust switched off at 18.7 s", SIGNALS),
    ("outside", "steps", "predicted: exhaust at full load from 22.5 s", SIGNALS),
    ("fitted", "steps-first", "fitted: current", CURRENT),
)


def draw(folder: Path, verdict: Path, target: Path) -> None:
    """Speeds of both fans and a current: measured, by the published model and by that of the verdict."""
    figure, axes = plt.subplots(2, 3, figsize=(12, 5.5), gridspec_kw={"width_ratios": [3, 3, 2]})
    for column, (role, name, title, signals) in enumerate(COLUMNS):
        data = pam.read(folder / "tunnel" / role, files=[LIBRARY])
        for model, label, style in (
            (None, "published model", "0.55"),
            (str(verdict), "verdict", "#0072b2"),
        ):
            compared = pam.compare(data, model, files=[LIBRARY])
            (run,) = (one for one in compared.runs if Path(one.run.name).stem == name)
            for axis, (signal, (words, factor)) in zip(
                axes[:, column], signals.items(), strict=False
            ):
                axis.plot(
                    run.run.time, factor * run.model[signal], color=style, lw=1.3, label=label
                )
                axis.set_ylabel(words)
        for axis, (signal, (_, factor)) in zip(axes[:, column], signals.items(), strict=False):
            axis.plot(
                run.run.time, factor * run.run.measurements[signal], "k.", ms=2.5, label="measured"
            )
            axis.grid(alpha=0.25)
            axis.set_xlabel("time [s]")
        axes[0, column].set_title(title, fontsize=10)
    axes[1, 2].axis("off")
    axes[1, 2].legend(*axes[0, 0].get_legend_handles_labels(), loc="center", frameon=False)
    figure.tight_layout()
    figure.savefig(target, dpi=110)


if __name__ == "__main__":
    draw(*(Path(word) for word in sys.argv[1:4]))
