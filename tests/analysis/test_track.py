"""Tracking: against the linear closed loop, by controllers in Python and in FMUs, and what cannot be joined."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam

PLANT = """
model Slide "Moves as fast as it is told"
  input Real u(start=0, unit="m/s");
  output Real y(unit="m");
  Real x(start=0, fixed=true, unit="m");
equation
  der(x) = u;
  y = x;
end Slide;
"""
PROPORTIONAL = """
model Gain "Proportional"
  input Real y(start=0, unit="m");
  input Real y_wanted(start=0, unit="m");
  output Real u(unit="m/s");
  parameter Real K(unit="1/s") = 6;
equation
  u = K*(y_wanted - y);
end Gain;
"""
WORDS = {"output": "y", "mean": 1.0, "amplitude": 0.1, "frequencies": [0.5, 1.5], "lead": 3.0}


@pytest.fixture
def slide(tmp_path: Path) -> str:
    (tmp_path / "Slide.mo").write_text(PLANT)
    return str(tmp_path / "Slide.mo")


@pytest.fixture
def gain(tmp_path: Path) -> str:
    (tmp_path / "Gain.mo").write_text(PROPORTIONAL)
    return str(tmp_path / "Gain.mo")


def proportional() -> pam.Controller:
    @pam.controller(inputs={"y": "m", "y_wanted": "m"}, outputs={"u": "m/s"}, interval=0.005)
    def law(time: float, y: float, y_wanted: float) -> float:
        return 6 * (y_wanted - y)

    return law


def test_a_closed_loop_whose_answer_is_known(slide: str) -> None:
    """y = K/(s + K) w, the sampling adding half a sample of delay; the error is that of the difference from one."""
    tracking = pam.track(slide, proportional, **WORDS)
    expected = 1 / (1 + 2j * np.pi * np.array(WORDS["frequencies"]) / 6)
    np.testing.assert_allclose(tracking.gain, expected, rtol=0.04)
    np.testing.assert_allclose(tracking.relative_error, np.abs(1 - tracking.gain), rtol=0.01)
    assert (
        tracking.settled.all()
        and tracking.rate == pytest.approx(200)
        and tracking.controller == "proportional"
    )


@pytest.mark.full
def test_an_fmu_says_the_same(slide: str, gain: str) -> None:
    """It acts at its samples alone, however finely what is wanted is given."""
    compiled, python = (
        pam.track(slide, gain, **WORDS, rate=200),
        pam.track(slide, proportional, **WORDS),
    )
    np.testing.assert_allclose(compiled.gain, python.gain, rtol=1e-9)
    stiffer = pam.track(slide, gain, {"control.K": 12}, **WORDS, rate=200)
    omega = 2 * np.pi * np.array(WORDS["frequencies"])
    np.testing.assert_allclose(stiffer.relative_error, omega / np.hypot(omega, 12), rtol=0.1)


@pytest.mark.full
def test_a_foreign_controller(slide: str, gain: str, tmp_path: Path) -> None:
    """In a process of its own; the same numbers."""
    foreign = str(pam.build(gain, tmp_path / "Gain.fmu"))
    other, own = (pam.track(slide, one, **WORDS, rate=100) for one in (foreign, gain))
    np.testing.assert_allclose(other.gain, own.gain, rtol=1e-9)
    assert other.controller == "Gain"


@pytest.mark.full
def test_the_muscle_follows_slowly_and_not_fast() -> None:
    tracking = pam.track(
        "Isotonic", "CoSimulation.ServoController", output="x", mean="45 mm", amplitude="5 mm", frequencies=[0.1, 2.0],
    )  # fmt: skip
    assert tracking.relative_error[0] < 0.05 and tracking.relative_error[1] > 0.8
    assert tracking.actuation["u_in"].max() <= 0.35 and tracking.actuation["u_out"].min() >= 0.145


@pytest.mark.full
def test_saved_loaded_drawn_and_shown(slide: str, tmp_path: Path) -> None:
    tracking = pam.track(slide, proportional, **WORDS)
    assert pam.load(pam.save(tracking, tmp_path / "t.npz")).as_dict() == tracking.as_dict()
    pam.draw(tracking, tmp_path / "t.png")
    assert (tmp_path / "t.png").read_bytes().startswith(b"\x89PNG")
    assert (
        tracking.to_csv(tmp_path / "t.csv").read_text().startswith("frequency [Hz],rms error [m],")
    )
    assert "<pre>" in tracking._repr_html_() and "follows 1e+03 mm" in str(tracking)


def raising() -> pam.Controller:
    @pam.controller(inputs={"y": "m", "y_wanted": "m"}, outputs={"u": "m/s"})
    def law(time: float, y: float, y_wanted: float) -> float:
        raise ValueError("no idea")

    return law


def deaf() -> pam.Controller:
    return pam.controller(inputs={"y": "m"}, outputs={"u": "m/s"})(lambda time, y: 0.0)


def idle() -> pam.Controller:
    return pam.controller(inputs={"y": "m", "y_wanted": "m"}, outputs={"v": "m/s"})(
        lambda time, y, y_wanted: 0.0
    )


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"output": "q"}, "no output 'q'"),
        ({"amplitude": "1 kg"}, "y=1 kg"),
        ({"amplitude": 0}, "the amplitude must be above zero"),
        ({"frequencies": [0]}, "frequencies and the rate must be above zero"),
        ({"periods": 1}, "two periods"),
        ({"controller": raising}, "no idea"),
        ({"controller": deaf}, "no input 'y_wanted'"),
        ({"controller": idle}, "has the name of an input of Slide: u"),
        ({"parameters": {"plant.q": 1}}, "'q'"),
    ],
)
def test_bad_input(slide: str, words: dict, message: str) -> None:
    with pytest.raises(pam.InputError, match=message):
        pam.track(slide, **({"controller": proportional} | WORDS | words))
