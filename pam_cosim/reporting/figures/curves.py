"""Measured against model."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import Signal
from pam_cosim.reporting.figures.layer import SPARSE, Layer, pages
from pam_cosim.reporting.figures.panels import drawn_over, panels, places
from pam_cosim.reporting.style import HALO, INK, Picture, drawing, legend_outside, picture
from pam_cosim.units import readable_factor
from pam_cosim.wording import enumeration

DASHES = (4.5, 2.0)


def draw_curves(
    axes: Axes, run: RunComparison, signal: Signal, layers: Sequence[Layer], stride: int = 1
) -> None:
    """Measured dots, one of each ``stride``, and a line for each model, in readable units."""
    factor = readable_factor(signal.unit)
    sample_rows = np.flatnonzero(np.isfinite(run.run.measurements[signal.name]))[::stride]
    is_sparse = len(sample_rows) <= SPARSE
    axes.plot(
        places(run)[sample_rows],
        run.run.measurements[signal.name][sample_rows] * factor,
        ls="none",
        marker="o",
        mec="none",
        zorder=2,
        ms=4.5 if is_sparse else 3.6,
        mfc=INK if is_sparse else HALO,
        rasterized=not is_sparse,
    )
    for i, layer in enumerate(layers):
        simulated = layer.run(run.run.name)
        if simulated is not None and signal.name in simulated.model:
            (line,) = axes.plot(
                places(simulated),
                simulated.model[signal.name] * factor,
                color=layer.colour,
                lw=1.6 if is_sparse else 1.1,
                zorder=3 + i,
            )
            if layer.dashed:
                line.set_dashes(DASHES)


def legend(layers: Sequence[Layer], is_sparse: bool, stride: int = 1) -> list[Line2D]:
    """Handles for measured dots and the models."""
    dot = Line2D([], [], ls="none", marker="o", mec="none", ms=4.5, mfc=INK if is_sparse else HALO)
    dot.set_label("measured" if stride == 1 else f"measured, 1 of {stride} samples")
    handles = [dot]
    for layer in layers:
        line = Line2D([], [], color=layer.colour, lw=1.6, label=layer.label)
        if layer.dashed:
            line.set_dashes(DASHES)
        handles.append(line)
    return handles


def curve_pictures(layers: Sequence[Layer]) -> list[Picture]:
    """Measured and modelled signals of all runs, some runs a picture."""
    comparison = layers[-1].comparison
    signals = list(comparison.data.signals.values())
    is_sparse = max((len(r.run.time) for r in comparison.runs), default=0) <= SPARSE
    pictures = []
    for runs in pages(comparison.runs):
        with drawing():
            figure = panels(runs, signals, lambda a, r, s: draw_curves(a, r, s, layers))
            legend_outside(figure, legend(layers, is_sparse))
            drawn = enumeration(list(dict.fromkeys(drawn_over(r) for r in runs)))
            alt = f"Measured and modelled {enumeration([s.name for s in signals])} over {drawn}"
            holdout = bool(np.any([r.run.role == "holdout" for r in runs]))
            pictures.append(picture(figure, alt, _caption(layers, holdout)))
    return pictures


def _caption(layers: Sequence[Layer], holdout: bool) -> str:
    if len(layers) == 1:
        text = "Dots are measured, the line is the model. Where the line leaves the dots, the model is wrong."
    else:
        text = (
            "Dots are measured. The solid line should run through the dots where a dashed one misses them. "
            "All runs of a row share one scale."
        )
    return f"{text} Runs marked holdout were never fitted." if holdout else text
