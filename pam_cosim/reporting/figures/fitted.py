"""The convergence of a fit, the ends of its descents, the correlation of its parameters, and their profiles."""

from __future__ import annotations

from math import ceil, isfinite

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, MaxNLocator

from pam_cosim.arrays import Array
from pam_cosim.fitting import Fit, Profile, Profiles
from pam_cosim.fitting.profile import INTERVAL_RISE
from pam_cosim.reporting.account.labels import short_model
from pam_cosim.reporting.account.wording import unit_text, wrapped
from pam_cosim.reporting.figures.bode import plain_decades
from pam_cosim.reporting.style import BLUE, INK, SOFT, VERMILLION, is_narrow, message, new_figure
from pam_cosim.units import readable_factor

_COLUMNS = 3


def fit_figure(fit: Fit) -> Figure:
    """Chi-square over simulations, the ends of several descents in order, the correlation matrix."""
    parts = [_convergence, _waterfall, _matrix]
    if len(fit.convergence.descents) == 1:
        parts.remove(_waterfall)
    shape = (len(parts), 1) if is_narrow() else (1, len(parts))
    figure = new_figure(4.0 * shape[1], 3.8 * shape[0])
    for axes, part in zip(figure.subplots(*shape), parts, strict=True):
        part(axes, fit)
    title = f"{fit.comparison.data.title}: {short_model(fit.model)}"
    figure.suptitle(title, x=0.01, ha="left", fontsize=9.5)
    return figure


def _convergence(axes: Axes, fit: Fit) -> None:
    descent = fit.convergence
    axes.set(xlabel="simulations of the fitted runs", ylabel="lowest reduced chi-square")
    if not len(descent.evaluations):
        message(axes, "not recorded")
        return
    end = max(fit.evaluations, int(descent.evaluations[-1]))
    x, y = (
        np.append(descent.evaluations, end),
        np.append(descent.chi2_reduced, descent.chi2_reduced[-1]),
    )
    axes.step(x, y, where="post", color=BLUE)
    searched = getattr(fit.search, "evaluations", None)
    if searched is not None:
        axes.axvline(searched, color=SOFT, ls="--", lw=0.9)
        axes.text(searched, y[0], " descent", color=SOFT, va="top", fontsize=7.5)
    _scale(axes, y)
    axes.grid(True)


def _scale(axes: Axes, values: Array) -> None:
    """Logarithmic where the values span a decade; a shorter span has no power of ten to label on such an axis."""
    if not values.min() > 0 or values.max() < 10 * values.min():
        return
    axes.set_yscale("log")
    plain_decades(axes.yaxis)
    if values.max() < 1000 * values.min():
        axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))


def _waterfall(axes: Axes, fit: Fit) -> None:
    ends = np.sort(fit.convergence.descents)
    axes.set(xlabel="descents, the lowest first", ylabel="reduced chi-square at the end")
    if not len(ends):
        message(axes, "no descent")
        return
    axes.plot(np.arange(1, len(ends) + 1), ends, "o-", color=VERMILLION, ms=4, lw=0.8)
    _scale(axes, ends)
    axes.set_xlim(0.5, len(ends) + 0.5)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.grid(True)


def _matrix(axes: Axes, fit: Fit) -> None:
    names, matrix = list(fit.parameters), fit.correlation
    if not matrix.size:
        message(axes, "no correlation")
        return
    axes.imshow(np.ma.masked_invalid(matrix), cmap="RdBu_r", vmin=-1, vmax=1)
    for i, j in np.ndindex(matrix.shape):
        if np.isfinite(matrix[i, j]):
            colour = "white" if abs(matrix[i, j]) > 0.6 else INK
            axes.text(
                j, i, f"{matrix[i, j]:.2f}", ha="center", va="center", fontsize=7, color=colour
            )
    numbered = [f"{wrapped(name, 20, 3)} ({i})" for i, name in enumerate(names, 1)]
    axes.set_xticks(range(len(names)), [f"({i})" for i in range(1, len(names) + 1)])
    axes.set_yticks(range(len(names)), numbered)
    axes.tick_params(length=0)
    axes.set_title("correlation of the estimates", loc="left")


def profile_figure(profiles: Profiles) -> Figure:
    """A panel for each parameter: the rise of chi-square, and the level where the 95 % interval ends."""
    count = len(profiles.profiles)
    columns = 1 if is_narrow() else min(_COLUMNS, max(count, 1))
    rows = max(1, ceil(count / columns))
    figure = new_figure(3.8 * columns, 2.7 * rows)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    for axes, profile in zip(panels, profiles.profiles.values(), strict=False):
        _profile(axes, profile)
    for axes in panels[count:]:
        axes.set_visible(False)
    return figure


def _profile(axes: Axes, profile: Profile) -> None:
    """The rise of chi-square over one parameter, its estimate, and the ends of the interval."""
    factor, unit = readable_factor(profile.unit), unit_text(profile.unit)
    axes.plot(profile.values * factor, profile.rise, "o-", color=BLUE, ms=3)
    axes.axhline(INTERVAL_RISE, color=SOFT, ls="--", lw=0.9)
    end = axes.get_yaxis_transform()
    axes.text(
        1.0, INTERVAL_RISE, "95 %", transform=end, ha="right", va="bottom", color=SOFT, fontsize=7.5
    )
    for bound in (profile.low, profile.high):
        if isfinite(bound):
            axes.plot([bound * factor] * 2, [0.0, INTERVAL_RISE], color=SOFT, ls=":", lw=1.2)
    axes.axvline(profile.best * factor, color=VERMILLION, lw=0.9)
    axes.plot(profile.best * factor, 0.0, "D", color=VERMILLION, ms=5, zorder=4)
    axes.text(
        profile.best * factor,
        0.55 * INTERVAL_RISE,
        " estimate",
        color=VERMILLION,
        va="center",
        fontsize=7.5,
    )
    axes.set_ylim(-0.05 * INTERVAL_RISE, max(1.2 * INTERVAL_RISE, 0.1))
    axes.set_xlabel(wrapped(f"{profile.name} [{unit}]" if unit else profile.name, 40))
    axes.set_ylabel("rise of chi-square")
    axes.set_title("" if profile.determined else "not determined", loc="left", color=VERMILLION)
    axes.grid(True)
