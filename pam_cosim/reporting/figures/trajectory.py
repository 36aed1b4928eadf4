"""One simulation: a panel for each output."""

from __future__ import annotations

from matplotlib.figure import Figure

from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import AFTER, new_figure
from pam_cosim.simulation import Trajectory
from pam_cosim.units import readable_factor

_WIDE = 6  # outputs up to which one column holds them


def trajectory_figure(trajectory: Trajectory) -> Figure:
    """Every signal of ``trajectory`` over time, in readable units."""
    names = list(trajectory.values)
    columns = 1 if len(names) <= _WIDE else 2
    rows = max(1, -(-len(names) // columns))
    figure = new_figure(8.0 * (1 if columns == 1 else 1.4), 0.7 + 1.7 * rows)
    grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
    for axes, name in zip(grid.T.ravel(), names, strict=False):
        si = trajectory.units.get(name, "")
        axes.plot(
            trajectory.time, trajectory.values[name] * readable_factor(si), color=AFTER, lw=1.5
        )
        unit = unit_text(si)
        axes.set_ylabel(f"{name} [{unit}]" if unit else name)
        axes.grid(True)
        axes.margins(x=0.01)
    for axes in grid.T.ravel()[len(names) :]:
        axes.set_visible(False)
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    figure.align_ylabels()
    return figure
