"""The columns of a data set, read backwards: what a rig's logger says where an input has a value."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim import study
from pam_cosim.measurement import rig_columns

HEAD = "t_ms [ms];I1 [mA];I2 [mA];Versorgung;Druck [bar]"
ROWS = ["0;15;15;5;0", "10;215;15;5;0.4", "20;215;15;5;0.9"]
COLUMNS = """
time = { column = "t_ms" }
u_in = { column = "I1", offset = "-15 mA" }
u_out = { formula = "(I2 - \\"15 mA\\") / 2" }
p_supply = { column = "Versorgung", unit = "bar" }
p = { column = "Druck" }
"""


def test_maps_of_inputs_are_inverted(tmp_path: Path) -> None:
    (tmp_path / "run.csv").write_text("\n".join([HEAD, *ROWS]))
    toml = f'model = "TankFilling"\n[columns]{COLUMNS}\n[signals.p]\nsigma = "1 kPa"\n[[runs]]\nfile = "run.csv"\n'
    (tmp_path / "experiment.toml").write_text(toml)
    data = pam.read(tmp_path)
    interface = study.describe(data.model)
    found = rig_columns(tmp_path, interface, ["time", *interface.inputs])
    assert {name: (c.name, c.unit) for name, c in found.items()} == {
        "time": ("t_ms", "ms"),
        "u_in": ("I1", "mA"),
        "u_out": ("I2", "mA"),
        "p_supply": ("Versorgung", "bar"),
    }
    (run,) = data.runs
    for name, recorded in (("u_in", [15, 215, 215]), ("u_out", 15.0), ("p_supply", 5.0)):
        np.testing.assert_allclose(found[name].numbers(run.inputs[name]), recorded, atol=1e-9)
    assert found["u_out"].numbers(np.array([0.1]))[0] == pytest.approx(215.0)


def test_what_is_no_line_or_not_there_is_left_out(tmp_path: Path) -> None:
    interface = study.describe("TankFilling")
    assert rig_columns(tmp_path, interface, ["u_in"]) == {}
    (tmp_path / "run.csv").write_text("\n".join([HEAD, *ROWS]))
    columns = COLUMNS.replace('(I2 - \\"15 mA\\") / 2', 'I2 * I2 / \\"1 A\\"')
    toml = f'model = "TankFilling"\n[columns]{columns}\n[[runs]]\nfile = "run.csv"\n'
    (tmp_path / "experiment.toml").write_text(toml)
    assert set(rig_columns(tmp_path, interface, interface.inputs)) == {"u_in", "p_supply"}
