"""A sweep: every scalar over what was varied, or the runs over time."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from pam_cosim.arrays import Array
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import AFTER, message, new_figure
from pam_cosim.sweeps import Sweep
from pam_cosim.units import readable_factor

_MAP = "cividis"  # alike for every kind of colour vision, and ordered in grey
_LINES = 20  # values of one axis up to which each is a line of its own
_RUNS = 60  # maximum number of runs that are drawn, evenly chosen
_WIDE, _HIGH = 4.6, 3.4  # of a panel [in]


def sweep_figure(sweep: Sweep) -> Figure:
    """A panel for each scalar: lines over one axis, a map or a family of lines over two, points over each of more."""
    if not sweep.scalars:
        return _trajectories(sweep)
    names = sweep.design.names
    across = len(names) if len(names) > 2 else 1
    count = len(sweep.scalars)
    columns = across if across > 1 else min(2, count)
    rows = count if across > 1 else -(-count // columns)
    figure = new_figure(_WIDE * columns, _HIGH * rows + 0.2)
    panels = figure.subplots(rows, columns, squeeze=False)
    for axes in panels.ravel()[count * across :]:
        axes.set_visible(False)
    for i, scalar in enumerate(sweep.scalars):
        values = sweep.column(scalar.name) * readable_factor(scalar.unit)
        label = _label(scalar.name, scalar.unit)
        if across > 1:
            for j, axes in enumerate(panels[i]):
                _points(axes, _shown(sweep, j), values, _name(sweep, j), label)
        elif not np.isfinite(values).any():
            message(panels.ravel()[i], "no run reached its end")
        elif len(names) == 1:
            _line(panels.ravel()[i], _shown(sweep, 0), values, _name(sweep, 0), label)
        else:
            _over_two(figure, panels.ravel()[i], sweep, values, label)
    return figure


def _label(name: str, unit: str) -> str:
    text = unit_text(unit)
    return f"{name} [{text}]" if text else name


def _name(sweep: Sweep, i: int) -> str:
    name = sweep.design.names[i]
    return _label(name, sweep.design.units[name])


def _shown(sweep: Sweep, i: int) -> Array:
    """(runs,) of one name that is varied, in its readable unit."""
    factor = readable_factor(sweep.design.units[sweep.design.names[i]])
    return np.asarray(sweep.design.points[:, i] * factor)


def _line(axes: Axes, x: Array, y: Array, name: str, label: str) -> None:
    order = np.argsort(x, kind="stable")
    axes.plot(x[order], y[order], color=AFTER, marker="o", ms=3, lw=1.3)
    _named(axes, name, label)


def _points(axes: Axes, x: Array, y: Array, name: str, label: str) -> None:
    axes.plot(x, y, color=AFTER, marker="o", ms=2.5, ls="none", alpha=0.6, mew=0)
    _named(axes, name, label)


def _named(axes: Axes, name: str, label: str) -> None:
    axes.set_xlabel(name)
    axes.set_ylabel(label)
    axes.grid(True)


def _over_two(figure: Figure, axes: Axes, sweep: Sweep, values: Array, label: str) -> None:
    x, y = _shown(sweep, 0), _shown(sweep, 1)
    if sweep.design.kind != "grid":
        points: Any = axes.scatter(x, y, c=values, cmap=_MAP, s=18, lw=0)
        _named(axes, _name(sweep, 0), _name(sweep, 1))
        figure.colorbar(points, ax=axes, label=label)
        return
    row_count, column_count = (len(values) for values in sweep.design.axes.values())
    table = values.reshape(row_count, column_count)
    if min(row_count, column_count) <= _LINES:
        _family(figure, axes, sweep, table, label, fewer=0 if row_count < column_count else 1)
        return
    mesh = axes.pcolormesh(
        x.reshape(table.shape)[:, 0],
        y.reshape(table.shape)[0],
        table.T,
        cmap=_MAP,
        shading="nearest",
    )
    axes.set_xlabel(_name(sweep, 0))
    axes.set_ylabel(_name(sweep, 1))
    figure.colorbar(mesh, ax=axes, label=label)


def _family(figure: Figure, axes: Axes, sweep: Sweep, table: Array, label: str, fewer: int) -> None:
    """A line for each value of the axis with fewer of them, coloured by it."""
    x, lines = (
        _shown(sweep, 1 - fewer).reshape(table.shape),
        _shown(sweep, fewer).reshape(table.shape),
    )
    if fewer == 1:
        x, lines, table = x.T, lines.T, table.T
    colours = _colours(lines[:, 0])
    for along, value, numbers in zip(x, lines[:, 0], table, strict=True):
        axes.plot(
            along, numbers, color=colours.to_rgba(np.asarray(value)), lw=1.3, marker="o", ms=2.5
        )
    _named(axes, _name(sweep, 1 - fewer), label)
    figure.colorbar(colours, ax=axes, label=_name(sweep, fewer))


def _colours(values: Array) -> ScalarMappable:
    return ScalarMappable(Normalize(float(values.min()), float(values.max())), _MAP)


def _trajectories(sweep: Sweep) -> Figure:
    """The kept variables over time, coloured by what is varied first."""
    good = [i for i in range(len(sweep)) if not sweep.table.failure(i)]
    figure = new_figure(8.0, 0.7 + 1.9 * max(1, len(sweep.outputs)))
    panels = figure.subplots(max(1, len(sweep.outputs)), 1, sharex=True, squeeze=False)[:, 0]
    drawn_runs = (
        [good[i] for i in np.unique(np.linspace(0, len(good) - 1, _RUNS).round().astype(int))]
        if good
        else []
    )
    shown_values = _shown(sweep, 0)
    colours = _colours(shown_values)
    for axes, name in zip(panels, sweep.outputs, strict=False):
        unit = sweep.units[name]
        for run in drawn_runs:
            values = sweep.table.values(run)[sweep.outputs.index(name)] * readable_factor(unit)
            axes.plot(
                sweep.time, values, color=colours.to_rgba(np.asarray(shown_values[run])), lw=0.9
            )
        if not drawn_runs:
            message(axes, "no run reached its end")
        axes.set_ylabel(_label(name, unit))
        axes.grid(True)
        axes.margins(x=0.01)
    panels[-1].set_xlabel("time [s]")
    figure.colorbar(colours, ax=list(panels), label=_name(sweep, 0))
    figure.align_ylabels(list(panels))
    return figure
