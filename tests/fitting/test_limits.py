"""A fit ends at its limits, with the best that it came to."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pam_cosim.fitting import FitOptions, fit
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet, FreeParameter
from pam_cosim.simulation import Simulator
from tests.fitting.models import data_set, recording

_RUN = 0.05  # s, that every run takes
_RUNS_AROUND = 12  # of all runs once more, for a first point and for the result


def _slow_data() -> DataSet:
    """Three decays whose rate is far from where a fit begins."""
    time = np.linspace(0.0, 0.1, 41)
    y = np.exp(-50.0 * time) + 1e-3 * np.random.default_rng(0).standard_normal(len(time))
    free = FreeParameter("a", 1e-4, 1e4, 1e-3, "1")
    return data_set("Decay", [recording(time, {"y": y})] * 3, {"y": 1e-3}, [free])


@pytest.mark.parametrize(
    "limits", [{"simulations": 15}, {"deadline": 15 * _RUN}, {}], ids=["runs", "time", "none"]
)
def test_a_slow_fit_ends_at_its_limit(
    limits: dict[str, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    data, outcome = _slow_data(), Simulator._outcome

    def slowly(self: Simulator, *args: Any, **kwargs: Any) -> Any:
        time.sleep(_RUN)
        return outcome(self, *args, **kwargs)

    monkeypatch.setattr(Simulator, "_outcome", slowly)
    with Simulator(build_model("Decay", [Path(__file__).with_name("Decay.mo")])) as simulator:
        before, began = Simulator.simulations, time.monotonic()
        if "deadline" in limits:
            limits = {"deadline": began + limits["deadline"]}
        found = fit(simulator, data, options=FitOptions(**limits))
    simulated = Simulator.simulations - before
    assert found.values["a"] > 1e-3  # it has gone a way
    if limits:
        assert simulated <= 15 + _RUNS_AROUND
    else:
        assert simulated > 2 * (15 + _RUNS_AROUND)
        assert found.values["a"] == pytest.approx(50.0, rel=0.05)
