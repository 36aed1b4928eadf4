"""The figures of ``fit --plot`` and ``--profile``: axes that can be read, and what is marked."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure

from pam_cosim.fitting import Convergence, Fit, Profiles
from pam_cosim.fitting.profile import Profile
from pam_cosim.reporting.figures.fitted import fit_figure, profile_figure
from pam_cosim.reporting.style import drawing
from tests.reporting.synthetic import make_data, make_fit


def fitted(chi2: list[float], descents: list[float]) -> Fit:
    made = make_fit(make_data(), 1.0)
    course = Convergence(np.arange(1, len(chi2) + 1), np.array(chi2), np.array(descents))
    return replace(made, convergence=course, correlation=np.eye(1))


def drawn(figure: Figure) -> Figure:
    figure.canvas.draw()
    return figure


@pytest.mark.parametrize("chi2", [[3140.0, 3020.0], [31.0, 2.5], [5e4, 2.0]])
def test_chi_square_has_numbers_at_its_axis(chi2: list[float]) -> None:
    with drawing():
        axes = drawn(fit_figure(fitted(chi2, [chi2[-1]]))).axes[0]
        low, high = axes.get_ylim()
        labels = [label.get_text() for label in axes.get_yticklabels()]
        inside = [t for t, y in zip(labels, axes.get_yticks(), strict=True) if low <= y <= high]
    assert len([text for text in inside if text]) >= 2, labels


def test_a_profile_shows_level_ends_and_estimate() -> None:
    values = np.linspace(0.0, 2.0, 9)
    profile = Profile("k", "N/m", 1.0, values, 8 * (values - 1) ** 2, 0.3, np.inf, {})
    with drawing():
        axes = profile_figure(Profiles("M", {"k": profile})).axes[0]
    assert {text.get_text().strip() for text in axes.texts} == {"95 %", "estimate"}
    ends = [line.get_xdata()[0] for line in axes.lines if line.get_linestyle() == ":"]
    assert ends == [0.3]
    assert any(line.get_marker() == "D" for line in axes.lines)
