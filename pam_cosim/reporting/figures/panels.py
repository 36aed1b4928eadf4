"""Small multiples: one row a signal, one column a run."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure

from pam_cosim.arrays import Array
from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import Signal
from pam_cosim.reporting.account.wording import unit_text, wrapped
from pam_cosim.reporting.figures.layer import COLUMNS, pages
from pam_cosim.reporting.style import LINE, WIDTH, is_narrow, message, new_figure
from pam_cosim.units import readable_factor

_NARROW = 4  # columns up to which a figure need not be as wide as the page
_HEIGHT, _MARGIN = 1.55, 0.85  # in, of a row and of what surrounds the rows
Panel = Callable[[Axes, RunComparison, Signal], None]


def panels(
    runs: Sequence[RunComparison], signals: Sequence[Signal], draw: Panel, row_label: str = "{}"
) -> Figure:
    """A grid of axes, filled by ``draw`` where the run measured the signal; it has a note where it did not.

    Args:
        runs: the columns.
        signals: the rows.
        draw: draws one panel.
        row_label: the label of a row, in which ``{}`` stands for the signal.
    """
    narrow = is_narrow()
    columns = max(min(len(runs), COLUMNS // 2 if narrow else COLUMNS), 1)
    blocks = pages(runs, columns)
    row = _HEIGHT * (0.75 if narrow else 1.25 if columns <= 2 else 1.0)
    height = len(blocks) * (_MARGIN + row * len(signals))
    figure = new_figure(WIDTH if columns > 1 else 0.75 * WIDTH, height)
    parts = figure.subfigures(len(blocks), 1, squeeze=False)[:, 0]
    for part, block in zip(parts, blocks, strict=True):
        _block(part, block, signals, draw, row_label)
    return figure


def _block(
    figure: SubFigure,
    runs: Sequence[RunComparison],
    signals: Sequence[Signal],
    draw: Panel,
    row_label: str,
) -> None:
    """The panels of runs side by side."""
    columns = len(runs)
    grid = figure.subplots(len(signals), columns, sharex="col", sharey="row", squeeze=False)
    for i, signal in enumerate(signals):
        for j, run in enumerate(runs):
            axes = grid[i, j]
            if run.run.sample_count(signal.name):
                axes.grid(True)
                draw(axes, run, signal)
            else:
                message(axes, "not measured")
                axes.tick_params(left=False, bottom=False)
                for spine in axes.spines.values():
                    spine.set_color(LINE)
        grid[i, 0].set_ylabel(wrapped(_label(row_label.format(signal.name), signal.unit), 22))
    for j, run in enumerate(runs):
        grid[0, j].set_title(
            _title(run, columns), fontweight="bold" if run.run.role == "holdout" else "normal"
        )
        grid[-1, j].set_xlabel(over(run))
        _limits(grid[-1, j], run)
    figure.align_ylabels(grid[:, 0])


def drawn_over(run: RunComparison) -> str:
    """The name of what a run is drawn over: time, or what was imposed along a curve of points at rest."""
    return "time" if run.run.along is None else run.run.along.name


def over(run: RunComparison) -> str:
    """The same with its unit."""
    along = run.run.along
    return "time [s]" if along is None else _label(along.name, along.unit)


def places(run: RunComparison) -> Array:
    """(n,) where the samples of a run are drawn, in the unit of the label."""
    return (
        run.run.time
        if run.run.along is None
        else run.run.time * readable_factor(run.run.along.unit)
    )


def _label(name: str, unit: str) -> str:
    text = unit_text(unit)
    return f"{name} [{text}]" if text else name


def _title(run: RunComparison, columns: int) -> str:
    longest = 22 if columns > _NARROW else 32
    return f"{wrapped(run.run.name, longest)}\n{run.run.role}"


def _limits(axes: Axes, run: RunComparison) -> None:
    low, high = float(np.min(places(run))), float(np.max(places(run)))
    space = 0.03 * (high - low)
    if space > 0:
        axes.set_xlim(low - space, high + space)
