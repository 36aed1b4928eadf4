"""Benches have one frame, that of a rig that is put together from parts, and share what several of them have."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.catalogue import compose_bench
from pam_cosim.fmu import build_model
from pam_cosim.simulation import Simulator
from tests.library.shelf import BENCH, benches, tree

FRAME = "PneumaticMuscle.Interfaces.Rig"
WITHOUT_SURROUNDINGS = {"PneumaticMuscle.Benches.LumpedLinear"}
MUSCLES = "PneumaticMuscle.Muscles.Components"


def test_benches_extend_the_frame_that_rigs_of_parts_extend() -> None:
    assert f"extends {FRAME};" in compose_bench(tree(), "valves", "hanging-load").text
    outside = {bench for bench in benches() if not tree().is_subtype(bench, FRAME)}
    assert outside == WITHOUT_SURROUNDINGS
    assert not [c.name for b in outside for c in tree().components(b) if c.name == "ambient"]


def test_a_channel_begins_as_all_of_its_bench_does() -> None:
    """Who extends a reading says so; left out, a channel would begin at its start values in a bench at rest."""
    for bench in benches():
        for channel in (c for c in tree().components(bench) if c.name.startswith("channel_")):
            said = {t for b in (bench, *tree().bases(bench)) for t in _said(b, channel.name)}
            own = {"dynamics" if bench in WITHOUT_SURROUNDINGS else "ambient.dynamics"}
            assert said == own, (bench, channel.name)


def _said(name: str, channel: str) -> list[str]:
    info = tree().classes[name]
    own = [c.modifications.get("dynamics") for c in info.components if c.name == channel]
    inherited = [base.modifications.get(f"{channel}.dynamics") for base in info.extends]
    return [text for text in (*own, *inherited) if text]


def test_another_muscle_takes_the_place_of_a_bench_s(tmp_path: Path) -> None:
    file = tmp_path / "Butyl.mo"
    file.write_text(
        f"model Butyl extends {BENCH}(redeclare {MUSCLES}.ButylMuscle muscle); end Butyl;"
    )
    with Simulator(build_model(str(file), brief=True)) as simulator:
        ours = simulator.run([0.0, 1.0, 4.0], parameters={"load.m": 5.0}).values["x"]
    with Simulator(build_model("PneumaticMuscle.Examples.ButylIsotonic", brief=True)) as simulator:
        stated = simulator.run([0.0, 1.0, 4.0], parameters={"load.m": 5.0}).values["x"]
    with Simulator(build_model(BENCH, brief=True)) as simulator:
        usual = simulator.run([0.0, 1.0, 4.0], parameters={"load.m": 5.0}).values["x"]
    assert ours == pytest.approx(stated, abs=1e-12)
    assert np.abs(ours - usual).max() > 1e-4
