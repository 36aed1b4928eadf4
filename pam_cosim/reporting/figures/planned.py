"""Planned runs: what to drive, and what each rival foretells of it."""

from __future__ import annotations

from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pam_cosim.diagnosis.planning import PlannedRun, RunPlan
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import BALANCES, BAND, FURTHER, INK, new_figure
from pam_cosim.units import format_quantity, readable_factor

_LETTERS = 110  # of a line of the title


def plan_figure(plan: RunPlan) -> Figure:
    """A column for each run: its inputs, and the signals that the models foretell, with their noise as a band."""
    inputs = [name for name in plan.runs[0].table if name != "time"]
    moving = [name for name in inputs if any(len(set(run.table[name])) > 1 for run in plan.runs)]
    signals = list(plan.sigma)
    rows = len(moving) + len(signals)
    figure = new_figure(8.0 if len(plan.runs) == 1 else 11.0, 1.2 + 1.5 * rows)
    grid = figure.subplots(rows, len(plan.runs), sharex="col", sharey="row", squeeze=False)
    for j, run in enumerate(plan.runs):
        for i, name in enumerate(moving):
            _input(grid[i, j], plan, run, name)
        for i, name in enumerate(signals, len(moving)):
            _signal(grid[i, j], plan, run, name)
        grid[-1, j].set_xlabel("time [s]")
        grid[0, j].set_title(_title(plan, run, inputs, moving))
    for i, name in enumerate([*moving, *signals]):
        unit = unit_text(plan.units[name])
        grid[i, 0].set_ylabel(f"{name} [{unit}]" if unit else name)
    grid[len(moving), 0].legend(loc="best")
    figure.suptitle(fill(plan.expectation, _LETTERS), fontsize=8.5)
    figure.align_ylabels()
    return figure


def _input(axes: Axes, plan: RunPlan, run: PlannedRun, name: str) -> None:
    values = np.array(run.table[name]) * readable_factor(plan.units[name])
    axes.plot(run.table["time"], values, color=INK, lw=1.2)
    axes.grid(True)


def _signal(axes: Axes, plan: RunPlan, run: PlannedRun, name: str) -> None:
    factor, sigma = readable_factor(plan.units[name]), plan.sigma[name]
    for k, rival in enumerate(plan.rivals):
        values, colour = run.predicted[rival][name] * factor, (BALANCES[2], *FURTHER)[k % (1 + len(FURTHER))]
        if not k:
            around = 2 * sigma * factor
            axes.fill_between(run.time, values - around, values + around, color=BAND, lw=0, label="2 sd of the noise")
        axes.plot(run.time, values, color=colour, lw=1.2, ls="-" if not k else "--", label=rival)
    axes.grid(True)


def _title(plan: RunPlan, run: PlannedRun, inputs: list[str], moving: list[str]) -> str:
    constant = {name: run.table[name][0] for name in inputs if name not in moving}
    values = {**constant, **run.parameters}
    return ", ".join(f"{n} = {format_quantity(v, plan.units[n], 4)}" for n, v in values.items())
