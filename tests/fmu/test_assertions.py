"""Assertions at run time: where a run ends, what is said, for both versions and both kinds of FMI."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, fmi2Discard, fmi2Error
from fmpy.fmi3 import FMU3Slave

from pam_cosim.fmu import build_fmu
from pam_cosim.simulation import Inputs, Simulator
from pam_cosim.simulation.failure import RunFailure
from tests.compiler.run import compiled

VERSIONS = ["2.0", "3.0"]


@cache
def _built(model: str, fmi: str, folder: Path) -> Path:
    return build_fmu(compiled(f"Assertions.{model}"), folder / f"{model}-{fmi[0]}.fmu", fmi=fmi)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("assertions")


@pytest.mark.parametrize("fmi", VERSIONS)
def test_the_run_ends_where_the_condition_does(fmi: str, folder: Path) -> None:
    with Simulator(_built("Growing", fmi, folder)) as simulator:
        with pytest.raises(RunFailure) as caught:
            simulator.run([0.0, 7.0, 20.0], parameters={"k": 0.75})
        assert "at time 2.66666667 s: x = 2 is not below 2 (k = 0.75)" in caught.value.reason
        assert caught.value.parameters == {"k": 0.75}
        good = simulator.run([0.0, 1.5])  # the same instance goes on to other runs
        assert good["y"][-1] == pytest.approx(1.5)
        assert good.warnings == ("an assertion of the model fails at time 1 s: above one",)
        assert simulator.run([0.0, 0.9]).warnings == ()


@pytest.mark.parametrize("fmi", VERSIONS)
def test_an_instance_stays_where_it_could_get_to(fmi: str, folder: Path) -> None:
    path = _built("Growing", fmi, folder)
    description = fmpy.read_model_description(str(path))
    directory = fmpy.extract(str(path))
    kind = FMU2Slave if fmi == "2.0" else FMU3Slave
    slave = kind(guid=description.guid, unzipDirectory=directory, instanceName="i",
                 modelIdentifier=description.coSimulation.modelIdentifier)  # fmt: skip
    slave.instantiate()
    if fmi == "2.0":
        slave.setupExperiment()
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    y = next(v.valueReference for v in description.modelVariables if v.name == "y")
    slave.doStep(0.0, 1.5)
    with pytest.raises(FMICallException) as caught:
        slave.doStep(1.5, 5.0)
    assert caught.value.status == fmi2Discard
    if fmi == "2.0":
        assert slave.getRealStatus(2) == pytest.approx(2.0, abs=1e-9)  # fmi2LastSuccessfulTime
    value = (slave.getReal if fmi == "2.0" else slave.getFloat64)([y])[0]
    assert value == pytest.approx(2.0, abs=1e-9)
    slave.terminate()
    slave.freeInstance()


@pytest.mark.parametrize("fmi", VERSIONS)
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_a_start_that_is_not_allowed_is_an_error(kind: str, fmi: str, folder: Path) -> None:
    with pytest.raises(FMICallException) as caught:
        fmpy.simulate_fmu(
            str(_built("Growing", fmi, folder)), fmi_type=kind, start_values={"k": -1.0}
        )
    assert (
        caught.value.function.endswith("ExitInitializationMode")
        and caught.value.status == fmi2Error
    )
    assert fmpy.simulate_fmu(
        str(_built("Growing", fmi, folder)), fmi_type=kind, start_values={"k": 0.1}, stop_time=1.0
    )["y"][-1] == pytest.approx(0.1)


@pytest.mark.parametrize("fmi", VERSIONS)
def test_model_exchange_ends_at_an_accepted_step(
    fmi: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What the FMU says is read where FMPy prints it: its proxy keeps a logger of ours longer than that lives."""
    arguments = {"fmi_type": "ModelExchange", "output_interval": 0.1, "debug_logging": True}
    path = str(_built("Growing", fmi, folder))
    assert fmpy.simulate_fmu(path, stop_time=1.5, **arguments)["y"][-1] == pytest.approx(1.5)
    assert capsys.readouterr().out.count("above one") == 1
    with pytest.raises(FMICallException) as caught:
        fmpy.simulate_fmu(path, stop_time=5.0, **arguments)
    assert (
        caught.value.function.endswith("CompletedIntegratorStep")
        and caught.value.status == fmi2Error
    )
    assert "is not below 2 (k = 1)" in capsys.readouterr().out


def test_inputs_that_break_a_condition(folder: Path) -> None:
    """At the point where they are set, and on the way of a ramp; with states and without."""
    with Simulator(_built("Growing", "2.0", folder)) as simulator:
        for times, values, at in (
            ([0.0, 0.5, 0.5, 1.0], [0, 0, 9, 9], 0.5),
            ([0.0, 1.0], [4, 6], 0.5),
        ):
            with pytest.raises(RunFailure, match=f"at time {at} s: u is too large"):
                simulator.run(
                    [0.0, 1.0], inputs=Inputs(np.array(times), {"u": np.array(values, dtype=float)})
                )
    ramp = Inputs(np.array([0.0, 1.0]), {"u": np.array([0.0, 2.0])})
    with (
        Simulator(_built("Algebraic", "2.0", folder)) as simulator,
        pytest.raises(RunFailure, match=r"at time 0\.75 s: y too large"),
    ):
        simulator.run([0.0, 1.0], inputs=ramp)
