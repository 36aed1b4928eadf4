"""Planned runs: what to drive, what each rival predicts of it, and by how much the rivals differ."""

from __future__ import annotations

from itertools import cycle
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pam_cosim.diagnosis.planning import PlannedRun, RunPlan
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import BALANCES, BAND, FURTHER, INK, new_figure
from pam_cosim.units import format_quantity, readable_factor

_LETTERS = 110  # of a line of the title
_STYLES = ("-", "--", ":", "-.")


def plan_figure(plan: RunPlan) -> Figure:
    """A column for each run: its inputs, the signals that the models predict, and their differences to the first."""
    inputs = [name for name in plan.runs[0].table if name != "time"]
    moving = [name for name in inputs if any(len(set(run.table[name])) > 1 for run in plan.runs)]
    signals = list(plan.sigma)
    rows = len(moving) + len(signals) + 1
    figure = new_figure(8.0 if len(plan.runs) == 1 else 11.0, 1.2 + 1.5 * rows)
    grid = figure.subplots(rows, len(plan.runs), sharex="col", sharey="row", squeeze=False)
    for j, run in enumerate(plan.runs):
        for i, name in enumerate(moving):
            _input(grid[i, j], plan, run, name)
        for i, name in enumerate(signals, len(moving)):
            _signal(grid[i, j], plan, run, name)
        _differences(grid[-1, j], plan, run)
        grid[-1, j].set_xlabel("time [s]")
        grid[0, j].set_title(_title(plan, run, inputs, moving))
    for i, name in enumerate([*moving, *signals]):
        unit = unit_text(plan.units[name])
        grid[i, 0].set_ylabel(f"{name} [{unit}]" if unit else name)
    grid[len(moving), 0].legend(loc="best")
    grid[-1, 0].set_ylabel("difference [sd of the noise]")
    grid[-1, 0].legend(loc="best", ncols=len(signals))
    figure.suptitle(fill(plan.expectation, _LETTERS), fontsize=8.5)
    figure.align_ylabels()
    return figure


def _input(axes: Axes, plan: RunPlan, run: PlannedRun, name: str) -> None:
    values = np.array(run.table[name]) * readable_factor(plan.units[name])
    axes.plot(run.table["time"], values, color=INK, lw=1.2)
    axes.grid(True)


def _signal(axes: Axes, plan: RunPlan, run: PlannedRun, name: str) -> None:
    factor = readable_factor(plan.units[name])
    for k, rival in enumerate(plan.rivals):
        style = "--" if k else "-"
        axes.plot(
            run.time,
            run.predicted[rival][name] * factor,
            color=_colour(k),
            lw=1.2,
            ls=style,
            label=rival,
        )
    axes.grid(True)


def _differences(axes: Axes, plan: RunPlan, run: PlannedRun) -> None:
    """Each rival minus the first one, a line style for each signal."""
    reference, *competitors = plan.rivals
    axes.axhspan(-2, 2, color=BAND, lw=0)
    for k, rival in enumerate(competitors, 1):
        for style, (name, sigma) in zip(cycle(_STYLES), plan.sigma.items()):
            apart = (run.predicted[rival][name] - run.predicted[reference][name]) / sigma
            axes.plot(run.time, apart, color=_colour(k), lw=1.2, ls=style, label=f"{name}, {rival}")
    axes.grid(True)


def _colour(rival: int) -> str:
    colours = (BALANCES[2], *FURTHER)
    return colours[rival % len(colours)]


def _title(plan: RunPlan, run: PlannedRun, inputs: list[str], moving: list[str]) -> str:
    constant = {name: run.table[name][0] for name in inputs if name not in moving}
    values = {**constant, **run.parameters}
    return ", ".join(f"{n} = {format_quantity(v, plan.units[n], 4)}" for n, v in values.items())
