"""Rules find an error that was planted."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from pam_cosim.comparison import Rule, RunComparison, where
from pam_cosim.measurement import Signal
from tests.comparison.fake import OUTPUTS, run
from tests.field import DOMAIN

Array = NDArray[np.float64]
TIME = np.linspace(0.0, 10.0, 1001)
# rises to 200 kPa in 4 s, rests for 2 s, falls in 4 s
P = 200e3 * np.interp(TIME, [0.0, 4.0, 6.0, 10.0], [0.0, 1.0, 1.0, 0.0])
X = 0.06 * (P / 200e3) ** 2
SIGMA = 0.2e-3


def rules(
    planted: Callable[[Array, Array], Array], size: float = 2e-3, runs: int = 1, seed: int = 0
) -> list[Rule]:
    """The rules for x when the rig differs from the model where ``planted(time, p)``, in the first run only."""
    rng = np.random.default_rng(seed)
    compared = []
    for k in range(runs):
        error = size * planted(TIME, P) * (k == 0) + SIGMA * rng.standard_normal(len(TIME))
        compared.append(RunComparison(run(f"run-{k}", TIME, x=X + error), {"p": P, "x": X}))
    return where(compared, {"x": Signal("x", "m", SIGMA)}, OUTPUTS, DOMAIN)


def share(planted: Callable[[Array, Array], Array]) -> float:
    return float(np.mean(planted(TIME, P)))


@pytest.mark.parametrize(
    ("words", "planted"),
    [
        (["filling"], lambda t, p: t < 4),
        (["holding"], lambda t, p: (t >= 4) & (t < 6)),
        (["venting"], lambda t, p: t > 6),
        (["filling", "50 kPa < p < 100 kPa"], lambda t, p: (t < 4) & (p > 50e3) & (p < 100e3)),
        (["venting", "middle"], lambda t, p: (t > 6) & (t < 6.67)),
    ],
)
def test_planted_error_is_found(words: list[str], planted: Callable[[Array, Array], Array]) -> None:
    best = rules(planted)[0]
    for word in words:
        assert word in best.rule
    assert best.signal == "x"
    assert best.error_share > 0.93
    assert best.time_share == pytest.approx(share(planted), abs=0.02)


def test_pressure_band_alone() -> None:
    """An error below 100 kPa in either direction is two bands, or more generally rules that all lie there."""
    stated = rules(lambda t, p: p < 50e3)
    assert (
        stated[0].rule == "0 kPa < p < 50 kPa"
        or "x <" in stated[0].rule
        or " < x" in stated[0].rule
    )
    assert stated[0].error_share > 0.93
    assert stated[0].time_share == pytest.approx(0.2, abs=0.02)


def test_error_in_one_run() -> None:
    best = rules(lambda t, p: t >= 0, runs=3)[0]
    assert best.rule == "in run-0"
    assert best.error_share > 0.93
    assert best.time_share == pytest.approx(1 / 3, abs=0.01)


def test_two_places_are_two_rules() -> None:
    stated = rules(lambda t, p: 1.0 * (t < 4) + 1.0 * (t > 8))
    assert stated[0].rule.startswith("filling")
    assert any("late" in r.rule or "venting" in r.rule for r in stated[1:]), stated


def test_error_within_the_noise_is_no_rule() -> None:
    """Differences that stay below the noise have no place."""
    compared = RunComparison(run("0", TIME, x=X + 0.9 * SIGMA), {"p": P, "x": X})
    assert where([compared], {"x": Signal("x", "m", SIGMA)}, OUTPUTS, DOMAIN) == []


@pytest.mark.parametrize("seed", range(5))
def test_plain_noise_has_no_place(seed: int) -> None:
    for rule in rules(lambda t, p: np.zeros(len(t)), seed=seed):
        assert rule.error_share < 2 * rule.time_share + 0.05, rule


def test_missing_samples_do_not_count() -> None:
    x = np.where(TIME < 4, X + 1e-3, X)
    x[::2] = np.nan
    compared = RunComparison(run("0", TIME, x=x), {"p": P, "x": X})
    best = where([compared], {"x": Signal("x", "m", SIGMA)}, OUTPUTS, DOMAIN)[0]
    assert best.rule.startswith("filling")
    assert best.error_share == pytest.approx(1.0)
    assert best.time_share == pytest.approx(0.4, abs=0.01)


def test_steps_in_time_do_not_break_the_phases() -> None:
    """Two rows at one time are a step: no division by zero, no phase of their own."""
    time = np.insert(TIME, 500, TIME[500])
    p, x = np.insert(P, 500, P[500]), np.insert(X, 500, X[500])
    compared = RunComparison(run("0", time, x=np.where(time < 4, x + 1e-3, x)), {"p": p, "x": x})
    assert where([compared], {"x": Signal("x", "m", SIGMA)}, OUTPUTS, DOMAIN)[0].rule.startswith(
        "filling"
    )
