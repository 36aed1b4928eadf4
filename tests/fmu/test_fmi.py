"""The FMI 2.0 functions themselves, through FMPy: order of calls, bad arguments, state, derivatives."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, FMU2Slave

from pam_cosim.compiler.ode import Ode
from tests.fmu import models


@contextmanager
def instance(
    make: Callable[[], Ode], kind: type = FMU2Slave
) -> Iterator[tuple[Any, dict[str, int]]]:
    """An instance before initialization, and the value references by name."""
    path = str(models.fmu(make))
    description = fmpy.read_model_description(path)
    folder = fmpy.extract(path)
    made = kind(
        guid=description.guid,
        unzipDirectory=folder,
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="test",
    )
    made.instantiate()
    try:
        yield made, {v.name: v.valueReference for v in description.modelVariables}
    finally:
        made.freeInstance()


def _initialise(fmu: Any, tolerance: float = 1e-8) -> None:
    fmu.setupExperiment(tolerance=tolerance, startTime=0.0)
    fmu.enterInitializationMode()
    fmu.exitInitializationMode()


def _refused(call: Callable[..., Any], *args: Any) -> None:
    with pytest.raises(FMICallException):
        call(*args)


def test_wrong_order_is_refused_and_does_no_harm() -> None:
    with instance(models.lag) as (fmu, vr):
        _refused(fmu.doStep, 0.0, 0.1)
        _refused(fmu.exitInitializationMode)
        _refused(fmu.terminate)
        _initialise(fmu)
        _refused(fmu.enterInitializationMode)
        _refused(fmu.setupExperiment)
        _refused(fmu.fmi2SetTime if hasattr(fmu, "fmi2SetTime") else fmu.exitInitializationMode)
        fmu.doStep(0.0, 0.1)
        fmu.terminate()
        _refused(fmu.doStep, 0.1, 0.1)
        assert np.isfinite(fmu.getReal([vr["x"]])[0])
        fmu.reset()
        _initialise(fmu)
        fmu.doStep(0.0, 0.1)


def test_bad_arguments_are_refused() -> None:
    with instance(models.lag) as (fmu, vr):
        _refused(fmu.getReal, [99])
        _refused(fmu.setReal, [99], [1.0])
        _refused(fmu.setReal, [vr["u"]], [float("nan")])
        _refused(fmu.setReal, [vr["feed"]], [1.0])
        _refused(fmu.getInteger, [0])
        _refused(fmu.setBoolean, [0], [True])
        _refused(fmu.setupExperiment, 0.0, 0.0)
        _refused(fmu.setupExperiment, 1e-6, 1.0, 0.5)
        _initialise(fmu)
        _refused(fmu.setReal, [vr["x_start"]], [1.0])
        fmu.setReal([vr["x_start"]], [0.0])  # the value that it has
        _refused(fmu.setRealInputDerivatives, [vr["x"]], [1], [1.0])
        _refused(fmu.setRealInputDerivatives, [vr["u"]], [2], [1.0])
        _refused(fmu.doStep, 0.5, 0.1)
        _refused(fmu.doStep, 0.0, 0.0)
        _refused(fmu.doStep, 0.0, -0.1)
        _refused(fmu.doStep, 0.0, float("inf"))
        fmu.doStep(0.0, 0.1)


def _march(fmu: Any, reference: int, times: np.ndarray) -> list[float]:
    values = []
    for a, b in zip(times[:-1], times[1:], strict=True):
        fmu.doStep(a, b - a)
        values.append(fmu.getReal([reference])[0])
    return values


def test_reset_repeats_every_bit() -> None:
    times = np.linspace(0.0, 1.5, 40)
    with instance(models.van_der_pol) as (fmu, vr):
        _initialise(fmu)
        first = _march(fmu, vr["v"], times)
        fmu.reset()
        _initialise(fmu)
        assert _march(fmu, vr["v"], times) == first


def test_state_saved_inside_a_pending_step() -> None:
    """Going back repeats every bit, also in another instance by way of the serialized state."""
    times = np.linspace(0.0, 1.5, 40)
    with instance(models.van_der_pol) as (fmu, vr), instance(models.van_der_pol) as (other, _):
        _initialise(fmu)
        _march(fmu, vr["v"], times[:21])
        state = fmu.getFMUState()
        frozen = fmu.serializeFMUState(state)
        first = _march(fmu, vr["v"], times[20:])
        fmu.setFMUState(state)
        assert fmu.getRealStatus(2) == times[20]
        assert _march(fmu, vr["v"], times[20:]) == first
        fmu.freeFMUState(state)
        foreign = other.deserializeFMUState(frozen)
        other.setFMUState(foreign)
        assert _march(other, vr["v"], times[20:]) == first
        other.freeFMUState(foreign)
        _refused(other.deserializeFMUState, frozen[:-1])


def test_start_value_of_a_state() -> None:
    """An exact one may be set and stays; a calculated one follows its parameter, also when read early."""
    with instance(models.van_der_pol) as (fmu, vr):
        fmu.setReal([vr["x"]], [1.5])
        fmu.setReal([vr["mu"]], [10.0])
        _initialise(fmu)
        assert fmu.getReal([vr["x"], vr["y"]]) == [1.5, 1.5]
    with instance(models.lag) as (fmu, vr):
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        fmu.setReal([vr["x_start"]], [0.7])
        assert fmu.getReal([vr["y"]]) == [0.7]
        fmu.setReal([vr["x_start"]], [0.9])
        assert fmu.getReal([vr["y"], vr["der(x)"]]) == pytest.approx([0.9, -1.8])


def _lag_derivatives(fmu: Any, vr: dict[str, int], known: str, value: float) -> list[float]:
    unknown = [vr[n] for n in ("der(x)", "y", "feed")]
    return list(fmu.getDirectionalDerivative(unknown, [vr[known]], [value]))


def test_directional_derivatives_are_exact() -> None:
    with instance(models.lag) as (fmu, vr):
        _initialise(fmu)
        assert _lag_derivatives(fmu, vr, "x", 2.0) == pytest.approx([-4.0, 2.0, 4.0], rel=1e-14)
        assert _lag_derivatives(fmu, vr, "u", 1.0) == pytest.approx([2.0, 0.0, 1.0], rel=1e-14)
        assert fmu.getDirectionalDerivative(
            [vr["der(x)"]], [vr["x"], vr["u"]], [1.0, 3.0]
        ) == pytest.approx([4.0])
        _refused(fmu.getDirectionalDerivative, [vr["u"]], [vr["x"]], [1.0])
        _refused(fmu.getDirectionalDerivative, [vr["y"]], [vr["feed"]], [1.0])


def test_output_derivatives() -> None:
    with instance(models.lag) as (fmu, vr):
        _initialise(fmu, 1e-10)
        fmu.setReal([vr["u"]], [1.0])
        fmu.setRealInputDerivatives([vr["u"]], [1], [0.5])
        fmu.doStep(0.0, 0.4)
        x, u = fmu.getReal([vr["x"], vr["u"]])
        assert u == pytest.approx(1.2)
        rate = fmu.getRealOutputDerivatives([vr["y"], vr["feed"]], [1, 1])
        assert list(rate) == pytest.approx([(u - x) / 0.5, 0.5 + 2 * (u - x) / 0.5], rel=1e-12)


def test_model_exchange_functions() -> None:
    with instance(models.van_der_pol, FMU2Model) as (fmu, vr):
        _refused(fmu.enterContinuousTimeMode)
        _initialise(fmu)
        fmu.enterEventMode()
        event = fmu.newDiscreteStates()
        assert not any(event[:5])
        fmu.enterContinuousTimeMode()
        x, rates = (ctypes.c_double * 2)(1.0, 2.0), (ctypes.c_double * 2)()
        fmu.setTime(0.5)
        fmu.setContinuousStates(x, 2)
        fmu.getDerivatives(rates, 2)
        assert list(rates) == [2.0, 1000.0 * (0.0 * 2.0 - 1.0)]
        _refused(fmu.getDerivatives, rates, 3)
        _refused(fmu.getEventIndicators, rates, 1)
        assert list(fmu.completedIntegratorStep()) == [0, 0]


def test_master_that_sets_values_and_slopes_at_every_step() -> None:
    """What agrees with the slope given before is no news to the solver; the ramp is followed exactly."""
    with instance(models.lag) as (fmu, vr):
        _initialise(fmu, 1e-9)
        times, reached = np.linspace(0.0, 2.0, 101), []
        for t, step in zip(times[:-1], np.diff(times), strict=True):
            fmu.setReal([vr["u"]], [0.3 * t])
            fmu.setRealInputDerivatives([vr["u"]], [1], [0.3])
            fmu.doStep(t, step)
            reached.append(fmu.getReal([vr["x"]])[0])
        numbers = (ctypes.c_longlong * 5)()
        fmu.dll.pam_get_statistics(ctypes.c_void_p(fmu.component), numbers)
    t = times[1:]
    assert reached == pytest.approx(0.3 * (t - 0.5 + 0.5 * np.exp(-t / 0.5)), abs=1e-8)
    assert numbers[0] < 60 and numbers[4] == 1, list(numbers)


def test_a_parameter_that_changes_in_a_run_takes_effect_there() -> None:
    """x' = (u - x)/tau from x = 1: tau is 0.5 s up to 0.3 s and 2 s from there."""
    exact = np.exp(-0.3 / 0.5 - 0.4 / 2.0)
    with instance(models.lag) as (fmu, vr):
        fmu.setReal([vr["x_start"]], [1.0])
        _initialise(fmu, 1e-10)
        fmu.doStep(0.0, 0.3)
        fmu.setReal([vr["tau"]], [2.0])
        fmu.doStep(0.3, 0.4)
        assert fmu.getReal([vr["x"]])[0] == pytest.approx(exact, rel=1e-8)
    with instance(models.lag, FMU2Model) as (fmu, vr):
        _initialise(fmu)
        fmu.enterContinuousTimeMode()
        _refused(fmu.setReal, [vr["tau"]], [2.0])
        fmu.enterEventMode()
        fmu.setReal([vr["tau"]], [2.0])
        fmu.enterContinuousTimeMode()
        fmu.setReal([vr["u"]], [3.0])
        assert fmu.getReal([vr["der(x)"]]) == [1.5]


