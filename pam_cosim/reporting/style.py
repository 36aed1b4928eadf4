"""The look of every figure, and how a figure becomes a picture. Same input, same bytes."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

# Okabe and Ito (2008): distinguishable with every kind of colour vision, and in grey by their brightness.
BLUE, VERMILLION, GREEN, PINK, ORANGE, SKY = (
    "#0072b2",
    "#d55e00",
    "#009e73",
    "#cc79a7",
    "#e69f00",
    "#56b4e9",
)
INK, SOFT, LINE, HALO, BAND = "#2b2f33", "#6b7178", "#d5d9dd", "#aeb4ba", "#e4e7ea"
BEFORE, AFTER = VERMILLION, BLUE
SENSOR = PINK  # what is wrong with an instrument, in every field
BALANCES = (
    ORANGE,
    GREEN,
    BLUE,
    SKY,
    VERMILLION,
    INK,
    SOFT,
)  # in the order of the field, the same in all figures
FURTHER = (VERMILLION, GREEN, PINK, ORANGE, SKY)

WIDTH = 11.0  # in, the full width of a page
_SETTINGS: dict[str, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 8.5,
    "axes.titlesize": 8.5,
    "axes.labelsize": 8.5,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 8.5,
    "legend.frameon": False,
    "text.color": INK,
    "text.parse_math": False,  # names are what they are, dollar signs too
    "axes.labelcolor": INK,
    "axes.edgecolor": LINE,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "axes.unicode_minus": True,
    "grid.color": BAND,
    "grid.linewidth": 0.7,
    "xtick.color": SOFT,
    "ytick.color": SOFT,
    "xtick.major.size": 3,
    "ytick.major.size": 3,
    "hatch.linewidth": 0.8,
    "path.simplify": True,
    "path.simplify_threshold": 0.2,
    "svg.fonttype": "path",
    "svg.hashsalt": "pam-cosim",
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
}


@dataclass(frozen=True)
class Picture:
    """A figure inside a page.

    Attributes:
        uri: the picture itself, as a data URI.
        alt: what it shows, for those who cannot see it.
        caption: what to see in it.
    """

    uri: str
    alt: str
    caption: str = ""


def balance_colours(order: Sequence[str], further: Sequence[str] = ()) -> dict[str, str]:
    """A colour for each balance of a field, in its order, for ``further`` ones after them, and for the sensor."""
    names = dict.fromkeys([*order, *sorted(further)])
    names.pop("sensor", None)
    return {name: BALANCES[i % len(BALANCES)] for i, name in enumerate(names)} | {"sensor": SENSOR}


@contextmanager
def drawing() -> Iterator[None]:
    """The settings of all figures, for as long as one is drawn and saved."""
    with matplotlib.rc_context():
        # A user's matplotlibrc must not change a report; the backend is left alone, no context would restore it.
        settings: Any = matplotlib.rcParams
        settings.update(
            {k: v for k, v in matplotlib.rcParamsDefault.items() if not k.startswith("backend")}
        )
        settings.update(_SETTINGS)
        yield


def new_figure(width: float, height: float) -> Figure:
    """An empty figure [in] without any global state."""
    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def picture(figure: Figure, alt: str, caption: str) -> Picture:
    """The figure as an embedded vector picture; call it inside ``drawing``."""
    file = io.BytesIO()
    figure.savefig(file, format="svg", dpi=160, metadata={"Date": None, "Creator": None})
    return Picture(
        "data:image/svg+xml;base64," + base64.b64encode(file.getvalue()).decode("ascii"),
        alt,
        caption,
    )


def png(figure: Figure, dpi: float = 150) -> bytes:
    """The figure as a PNG file; call it inside ``drawing``."""
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=dpi, metadata={"Software": None})
    return file.getvalue()


def message(axes: Axes, text: str) -> None:
    """An empty panel that says why it is empty."""
    axes.text(
        0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=SOFT, fontsize=8
    )
