"""Benches have one frame, that of a rig that is put together from parts, and share what several of them have."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.catalogue import compose_bench
from pam_cosim.fmu import build_model
from pam_cosim.simulation import Simulator
from tests.library.catalogue import BENCH, benches, tree

FRAME = "PneumaticMuscle.Interfaces.Rig"
WITHOUT_SURROUNDINGS = {"PneumaticMuscle.Benches.LumpedLinear"}
MUSCLES = "PneumaticMuscle.Muscles.Components"


def test_benches_extend_the_frame_that_rigs_of_parts_extend() -> None:
    assert f"extends {FRAME};" in compose_bench(tree(), "valves", "hanging-load").text
    outside = {bench for bench in benches() if not tree().is_subtype(bench, FRAME)}
    assert outside == WITHOUT_SURROUNDINGS
    assert not [c.name for b in outside for c in tree().components(b) if c.name == "ambient"]


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