def test_messages_name_the_variable_and_need_no_arguments() -> None:
    told: list[tuple[int, bytes, bytes]] = []
    with instance(models.oscillator) as (fmu, vr):
        functions = fmpy.fmi2.fmi2CallbackFunctions()
        functions.logger = fmpy.fmi2.fmi2CallbackLoggerTYPE(
            lambda _, instance, status, category, message: told.append((status, category, message))
        )
        functions.allocateMemory = fmpy.fmi2.fmi2CallbackAllocateMemoryTYPE(fmpy.fmi2.calloc)
        functions.freeMemory = fmpy.fmi2.fmi2CallbackFreeMemoryTYPE(fmpy.fmi2.free)
        first = fmu.component
        fmu.instantiate(callbacks=functions, loggingOn=True)
        fmu.setReal([vr["k"]], [1e9])
        fmu.setReal([vr["k"]], [2e9])
        _initialise(fmu)
        fmu.doStep(0.0, 1e-6)
        fmu.setReal([vr["m"]], [2.0])
        fmu.fmi2FreeInstance(fmu.component)
        fmu.component = first
    warning, event = told
    assert warning[:2] == (1, b"logStatusWarning") and event[:2] == (0, b"logEvents")
    assert warning[2].startswith(b"k = 1e+09 N/m is outside the range of the model, at least 0 N/m")
    assert event[2] == b"at time 1e-06 s: m = 2 kg"
