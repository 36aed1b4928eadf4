"""The look of every figure, and how a figure becomes a picture. Same input, same bytes."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cache
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties, findfont, fontManager, get_font
from matplotlib.text import Text

from pam_cosim.reporting.account.wording import wrapped

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
_COLUMN = 5.0  # in, below which a figure is of one column of a journal: smaller letters, panels below one another
_LETTER = 0.58  # mean width of a letter, of its size
_FURTHER_FONTS = (
    "Noto Sans CJK JP",
    "Yu Gothic",
    "Hiragino Sans",
    "Arial Unicode MS",
)
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


def balance_colours(order: Sequence[str], other_balances: Sequence[str] = ()) -> dict[str, str]:
    """A colour for each balance of a field in its order, for ``other_balances`` after them, and for the sensor."""
    names = dict.fromkeys([*order, *sorted(other_balances)])
    names.pop("sensor", None)
    return {name: BALANCES[i % len(BALANCES)] for i, name in enumerate(names)} | {"sensor": SENSOR}


_widest: ContextVar[float | None] = ContextVar("_widest", default=None)


@contextmanager
def drawing(width: float | None = None) -> Iterator[None]:
    """The settings of all figures, for as long as one is drawn and saved; ``width``: that it is drawn for [in]."""
    token = _widest.set(width)
    try:
        with _settings():
            yield
    finally:
        _widest.reset(token)


@contextmanager
def _settings() -> Iterator[None]:
    with matplotlib.rc_context():
        # A user's matplotlibrc must not change a report; the backend is left alone, no context would restore it.
        settings: Any = matplotlib.rcParams
        settings.update(
            {k: v for k, v in matplotlib.rcParamsDefault.items() if not k.startswith("backend")}
        )
        settings.update(_SETTINGS)
        settings["font.family"] = list(_fonts())
        if is_narrow():
            settings.update({key: 7.0 for key, size in _SETTINGS.items() if size in (7.5, 8.5)})
        yield


def is_narrow() -> bool:
    """Whether the figure is drawn for one column of a journal."""
    return (_widest.get() or WIDTH) < _COLUMN


@cache
def _fonts() -> tuple[str, ...]:
    """The font, and after it those that are installed and have further letters."""

    installed = fontManager.get_font_names()
    return (_SETTINGS["font.family"], *(name for name in _FURTHER_FONTS if name in installed))


@cache
def _substitute(letter: str) -> str:
    """The letter, or a question mark where no font has it."""
    if letter.isspace():
        return letter
    files = (findfont(FontProperties(family=name)) for name in _fonts())
    return letter if any(get_font(file).get_char_index(ord(letter)) for file in files) else "?"


def new_figure(width: float, height: float) -> Figure:
    """An empty figure [in] without any global state; as wide as it is drawn for, where that is stated."""
    drawn = _widest.get() or width
    height *= max(min(drawn / width, 1.0), 0.6) ** 0.5
    figure = Figure(figsize=(drawn, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def letters_in(width: float) -> int:
    """How many letters of a label fit side by side into a width [in]."""
    return max(int(72 * width / (_LETTER * (7.0 if is_narrow() else 8.5))), 8)


def legend_outside(
    figure: Figure, handles: Sequence[Any], loc: Any = "outside upper center"
) -> None:
    """A legend outside the axes, in as many columns as the figure is wide, long labels in lines."""
    room = letters_in(figure.get_size_inches()[0])
    labels = [wrapped(str(handle.get_label()), room - 8, 3) for handle in handles]
    longest = max((len(line) for label in labels for line in label.split("\n")), default=1)
    figure.legend(handles, labels, loc=loc, ncols=max(room // (longest + 7), 1))


def _finished(figure: Figure) -> Figure:
    """The figure with letters that the fonts have."""
    for text in figure.findobj(Text):
        words = text.get_text()
        if not words.isascii():
            text.set_text("".join(map(_substitute, words)))
    return figure


def picture(figure: Figure, alt: str, caption: str) -> Picture:
    """The figure as an embedded vector picture; call it inside ``drawing``."""
    content = base64.b64encode(image(figure, "svg", 160)).decode("ascii")
    return Picture("data:image/svg+xml;base64," + content, alt, caption)


_METADATA = {
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}  # that would differ from one day or version to the next


def image(figure: Figure, kind: str = "png", dpi: float = 150) -> bytes:
    """The figure as a file: png, svg or pdf; call it inside ``drawing``."""
    file = io.BytesIO()
    metadata: dict[str, Any] = _METADATA[kind]
    _finished(figure).savefig(file, format=kind, dpi=dpi, metadata=metadata)
    return file.getvalue()


def message(axes: Axes, text: str) -> None:
    """An empty panel with the reason why it is empty."""
    axes.text(
        0.5, 0.5, text, transform=axes.transAxes, ha="center", va="center", color=SOFT, fontsize=8
    )
