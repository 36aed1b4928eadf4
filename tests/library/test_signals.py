"""What drives a bench and what is read of it are connectors, to which blocks of Modelica.Blocks connect."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.catalogue.place import is_signal
from pam_cosim.fmu import build_model
from pam_cosim.simulation import Simulator
from tests.library.catalogue import BENCH, benches, check_each, tree

ROLES = ("PneumaticMuscle.Pneumatics", "PneumaticMuscle.Mechanics", "PneumaticMuscle.Instruments")
PARTS = [
    name
    for name, info in tree().classes.items()
    if name.rpartition(".")[0] in ROLES and info.kind == "model"
]

WIRED = """
model Wired "A bench wired to blocks"
  connector RealInput = input Real;
  connector RealOutput = output Real;
  block Constant
    parameter Real k;
    RealOutput y;
  equation
    y = k;
  end Constant;
  block Gain
    parameter Real k;
    RealInput u;
    RealOutput y;
  equation
    y = k*u;
  end Gain;
  PneumaticMuscle.Benches.Isotonic bench;
  Constant inlet(k=0.3), outlet(k=0), supply(k=2e5);
  Gain kilopascals(k=1e-3);
  PneumaticMuscle.Interfaces.Signals.LengthOutput x;
  output Real p = kilopascals.y;
equation
  connect(inlet.y, bench.u_in);
  connect(outlet.y, bench.u_out);
  connect(supply.y, bench.p_supply);
  connect(bench.p, kilopascals.u);
  connect(bench.x, x);
end Wired;
"""


def test_signals_of_benches_and_parts_are_connectors() -> None:
    assert len(PARTS) > 15
    check_each(_has_connectors, (*benches(), *PARTS))


def _has_connectors(name: str) -> None:
    signals = [c for c in tree().components(name) if c.prefixes & {"input", "output"}]
    assert signals or name not in benches()
    for signal in signals:
        assert is_signal(tree(), signal.type), signal.name


def test_blocks_connect_to_a_bench(tmp_path: Path) -> None:
    file = tmp_path / "Wired.mo"
    file.write_text(WIRED)
    times = np.linspace(0, 2, 41)
    with Simulator(build_model(str(file), brief=True)) as simulator:
        wired = simulator.run(times, tolerance=1e-8).values
    with Simulator(build_model(BENCH, brief=True)) as simulator:
        start = {"u_in": 0.3, "u_out": 0.0, "p_supply": 2e5}
        alone = simulator.run(times, parameters=start, tolerance=1e-8).values
    assert wired["p"] * 1e3 == pytest.approx(alone["p"], rel=1e-6, abs=0.1)
    assert wired["x"] == pytest.approx(alone["x"], rel=1e-6, abs=1e-8)
    assert alone["x"][-1] > 0.01
