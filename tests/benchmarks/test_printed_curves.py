"""A curve that is drawn in a notebook is read back to within half a pixel."""

from __future__ import annotations

import base64
import json
from io import BytesIO

import matplotlib.pyplot as plt
import numpy as np
import pytest

from benchmarks.real_rigs.printed_curves import Panel, picture

BLUE, YELLOW = "#648fff", "#ffb000"


def notebook_of(first: np.ndarray, second: np.ndarray) -> tuple[bytes, Panel]:
    """A notebook that shows both courses, and where its axes are."""
    figure, axis = plt.subplots(figsize=(4, 3), dpi=150)
    axis.plot(first, color=BLUE, lw=1)
    axis.plot(second, color=YELLOW, lw=1)
    axis.set(xlim=(0, 100), ylim=(0, 10))
    figure.canvas.draw()
    height = figure.bbox.height
    (x_0, y_0), (x_1, y_1) = axis.transData.transform([(0, 0), (100, 10)])
    stream = BytesIO()
    figure.savefig(stream, dpi=150, transparent=True)
    plt.close(figure)
    data = {"image/png": base64.b64encode(stream.getvalue()).decode()}
    panel = Panel(
        (int(height - y_1) + 4, int(height - y_0) - 3),
        [(0, x_0 - 0.5), (100, x_1 - 0.5)],
        [(0, height - y_0 - 0.5), (10, height - y_1 - 0.5)],
        96,
    )
    return json.dumps(
        {"cells": [{"outputs": [{"text": "no picture"}, {"data": data}]}, {}]}
    ).encode(), panel


def test_two_lines_that_cross_are_told_apart_by_their_colours() -> None:
    at = np.arange(101.0)
    rise, fall = 1 + 8 * np.tanh(at / 30), 9 * np.exp(-at / 40) + 0.5
    notebook, panel = notebook_of(rise, fall)
    image = picture(notebook, 0)
    pixel = 10 / (panel.up[0][1] - panel.up[1][1])
    read = panel.course(image, YELLOW, [BLUE], panel.up[0][1] - 9.5 / pixel)
    assert read[2:] == pytest.approx(fall[2:96], abs=0.5 * pixel)
    hidden = np.abs(rise - fall) < 12 * pixel
    read = panel.course(image, BLUE, [YELLOW], panel.up[0][1] - 1 / pixel)
    assert read[2:][~hidden[2:96]] == pytest.approx(rise[2:96][~hidden[2:96]], abs=0.7 * pixel)


def test_a_cell_without_a_picture_is_said() -> None:
    notebook, _ = notebook_of(np.zeros(2), np.ones(2))
    with pytest.raises(ValueError, match="cell 1 of the notebook shows no picture"):
        picture(notebook, 1)
