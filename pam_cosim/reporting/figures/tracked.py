"""A tracking test: the error by frequency, and the courses themselves."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from pam_cosim.analysis import Tracking
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.figures.bode import plain_decades
from pam_cosim.reporting.style import AFTER, BALANCES, INK, new_figure
from pam_cosim.units import readable_factor

_MOST_COURSES = 5


def tracking_figure(tracking: Tracking) -> Figure:
    """Error by frequency, and the output over the last period at some of them."""
    figure = new_figure(10.0, 3.8)
    left, right = figure.subplots(1, 2)
    factor, unit = readable_factor(tracking.unit), unit_text(tracking.unit)
    left.loglog(tracking.frequencies, 100 * tracking.relative_error, "-", color=AFTER, lw=1.2)
    settled = tracking.settled.astype(bool)
    for at, fill in ((settled, AFTER), (~settled, "white")):
        left.loglog(
            tracking.frequencies[at], 100 * tracking.relative_error[at], "o", color=AFTER, mfc=fill
        )
    left.axhline(100, color=INK, lw=0.8, ls=":")
    left.set(xlabel="frequency [Hz]", ylabel="rms error [% of the sine's]")
    plain_decades(left.xaxis)
    plain_decades(left.yaxis)
    right.plot(tracking.phase, tracking.wanted * factor, color=INK, lw=1.4, label="wanted")
    shown = np.unique(
        np.linspace(0, len(tracking.frequencies) - 1, _MOST_COURSES).round().astype(int)
    )
    for j, k in enumerate(shown):
        colour = BALANCES[j % len(BALANCES)]
        label = f"{tracking.frequencies[k]:.3g} Hz"
        right.plot(tracking.phase, tracking.courses[k] * factor, color=colour, lw=1.1, label=label)
    right.set(
        xlabel="part of a period", ylabel=f"{tracking.output} [{unit}]" if unit else tracking.output
    )
    right.legend(loc="best", ncols=2)
    for axes in (left, right):
        axes.grid(True)
    return figure
