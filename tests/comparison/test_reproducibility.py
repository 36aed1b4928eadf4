"""What comes again in other runs, and what does not."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from pam_cosim.comparison import RunComparison, reproducibility
from pam_cosim.measurement import Signal
from tests.comparison.test_residual_statistics import red, white
from tests.fitting.models import recording

Array = NDArray[np.float64]
SIGNALS = {"y": Signal("y", "1", 1.0)}
TIME = np.linspace(0.0, 10.0, 501)


def _runs(error: Callable[[int, Array], Array], count: int = 6) -> list[RunComparison]:
    """Runs of a model whose output swings at a different pace in each; what was measured differs by ``error``."""
    runs = []
    for k in range(count):
        y = np.sin((1 + 0.3 * k) * TIME + k)
        runs.append(RunComparison(recording(TIME, {"y": y + error(k, y)}), {"y": y}))
    return runs


@pytest.mark.parametrize("seed", range(5))
def test_noise_of_any_colour_does_not_come_again(seed: int) -> None:
    for noise in (
        lambda k, y: white(100 * seed + k, 501),
        lambda k, y: red(0.9, 100 * seed + k, 501),
        lambda k, y: (
            white(100 * seed + k, 501) + 0.7 * np.sin(0.4 * TIME + white(seed + k, 1)[0] * 7)
        ),
    ):
        repeated = reproducibility(_runs(noise), SIGNALS)
        assert repeated.variance < 0.02 or repeated.score < 1.0


@pytest.mark.parametrize("runs", [2, 3, 6])
def test_an_effect_of_the_signal_comes_again(runs: int) -> None:
    """A cubic of the signal with 0.4 of the noise's variance."""
    repeated = reproducibility(_runs(lambda k, y: white(k, 501) + 1.1 * y**3, runs), SIGNALS)
    assert repeated.variance == pytest.approx(1.1**2 * 5 / 16, rel=0.4) and repeated.score > 2


def test_too_few_runs_and_missing_samples() -> None:
    assert np.isnan(reproducibility([], SIGNALS).variance)
    runs = _runs(lambda k, y: np.where(np.arange(501) % 3 == 0, np.nan, y), 3)
    assert reproducibility(runs, SIGNALS).variance == pytest.approx(0.5, rel=0.3)
    assert np.isnan(reproducibility(runs, {}).variance)
