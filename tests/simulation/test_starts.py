"""Runs that begin elsewhere than the model does by itself, and the slopes by where they begin."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.fmu import build_model
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.model.references import START_VALUES
from pam_cosim.simulation import Inputs, Settle, Simulator

TIMES = np.linspace(0.0, 2.0, 41)
INPUTS = Inputs(
    np.array([0.0, 2.0]), {"u_in": np.array([0.35, 0.35]), "u_out": np.array([0.05, 0.05])}
)
GAS, POSITION, SPEED = "muscle.gas.p", "load.s", "load.v"


@pytest.fixture(scope="module")
def isotonic() -> Iterator[Simulator]:
    path = build_model("Isotonic", sensitivities=("valve.C_A", START_VALUES), where_smooth=True)
    with Simulator(path) as simulator:
        yield simulator


def test_every_state_has_a_start_value(isotonic: Simulator) -> None:
    assert isotonic.interface.states == (GAS, POSITION, SPEED)
    assert isotonic.interface.rates == tuple(f"der({name})" for name in isotonic.interface.states)
    assert set(isotonic.interface.states) <= isotonic.interface.settable.keys()
    assert isotonic.interface.start_values[GAS].start == 101325.0


def test_a_run_goes_on_from_where_another_was_cut(isotonic: Simulator) -> None:
    states = list(isotonic.interface.states)
    whole = isotonic.run(TIMES, inputs=INPUTS, outputs=["p", "x", *states], tolerance=1e-9)
    begins = {name: float(whole[name][20]) for name in states}
    rest = isotonic.run(
        TIMES[20:], parameters=begins, inputs=INPUTS, outputs=["p", "x"], tolerance=1e-9
    )
    for name in ("p", "x"):
        assert np.abs(rest[name] - whole[name][20:]).max() < 1e-6 * np.ptp(whole[name])


@pytest.mark.parametrize("settle", ["none", "others", "all"])
@pytest.mark.parametrize("by", [GAS, POSITION, SPEED, "valve.C_A"])
def test_slopes_by_start_values_are_exact(isotonic: Simulator, by: str, settle: Settle) -> None:
    held = {GAS: 2.2e5} if settle == "others" else {GAS: 2.2e5, POSITION: 0.03, SPEED: 0.1}
    at = held.get(by, 0.7)
    if by == POSITION and settle == "others":
        held = {**held, by: (at := 0.02)}
    if by == SPEED and settle == "others":  # a mass that moves is nowhere at rest
        held = {**held, POSITION: 0.03, by: (at := 0.02)}

    def course(value: float) -> np.ndarray:
        run = isotonic.run(
            TIMES,
            parameters={**held, by: value},
            inputs=INPUTS,
            outputs=["x"],
            settle=settle,
            tolerance=1e-9,
        )
        return run["x"]

    slope = sensitivity_name("x", by)
    run = isotonic.run(
        TIMES,
        parameters={**held, by: at},
        inputs=INPUTS,
        outputs=[slope],
        settle=settle,
        tolerance=1e-9,
    )
    step = 1e-4 * abs(at)
    difference = (course(at + step) - course(at - step)) / (2 * step)
    rounding = (
        1e-6 * float(np.abs(course(at)).max()) / abs(at)
    )  # where a start value does not matter
    size = max(float(np.abs(difference).max()), rounding)
    assert np.abs(run[slope] - difference).max() < 1e-3 * size


def test_all_settles_under_the_first_inputs(isotonic: Simulator) -> None:
    run = isotonic.run(TIMES, inputs=INPUTS, outputs=["p", "x", SPEED], settle="all")
    assert np.ptp(run["p"]) < 1e-6 * run["p"][0]
    assert np.ptp(run["x"]) < 1e-6 * run["x"][0]
    assert run["p"][0] > 1e5


def test_what_is_given_stays_where_others_settle(isotonic: Simulator) -> None:
    states = list(isotonic.interface.states)
    rates = list(isotonic.interface.rates)
    run = isotonic.run(
        TIMES[:1], parameters={GAS: 2e5}, inputs=INPUTS, outputs=[*states, *rates], settle="others"
    )
    assert run[GAS][0] == 2e5
    assert abs(run["der(muscle.gas.p)"][0]) > 1e3  # gas flows
    assert abs(run["der(load.v)"][0]) < 1e-6 and abs(run[SPEED][0]) < 1e-12


def test_an_unknown_state_is_refused(isotonic: Simulator) -> None:
    with pytest.raises(InputError, match="gas.q"):
        isotonic.run(TIMES, parameters={"muscle.gas.q": 1.0})
