"""A muscle as an actuator of MuJoCo: against the model at other points, in MuJoCo where that is installed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.simulation.models import opened
from pam_cosim.study.actuators import Actuator
from tests.cli.conftest import ROOT, Outcome
from tests.cli.test_commands import done

Command = Callable[..., Outcome]


@pytest.fixture(scope="module")
def muscle() -> Actuator:
    return pam.actuator(contractions=("0 mm", "50 mm"))


def test_its_error_is_what_it_states_at_other_points(muscle: Actuator) -> None:
    p, x = (
        one.ravel() for one in np.meshgrid(np.linspace(60e3, 290e3, 9), np.linspace(1e-3, 37e-3, 9))
    )
    with opened("QuasiStaticIsometric") as simulator:
        force = simulator.equilibria({"p": p, "x": x})["F"]
    pulls = force > 0.0
    error = (muscle.pull(p, x) - force)[pulls]
    assert pulls.sum() > 60 and np.ptp(force) > 300.0
    assert (
        np.sqrt(np.mean(error**2)) < 1.5 * muscle.rms and np.abs(error).max() <= 1.01 * muscle.worst
    )
    assert muscle.rms < 0.01 * muscle.greatest


def test_pressure_lifts_and_length_slackens(muscle: Actuator) -> None:
    more_pressure, longer = (
        muscle.pull(np.array([1e5, 2e5]), 0.01),
        muscle.pull(2e5, np.array([0.03, 0.01])),
    )
    assert more_pressure[0] < more_pressure[1] and longer[0] < longer[1]
    assert muscle.pull(np.array(0.0), np.array(0.05)) == 0.0, "a muscle does not push"


def test_the_file_says_its_error(muscle: Actuator, command: Command, place: Path) -> None:
    said = done(command("actuator", "-o", "muscle.xml", "--time-constant", "50 ms")).out
    text = (place / "muscle.xml").read_text(encoding="utf-8")
    assert str(muscle) in said and str(muscle).splitlines()[1] in text
    made = ElementTree.fromstring(text).find("actuator/general")
    assert (
        made is not None and made.get("dyntype") == "filterexact" and made.get("dynprm") == "0.05"
    )
    numbers = [
        float(one) for one in (made.get("gainprm", "") + " " + made.get("biasprm", "")).split()
    ]
    assert numbers == pytest.approx([*muscle.gain, 0.0, *muscle.bias, 0.0], rel=1e-8)


def test_what_a_data_set_states_goes_along(command: Command, place: Path) -> None:
    """Fitted values alone are no muscle: its length is in the data set."""
    (place / "fitted.json").write_text('{"muscle.D0": 0.03, "muscle.turns": 2.0}')
    data = ROOT / "examples" / "static-map"
    words = ("actuator", "--params", "fitted.json", "-o")
    alone, whole = done(command(*words, "a.xml")), done(command(*words, "b.xml", "--data", data))
    assert alone.out != whole.out
    site = ElementTree.parse(place / "b.xml").find("worldbody/body")
    assert site is not None and site.get("pos") == "0 0 0.296"
    by_hand = done(command(*words, "c.xml", "--set", "muscle.L0=296 mm", "--set", "muscle.mu_fb=0"))
    assert by_hand.out == whole.out


def test_mujoco_pulls_as_it_should(muscle: Actuator, tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_path(str(muscle.write(tmp_path / "muscle.xml")))
    state = mujoco.MjData(model)
    for x, p in ((0.0, 2e5), (0.02, 2.5e5), (0.03, 1e5)):
        state.qpos[0], state.ctrl[0] = x, p
        mujoco.mj_forward(model, state)
        assert -state.actuator_force[0] == pytest.approx(
            float(muscle.pull(np.array(p), np.array(x))), rel=1e-6
        )
        assert state.qfrc_actuator[0] > 0.0, "it lifts"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("-o", "muscle.txt"), "ends in .xml"),
        (("--force", "G"), "no 'G'"),
        (("--length", "muscle.L1"), "muscle.L1"),
        (("--pressure", "p=3 bar:1 bar"), "begin below its end"),
        (("--contraction", "x=100 mm:120 mm"), "pulls at"),
        (("--pressure", "p=1 bar"), "FROM:TO"),
        (("--pressure", "x=0 mm:5 mm", "--contraction", "p=0 bar:1 bar"), "'x' is no pressure"),
        (("--length", "ambient.T"), "'ambient.T' is no length"),
        (("--contraction", "x=0 m:5 m"), "not within muscle.L0, 240 mm"),
        (("--time-constant", "5 kg"), "--time-constant: unit 'kg'"),
        (("--time-constant", "0"), "--time-constant must be a finite time above zero"),
    ],
)
def test_what_cannot_be_used(
    words: tuple[str, ...], message: str, command: Command, place: Path
) -> None:
    outcome = command("actuator", *words)
    assert outcome.status == 2 and message in outcome.err, outcome.err
    assert list(place.iterdir()) == []
