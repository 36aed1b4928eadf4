"""Planned runs: what to drive, what each rival predicts of it, and by how much the rivals differ."""

from __future__ import annotations

from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from pam_cosim.diagnosis.planning import PlannedRun, RunPlan
from pam_cosim.reporting.account.wording import unit_text, wrapped
from pam_cosim.reporting.style import (
    BALANCES,
    BAND,
    FURTHER,
    INK,
    is_narrow,
    legend_outside,
    letters_in,
    new_figure,
)
from pam_cosim.units import format_quantity, readable_factor


def plan_figure(plan: RunPlan) -> Figure:
    """A column for each run: its inputs, the signals that the models predict, and their differences to the first."""
    inputs = [name for name in plan.runs[0].table if name != "time"]
    moving = [name for name in inputs if any(len(set(run.table[name])) > 1 for run in plan.runs)]
    signals = list(plan.sigma)
    rows = len(moving) + 2 * len(signals)
    columns = len(plan.runs)
    figure = new_figure(8.0 if columns == 1 else 11.0, 1.6 + 1.25 * rows)
    grid = figure.subplots(rows, columns, sharex="col", sharey="row", squeeze=False)
    room = letters_in(float(figure.get_size_inches()[0]) / columns) - 8
    for j, run in enumerate(plan.runs):
        column = grid[:, j]
        for axes, name in zip(column, moving, strict=False):
            _input(axes, plan, run, name)
        for i, name in enumerate(signals):
            _signal(column[len(moving) + 2 * i], plan, run, name)
            _differences(column[len(moving) + 2 * i + 1], plan, run, name)
        column[-1].set_xlabel("time [s]")
        column[0].set_title(fill(_title(plan, run, inputs, moving), room))
    labels = [(name, plan.units[name]) for name in moving]
    for name in signals:
        labels += [(name, plan.units[name]), (f"Δ{name}", "σ")]
    for axes, (name, unit) in zip(grid[:, 0], labels, strict=True):
        text = unit_text(unit) if unit != "σ" else unit
        axes.set_ylabel(f"{wrapped(name, 16)}\n[{text}]" if text else wrapped(name, 16))
    lines = [
        Line2D([], [], color=_colour(k), ls="--" if k else "-", lw=1.4, label=rival)
        for k, rival in enumerate(plan.rivals)
    ]
    note = Patch(color=BAND, label="Δ: difference to the first; band: ±2 σ of the noise")
    legend_outside(figure, [*lines, note], "outside lower center")
    if not is_narrow():  # the caption of a paper has it
        title = fill(plan.expectation, letters_in(float(figure.get_size_inches()[0])))
        figure.suptitle(title, fontsize="medium")
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
        )
    axes.grid(True)


def _differences(axes: Axes, plan: RunPlan, run: PlannedRun, name: str) -> None:
    """Each rival minus the first one [standard deviations of the noise]."""
    reference, *competitors = (run.predicted[rival][name] for rival in plan.rivals)
    axes.axhspan(-2, 2, color=BAND, lw=0)
    for k, predicted in enumerate(competitors, 1):
        apart = (predicted - reference) / plan.sigma[name]
        axes.plot(run.time, apart, color=_colour(k), lw=1.2, ls="--")
    axes.grid(True)


def _colour(rival: int) -> str:
    colours = (BALANCES[2], *FURTHER)
    return colours[rival % len(colours)]


def _title(plan: RunPlan, run: PlannedRun, inputs: list[str], moving: list[str]) -> str:
    constant = {name: run.table[name][0] for name in inputs if name not in moving}
    values = {**constant, **run.parameters}
    return ", ".join(f"{n} = {format_quantity(v, plan.units[n], 4)}" for n, v in values.items())
