"""Single pictures as files: PNG, SVG or PDF."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import singledispatch
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from pam_cosim.analysis import FrequencyResponse, LinearModel, LinearModels, Observation
from pam_cosim.comparison import Comparison, ConditionTable
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.planning import RunPlan
from pam_cosim.errors import InputError
from pam_cosim.files import PICTURE, check_ending, check_writable, write_bytes
from pam_cosim.fitting import Fit, PredictiveBands, Profiles
from pam_cosim.ledger import Ledger
from pam_cosim.reporting.diagnosis_page import layers_of, rungs_of
from pam_cosim.reporting.figures.banded import bands_figure
from pam_cosim.reporting.figures.bode import bode, poles_along
from pam_cosim.reporting.figures.condition_maps import condition_maps
from pam_cosim.reporting.figures.curves import draw_curves, legend
from pam_cosim.reporting.figures.fitted import fit_figure, profile_figure
from pam_cosim.reporting.figures.frequency import frequency_figure
from pam_cosim.reporting.figures.layer import SPARSE, alone
from pam_cosim.reporting.figures.ledger import ledger_figure
from pam_cosim.reporting.figures.observed import observation_figure
from pam_cosim.reporting.figures.panels import panels
from pam_cosim.reporting.figures.planned import plan_figure
from pam_cosim.reporting.figures.showcase import showcase
from pam_cosim.reporting.figures.sweep import sweep_figure
from pam_cosim.reporting.figures.trajectory import trajectory_figure
from pam_cosim.reporting.representative_run import most_telling
from pam_cosim.reporting.style import drawing, image, legend_outside
from pam_cosim.simulation import Trajectory
from pam_cosim.sweeps import Sweep
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import shown

_INCH = 0.0254  # m


def draw(product: Any, path: Path | str, width: str | float | None = None) -> None:
    """Draws a product of a study: its signals over time, or the error coming down.

    Args:
        product: of a study.
        path: ends in .png, .svg or .pdf.
        width: of the picture, such as "88 mm", the column of a journal [m]; default: that of a page.

    Raises:
        InputError: nothing to draw, another kind of thing, no such width, or the file cannot be written.
    """
    _drawn(lambda: figure_of(product), path, width)


def plot_fit(fit: Fit, path: Path | str, width: str | float | None = None) -> None:
    """Draws the convergence of a fit, the ends of its descents and the correlation of its parameters; as ``draw``."""
    _drawn(lambda: fit_figure(fit), path, width)


def plot_tables(
    tables: Sequence[ConditionTable], path: Path | str, width: str | float | None = None
) -> None:
    """Draws tables over the same conditions, a row of maps for each signal; as ``draw``."""
    _drawn(lambda: condition_maps(tables), path, width)


def _drawn(figure: Callable[[], Figure], path: Path | str, width: str | float | None) -> None:
    file = Path(path)
    check_ending(file, "pictures are drawn as PNG, SVG or PDF", PICTURE)
    check_writable(file)
    with drawing(inches_of(width)):
        write_bytes(file, image(figure(), file.suffix.lower().removeprefix(".")))


def inches_of(width: str | float | None) -> float | None:
    """A width of a picture, with a unit or in metres [in]; None: that of a page.

    Raises:
        InputError: it is no length, or nothing can be drawn so wide.
    """
    if width is None:
        return None
    try:
        inches = (parse_quantity(width, "m") if isinstance(width, str) else width) / _INCH
    except UnitError as problem:
        raise InputError(f"the width of a picture: {problem}") from None
    if not 1.5 <= inches <= 40:
        raise InputError(f"a picture {shown(width)} wide cannot be drawn; a column is '88 mm' wide")
    return inches


@singledispatch
def figure_of(product: Any) -> Figure:
    """The figure of a product; called inside ``drawing``.

    Raises:
        InputError: there is nothing to draw, or it is another kind of thing.
    """
    raise InputError(f"a {type(product).__name__} cannot be drawn")


@figure_of.register
def _(trajectory: Trajectory) -> Figure:
    if not trajectory.values or not len(trajectory.time):
        raise InputError("the simulation has no output to draw")
    return trajectory_figure(trajectory)


@figure_of.register
def _(product: Fit) -> Figure:
    return figure_of(product.comparison)


@figure_of.register
def _(comparison: Comparison) -> Figure:
    layers, signals = (alone(comparison),), [*comparison.data.signals.values()]
    is_sparse = max(len(r.run.time) for r in comparison.runs) <= SPARSE
    figure = panels(comparison.runs, signals, lambda a, r, s: draw_curves(a, r, s, layers))
    legend_outside(figure, legend(layers, is_sparse))
    return figure


@figure_of.register
def _(table: ConditionTable) -> Figure:
    return condition_maps([table])


@figure_of.register
def _(diagnosis: Diagnosis) -> Figure:
    """In one picture, the most informative run and the falling error."""
    layers, rungs = layers_of(diagnosis), rungs_of(diagnosis)
    telling = most_telling(layers, list(diagnosis.data.signals.values()))
    if telling is None:
        raise InputError("the data hold no sample to draw", diagnosis.data.folder)
    return showcase(layers, rungs, *telling)


_FIGURES: dict[type[Any], Callable[[Any], Figure]] = {
    Sweep: sweep_figure,
    Profiles: profile_figure,
    Ledger: ledger_figure,
    LinearModel: bode,
    FrequencyResponse: frequency_figure,
    Observation: observation_figure,
    LinearModels: poles_along,
    RunPlan: plan_figure,
    PredictiveBands: bands_figure,
}
for kind, of_kind in _FIGURES.items():
    figure_of.register(kind, of_kind)
