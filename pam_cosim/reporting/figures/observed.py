"""Estimates of an observer with their uncertainty, and its innovations."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from pam_cosim.analysis import Observation
from pam_cosim.analysis.observation import DEVIATIONS, LEVEL
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import AFTER, BALANCES, BAND, INK, new_figure
from pam_cosim.units import readable_factor


def observation_figure(observation: Observation) -> Figure:
    """A panel for each requested estimate or whose truth is known, and one for the innovations."""
    names = list(dict.fromkeys([*observation.outputs, *observation.truth]))
    figure = new_figure(8.0, 0.9 + 1.9 * (len(names) + 1))
    grid = figure.subplots(len(names) + 1, 1, sharex=True)
    for axes, name in zip(grid, names, strict=False):
        factor, unit = readable_factor(observation.units[name]), unit_text(observation.units[name])
        value, around = (
            observation[name] * factor,
            DEVIATIONS * observation.deviations[name] * factor,
        )
        axes.fill_between(
            observation.time, value - around, value + around, color=AFTER, alpha=0.25, lw=0
        )
        axes.plot(observation.time, value, color=AFTER, lw=1.2, label=f"estimate, {LEVEL:.0%}")
        if name in observation.measured:
            measured = observation.measured[name] * factor
            axes.plot(observation.time, measured, ".", color=BALANCES[0], ms=2, label="measured")
        if name in observation.truth:
            axes.plot(
                observation.time, observation.truth[name] * factor, color=INK, lw=0.9, label="truth"
            )
        axes.set_ylabel(f"{name} [{unit}]" if unit else name)
        axes.legend(loc="best", ncols=3)
        axes.grid(True)
    last = grid[-1]
    last.axhspan(-DEVIATIONS, DEVIATIONS, color=BAND, zorder=0)
    for i, (name, values) in enumerate(observation.innovations.items()):
        last.plot(
            observation.time, values, ".", ms=3, color=BALANCES[i % len(BALANCES)], label=name
        )
    sizes = [
        float(np.nanmax(np.abs(v)))
        for v in observation.innovations.values()
        if np.isfinite(v).any()
    ]
    end = 1.1 * max(3.0, *sizes, 0.0)
    last.set(xlabel="time [s]", ylabel="normalised innovations", ylim=(-end, end))
    last.legend(loc="best", ncols=4)
    last.grid(True)
    figure.align_ylabels()
    return figure
