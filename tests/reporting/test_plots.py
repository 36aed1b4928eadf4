from __future__ import annotations

import os
import struct

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.reporting import (
    draw,
    write_report,
)
from pam_cosim.reporting.diagnosis_page import rungs_of
from pam_cosim.reporting.figures.ladder import draw_ladder
from pam_cosim.reporting.figures.trajectory import trajectory_figure
from pam_cosim.reporting.style import drawing, new_figure
from pam_cosim.simulation import Trajectory
from tests.reporting.synthetic import SIGNALS, make_data, make_diagnosis
from tests.tiers import quick


def size(path):
    content = path.read_bytes()
    assert content[:8] == b"\x89PNG\r\n\x1a\n"
    return struct.unpack(">II", content[16:24])


def trajectory():
    time = np.linspace(0, 5, 50)
    return Trajectory(
        time,
        {"p": 1e5 * time, "x": 0.01 * time, "eps": 0.1 * time},
        {"p": "Pa", "x": "m", "eps": "1"},
    )


def test_a_trajectory_has_one_panel_each_in_readable_units(tmp_path):
    figure = trajectory_figure(trajectory())
    assert [a.get_ylabel() for a in figure.axes] == ["p [kPa]", "x [mm]", "eps"]
    assert figure.axes[0].lines[0].get_ydata()[-1] == pytest.approx(500)
    draw(trajectory(), tmp_path / "a.png")
    draw(trajectory(), tmp_path / "b.png")
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert size(tmp_path / "a.png")[0] == 1200


def test_the_ladder_shows_the_errors_as_scored():
    diagnosis = make_diagnosis("identified")
    with drawing():
        axes = new_figure(4, 3).subplots()
        draw_ladder(axes, rungs_of(diagnosis), SIGNALS["x"], 4.0)
    heights = [bar.get_height() for bar in axes.patches]
    expected = [
        fit.comparison.scores[role]["x"].rmse * 1e3
        for fit in (diagnosis.base, diagnosis.final)
        for role in ("fit", "holdout")
    ]
    assert heights == pytest.approx(expected)
    assert [t.get_text() for t in axes.get_xticklabels()] == ["base model", "+ StiffWall"]
    assert axes.lines[-1].get_ydata()[0] == pytest.approx(0.2)


@pytest.mark.parametrize("kind", quick(["identified", "none_missing"], "identified"))
@pytest.mark.parametrize("samples", [15, 1000])
def test_the_ladder_figure_is_a_png_of_1350_pixels(tmp_path, kind, samples):
    draw(make_diagnosis(kind, make_data(samples=samples)), tmp_path / "ladder.png")
    assert size(tmp_path / "ladder.png")[0] == 1350


def test_a_report_is_written_whole(tmp_path):
    write_report(tmp_path / "r.html", "<p>é</p>")
    write_report(tmp_path / "r.html", "<p>è</p>")
    assert (tmp_path / "r.html").read_text(encoding="utf-8") == "<p>è</p>"
    assert os.listdir(tmp_path) == ["r.html"]


def test_files_that_cannot_be_written_are_named(tmp_path):
    with pytest.raises(InputError, match="folder does not exist"):
        write_report(tmp_path / "missing" / "r.html", "x")
    with pytest.raises(InputError, match="name a file"):
        write_report(tmp_path, "x")
    with pytest.raises(InputError, match="folder does not exist"):
        draw(trajectory(), tmp_path / "missing" / "r.png")
    with pytest.raises(InputError, match="no output to draw"):
        draw(Trajectory(np.zeros(0), {}, {}), tmp_path / "r.png")
    assert os.listdir(tmp_path) == []
