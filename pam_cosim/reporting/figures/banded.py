"""Predictions with the uncertainty of the parameters and the noise."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pam_cosim.arrays import Array
from pam_cosim.fitting import Band, PredictiveBands
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import AFTER, BAND, INK, SOFT, new_figure
from pam_cosim.units import readable_factor


def bands_figure(prediction: PredictiveBands) -> Figure:
    """A row for each signal: its values with bands and readings, and the same minus the fitted values."""
    figure = new_figure(11.0, 0.9 + 1.9 * len(prediction.bands))
    grid = figure.subplots(len(prediction.bands), 2, sharex=True, squeeze=False)
    for row, (name, band) in zip(grid, prediction.bands.items(), strict=True):
        unit = unit_text(band.unit)
        for axes, base in zip(row, (np.zeros(len(band.value)), band.value), strict=True):
            _draw(axes, prediction.time, band, base)
        row[0].set_ylabel(f"{name} [{unit}]" if unit else name)
    grid[0, 0].legend(loc="best", labelcolor=SOFT)
    grid[0, 0].set_title(f"{prediction.model}, {prediction.run}")
    grid[0, 1].set_title("minus the values with the fitted parameters")
    for axes in grid[-1]:
        axes.set_xlabel("time [s]")
    figure.align_ylabels(grid[:, 0])
    return figure


def _draw(axes: Axes, time: Array, band: Band, base: Array) -> None:
    factor = readable_factor(band.unit)
    low, high = (band.reading_low - base) * factor, (band.reading_high - base) * factor
    axes.fill_between(time, low, high, color=BAND, lw=0, label="95 % of readings")
    low, high = (band.low - base) * factor, (band.high - base) * factor
    axes.fill_between(time, low, high, color=AFTER, alpha=0.35, lw=0, label="95 %, parameters")
    if band.measured.size:
        axes.plot(time, (band.measured - base) * factor, ".", color=INK, ms=2, label="measured")
    axes.plot(time, (band.value - base) * factor, color=AFTER, lw=1.1, label="fitted parameters")
    axes.grid(True)
