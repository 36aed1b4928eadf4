"""The error ladder: how far each added effect brings the error down towards the noise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from pam_cosim.comparison import SignalScore
from pam_cosim.measurement import ROLES, Signal
from pam_cosim.reporting.account.wording import number, unit_text, wrapped
from pam_cosim.reporting.style import (
    AFTER,
    BEFORE,
    INK,
    SOFT,
    WIDTH,
    Picture,
    drawing,
    is_narrow,
    legend_outside,
    letters_in,
    new_figure,
    picture,
)
from pam_cosim.units import readable_factor

_WIDEST = 3  # panels side by side


@dataclass(frozen=True)
class Rung:
    """One model of the ladder.

    Attributes:
        label: what was added.
        scores: per role and signal.
    """

    label: str
    scores: Mapping[str, Mapping[str, SignalScore]]


def draw_ladder(axes: Axes, rungs: Sequence[Rung], signal: Signal, room: float) -> list[Line2D]:
    """Bars of the rms error of one signal, a group for each rung, one bar for each role that has runs.

    Args:
        axes: to draw on.
        rungs: the models.
        signal: of which the error is.
        room: width of the axes [in].

    Returns:
        Handles of a legend with the labels that have no room under the bars, where numbers stand for them.
    """
    factor = readable_factor(signal.unit)
    roles = [r for r in ROLES if any(signal.name in rung.scores.get(r, {}) for rung in rungs)]
    width = min(0.38, 0.76 / max(len(roles), 1))
    noise = signal.sigma * factor
    highest = noise
    for i, rung in enumerate(rungs):
        for k, role in enumerate(roles):
            score = rung.scores.get(role, {}).get(signal.name)
            if score is None or not np.isfinite(score.rmse):
                continue
            at, value = i + (k - (len(roles) - 1) / 2) * width, score.rmse * factor
            highest = max(highest, value)
            _draw_bar(axes, at, value, 0.9 * width, role, BEFORE if i == 0 else AFTER)
            axes.annotate(
                number(value),
                (at, value),
                (0, 2.5),
                textcoords="offset points",
                ha="center",
                va="bottom",
                fontsize="small",
                color=INK,
                zorder=6,
            )
    axes.axhline(noise, color=INK, lw=1.1, dashes=(3, 2), zorder=5)
    axes.set_ylim(0, 1.16 * highest or 1)
    space = 1.2 if len(rungs) == 1 else 0.6
    label_length = letters_in(0.8 * room / max(len(rungs), 2))
    axes.set_xlim(-space, len(rungs) - 1 + space)
    labels = {i: wrapped(r.label, label_length, 4) for i, r in enumerate(rungs)}
    too_long = [i for i, label in labels.items() if "…" in label]
    labels |= {i: f"({i})" for i in too_long}
    axes.set_xticks(range(len(rungs)), list(labels.values()))
    axes.tick_params(axis="x", length=0, labelcolor=INK)
    axes.grid(True, axis="y")
    unit = unit_text(signal.unit)
    axes.set_ylabel(f"rms error [{unit}]" if unit else "rms error")
    return [Line2D([], [], ls="", label=f"({i}) {rungs[i].label}") for i in too_long]


def _draw_bar(axes: Axes, at: float, height: float, width: float, role: str, colour: str) -> None:
    """A full bar for fitted runs, a hatched one for holdout runs."""
    full = role == "fit"
    face, hatch = (colour, None) if full else ("white", "////")
    axes.bar(
        at, height, width, facecolor=face, edgecolor=colour, hatch=hatch, linewidth=1.0, zorder=3
    )


def ladder_legend(roles: Sequence[str]) -> list[Patch | Line2D]:
    """Handles for the two roles and the noise."""
    handles: list[Patch | Line2D] = []
    if "fit" in roles:
        handles.append(Patch(facecolor=SOFT, edgecolor=SOFT, label="fitted runs"))
    if "holdout" in roles:
        handles.append(Patch(facecolor="white", edgecolor=SOFT, hatch="////", label="holdout runs"))
    noise = Line2D([], [], color=INK, lw=1.1, label="noise")
    noise.set_dashes((3, 2))
    return [*handles, noise]


def roles_of(rungs: Sequence[Rung]) -> list[str]:
    """The roles that have runs."""
    return [r for r in ROLES if any(rung.scores.get(r) for rung in rungs)]


def ladder_picture(rungs: Sequence[Rung], signals: Sequence[Signal]) -> Picture:
    """The ladder of every signal."""
    columns = 1 if is_narrow() else max(1, min(len(signals), _WIDEST if len(rungs) <= 3 else 2))
    rows = -(-len(signals) // columns)
    with drawing():
        figure = new_figure(WIDTH if columns > 1 else 0.7 * WIDTH, 0.5 + 2.5 * rows)
        grid = figure.subplots(rows, columns, squeeze=False).ravel()
        handles: list[Line2D] = []
        for axes, signal in zip(grid, signals, strict=False):
            handles = draw_ladder(axes, rungs, signal, figure.get_size_inches()[0] / columns)
            axes.set_title(
                signal.name if signal.fitted else f"{signal.name} (not fitted)",
                loc="left",
                fontweight="bold",
            )
        for axes in grid[len(signals) :]:
            axes.set_visible(False)
        legend_outside(figure, [*ladder_legend(roles_of(rungs)), *handles])
        return picture(
            figure, "Root mean square error of each signal, model by model", _caption(rungs)
        )


def _caption(rungs: Sequence[Rung]) -> str:
    holdout = "holdout" in roles_of(rungs)
    if len(rungs) == 1:
        return "Root mean square error of the base model. The dashed line is the noise, the smallest error to expect."
    text = (
        "Root mean square error, from the base model to the model with all effects that were added. "
        "The dashed line is the noise: no honest model goes below it."
    )
    return (
        f"{text} An effect that is real lowers the hatched bars as much as the solid ones."
        if holdout
        else text
    )
