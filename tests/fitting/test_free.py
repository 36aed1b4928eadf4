"""Search coordinates, and parameters of unknown order of magnitude."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from pam_cosim import study
from pam_cosim.errors import InputError
from pam_cosim.fitting import Free, base_parameters, fit
from pam_cosim.measurement import FreeParameter
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Simulator
from tests.fitting.models import data_set, recording, vessel_data


@given(st.floats(0.0, 1.0), st.sampled_from([(1e-12, 1e-8), (0.5, 0.9), (-3.0, 2.0), (0.0, 1e4)]))
def test_coordinates_go_there_and_back(share: float, bounds: tuple[float, float]) -> None:
    low, high = bounds
    free = Free("a", low, high, low)
    value = low + share * (high - low)
    assert free.to_value(free.to_z(value)) == pytest.approx(value, rel=1e-12, abs=1e-300)
    assert free.to_value(free.to_z(low) - 5.0) == pytest.approx(low, rel=1e-12, abs=1e-300)
    assert free.to_value(free.to_z(high) + 5.0) == pytest.approx(high, rel=1e-12)
    assert free.to_value(1e6 * abs(free.to_z(high)) + 1e6) == pytest.approx(
        high, rel=1e-12
    )  # no number holds its power


def test_bounds_far_apart_are_searched_by_order_of_magnitude() -> None:
    assert Free("a", 1e-12, 1e-8, 1e-10).logarithmic
    assert not Free("a", 0.5, 0.9, 0.7).logarithmic
    assert not Free("a", 0.0, 1e4, 1.0).logarithmic
    wide = Free("a", 1e-12, 1e-8, 1e-10)
    assert wide.to_value((wide.to_z(1e-12) + wide.to_z(1e-8)) / 2) == pytest.approx(1e-10)


@pytest.mark.parametrize("start", [1e-3, 1.0, 3e4])
def test_rate_is_found_over_seven_decades(start: float) -> None:
    time = np.linspace(0.0, 1.0, 101)
    y = np.exp(-7.0 * time) + 0.01 * np.random.default_rng(1).standard_normal(101)
    free = FreeParameter("a", 1e-3, 1e5, start, "1")
    with Simulator(study.build(str(Path(__file__).parent / "Decay.mo"))) as simulator:
        result = fit(simulator, data_set("Decay", [recording(time, {"y": y})], {"y": 0.01}, [free]),
                    starts=[{"a": 0.1}, {"a": 10.0}, {"a": 1e3}])  # fmt: skip
    estimate = result.parameters["a"]
    assert estimate.low <= 7.0 <= estimate.high
    assert estimate.low > 0 and estimate.high / estimate.low < 1.1
    # symmetric by order of magnitude
    assert estimate.low * estimate.high == pytest.approx(estimate.value**2, rel=1e-9)


def test_unknown_parameter_names_the_file() -> None:
    data = vessel_data(fit=(FreeParameter("tank.m", 0.0, 1.0),))
    with pytest.raises(InputError, match="Test has no parameter 'tank.m' to fit") as caught:
        base_parameters(data, Interface("Test"))
    assert caught.value.file == data.folder / "experiment.toml"
