"""What holds pictures and texts against the documentation sees what has changed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import rgb_to_hsv
from matplotlib.figure import Figure
from matplotlib.image import imread, imsave

from tests.documentation.pages import DOCS, other_pictures, stands_in
from tests.pictures import drawn

PICTURE = "fit-methods.png"
CURVES = {
    "differential-evolution": 205,
    "least-squares": 28,
    "multi-start": 120,
    "particle-swarm": 0,
}  # hue [degrees]


def kept(folder: Path, picture: np.ndarray) -> bool:
    imsave(folder / PICTURE, picture)
    return other_pictures(folder, by_processor=True) == []


@pytest.mark.parametrize("curve", CURVES)
def test_a_curve_that_vanished_is_missed(curve: str, tmp_path: Path) -> None:
    picture = imread(DOCS / "pictures" / PICTURE)[..., :3]
    hue, saturation, _ = np.moveaxis(rgb_to_hsv(picture), -1, 0)
    away = np.abs((hue * 360 - CURVES[curve] + 180) % 360 - 180)
    gone = np.where(((away < 10) & (saturation > 0.05))[..., None], 1.0, picture)
    assert kept(tmp_path, picture) and not kept(tmp_path, gone)


def test_a_step_that_moved_and_a_mark_more_are_borne(tmp_path: Path) -> None:
    picture = imread(DOCS / "pictures" / PICTURE)[..., :3].copy()
    step = picture[190:295, 485:496].copy()  # the fall of the swarm to its second best value
    picture[190:295, 490:501] = step
    picture[250:260, 600:602] = (0.84, 0.15, 0.16)
    assert kept(tmp_path, picture)


def test_empty_axes_show_nothing(tmp_path: Path) -> None:
    figure = Figure(figsize=(8, 6), layout="constrained")
    axes = figure.subplots(2, 2).ravel()
    for one in axes:
        one.set(xlabel="time", ylabel="pressure", title="a title")
        one.grid()
    figure.savefig(tmp_path / "empty.png")
    axes[3].plot([0.4, 0.6], [1.0, 2.0])
    axes[3].set_xlim(0.0, 1.0)
    figure.savefig(tmp_path / "line.png")
    assert (tmp_path / "empty.png").stat().st_size > 10_000
    assert drawn(tmp_path / "line.png") and not drawn(tmp_path / "empty.png")


def test_only_counts_may_differ_by_more_than_their_digits() -> None:
    line = "120 simulations, chi-square 1.5 and 3 starts"
    assert stands_in(line, "123 simulations, chi-square 1.5 and 1 starts", more=3)
    assert not stands_in(line, "120 simulations, chi-square 1.6 and 3 starts", more=3)
    assert not stands_in(line, "127 simulations, chi-square 1.5 and 3 starts", more=3)
    assert not stands_in(line, "124 simulations, chi-square 1.5 and 3 starts")
