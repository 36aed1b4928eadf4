"""Effects of one channel in series: order, parameters, values, and what is refused with which reason."""

from __future__ import annotations

import re
from itertools import permutations
from pathlib import Path

import numpy as np
import pytest
from scipy.signal import lfilter

from pam_cosim import study
from pam_cosim.catalogue import compose
from pam_cosim.compiler import read_library
from pam_cosim.errors import InputError
from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Simulator
from tests.library.catalogue import BENCH, driven, tree

ONE_CHANNEL = {
    "PositionOffset": ("offset", 2e-3),
    "PositionLag": ("tau", 0.1),
    "PositionGain": ("gain", 1.1),
    "PositionCeiling": ("high", 0.05),
}
SIX = [*ONE_CHANNEL, "PressureLag", "LinearBladder"]
STEP = 1e-3


@pytest.mark.parametrize("order", list(permutations(ONE_CHANNEL))[::5], ids="-".join)
def test_effects_of_one_channel_act_one_after_the_other(order: tuple[str, ...]) -> None:
    composition = compose(tree(), BENCH, order)
    parameters = {f"channel_x.{name}": value for name, value in ONE_CHANNEL.values()}
    assert composition.parameters == {e: (f"channel_x.{ONE_CHANNEL[e][0]}",) for e in order}
    times = np.arange(0, 10, STEP)
    with Simulator(build_source(composition.name, composition.text, brief=True)) as simulator:
        shown = simulator.run(times, parameters=parameters, tolerance=1e-8).values["x"]
    with Simulator(build_model(BENCH, brief=True)) as simulator:
        x = simulator.run(times, tolerance=1e-8).values["x"]
    for effect in sorted(order, key="PositionCeiling".__eq__):  # a limit of the record is its last
        x = _passed(effect, x)
    assert np.abs(shown - x).max() < 3e-5 and shown.max() > 0.049


def _passed(effect: str, x: np.ndarray) -> np.ndarray:
    value = ONE_CHANNEL[effect][1]
    if effect == "PositionOffset":
        return x + value
    if effect == "PositionGain":
        return value * x
    if effect == "PositionCeiling":
        return np.minimum(x, value)
    share = np.exp(-STEP / value)
    late, _ = lfilter([(1 - share) / 2, (1 - share) / 2], [1, -share], x - x[0], zi=[0.0])
    return x[0] + late


def test_six_effects_are_added_with_values_and_more_to_their_file(tmp_path: Path) -> None:
    first, further = tmp_path / "First.mo", tmp_path / "Further.mo"
    values = {f"channel_x.{name}": value for name, value in ONE_CHANNEL.values()}
    study.add(SIX, "Isotonic", first, values=values | {"channel_p.tau": 0.07, "bladder.k": 300.0})
    study.add(["PositionFloor", "PressureGain"], str(first), further, values={"channel_x.tau": 0.2})
    for model, tau in ((first, 0.1), (further, 0.2)):
        parameters = study.describe(str(model)).parameters
        stated = values | {"channel_x.tau": tau, "channel_p.tau": 0.07, "bladder.k": 300.0}
        assert {name: parameters[name].start for name in stated} == stated
        assert (parameters["channel_x.tau"].min, parameters["channel_x.tau"].max) == (1e-6, 5)
    assert "channel_x.low" in parameters
    assert np.isfinite(study.simulate(str(further)).values["x"]).all()


@pytest.mark.parametrize(
    ("effects", "said"),
    [
        (["EnergyGas", "RealGas"], "EnergyGas and RealGas are two laws of one place, muscle.Gas"),
        (["LinearBladder", "ValveLag", "ValveDelay"], "ValveLag and ValveDelay are two laws of"),
        (["PressureLag", "PressureTwoLags"], "PressureLag and PressureTwoLags both have a para"),
        (["ForceOffset"], "Isotonic has no place for ForceOffset; 'pam-cosim effects ForceOffset'"),
        (["LoadFrequencyFriction"], "Isotonic has no place for LoadFrequencyFriction;"),
    ],
)
def test_an_effect_without_a_place_is_named_with_its_rival(effects: list[str], said: str) -> None:
    with pytest.raises(InputError, match=re.escape(said)):
        compose(tree(), BENCH, effects)
    if len(effects) > 1:  # what the message says to do
        compose(tree(), BENCH, effects[:-1])


def test_a_law_that_a_bench_chose_for_its_channel_stays(tmp_path: Path) -> None:
    file = tmp_path / "Mine.mo"
    file.write_text("""model Halved extends PneumaticMuscle.Interfaces.PositionChannel;
  parameter Real by = 2; equation y = u/by; end Halved;
model Mine extends PneumaticMuscle.Benches.Isotonic(redeclare model PositionChannel = Halved,
  channel_x(by=4)); end Mine;""")
    made = compose(read_library(files=[file]), "Mine", ["PositionOffset"], files=[file])
    with Simulator(build_source(made.name, made.text, [file], brief=True)) as simulator:
        own = driven(simulator, {"channel_x.offset": 1e-3})["x"]
    with Simulator(build_model(BENCH, brief=True)) as simulator:
        x = driven(simulator, {})["x"]
    np.testing.assert_allclose(own, x / 4 + 1e-3, atol=1e-7)
