"""One picture of a diagnosis: a run before and after, and the falling error."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import Signal
from pam_cosim.reporting.account.wording import unit_text, wrapped
from pam_cosim.reporting.figures.curves import draw_curves, legend
from pam_cosim.reporting.figures.ladder import Rung, draw_ladder, ladder_legend, roles_of
from pam_cosim.reporting.figures.layer import SPARSE, Layer
from pam_cosim.reporting.figures.panels import over
from pam_cosim.reporting.style import is_narrow, legend_outside, letters_in, new_figure

_DOTS = SPARSE  # more would hide under the line


def showcase(
    layers: Sequence[Layer], rungs: Sequence[Rung], run: RunComparison, signal: Signal
) -> Figure:
    """Measured and modelled signal of one run, and the ladder of that signal, beside it or below."""
    narrow = is_narrow()
    figure = new_figure(9.0, 9.0 if narrow else 3.9 + 0.25 * max(len(rungs) - 2, 0))
    share = 0.5 if len(rungs) > 3 else 0.42 if len(rungs) > 2 else 0.36
    shape = {"height_ratios": [1, 1]} if narrow else {"width_ratios": [1 - share, share]}
    above, below = figure.subplots(*((2, 1) if narrow else (1, 2)), **shape)
    above.grid(True)
    interval = -(-run.run.sample_count(signal.name) // _DOTS)
    draw_curves(above, run, signal, layers, interval)
    unit = unit_text(signal.unit)
    above.set_ylabel(f"{signal.name} [{unit}]" if unit else signal.name)
    above.set_xlabel(over(run))
    kind = "a holdout run, never fitted" if run.run.role == "holdout" else "a fitted run"
    width = float(figure.get_size_inches()[0])
    rooms = (width, width) if narrow else ((1 - share) * width, share * width)
    titles = f"{run.run.name}, {kind}", f"error of {signal.name}"
    for axes, title, room in zip((above, below), titles, rooms, strict=True):
        text = wrapped(title, int(0.8 * letters_in(room)))
        axes.set_title(text, loc="left", fontweight="bold")
    ladder_handles = draw_ladder(below, rungs, signal, rooms[1])
    handles = [*legend(layers, True, interval), *ladder_legend(roles_of(rungs)), *ladder_handles]
    legend_outside(figure, handles, "outside lower center")
    return figure
