"""Scores by two parameters of the runs: a coloured field for each, with its number, and mean and spread around it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pam_cosim.comparison import STATISTICS, ConditionTable, Statistic
from pam_cosim.reporting.style import BAND, INK, SOFT, new_figure

_COLOURS = "cividis"
_DARK = 0.55  # of the colours, above which ink is readable on them


def condition_maps(tables: Sequence[ConditionTable]) -> Figure:
    """A column for each signal, a map for each statistic; yellow is good in all of them."""
    example = tables[0]
    width = 1.4 + 0.72 * (len(example.columns.values) + 1.4)
    height = 1.0 + 0.36 * (len(example.rows.values) + 1)
    figure = new_figure(max(5.0, width * len(tables)), height * len(STATISTICS))
    grid = figure.subplots(len(STATISTICS), len(tables), squeeze=False)
    for row, statistic in zip(grid, STATISTICS, strict=True):
        for axes, table in zip(row, tables, strict=True):
            _map(axes, table, statistic)
    return figure


def _map(axes: Axes, table: ConditionTable, statistic: Statistic) -> None:
    values, texts = table.values(statistic), table.texts(statistic)
    m, n = values.shape
    good = np.ma.masked_invalid(values if statistic == "correlation" else -values)
    shades = (good - good.min()) / (np.ma.ptp(good) or 1.0) if good.count() else good
    axes.imshow(
        shades, cmap=_COLOURS, aspect="auto", extent=(-0.5, n - 0.5, m - 0.5, -0.5), vmin=0, vmax=1
    )
    for i, j in np.ndindex(m, n):
        dark = bool(np.ma.filled(shades[i, j], 1.0) > _DARK)
        axes.text(
            j,
            i,
            texts[i + 1][j + 1],
            ha="center",
            va="center",
            fontsize=7.5,
            color=INK if dark else "white",
        )
    for i in range(m):
        axes.text(
            n + 0.05,
            i,
            _stacked(texts[i + 1][n + 1]),
            ha="center",
            va="center",
            fontsize=7,
            color=SOFT,
        )
    for j in range(n):
        axes.text(
            j, m, _stacked(texts[m + 1][j + 1]), ha="center", va="center", fontsize=7, color=SOFT
        )
    axes.text(n + 0.05, m, "mean\n± sd", ha="center", va="center", fontsize=7, color=SOFT)
    axes.set(xlim=(-0.5, n + 0.6), ylim=(m + 0.5, -0.5))
    axes.set_xticks(range(n), table.columns.labels)
    axes.set_yticks(range(m), table.rows.labels)
    axes.set_xlabel(table.columns.name)
    axes.set_ylabel(table.rows.name)
    axes.tick_params(length=0)
    axes.set_title(table.title(statistic), loc="left")
    for side in axes.spines.values():
        side.set_visible(False)
    axes.set_facecolor(BAND if good.mask.any() else "white")


def _stacked(text: str) -> str:
    return text.replace(" ± ", "\n± ")
