"""The noise of points along curves, where some stand at one place or nearly so."""

from __future__ import annotations

import warnings

import numpy as np

from pam_cosim.measurement.noise import _along_curves


def test_places_that_are_repeated_or_next_to_one_another_give_a_number_and_no_warning() -> None:
    chance = np.random.default_rng(1)
    at = np.sort(np.concatenate([np.arange(200.0), np.arange(0.0, 200.0, 2.0), [0.0, 1e-160]]))
    y = 3.0 * at + chance.normal(0.0, 0.5, len(at))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        sigma = _along_curves([(at, y), (np.zeros(20), y[:20])])
    assert 0.3 < sigma < 0.7
