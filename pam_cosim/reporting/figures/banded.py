"""Predictions with what the parameters and the noise leave open."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from pam_cosim.fitting import PredictiveBands
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import AFTER, BAND, INK, SOFT, new_figure
from pam_cosim.units import readable_factor


def bands_figure(prediction: PredictiveBands) -> Figure:
    """A panel for each signal: its value, the band of the parameters, the band of a reading, and readings."""
    figure = new_figure(8.0, 0.9 + 1.9 * len(prediction.bands))
    grid = figure.subplots(len(prediction.bands), 1, sharex=True, squeeze=False)[:, 0]
    time = prediction.time
    for axes, (name, band) in zip(grid, prediction.bands.items(), strict=True):
        factor, unit = readable_factor(band.unit), unit_text(band.unit)
        if np.isfinite(band.reading_low).any():
            low, high = band.reading_low * factor, band.reading_high * factor
            axes.fill_between(time, low, high, color=BAND, lw=0, label="95 % of readings")
        axes.fill_between(time, band.low * factor, band.high * factor, color=AFTER, alpha=0.35, lw=0, label="95 %")
        if band.measured.size:
            axes.plot(time, band.measured * factor, ".", color=INK, ms=2, label="measured")
        axes.plot(time, band.value * factor, color=AFTER, lw=1.1, label="fitted parameters")
        axes.set_ylabel(f"{name} [{unit}]" if unit else name)
        axes.grid(True)
    grid[0].legend(loc="best", ncols=4, labelcolor=SOFT)
    grid[0].set_title(f"{prediction.model}, {prediction.run}")
    grid[-1].set_xlabel("time [s]")
    figure.align_ylabels()
    return figure
