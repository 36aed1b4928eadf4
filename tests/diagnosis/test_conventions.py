"""A convention of the logger is found before any effect, and what the data set states is never overruled."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.measurement import DataSet

_TANK = {"tank.V": "2 l", "valve.C_A": 0.7}


def _recorded(folder: Path, states: str = "") -> DataSet:
    """A tank that a controller of 20 Hz fills and empties by sines, and holds its commands."""
    time = np.arange(0.0, 8.0, 0.05)
    rows = {
        "u_in": np.clip(0.3 * np.sin(5.0 * time), 0.0, None).round(4),
        "u_out": np.clip(-0.3 * np.sin(5.0 * time), 0.0, None).round(4),
        "p_supply": np.full(len(time), 5e5),
    }
    run = pam.simulate(
        "TankFilling",
        _TANK,
        inputs=pam.Inputs(time, rows, "previous"),
        stop_time=float(time[-1]),
        interval=0.05,
    )
    read = np.interp(time, run.time, run["p"])
    noise = np.random.default_rng(3).normal(0.0, 100.0, len(time))
    table = np.column_stack([time, *rows.values(), read + noise])
    folder.mkdir()
    np.savetxt(
        folder / "run.csv", table, "%.9g", ",", comments="",
        header="time [s],u_in [A],u_out [A],p_supply [Pa],p [Pa]",
    )  # fmt: skip
    (folder / "experiment.toml").write_text(
        'title = "tank"\nmodel = "PneumaticMuscle.Benches.TankFilling"\n[signals.p]\nsigma = "0.1 kPa"\n'
        '[parameters]\n"tank.V" = "2 l"\n[fit]\n"valve.C_A" = { min = 0.5, max = 0.9 }\n'
        f'[[runs]]\nfile = "run.csv"\n{states}\n'
    )
    return pam.read(folder)


@pytest.mark.parametrize("states", ["", 'interpolation = "linear"', 'interpolation = "previous"'])
def test_held_commands(states: str, tmp_path: Path) -> None:
    data = _recorded(tmp_path / "tank", states)
    diagnosis = pam.diagnose(data, workers=0, explain=False, simulation_limit=300)
    assert diagnosis.data.runs[0].interpolation_stated == bool(states)
    if states:
        assert diagnosis.convention == ""
        assert diagnosis.data.runs[0].interpolation == states.split('"')[1]
        return
    assert "held commands fit the data much better than linear ones" in diagnosis.convention
    assert f"LOOK FIRST: {diagnosis.convention}" in str(diagnosis)
    assert diagnosis.as_dict()["convention"] == diagnosis.convention
    assert diagnosis.verdict.kind == "none_missing"
    written = replace(data, runs=(replace(data.runs[0], interpolation="previous"),))
    assert diagnosis.base.comparison.chi2_reduced() == pytest.approx(
        pam.fit(written).comparison.chi2_reduced(), rel=1e-3
    )


def test_a_larger_limit_tries_what_a_limit_left(tmp_path: Path) -> None:
    data = _recorded(tmp_path / "tank", 'interpolation = "linear"')
    few = pam.diagnose(data, workers=0, explain=False, simulation_limit=20)
    assert "--simulation-limit states how many" in str(few)
    more = pam.diagnose(data, workers=0, explain=False, simulation_limit=2 * few.simulations)
    assert more.simulations > few.simulations and more.untried != few.untried
