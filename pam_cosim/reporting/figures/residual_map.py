"""Where in the range that was visited a model is wrong: its residual over the plane of two signals."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh

from pam_cosim.arrays import Array
from pam_cosim.measurement import Signal
from pam_cosim.reporting.account.wording import unit_text
from pam_cosim.reporting.figures.layer import Layer
from pam_cosim.reporting.style import BAND, SOFT, WIDTH, Picture, drawing, new_figure, picture
from pam_cosim.units import readable_factor

_CELLS = 14
_FEWEST = 200  # samples, below which a plane of cells shows single samples
_FULL = 5.0  # noise standard deviations of the darkest colour


def residual_map(layers: Sequence[Layer], signals: Sequence[Signal]) -> Picture | None:
    """A panel for each fitted signal and model; None with fewer than two signals or few samples."""
    judged = [s for s in signals if s.fitted]
    if len(signals) < 2 or not judged or min(_count(layers[0], s.name) for s in judged) < _FEWEST:
        return None
    across, up = signals[:2]
    with drawing():
        figure = new_figure(min(WIDTH, 0.9 + 3.2 * len(judged)), 0.6 + 2.1 * len(layers))
        grid = figure.subplots(len(layers), len(judged), sharex=True, sharey=True, squeeze=False)
        for row, layer in zip(grid, layers, strict=True):
            for axes, signal in zip(row, judged, strict=True):
                drawn = _draw(axes, layer, signal, across, up)
                axes.set_title(f"{signal.name}, {layer.label}", fontsize=8)
            row[0].set_ylabel(_label(up))
        for axes in grid[-1]:
            axes.set_xlabel(_label(across))
        figure.colorbar(
            drawn, ax=grid, label="measured − model\n[noise standard deviations]", extend="both"
        )
        return picture(
            figure,
            f"Mean residual of each signal over the plane of {across.name} and {up.name}",
            f"Mean of measured minus model in each part of the plane of modelled {across.name} and {up.name}. White: "
            "no error on average; grey: no samples. A patch of one colour says at which states the model is wrong.",
        )


def binned_residual(
    layer: Layer, signal: Signal, across: Signal, up: Signal
) -> tuple[Array, Array, Array]:
    """Mean residual (cells, cells) in noise standard deviations, NaN where no sample lies; edges (cells + 1,) [SI]."""
    runs = [r for r in layer.comparison.runs if r.run.sample_count(signal.name)]
    noise = [signal.sigma_at(r.run.measurements[signal.name]) for r in runs]
    error = np.concatenate(
        [r.residual(signal.name) / sd for r, sd in zip(runs, noise, strict=True)]
    )
    x, y = (np.concatenate([r.model[s.name] for r in runs]) for s in (across, up))
    is_measured = np.isfinite(error)
    edges = [np.histogram_bin_edges(v[is_measured], _CELLS) for v in (y, x)]
    count, y_edges, x_edges = np.histogram2d(y[is_measured], x[is_measured], bins=edges)
    total, _, _ = np.histogram2d(
        y[is_measured], x[is_measured], bins=edges, weights=error[is_measured]
    )
    return (
        np.divide(total, count, out=np.full_like(total, np.nan), where=count > 0),
        x_edges,
        y_edges,
    )


def _draw(axes: Axes, layer: Layer, signal: Signal, across: Signal, up: Signal) -> QuadMesh:
    mean, x_edges, y_edges = binned_residual(layer, signal, across, up)
    fx, fy = (readable_factor(s.unit) for s in (across, up))
    axes.set_facecolor(BAND)
    axes.tick_params(colors=SOFT)
    return axes.pcolormesh(
        x_edges * fx, y_edges * fy, mean, cmap="RdBu_r", vmin=-_FULL, vmax=_FULL, rasterized=True
    )


def _count(layer: Layer, name: str) -> int:
    return sum(r.run.sample_count(name) for r in layer.comparison.runs)


def _label(signal: Signal) -> str:
    unit = unit_text(signal.unit)
    return f"{signal.name} [{unit}]" if unit else signal.name
