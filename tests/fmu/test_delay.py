"""Delayed inputs through the FMI functions: their past belongs to the FMU's state."""

from __future__ import annotations

from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Model
from fmpy.validation import validate_fmu

from tests.fmu import models
from tests.fmu.test_fmi import instance

MODELS = [models.delayed_lag, models.delayed_start, models.delayed_gain, models.delayed_mix]


@pytest.mark.parametrize("make", MODELS, ids=lambda make: make.__name__)
def test_fmpy_finds_no_problem_and_simulates(make: Any) -> None:
    path = str(models.fmu(make))
    assert validate_fmu(path) == []
    result = fmpy.simulate_fmu(path, stop_time=2.0)
    assert all(np.isfinite(result[name]).all() for name in result.dtype.names)


def test_fmpy_simulates_a_step() -> None:
    """FMPy stops at the step by itself."""
    step = np.array(
        [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (3.0, 2.0)], dtype=[("time", float), ("u", float)]
    )
    result = fmpy.simulate_fmu(str(models.fmu(models.delayed_lag)), input=step, stop_time=3.0, output_interval=0.1,
                               relative_tolerance=1e-8)  # fmt: skip
    exact = np.where(result["time"] > 1.3, 2.0 * (1.0 - np.exp(-(result["time"] - 1.3) / 0.5)), 0.0)
    assert result["y"] == pytest.approx(exact, abs=1e-6)


def test_model_exchange_is_not_offered() -> None:
    description = fmpy.read_model_description(str(models.fmu(models.delayed_lag)))
    assert description.modelExchange is None and description.coSimulation is not None
    with pytest.raises(Exception, match="instantiate"), instance(models.delayed_lag, FMU2Model):
        pass


def _begin(fmu: Any, vr: dict[str, int], delay: float, u: float) -> None:
    fmu.setReal([vr["T"]], [delay])
    fmu.setupExperiment(tolerance=1e-9, startTime=0.0)
    fmu.enterInitializationMode()
    fmu.setReal([vr["u"]], [u])
    assert fmu.getReal([vr["echo"]]) == [u]
    fmu.exitInitializationMode()
    assert fmu.getReal([vr["echo"]]) == [u]


def _zigzag(
    fmu: Any, vr: dict[str, int], steps: range, width: float = 0.05
) -> list[tuple[float, float]]:
    """Jumps and slopes at every step."""
    values = []
    for i in steps:
        fmu.setReal([vr["u"]], [(-1.0) ** i + 0.1 * i])
        fmu.setRealInputDerivatives([vr["u"]], [1], [0.3 * (i % 3)])
        fmu.doStep(i * width, width)
        values.append(tuple(fmu.getReal([vr["y"], vr["echo"]])))
    return values


def test_state_saved_with_jumps_under_way() -> None:
    """Going back repeats every bit: in place, and in another instance by way of bytes; reset forgets all."""
    with instance(models.delayed_lag) as (fmu, vr), instance(models.delayed_lag) as (other, _):
        _begin(fmu, vr, 0.33, 1.0)
        first = _zigzag(fmu, vr, range(10))
        state = fmu.getFMUState()
        frozen = fmu.serializeFMUState(state)
        second = _zigzag(fmu, vr, range(10, 40))
        fmu.setFMUState(state)
        assert _zigzag(fmu, vr, range(10, 40)) == second
        fmu.freeFMUState(state)
        foreign = other.deserializeFMUState(frozen)
        other.setFMUState(foreign)
        assert _zigzag(other, vr, range(10, 40)) == second
        other.freeFMUState(foreign)
        fmu.reset()
        _begin(fmu, vr, 0.33, 1.0)
        assert _zigzag(fmu, vr, range(10)) + _zigzag(fmu, vr, range(10, 40)) == first + second


def test_the_past_grows_with_the_delay() -> None:
    """Five thousand jumps under way at once come out one by one."""
    with instance(models.delayed_lag) as (fmu, vr):
        _begin(fmu, vr, 5.0, 1.0)
        values = _zigzag(fmu, vr, range(12000), width=0.001)
    inside = [i for i in range(5000, 11990) if i % 3 == 0]
    delayed = np.array([values[i + 5000][1] if i + 5000 < 12000 else np.nan for i in inside])
    expected = np.array([(-1.0) ** i + 0.1 * i for i in inside])
    known = ~np.isnan(delayed)
    assert known.sum() > 600
    # Read at the end of a step, where the next line may have begun: either is right to rounding.
    following = np.array([(-1.0) ** (i + 1) + 0.1 * (i + 1) for i in inside])
    off = np.minimum(np.abs(delayed - expected), np.abs(delayed - following))
    assert off[known].max() < 1e-9


def test_directional_derivatives() -> None:
    """d(t) = u(t - T): the present input does not count, the delay and time do."""
    with instance(models.delayed_lag) as (fmu, vr):
        unknown = [vr["der(x)"], vr["echo"]]
        fmu.setReal([vr["T"]], [0.3])
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        assert fmu.getDirectionalDerivative(unknown, [vr["u"]], [1.0]) == [2.0, 1.0]
        fmu.exitInitializationMode()
        fmu.setRealInputDerivatives([vr["u"]], [1], [4.0])
        fmu.doStep(0.0, 0.2)
        assert fmu.getDirectionalDerivative(unknown, [vr["T"]], [1.0]) == [0.0, 0.0]
        fmu.doStep(0.2, 0.3)
        assert fmu.getReal([vr["echo"]]) == pytest.approx([4.0 * 0.2])
        assert fmu.getDirectionalDerivative(unknown, [vr["u"]], [1.0]) == [0.0, 0.0]
        assert fmu.getDirectionalDerivative(unknown, [vr["T"]], [1.0]) == [-8.0, -4.0]
        assert fmu.getRealOutputDerivatives([vr["echo"]], [1]) == [4.0]


def test_what_comes_from_before_the_start_may_be_another_value() -> None:
    with instance(models.delayed_start) as (fmu, vr):
        fmu.setReal([vr["u"], vr["T"]], [4.0, 0.25])
        fmu.setupExperiment(tolerance=1e-10, startTime=0.0)
        fmu.enterInitializationMode()
        assert fmu.getReal([vr["echo"]]) == [-1.0]
        fmu.exitInitializationMode()
        assert fmu.getReal([vr["echo"]]) == [-1.0]
        fmu.doStep(0.0, 0.25)
        assert fmu.getReal([vr["echo"]]) == [4.0]
        x = -1.0 + np.exp(-0.5)
        assert fmu.getReal([vr["y"]]) == pytest.approx([x], abs=1e-9)
        fmu.doStep(0.25, 0.5)
        assert fmu.getReal([vr["y"]]) == pytest.approx([4.0 + (x - 4.0) * np.exp(-1.0)], abs=1e-9)


def test_an_input_set_at_the_start_but_after_initialization_is_a_jump() -> None:
    with instance(models.delayed_lag) as (fmu, vr):
        _begin(fmu, vr, 0.3, 1.0)
        fmu.setReal([vr["u"]], [5.0])
        fmu.doStep(0.0, 0.25)
        assert fmu.getReal([vr["echo"]]) == [1.0]
        fmu.doStep(0.25, 0.1)
        assert fmu.getReal([vr["echo"]]) == [5.0]
