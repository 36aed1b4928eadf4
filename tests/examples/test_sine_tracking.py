"""The tracking test of the examples, against the linear closed loop."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from tests.documentation.pages import blocks
from tests.examples.modules import EXAMPLES, example

PLANT = """
model Slide "An integrator"
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
SINE = {"output": "y", "mean": 1.0, "amplitude": 0.1, "frequencies": [0.5, 1.5], "lead": 3.0}
OMEGA = 2 * np.pi * np.array(SINE["frequencies"])
track = example("tracking/sine_tracking.py").track


@pytest.fixture
def slide(tmp_path: Path) -> str:
    (tmp_path / "Slide.mo").write_text(PLANT)
    return str(tmp_path / "Slide.mo")


def proportional() -> pam.Controller:
    @pam.controller(inputs={"y": "m", "y_wanted": "m"}, outputs={"u": "m/s"}, interval=0.005)
    def law(time: float, y: float, y_wanted: float) -> float:
        return 6 * (y_wanted - y)

    return law


def test_a_closed_loop_whose_answer_is_known(slide: str) -> None:
    """y = K/(s + K) w; the samples add a delay of half an interval. The error is the magnitude of 1 - gain."""
    tracking = track(slide, proportional, **SINE)
    np.testing.assert_allclose(tracking.gain, 1 / (1 + 1j * OMEGA / 6), rtol=0.04)
    np.testing.assert_allclose(tracking.relative_error, np.abs(1 - tracking.gain), rtol=0.01)
    assert tracking.settled.all()


@pytest.mark.full
def test_an_fmu_at_the_same_samples_has_the_same_gain(slide: str, tmp_path: Path) -> None:
    (tmp_path / "Gain.mo").write_text(PROPORTIONAL)
    gain = str(tmp_path / "Gain.mo")
    compiled = track(slide, gain, **SINE, interval=0.005)
    np.testing.assert_allclose(compiled.gain, track(slide, proportional, **SINE).gain, rtol=1e-9)
    stiffer = track(slide, gain, {"control.K": 12}, **SINE, interval=0.005)
    np.testing.assert_allclose(stiffer.relative_error, OMEGA / np.hypot(OMEGA, 12), rtol=0.1)


@pytest.mark.full
def test_the_page_follows_a_slow_sine(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(EXAMPLES.parent)
    monkeypatch.setattr(sys, "path", sys.path.copy())
    names: dict[str, object] = {}
    exec(blocks("runs.md#Tracking a sine", "python")[0], names)
    slow, fast = names["tracking"].relative_error  # type: ignore[attr-defined]
    assert slow < 0.1 < fast
    assert f"{slow:.1%}" in capsys.readouterr().out
