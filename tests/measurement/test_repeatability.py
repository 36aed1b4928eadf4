"""Repeatability: what runs of the same test differ by counts in the place of the noise where it is more."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.measurement import Run, Signal, StatedSignal, complete_noise
from pam_cosim.measurement.data_set import Along

NOISE, SCATTER = 0.3, 1.5


def runs_of(
    offsets: list[float], *, static: bool = False, load: list[float] | None = None
) -> tuple[Run, ...]:
    """Runs of one test; the force of each is off by an amount of its own, and follows small errors of the pressure."""
    rng = np.random.default_rng(1)
    runs = []
    for number, offset in enumerate(offsets):
        time = np.linspace(0, 6, 240) + (0.0 if static else rng.uniform(0, 3.0))
        pressure = 2e5 * np.abs(np.sin(time - time[0])) + rng.normal(0, 300.0)
        force = 1e-3 * pressure + offset + rng.normal(0, NOISE, len(time))
        along = Along("p", "Pa") if static else None
        at = np.linspace(0, 2e5, len(time)) if static else time
        known = {"m": load[number] if load else 1.0}
        inputs = {"p": pressure if not static else at}
        forces = force if not static else 1e-3 * at + offset + rng.normal(0, NOISE, len(time))
        runs.append(
            Run(
                f"r{number}",
                Path(f"r{number}.csv"),
                "fit",
                "linear",
                known,
                at,
                inputs,
                {"F": forces},
                along=along,
            )
        )
    return tuple(runs)


def completed(runs: tuple[Run, ...], signal: StatedSignal) -> Signal:
    return complete_noise({"F": signal}, runs)["F"]


@pytest.mark.parametrize("static", [False, True])
def test_runs_that_repeat_one_another_show_it(static: bool) -> None:
    offsets = np.random.default_rng(2).normal(0, SCATTER, 12).tolist()
    signal = completed(runs_of(offsets, static=static), StatedSignal("F", "N", NOISE))
    assert signal.repeatability == pytest.approx(
        np.hypot(np.std(offsets, ddof=1), NOISE), rel=0.05
    )  # twelve runs
    assert (signal.sigma, signal.scatter, signal.source) == (
        signal.repeatability,
        "repeatability",
        "of repeated runs",
    )


def test_different_tests_do_not_repeat_one_another() -> None:
    offsets = [0.0, 5.0, -5.0, 9.0]
    signal = completed(runs_of(offsets, load=[1.0, 2.0, 3.0, 4.0]), StatedSignal("F", "N", NOISE))
    assert signal.sigma == NOISE
