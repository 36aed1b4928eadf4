"""Models that begin at rest, through FMI: from which guess, with which slopes, and what is said where none is."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import fmpy
import fmpy.cli
import fmpy.validation
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave

from pam_cosim.compiler.sensitivities import with_sensitivities
from pam_cosim.fmu import build_fmu, build_source
from pam_cosim.fmu.build import FMI_VERSIONS
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.simulation import Inputs, RunFailure, Simulator
from tests.compiler.run import MODELS, compiled
from tests.fmu.models import folder

KINDS = ("CoSimulation", "ModelExchange")
BY = ("tank.k", "tank.p_start", "second.p_start", "tank.p")


@cache
def fmu(model: str, fmi: str = "2.0", by: tuple[str, ...] = ()) -> Path:
    path = folder() / f"{model}-{fmi}-{len(by)}.fmu"
    return build_fmu(with_sensitivities(compiled(f"Rest.{model}"), by), path, fmi=fmi)


def at_start(model: str, fmi: str, kind: str, **start: float) -> Any:
    """Outputs and states when initialization has ended, as FMPy reads them."""
    values = {name.replace("__", "."): value for name, value in start.items()}
    names = ["tank.p", "tank.q[1]", "tank.q[2]"]
    return fmpy.simulate_fmu(
        str(fmu(model, fmi)),
        fmi_type=kind,
        stop_time=1.0,
        output_interval=0.5,
        start_values=values,
        output=names,
    )


@pytest.mark.parametrize("fmi", FMI_VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_run_begins_at_rest_under_its_first_inputs(kind: str, fmi: str) -> None:
    for k in (1.0, 2.0):
        result = at_start("Steady", fmi, kind, u=27.0 * k, tank__k=k)
        for row in result.tolist():
            assert row[1:] == pytest.approx([3.0, 3.0, 9.0], rel=1e-7)


@pytest.mark.parametrize("fmi", FMI_VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_a_start_value_that_is_set_is_a_guess(kind: str, fmi: str) -> None:
    assert at_start("Steady", fmi, kind, u=27.0, tank__p=2.0).tolist()[0][1:] == pytest.approx(
        [3.0, 3.0, 9.0], rel=1e-9
    )
    assert at_start("Plain", fmi, kind, u=27.0, tank__p=2.0).tolist()[0][1:] == (2.0, 0.0, 0.0)
    assert at_start("Guess", fmi, kind, u=27.0, tank__p=2.0).tolist()[0][1:] == (2.0, 0.0, 0.0)


def test_runs_of_this_projects_fmus_begin_at_stated_values() -> None:
    with Simulator(fmu("Steady")) as simulator:
        run = simulator.run([0.0], parameters={"tank.p": 1.5}, outputs=["tank.p", "tank.q[1]"])
        assert (run["tank.p"][0], run["tank.q[1]"][0]) == (1.5, pytest.approx(1.5))
        other = simulator.run([0.0], outputs=["tank.p"])  # and the next run does not
        assert other["tank.p"][0] == pytest.approx(2.0)


@pytest.mark.parametrize("name", BY)
@pytest.mark.parametrize("state", ["tank.p", "tank.q[2]", "second.p"])
def test_slopes_of_the_start_are_those_of_finite_differences(state: str, name: str) -> None:
    """By a parameter in the rates, by a guess, by the start of what the rest stands beside, by a start that is set."""
    values = {"tank.k": 1.3, "tank.p_start": 2.0, "second.p_start": 19.0}
    at = values.get(name, 2.5)
    with Simulator(fmu("Two", by=BY)) as simulator:

        def value(x: float) -> float:
            return float(
                simulator.run(
                    [0.0], parameters={**values, name: x}, outputs=[state], tolerance=1e-9
                )[state][0]
            )

        slope = sensitivity_name(state, name)
        run = simulator.run([0.0], parameters={**values, name: at}, outputs=[slope])
        step = 1e-5 * at
        difference = (value(at + step) - value(at - step)) / (2 * step)
        assert run[slope][0] == pytest.approx(difference, rel=1e-5, abs=1e-7)


def leaning(u: float) -> float:
    """The pressure p with p^3 + p^2/10 = u."""
    return float(next(r.real for r in np.roots([1.0, 0.1, 0.0, -u]) if abs(r.imag) < 1e-9))


@pytest.mark.parametrize("fmi", FMI_VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_what_follows_a_rest_acts_on_it(kind: str, fmi: str) -> None:
    """z = p^2 at the start, where der(z) does not vanish; z takes from what feeds p."""

    def first(**start: float) -> dict[str, float]:
        names = ["tank.p", "z", "der(z)"]
        result = fmpy.simulate_fmu(
            str(fmu("Leaning", fmi)),
            fmi_type=kind,
            stop_time=0.1,
            start_values={"u": 27.0, **start},
            output=names,
        )
        return {name: float(result[name][0]) for name in names}

    p = leaning(27.0)
    assert first() == pytest.approx({"tank.p": p, "z": p**2, "der(z)": p - p**2}, rel=1e-9)
    p = 26 ** (1 / 3)
    assert first(z=10.0) == pytest.approx({"tank.p": p, "z": 10.0, "der(z)": p - 10}, rel=1e-9)


def test_a_model_as_data_begins_there_too() -> None:
    source = (MODELS / "Rest.mo").read_text()
    with Simulator(build_source("Rest.Leaning", source, lean=True, brief=True)) as simulator:
        run = simulator.run([0.0], parameters={"u": 27.0}, outputs=["tank.p", "z"])
        assert (run["tank.p"][0], run["z"][0]) == pytest.approx((leaning(27.0), leaning(27.0) ** 2))


@pytest.mark.parametrize(
    ("model", "wanted"), [("Steady", lambda u: u ** (1 / 3)), ("Leaning", leaning)]
)
def test_slopes_along_a_seed_in_initialization_mode(
    model: str, wanted: Callable[[float], float]
) -> None:
    """Of the rest by an input, as FMI's directional derivatives; each input that is set there has its own rest."""
    path = fmu(model)
    description = fmpy.read_model_description(str(path))
    reference = {v.name: v.valueReference for v in description.modelVariables}
    instance = FMU2Slave(
        guid=description.guid,
        unzipDirectory=fmpy.extract(str(path)),
        modelIdentifier=description.coSimulation.modelIdentifier,
        instanceName="one",
    )
    instance.instantiate()
    instance.setupExperiment(startTime=0.0)
    instance.enterInitializationMode()

    def p(u: float) -> float:
        instance.setReal([reference["u"]], [u])
        return float(instance.getReal([reference["tank.p"]])[0])

    difference = (p(27.001) - p(26.999)) / 0.002
    assert p(27.0) == pytest.approx(wanted(27.0))
    (slope,) = instance.getDirectionalDerivative([reference["y"]], [reference["u"]], [1.0])
    assert slope == pytest.approx((wanted(27.001) - wanted(26.999)) / 0.002, rel=1e-6)
    assert slope == pytest.approx(difference, rel=1e-6)
    (none,) = instance.getDirectionalDerivative([reference["y"]], [reference["tank.p"]], [1.0])
    assert none == 0.0  # of a guess
    instance.exitInitializationMode()
    assert instance.getReal([reference["tank.p"]])[0] == pytest.approx(wanted(27.0))
    instance.terminate()
    instance.freeInstance()


@pytest.mark.parametrize("fmi", FMI_VERSIONS)
@pytest.mark.parametrize("kind", KINDS)
def test_no_rest_is_an_error(kind: str, fmi: str) -> None:
    with pytest.raises(Exception, match="xitInitializationMode failed with status 3"):
        fmpy.simulate_fmu(str(fmu("Nowhere", fmi)), fmi_type=kind, stop_time=1.0)


@pytest.mark.parametrize("fmi", FMI_VERSIONS)
def test_the_error_is_a_sentence_and_another_input_may_have_a_rest(fmi: str) -> None:
    with Simulator(fmu("Nowhere", fmi)) as simulator:
        with pytest.raises(
            RunFailure, match="does not begin at rest, as it shall: no equilibrium was found: 'x'"
        ):
            simulator.run([0.0, 1.0])
        run = simulator.run(
            [0.0, 0.01], inputs=Inputs(np.array([0.0]), {"u": np.array([-4.0])}), outputs=["x"]
        )
        assert run["x"][0] == pytest.approx(-2.0)
