"""A linear model: gain and phase by frequency, and steps."""

from __future__ import annotations

import numpy as np
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

from pam_cosim.analysis.frequency_response import phase
from pam_cosim.analysis.linear import LinearModel
from pam_cosim.analysis.linear_models import LinearModels
from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.style import BALANCES, new_figure
from pam_cosim.units import readable_factor

_POINTS = 400
_DECADES = 1.3  # on either side of the poles
_FLAT = (0.1, 20.0)  # [Hz], of a model without poles


def bode(model: LinearModel) -> Figure:
    """A row for each output: gain, phase and the answer to a step, with a line for each input.

    Raises:
        InputError: there is no input or no output.
    """
    if not model.inputs or not model.outputs:
        raise InputError(
            f"{model.model} has no {'output' if model.inputs else 'input'}: there is no response to draw"
        )
    frequencies, times = spread_frequencies(model), spread_times(model)
    gains, steps = model.response(frequencies), model.step(times)
    rows = len(model.outputs)
    figure = new_figure(11.0, 0.9 + 2.3 * rows)
    grid = figure.subplots(rows, 3, squeeze=False, sharex="col")
    for i, output in enumerate(model.outputs):
        for j, name in enumerate(model.inputs):
            factor = readable_factor(model.units.get(output, "")) / readable_factor(
                model.units.get(name, "")
            )
            colour, gain = BALANCES[j % len(BALANCES)], gains[:, i, j]
            if not np.any(np.abs(gain) > 0):
                continue  # this input does not act on this output
            grid[i, 0].loglog(frequencies, np.abs(gain) * factor, color=colour)
            grid[i, 1].semilogx(frequencies, phase(gain), color=colour)
            grid[i, 2].plot(times, steps[:, i, j] * factor, color=colour)
        unit = unit_text(model.units.get(output, ""))
        grid[i, 0].set_ylabel(f"{output} [{unit}] per input" if unit else f"{output} per input")
        grid[i, 1].set_ylabel("phase [°]")
    for axes, title in zip(
        grid[0], ("gain", "phase", "after a step of the input by one unit"), strict=True
    ):
        axes.set_title(title, loc="left")
    for axes, label in zip(grid[-1], ("frequency [Hz]", "frequency [Hz]", "time [s]"), strict=True):
        axes.set_xlabel(label)
    for axes in grid.ravel():
        axes.grid(True)
    for axes in grid[:, 0]:
        plain_decades(axes.yaxis)
    for axes in grid[0, :2]:
        plain_decades(axes.xaxis)
    names = [_with_unit(name, model.units.get(name, "")) for name in model.inputs]
    lines = [
        grid[0, 0].plot([], [], color=BALANCES[j % len(BALANCES)])[0] for j in range(len(names))
    ]
    figure.legend(lines, names, loc="outside upper center", ncols=min(4, len(names)))
    figure.align_ylabels()
    return figure


def poles_along(linear_models: LinearModels) -> Figure:
    """The poles over the time of a run: how fast, and how damped."""
    figure = new_figure(8.0, 3.4)
    pole_axes, right = figure.subplots(1, 2)
    times, poles = linear_models.times, linear_models.poles
    for j in range(poles.shape[1]):
        colour = BALANCES[j % len(BALANCES)]
        pole_axes.semilogy(times, np.abs(poles[:, j]), "o", color=colour, ms=4)
        with np.errstate(invalid="ignore", divide="ignore"):
            right.plot(times, -poles[:, j].real / np.abs(poles[:, j]), "o", color=colour, ms=4)
    pole_axes.set(xlabel="time [s]", ylabel="size of the pole [1/s]")
    right.set(xlabel="time [s]", ylabel="damping ratio")
    plain_decades(pole_axes.yaxis)
    for axes in (pole_axes, right):
        axes.grid(True)
    return figure


def plain_decades(axis: Axis) -> None:
    """Powers of ten as numbers: the figures set no mathematics."""
    axis.set_major_locator(LogLocator(numticks=8))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())


def _with_unit(name: str, unit: str) -> str:
    text = unit_text(unit)
    return f"by {name} [{text}]" if text else f"by {name}"


def _sizes(model: LinearModel) -> Array:
    sizes = np.abs(model.poles)
    return np.asarray(sizes[sizes > 1e-12 * sizes.max(initial=0.0)])


def spread_frequencies(model: LinearModel) -> Array:
    """[Hz] around all poles."""
    sizes = _sizes(model) / (2 * np.pi)
    if not sizes.size:
        return np.geomspace(*_FLAT, _POINTS)
    return np.geomspace(sizes.min() * 10**-_DECADES, sizes.max() * 10**_DECADES, _POINTS)


def spread_times(model: LinearModel) -> Array:
    """[s] until the slowest mode has settled."""
    sizes = _sizes(model)
    return np.linspace(0.0, 6.0 / sizes.min() if sizes.size else 1.0, _POINTS)
