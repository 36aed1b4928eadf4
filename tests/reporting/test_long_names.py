"""Pictures with the longest names, many runs and letters of other scripts: nothing is cut off or covers an axis."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from pam_cosim.diagnosis.planning import PlannedRun, RunPlan
from pam_cosim.diagnosis.planning.run_plan import Separation
from pam_cosim.errors import InputError
from pam_cosim.fitting import Estimate
from pam_cosim.reporting import draw
from pam_cosim.reporting.diagnosis_page import layers_of, rungs_of
from pam_cosim.reporting.figures.fitted import fit_figure
from pam_cosim.reporting.figures.ladder import Rung
from pam_cosim.reporting.figures.showcase import showcase
from pam_cosim.reporting.plots import figure_of
from pam_cosim.reporting.representative_run import most_telling
from pam_cosim.reporting.style import drawing, image
from tests.reporting.synthetic import make_comparison, make_data, make_diagnosis, make_fit

LONG = "muscle.sleeve.alpha_0/stated of the upper"  # as long as the longest of the catalogue
RIVALS = tuple(f"{LONG}.{i} + ProportionalFriction" for i in range(4))
PLACES = ("p", "x", "T", "angle.of.the.upper.lever")
NARROW = 88 / 25.4  # in


def long_diagnosis() -> Figure:
    diagnosis = make_diagnosis("identified")
    layers = [replace(layer, label=f"with {LONG}") for layer in layers_of(diagnosis)]
    first, last = rungs_of(diagnosis)[0], rungs_of(diagnosis)[-1]
    rungs = [first, *(Rung(f"+ {rival}", last.scores) for rival in RIVALS[:3])]
    telling = most_telling(layers, list(diagnosis.data.signals.values()))
    assert telling is not None
    run, signal = telling
    named = replace(run, run=replace(run.run, name=LONG))
    layers = [
        replace(
            layer,
            comparison=replace(
                layer.comparison,
                runs=tuple(
                    replace(one, run=replace(one.run, name=LONG))
                    for one in layer.comparison.runs
                    if one.run.name == run.run.name
                ),
            ),
        )
        for layer in layers
    ]
    return showcase(layers, rungs, named, signal)


def long_plan() -> Figure:
    time = np.linspace(0.0, 8.0, 200)
    predicted = {
        rival: {name: (k + 1) * 1e3 * np.sin(time + k) for name in PLACES}
        for k, rival in enumerate(RIVALS)
    }
    pairs = tuple(Separation(a, b, 42.0) for i, a in enumerate(RIVALS) for b in RIVALS[i + 1 :])
    table = {"time": [0.0, 4.0, 4.0, 8.0], "u_in": [0.0, 0.0, 0.3, 0.3], "p_supply": [5e5] * 4}
    run = PlannedRun({"load.m": 5.0}, table, pairs, 3.0, time, predicted)
    units = dict.fromkeys(PLACES, "Pa") | {"u_in": "A", "p_supply": "Pa", "load.m": "kg"}
    sigma = dict.fromkeys(PLACES, 500.0)
    explanations = tuple((rival,) for rival in RIVALS)
    return figure_of(
        RunPlan(
            "rig", "M", "ambiguous", RIVALS, explanations, ("leak",), (run, run), units, sigma, 120
        )
    )


def many_runs() -> Figure:
    return figure_of(make_comparison(make_data(("fit", "holdout") * 6, 60), 3.0))


def long_fit() -> Figure:
    """Four parameters with long names, their correlations, and two descents."""
    estimates = {f"{LONG}.{i}": Estimate(1e3, 900.0, 1100.0, "Pa") for i in range(4)}
    fit = make_fit(make_data(("fit",), 60), 1.0, estimates)
    return fit_figure(replace(fit, correlation=np.eye(4)))


@pytest.mark.parametrize("width", [None, NARROW], ids=["page", "column"])
@pytest.mark.parametrize("made", [long_diagnosis, long_plan, many_runs, long_fit])
def test_nothing_is_cut_off_and_axes_keep_room(
    made: Callable[[], Figure], width: float | None
) -> None:
    with drawing(width):
        figure = made()
        FigureCanvasAgg(figure).draw()
        drawn, (wide, high) = figure.get_tightbbox(), figure.get_size_inches()
        assert width is None or wide == pytest.approx(width)
        assert drawn.x0 >= -0.03 and drawn.x1 <= wide + 0.03
        assert drawn.y0 >= -0.03 and drawn.y1 <= high + 0.03
        for axes in figure.axes:
            box = axes.get_window_extent()
            assert box.width > 0.6 * figure.dpi and box.height > 0.4 * figure.dpi
            low, high = sorted(axes.get_xlim())
            ticks = zip(axes.get_xticks(), axes.get_xticklabels(), strict=False)
            labels = [one.get_window_extent() for at, one in ticks if low <= at <= high]
            apart = (a.x1 <= b.x0 + 1 for a, b in itertools.pairwise(labels) if a.width and b.width)
            assert all(apart)


def test_letters_that_no_font_has_are_replaced_by_plain_ones() -> None:
    with drawing():
        figure = many_runs()
        figure.suptitle("\U0001f9ea \u0378 p [kPa]")
        image(figure)
        words = [text.get_text() for text in figure.findobj(Text)]
    assert any(word.endswith("? p [kPa]") for word in words)


@pytest.mark.parametrize(
    ("ending", "begins"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")]
)
def test_a_picture_has_the_format_of_its_name(tmp_path: Path, ending: str, begins: bytes) -> None:
    for name in ("a", "b"):
        draw(make_comparison(make_data(("fit",), 40), 3.0), tmp_path / f"{name}.{ending}", "88 mm")
    content = (tmp_path / f"a.{ending}").read_bytes()
    assert content.startswith(begins) and content == (tmp_path / f"b.{ending}").read_bytes()


@pytest.mark.parametrize("width", ["88", "wide", "2 mm", "3 kg"])
def test_a_width_that_is_none_is_refused(tmp_path: Path, width: str) -> None:
    with pytest.raises(InputError, match="width of a picture|cannot be drawn"):
        draw(make_comparison(make_data(("fit",), 40), 3.0), tmp_path / "a.png", width)
    assert not list(tmp_path.iterdir())
