"""Draws docs/pictures/where-a-recording-begins.png: a run of the rig without its first seconds, from three starts.

python -m benchmarks.starts.picture [FILE]
"""

from __future__ import annotations

import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import pam_cosim as pam
from benchmarks.starts.cutting import Keep, cut_files
from pam_cosim.measurement import Start, StartMode
from rig.measurement import measure, write_data_set
from rig.plan import default_plan

CUT = 2.5  # s
STARTS: dict[StartMode, str] = {
    "rest": "tab:red",
    "measured": "tab:orange",
    "estimated": "tab:blue",
}
KNOWN = {"valve.C_A": 0.72, "muscle.mu_fb": 0.018}  # of the rig: the start alone is not


def _late(random: np.random.Generator) -> Keep:
    return lambda time, begin, end: time >= CUT


def drawn(file: Path) -> None:
    """Draws it."""
    with tempfile.TemporaryDirectory() as name:
        whole, late = Path(name) / "whole", Path(name) / "late"
        write_data_set(whole, measure(default_plan()[3:4], seed=1))
        data = pam.read(cut_files(whole, late, _late, 0))
    figure, axes = plt.subplots(2, 1, sharex=True, figsize=(8, 5))
    for panel, (signal, factor, label) in zip(
        axes, (("p", 1e-3, "p [kPa]"), ("x", 1e3, "x [mm]")), strict=True
    ):
        run = data.runs[0]
        panel.plot(
            run.time, run.measurements[signal] * factor, ".", color="0.75", ms=3, label="measured"
        )
        panel.set_ylabel(label)
        panel.grid(True, color="0.9")
    for mode, colour in STARTS.items():
        started = replace(data, runs=(replace(data.runs[0], start=Start(mode)),))
        compared = pam.compare(started, parameters=KNOWN)
        left = compared.chi2_reduced()
        for panel, (signal, factor) in zip(axes, (("p", 1e-3), ("x", 1e3)), strict=True):
            modelled = compared.runs[0].model[signal] * factor
            panel.plot(
                compared.runs[0].run.time,
                modelled,
                color=colour,
                lw=1.3,
                label=f"{mode}: chi2 {left:.3g}",
            )
    axes[0].legend(loc="upper right", fontsize=8)
    axes[1].set_xlabel("time [s]")
    figure.tight_layout()
    figure.savefig(file, dpi=110, metadata={"Software": None})


if __name__ == "__main__":
    drawn(Path(sys.argv[1] if len(sys.argv) > 1 else "docs/pictures/where-a-recording-begins.png"))
