"""What each model leaves, against the noise."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import Signal
from pam_cosim.reporting.figures.layer import SPARSE, Layer, pages
from pam_cosim.reporting.figures.panels import drawn_over, panels, places
from pam_cosim.reporting.style import BAND, SOFT, Picture, drawing, legend_outside, picture
from pam_cosim.units import readable_factor
from pam_cosim.wording import enumeration

_BAND_SIGMAS = 2


def draw_residuals(axes: Axes, run: RunComparison, signal: Signal, layers: Sequence[Layer]) -> None:
    """Measured minus model for each model, over the band of the noise."""
    factor = readable_factor(signal.unit)
    if signal.sigma_of_reading:
        _growing_band(axes, run, signal, factor)
    else:
        reach = _BAND_SIGMAS * signal.sigma * factor
        axes.axhspan(-reach, reach, color=BAND, zorder=1)
        for edge in (-reach, reach):
            axes.axhline(edge, color=SOFT, lw=0.6, zorder=9)
    axes.axhline(0, color=SOFT, lw=0.8, zorder=2)
    is_sparse = run.run.sample_count(signal.name) <= SPARSE
    for i, layer in enumerate(layers):
        simulated = layer.run(run.run.name)
        if simulated is None or signal.name not in simulated.model:
            continue
        residual = simulated.residual(signal.name) * factor
        is_measured = np.isfinite(residual)
        axes.plot(
            places(simulated)[is_measured],
            residual[is_measured],
            color=layer.colour,
            zorder=3 + i,
            marker="o",
            mec="none",
            ms=4 if is_sparse else 1.6,
            ls="-" if is_sparse else "none",
            lw=0.8,
            alpha=1.0 if is_sparse else 0.6,
            rasterized=not is_sparse,
        )


def _growing_band(axes: Axes, run: RunComparison, signal: Signal, factor: float) -> None:
    """The band of noise that grows with the reading, from sample to sample."""
    is_measured = np.isfinite(run.run.measurements[signal.name])
    at = places(run)[is_measured]
    reach = (
        _BAND_SIGMAS
        * factor
        * np.asarray(signal.sigma_at(run.run.measurements[signal.name][is_measured]))
    )
    axes.fill_between(at, -reach, reach, color=BAND, lw=0.0, zorder=1)
    for sign in (-1.0, 1.0):
        axes.plot(at, sign * reach, color=SOFT, lw=0.6, zorder=9)


def residual_pictures(layers: Sequence[Layer]) -> list[Picture]:
    """Measured minus model of all runs, some runs a picture."""
    comparison = layers[-1].comparison
    signals = list(comparison.data.signals.values())
    pictures = []
    handles: list[Line2D | Patch] = [
        Line2D([], [], color=x.colour, marker="o", mec="none", ms=4, ls="none", label=x.label)
        for x in layers
    ]
    handles.append(Patch(color=BAND, label=f"noise, ±{_BAND_SIGMAS} standard deviations"))
    for runs in pages(comparison.runs):
        with drawing():
            figure = panels(
                runs, signals, lambda a, r, s: draw_residuals(a, r, s, layers), "{} error"
            )
            legend_outside(figure, handles)
            drawn = enumeration(list(dict.fromkeys(drawn_over(r) for r in runs)))
            signal_names = enumeration([s.name for s in signals])
            alt = f"Measured minus modelled {signal_names} over {drawn}, with the band of the noise"
            caption = (
                "Measured minus model. A complete model leaves points scattered within the grey band, 19 of 20; "
                "a curve that can be followed by eye is physics that is not in the model."
            )
            pictures.append(picture(figure, alt, caption))
    return pictures
