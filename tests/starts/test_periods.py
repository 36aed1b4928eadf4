"""Periodic runs: as many periods are simulated before them as a motion known in closed form needs."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import pam_cosim as pam
from pam_cosim.criteria import CRITERIA

LAG = """model Lag "Follows its input"
  input Real w(start=0);
  output Real y(unit="1");
  parameter Real rate(unit="1/s") = 1;
  Real s(unit="1", start=0, fixed=true);
equation
  der(s) = {right};
  y = s;
end Lag;"""
SIGMA = 1e-3


def compared(folder: Path, right: str) -> pam.Comparison:
    """A period of one second under a sine, against a model with the given equation."""
    (folder / "Lag.mo").write_text(LAG.format(right=right))
    t = np.arange(200) / 200
    rows = [f"{time:.3f},{np.sin(2 * np.pi * time):.9f},0" for time in t]
    (folder / "one.csv").write_text("\n".join(["time [s],w,y", *rows, ""]))
    (folder / "experiment.toml").write_text(
        f'title = "a lag"\nmodel = "Lag"\n[signals.y]\nsigma = "{SIGMA}"\n'
        '[[runs]]\nfile = "one.csv"\nrole = "fit"\nperiodic = true\n'
    )
    model = str(folder / "Lag.mo")
    return pam.compare(pam.read(folder, model=model), model)


def test_as_many_periods_as_the_transient_lasts(tmp_path: Path) -> None:
    """Under sin(w t) the lag begins w/(1 + w^2) off its periodic course, and e times less after each period."""
    (run,) = compared(tmp_path, "rate*(w - s)").data.runs
    omega = 2 * np.pi
    off = omega / (1 + omega**2)
    needed = int(np.log(off / (CRITERIA.starts.round * SIGMA))) + 1
    assert 3 < needed < CRITERIA.starts.periods
    assert run.start.periods == needed
    assert run.start.reason == f"one is periodic: {needed} periods of 1 s are simulated before it"


def test_a_motion_that_drifts_is_said_not_to_be_periodic(tmp_path: Path) -> None:
    (run,) = compared(tmp_path, "rate*(w + 1)").data.runs
    assert run.start.periods == CRITERIA.starts.periods
    assert run.start.reason.endswith("and it is not periodic by then")
