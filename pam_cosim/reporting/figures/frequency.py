"""A frequency response by sines, drawn over that of the linear model."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from pam_cosim.analysis.frequency_response import FrequencyResponse, phase
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.figures.bode import plain_decades
from pam_cosim.reporting.style import AFTER, SOFT, VERMILLION, new_figure
from pam_cosim.units import format_quantity, readable_factor, readable_unit

_POINTS = 300


def frequency_figure(response: FrequencyResponse) -> Figure:
    """A column for each output: gain, phase and distortion by frequency."""
    outputs = response.outputs
    figure = new_figure(
        1.0 + 3.0 * len(outputs), 6.0
    )  # wider ones are shrunk on a page, and their letters
    grid = figure.subplots(3, len(outputs), squeeze=False, sharex=True, height_ratios=(3, 2, 1.3))
    fine = np.geomspace(response.frequencies.min() / 1.3, response.frequencies.max() * 1.3, _POINTS)
    smooth = None if response.linear is None else response.linear.response(fine)[:, :, 0]
    settled = response.settled.astype(bool)
    for i, name in enumerate(outputs):
        factor = readable_factor(response.units[name]) / readable_factor(
            response.units[response.input]
        )
        gain, turn = grid[0, i], grid[1, i]
        angles = phase(response.gain[:, i])
        if smooth is not None:
            gain.loglog(
                fine, np.abs(smooth[:, i]) * factor, color=SOFT, lw=1.2, label="linear model"
            )
            line = phase(smooth[:, i])
            turn.semilogx(fine, line, color=SOFT, lw=1.2)
            angles = angles + 360.0 * np.round(
                (np.interp(response.frequencies[0], fine, line) - angles[0]) / 360.0
            )
        for selection, fill in ((settled, AFTER), (~settled, "none")):
            label = "sines" if fill != "none" else "sines, not settled"
            if np.any(selection):
                style = {"ls": "none", "marker": "o", "ms": 5, "color": AFTER, "mfc": fill}
                gain.loglog(
                    response.frequencies[selection],
                    np.abs(response.gain[selection, i]) * factor,
                    label=label,
                    **style,
                )
                turn.semilogx(response.frequencies[selection], angles[selection], **style)
        grid[2, i].semilogx(
            response.frequencies,
            100 * response.distortion[:, i],
            "o-",
            color=VERMILLION,
            ms=4,
            lw=1,
        )
        grid[2, i].set_ylim(bottom=0)
        unit, by = (
            readable_unit(response.units[name]),
            readable_unit(response.units[response.input]),
        )
        gain.set_title(f"{name} by {response.input}", loc="left")
        gain.set_ylabel(f"gain [{unit_text(unit) or '1'}/{by or '1'}]")
        turn.set_ylabel("phase [°]")
        grid[2, i].set_ylabel("distortion [%]")
        grid[2, i].set_xlabel("frequency [Hz]")
        plain_decades(gain.yaxis)
    for axes in grid.ravel():
        plain_decades(axes.xaxis)
        axes.grid(True)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    swing = format_quantity(response.amplitude, response.units[response.input])
    labels = [f"{label} of {swing}" if label == "sines" else label for label in labels]
    figure.legend(handles, labels, loc="outside upper center", ncols=len(labels))
    figure.align_ylabels()
    return figure
