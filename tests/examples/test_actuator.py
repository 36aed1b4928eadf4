"""A muscle as an actuator of MuJoCo: against the model at other points, in MuJoCo where that is installed."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from pam_cosim.simulation.models import opened
from tests.examples.modules import EXAMPLES, example

script = example("mujoco-actuator/actuator.py")


@pytest.fixture(scope="module")
def muscle() -> Any:
    return script.actuator()


def test_its_error_is_what_it_states_at_other_points(muscle: Any) -> None:
    p, x = (
        one.ravel() for one in np.meshgrid(np.linspace(60e3, 290e3, 9), np.linspace(1e-3, 37e-3, 9))
    )
    with opened("QuasiStaticIsometric") as simulator:
        force = simulator.equilibria({"p": p, "x": x})["F"]
    pulls = force > 0.0
    error = (muscle.pull(p, x) - force)[pulls]
    assert pulls.sum() > 60 and np.ptp(force) > 300.0
    assert np.sqrt(np.mean(error**2)) < 1.5 * muscle.rms
    assert np.abs(error).max() <= 1.01 * muscle.worst
    assert muscle.rms < 0.01 * muscle.greatest


def test_a_muscle_does_not_push(muscle: Any) -> None:
    assert muscle.pull(1e5, 0.01) < muscle.pull(2e5, 0.01)
    assert muscle.pull(2e5, 0.03) < muscle.pull(2e5, 0.01)
    assert muscle.pull(0.0, 0.05) == 0.0


def test_the_data_set_adds_the_values_that_it_states(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The length of the muscle is in the data set, not among the fitted values."""
    fitted, scene = tmp_path / "fitted.json", tmp_path / "muscle.xml"
    fitted.write_text('{"muscle.D0": 0.03, "muscle.turns": 2.0}')
    words = ["--params", str(fitted), "-o", str(scene)]
    script.main([*words, "--data", str(EXAMPLES / "static-map")])
    whole = scene.read_text()
    site = ElementTree.fromstring(whole).find("worldbody/body")
    assert site is not None and site.get("pos") == "0 0 0.296"
    script.main([*words, "--set", "muscle.L0=296 mm", "--set", "muscle.mu_fb=0"])
    assert scene.read_text() == whole
    assert "written: " in capsys.readouterr().out


def test_mujoco_has_the_same_force(muscle: Any) -> None:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_string(muscle.xml())
    state = mujoco.MjData(model)
    for x, p in ((0.0, 2e5), (0.02, 2.5e5), (0.03, 1e5)):
        state.qpos[0], state.ctrl[0] = x, p
        mujoco.mj_forward(model, state)
        assert -state.actuator_force[0] == pytest.approx(float(muscle.pull(p, x)), rel=1e-6)
        assert state.qfrc_actuator[0] > 0.0, "it lifts"
