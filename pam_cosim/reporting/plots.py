"""Single pictures as PNG files."""

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
from pam_cosim.reporting.style import drawing, png
from pam_cosim.simulation import Trajectory
from pam_cosim.sweeps import Sweep


def _check(path: Path | str) -> None:
    """Finds out before the work whether a picture can be written there."""
    check_ending(Path(path), "pictures are drawn as PNG", PICTURE)
    check_writable(Path(path))


@singledispatch
def draw(product: Any, path: Path | str) -> None:
    """Draws a product of a study as PNG: its signals over time, or the error coming down.

    Raises:
        InputError: nothing to draw, another kind of thing, or the file cannot be written.
    """
    raise InputError(f"a {type(product).__name__} cannot be drawn", Path(path))


@draw.register
def plot_trajectory(trajectory: Trajectory, path: Path | str) -> None:
    """Draws every signal of a simulation, one panel each, as PNG.

    Raises:
        InputError: there is nothing to draw, or the file cannot be written.
    """
    if not trajectory.values or not len(trajectory.time):
        raise InputError("the simulation has no output to draw")
    _check(path)
    with drawing():
        write_bytes(Path(path), png(trajectory_figure(trajectory)))


@draw.register
def _(product: Fit, path: Path | str) -> None:
    plot_comparison(product.comparison, path)


@draw.register
def plot_comparison(comparison: Comparison, path: Path | str) -> None:
    """Draws measured and modelled signals of all runs, one column a run, as PNG.

    Raises:
        InputError: the file cannot be written.
    """
    _check(path)
    layers = (alone(comparison),)
    few = max(len(r.run.time) for r in comparison.runs) <= SPARSE
    with drawing():
        signals = list(comparison.data.signals.values())
        figure = panels(comparison.runs, signals, lambda a, r, s: draw_curves(a, r, s, layers))
        handles = legend(layers, few)
        figure.legend(handles=handles, loc="outside upper center", ncols=len(handles))
        write_bytes(Path(path), png(figure))


def plot_fit(fit: Fit, path: Path | str) -> None:
    """Draws how a fit came down, where its descents ended and how its parameters hang together, as PNG.

    Raises:
        InputError: the file cannot be written.
    """
    _check(path)
    with drawing():
        write_bytes(Path(path), png(fit_figure(fit)))


@draw.register
def _(product: ConditionTable, path: Path | str) -> None:
    plot_tables([product], path)


def plot_tables(tables: Sequence[ConditionTable], path: Path | str) -> None:
    """Draws tables over the same conditions, a row of maps for each signal, as PNG.

    Raises:
        InputError: the file cannot be written.
    """
    _check(path)
    with drawing():
        write_bytes(Path(path), png(condition_maps(tables)))


def _registered(kind: type[Any], figure: Callable[[Any], Figure]) -> None:
    """``draw`` of such a product is this one figure."""

    def draw_one(product: Any, path: Path | str) -> None:
        _check(path)
        with drawing():
            write_bytes(Path(path), png(figure(product)))

    draw.register(kind, draw_one)


_registered(Sweep, sweep_figure)
_registered(Profiles, profile_figure)
_registered(Ledger, ledger_figure)
_registered(LinearModel, bode)
_registered(FrequencyResponse, frequency_figure)
_registered(Observation, observation_figure)
_registered(LinearModels, poles_along)
_registered(RunPlan, plan_figure)
_registered(PredictiveBands, bands_figure)


@draw.register
def error_ladder_figure(diagnosis: Diagnosis, path: Path | str) -> None:
    """Draws the diagnosis in one picture, 1350 pixels wide: the most informative run and the falling error.

    Raises:
        InputError: the data hold no sample, or the file cannot be written.
    """
    _check(path)
    layers, rungs = layers_of(diagnosis), rungs_of(diagnosis)
    telling = most_telling(layers, list(diagnosis.data.signals.values()))
    if telling is None:
        raise InputError("the data hold no sample to draw", diagnosis.data.folder)
    with drawing():
        write_bytes(Path(path), png(showcase(layers, rungs, *telling)))
