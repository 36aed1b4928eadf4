"""Profile likelihood against what is known exactly, and what is said of parameters that data do not determine."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.fitting.profile import correlations
from pam_cosim.reporting import plot_fit
from tests.fitting.models import vessel_data
from tests.fitting.test_swarm import confounded
from tests.pictures import drawn


@pytest.mark.full
def test_profile_of_a_well_determined_fit_ends_where_its_interval_does(tmp_path: Path) -> None:
    data = vessel_data()
    fit = pam.fit(data)
    made = pam.profile(data, fit)
    for name, estimate in fit.parameters.items():
        profile = made.profiles[name]
        assert profile.determined and profile.values[0] < estimate.value < profile.values[-1]
        assert np.all(np.diff(profile.values) > 0) and profile.rise.min() == 0
        width = estimate.high - estimate.low
        assert profile.low == pytest.approx(estimate.low, abs=0.1 * width)
        assert profile.high == pytest.approx(estimate.high, abs=0.1 * width)
        assert f"{name} lies between" in str(made)
    pam.draw(made, tmp_path / "profiles.png")
    plot_fit(fit, tmp_path / "fit.png")
    assert drawn(tmp_path / "profiles.png") and drawn(tmp_path / "fit.png")
    again = pam.load(pam.save(made, tmp_path / "profiles.npz"))
    assert str(again) == str(made)


@pytest.mark.parametrize(("law", "power"), [("a*b", -1), ("a/b", 1)])
def test_what_is_not_determined_is_said_with_what_follows_it(
    law: str, power: int, tmp_path: Path
) -> None:
    fit = confounded(law, tmp_path)
    model = str(tmp_path / "Product.mo")
    made = pam.profile(pam.read(tmp_path, model=model), fit, model)
    assert (
        fit.correlation[0, 1] == pytest.approx(power, abs=1e-3) and abs(fit.correlation[0, 2]) < 0.1
    )
    assert not fit.confused()  # the combination says it
    a, c = made.profiles["a"], made.profiles["c"]
    assert not a.determined and c.determined
    assert a.followers() == {"b": pytest.approx(power, abs=0.02)}
    assert "these data do not determine a: anything from" in a.sentence()
    assert "others follow: b as its power" in a.sentence() and "c lies between" in str(made)


def test_correlation_matrix_by_hand() -> None:
    jacobian = np.array([[1.0, 0.9, 0.0], [0.0, np.sqrt(0.19), 0.0]])
    matrix = correlations(jacobian)
    np.testing.assert_allclose(matrix[:2, :2], [[1, -0.9], [-0.9, 1]], atol=1e-12)
    assert np.isnan(matrix[2]).all() and np.isnan(matrix[:, 2]).all()


def test_fit_says_which_parameters_are_hardly_told_apart() -> None:
    fit = pam.fit(vessel_data())
    assert fit.correlation.shape == (2, 2) and fit.correlation[0, 1] == pytest.approx(
        fit.correlation[1, 0]
    )
    close = abs(fit.correlation[0, 1]) > 0.95
    assert bool(fit.confused()) == close == ("hardly be separated" in str(fit))
