"""The FMI 3.0 functions themselves, through FMPy: order of calls, bad arguments, state, derivatives, early ends."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Model, FMU3ScheduledExecution, FMU3Slave

from pam_cosim.compiler.ode import Ode
from pam_cosim.simulation import RunFailure, Simulator
from tests.fmu import models


@contextmanager
def instance(
    make: Callable[[], Ode], kind: type = FMU3Slave, **options: Any
) -> Iterator[tuple[Any, dict, list]]:
    """An instance before initialization, the value references by name, and the log."""
    fmi = "2.0" if kind is FMU2Slave else "3.0"
    path = str(models.fmu(make, fmi))
    description = fmpy.read_model_description(path)
    made = kind(
        guid=description.guid,
        unzipDirectory=fmpy.extract(path),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="test",
    )
    log: list[str] = []
    if fmi == "3.0":
        options = {
            "loggingOn": True,
            "logMessage": lambda e, s, c, message: log.append(message.decode()),
        } | options
    made.instantiate(**options)
    try:
        yield made, {v.name: v.valueReference for v in description.modelVariables}, log
    finally:
        made.freeInstance()


def _initialise(fmu: Any, tolerance: float = 1e-8) -> None:
    fmu.enterInitializationMode(tolerance=tolerance, startTime=0.0)
    fmu.exitInitializationMode()


def _refused(call: Callable[..., Any], *args: Any) -> None:
    with pytest.raises(FMICallException) as caught:
        call(*args)
    assert caught.value.status == 3


def test_wrong_order_is_refused_and_does_no_harm() -> None:
    with instance(models.lag) as (fmu, vr, log):
        _refused(fmu.doStep, 0.0, 0.1)
        _refused(fmu.exitInitializationMode)
        _refused(fmu.terminate)
        _initialise(fmu)
        _refused(fmu.enterInitializationMode)
        _refused(fmu.enterEventMode)
        _refused(fmu.enterStepMode)
        _refused(fmu.enterConfigurationMode)
        fmu.doStep(0.0, 0.1)
        fmu.terminate()
        _refused(fmu.doStep, 0.1, 0.1)
        assert np.isfinite(fmu.getFloat64([vr["x"]])[0])
        fmu.reset()
        _initialise(fmu)
        fmu.doStep(0.0, 0.1)
        assert "fmi3DoStep must not be called before initialization" in log
        assert "fmi3EnterConfigurationMode: the model has no structural parameters" in log


def test_bad_arguments_are_refused() -> None:
    with instance(models.lag) as (fmu, vr, log):
        _refused(fmu.getFloat64, [99])
        _refused(fmu.setFloat64, [99], [1.0])
        _refused(fmu.setFloat64, [vr["u"]], [float("nan")])
        _refused(fmu.setFloat64, [vr["u"]], [1.0, 2.0])
        _refused(fmu.setFloat64, [vr["y"]], [1.0])
        _refused(fmu.getInt32, [0])
        _refused(fmu.setBoolean, [0], [True])
        _refused(fmu.getClock, [0])
        _refused(fmu.enterInitializationMode, 0.0)
        _refused(fmu.enterInitializationMode, 1e-6, 1.0, 0.5)
        _initialise(fmu)
        _refused(fmu.setFloat64, [vr["x_start"]], [1.0])
        _refused(fmu.doStep, 0.5, 0.1)
        _refused(fmu.doStep, 0.0, 0.0)
        _refused(fmu.doStep, 0.0, float("inf"))
        _refused(fmu.getDirectionalDerivative, [vr["u"]], [vr["x"]], [1.0])
        _refused(fmu.getDirectionalDerivative, [vr["y"]], [vr["x"]], [1.0, 2.0])
        fmu.doStep(0.0, 0.1)
        assert "fmi3SetFloat64: 1 values are needed for 1 variables, not 2" in log


def test_instances_that_cannot_be_made() -> None:
    with (
        pytest.raises(Exception, match="instantiate"),
        instance(models.lag, FMU3ScheduledExecution),
    ):
        pass
    with pytest.raises(Exception, match="instantiate"), instance(models.lag, eventModeUsed=True):
        pass
    with pytest.raises(Exception, match="instantiate"), instance(models.delayed_lag, FMU3Model):
        pass


def test_jacobian_forwards_and_backwards() -> None:
    """Adjoint derivatives are the transposed directional ones, which are exact."""
    with instance(models.lag) as (fmu, vr, _):
        _initialise(fmu)
        unknowns, knowns = [vr[n] for n in ("der(x)", "y", "feed")], [vr["x"], vr["u"]]
        columns = [fmu.getDirectionalDerivative(unknowns, [known], [1.0]) for known in knowns]
        assert (
            pytest.approx(np.array([[-2.0, 2.0], [1.0, 0.0], [2.0, 1.0]]), rel=1e-14)
            == np.array(columns).T
        )
        seed = [0.3, -1.0, 2.0]
        adjoint = fmu.getAdjointDerivative(unknowns, knowns, seed, nSensitivity=2)
        assert adjoint == pytest.approx(list(np.array(columns) @ seed), rel=1e-14)
        _refused(fmu.getAdjointDerivative, unknowns, knowns, seed[:2], 2)
    with instance(models.lag) as (fmu, vr, _):
        fmu.enterInitializationMode()
        through_start = fmu.getAdjointDerivative(
            [vr["der(x)"], vr["feed"]], [vr["x_start"]], [1.0, 1.0], nSensitivity=1
        )
        assert through_start == pytest.approx([-2.0 + 2.0], abs=1e-14)


def _march(fmu: Any, reference: int, times: np.ndarray) -> list[float]:
    values = []
    for a, b in zip(times[:-1], times[1:], strict=True):
        assert fmu.doStep(a, b - a) == (False, False, False, b)
        values.append(fmu.getFloat64([reference])[0])
    return values


def test_state_saved_inside_a_pending_step() -> None:
    """Going back repeats every bit, also in another instance by way of the serialized state."""
    times = np.linspace(0.0, 1.5, 40)
    with (
        instance(models.van_der_pol) as (fmu, vr, _),
        instance(models.van_der_pol) as (other, _, log),
    ):
        _initialise(fmu)
        _march(fmu, vr["v"], times[:21])
        state = fmu.getFMUState()
        frozen = fmu.serializeFMUState(state)
        first = _march(fmu, vr["v"], times[20:])
        fmu.setFMUState(state)
        assert _march(fmu, vr["v"], times[20:]) == first
        fmu.freeFMUState(state)
        foreign = other.deserializeFMUState(frozen)
        other.setFMUState(foreign)
        assert _march(other, vr["v"], times[20:]) == first
        other.freeFMUState(foreign)
        damaged = bytearray(frozen)
        damaged[len(frozen) // 2] ^= 1
        _refused(other.deserializeFMUState, bytes(damaged))
        _refused(other.deserializeFMUState, frozen[:-1])
        assert "damaged" in log[-1]


def test_model_exchange_functions() -> None:
    with instance(models.van_der_pol, FMU3Model) as (fmu, _, _):
        _refused(fmu.enterContinuousTimeMode)
        _initialise(fmu)
        assert fmu.getNumberOfEventIndicators() == 0
        assert fmu.getNumberOfContinuousStates() == 2
        assert not any(fmu.updateDiscreteStates()[:5])
        fmu.enterContinuousTimeMode()
        x, rates = (ctypes.c_double * 2)(1.0, 2.0), (ctypes.c_double * 2)()
        fmu.setTime(0.5)
        fmu.setContinuousStates(x, 2)
        fmu.getContinuousStateDerivatives(rates, 2)
        assert list(rates) == [2.0, 1000.0 * (0.0 * 2.0 - 1.0)]
        _refused(fmu.getContinuousStateDerivatives, rates, 3)
        _refused(fmu.getEventIndicators, rates, 1)
        assert list(fmu.completedIntegratorStep()) == [False, False]
        fmu.enterEventMode()
        fmu.terminate()


def test_output_derivatives() -> None:
    with instance(models.lag) as (fmu, vr, _):
        fmu.setFloat64([vr["u"]], [1.0])
        _initialise(fmu, 1e-10)
        fmu.doStep(0.0, 0.4)
        x = fmu.getFloat64([vr["x"]])[0]
        assert fmu.getOutputDerivatives([vr["y"], vr["feed"]], [1, 1]) == pytest.approx(
            [(1 - x) / 0.5, 2 * (1 - x) / 0.5]
        )
        _refused(fmu.getOutputDerivatives, [vr["y"]], [2])


# [s] when x' = -1 - sqrt(x - 0.5) has taken x from 1 to 0.5
_BREAKDOWN = 2.0 * (np.sqrt(0.5) - np.log(1.0 + np.sqrt(0.5)))


def test_step_that_cannot_be_completed_is_discarded_in_fmi_3() -> None:
    with instance(models.breaks_down) as (fmu, vr, log):
        _initialise(fmu)
        early, last = ctypes.c_bool(True), ctypes.c_double()
        flags = [ctypes.c_bool(True) for _ in range(2)]
        pointers = [ctypes.byref(v) for v in (*flags, early, last)]
        with pytest.raises(FMICallException) as caught:
            fmu.fmi3DoStep(fmu.component, 0.0, 1.0, True, *pointers)
        assert caught.value.status == 2
        assert last.value == pytest.approx(_BREAKDOWN, abs=1e-5) and not early.value
        assert fmu.getFloat64([vr["time"]]) == [last.value]
        assert "'tank.x'" in log[0] and "at time 0.344" in log[0]
        _refused(fmu.doStep, last.value, 0.1)
        fmu.reset()
        _initialise(fmu)
        assert _march(fmu, vr["y"], np.array([0.0, 0.1]))[0] < 0.9
        fmu.terminate()


def test_step_that_cannot_be_completed_is_discarded_in_fmi_2() -> None:
    with instance(models.breaks_down, FMU2Slave) as (fmu, vr, _):
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
        state = fmu.getFMUState()
        fmu.exitInitializationMode()
        step = fmu.dll.fmi2DoStep
        step.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double, ctypes.c_int]
        assert step(fmu.component, 0.0, 1.0, 1) == 2
        assert fmu.getRealStatus(2) == pytest.approx(_BREAKDOWN, abs=1e-5)
        assert not fmu.getBooleanStatus(3)
        assert step(fmu.component, fmu.getRealStatus(2), 0.1, 1) == 3
        fmu.setFMUState(state)
        fmu.setReal([vr["floor"]], [-100.0])
        fmu.exitInitializationMode()
        assert step(fmu.component, 0.0, 1.0, 1) == 0
        fmu.freeFMUState(state)
        fmu.reset()


def test_simulator_tells_why_a_run_of_fmi_3_ends() -> None:
    with Simulator(models.fmu(models.breaks_down, "3.0")) as simulator:
        with pytest.raises(RunFailure, match="time 0.344613293 s .*'tank.x'") as caught:
            simulator.run(np.linspace(0.0, 1.0, 11))
        assert caught.value.time == pytest.approx(0.3)
        assert np.isfinite(simulator.run([0.0, 0.2])["y"]).all()
