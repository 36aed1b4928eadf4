"""One picture that tells the whole story: a run before and after, and the falling error."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import Signal
from pam_cosim.reporting.account.wording import unit_text, wrapped
from pam_cosim.reporting.figures.curves import draw_curves, legend
from pam_cosim.reporting.figures.ladder import Rung, draw_ladder, ladder_legend, roles_of
from pam_cosim.reporting.figures.layer import SPARSE, Layer
from pam_cosim.reporting.figures.panels import over
from pam_cosim.reporting.style import new_figure

_DOTS = SPARSE  # more would hide under the line


def showcase(
    layers: Sequence[Layer], rungs: Sequence[Rung], run: RunComparison, signal: Signal
) -> Figure:
    """Left: measured and modelled signal of one run. Right: the ladder of that signal."""
    figure = new_figure(9.0, 3.9)
    left, right = figure.subplots(1, 2, width_ratios=[1.75, 1.0] if len(rungs) < 3 else [1.35, 1.0])
    left.grid(True)
    every = -(-run.run.sample_count(signal.name) // _DOTS)
    draw_curves(left, run, signal, layers, every)
    unit = unit_text(signal.unit)
    left.set_ylabel(f"{signal.name} [{unit}]" if unit else signal.name)
    left.set_xlabel(over(run))
    kind = "a holdout run, never fitted" if run.run.role == "holdout" else "a fitted run"
    left.set_title(
        wrapped(f"{run.run.name}, {kind}", 40), loc="left", fontweight="bold", fontsize=9.5
    )
    handles = legend(layers, True, every)
    left.legend(
        handles=handles,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.16),
        ncols=len(handles),
        columnspacing=1.4,
    )
    draw_ladder(right, rungs, signal, size=8.5)
    right.set_title(f"error of {signal.name}", loc="left", fontweight="bold", fontsize=9.5)
    below = ladder_legend(roles_of(rungs))
    right.legend(
        handles=below,
        loc="upper center",
        bbox_to_anchor=(0.45, -0.16),
        ncols=len(below),
        columnspacing=1.2,
        handlelength=1.5,
    )
    return figure
