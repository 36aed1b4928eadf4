"""What a user knows of a valve or a muscle from its data sheet, stated in the words of that."""

from __future__ import annotations

import re
import shlex
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from tests.drafting.corpus import CASES

BEGIN, SLOPE = 0.145, 1.80e-6  # DP (62): A = SLOPE (u - BEGIN)
BY_NAME = {case.name: case for case in CASES}


def drafted(tmp_path: Path, name: str, **wishes: Any) -> pam.NewDataSet:
    """The data set of a case of the corpus."""
    files = BY_NAME[name].write(tmp_path / "files")
    return pam.new(tmp_path / "rig", files, **{**BY_NAME[name].stated, **wishes})


def written(made: pam.NewDataSet) -> dict[str, Any]:
    return tomllib.loads((made.folder / "experiment.toml").read_text())


@pytest.mark.parametrize(
    ("text", "area", "full", "begin"),
    [
        ("0.8 mm2 at 250 mA", 0.8e-6, 0.25, 0.0),
        ("area 0.8 mm2 at 0.25 A from 40 mA", 0.8e-6, 0.25, 0.04),
        # VDI 3290: from 7 to 6 bar absolute at 20 degC; psi of the isentropic flow is 0.492, T 293 K, rho 1.19 kg/m3
        ("flow 120 l/min at 300 mA", 2e-3 * 1.189 / (7e5 * 0.492 / np.sqrt(287.05 * 293.15)), 0.3, 0.0),
    ],
)  # fmt: skip
def test_an_area_at_a_current(
    tmp_path: Path, text: str, area: float, full: float, begin: float
) -> None:
    made = drafted(tmp_path, "valves: mA", valve=text)
    modelled = np.maximum(0.0, SLOPE * (made.data.runs[0].inputs["u_in"] - BEGIN))
    recorded = BY_NAME["valves: mA"].truth["u_in"]
    wanted = area * np.maximum(0.0, (recorded - begin) / (full - begin))
    np.testing.assert_allclose(modelled, wanted, rtol=0.01, atol=1e-11)
    assert (
        "valve.C_A" in written(made)["fit"]
    )  # no data sheet tells what the jet leaves of the area


def test_valves_that_differ_by_their_inputs(tmp_path: Path) -> None:
    sheets = "u_in=1.0 mm2 at 0.2 A; u_out=1.4 mm2 at 0.2 A"
    columns = written(drafted(tmp_path, "valves: mA", valve=sheets))["columns"]
    gains = {
        n: float(re.findall(r"([\d.]+) A/", columns[n]["formula"])[-1]) for n in ("u_in", "u_out")
    }
    assert gains["u_in"] == pytest.approx(1e-6 / SLOPE / 0.2, rel=1e-4)
    assert gains["u_out"] == pytest.approx(1.4 * gains["u_in"], rel=1e-4)


def test_an_area_at_a_voltage_and_of_a_valve_that_is_open_or_shut(tmp_path: Path) -> None:
    rows = ["t [s],U_in [V],U_out [V],p_supply [kPa],p [kPa],x [mm]"]
    rows += [f"{0.01 * k:.2f},{5 * (k > 50)},0,500,{min(k, 200)},{0.1 * min(k, 200)}" for k in range(300)]  # fmt: skip
    file = tmp_path / "run.csv"
    file.write_text("\n".join(rows) + "\n")
    columns = {"u_in": "U_in", "u_out": "U_out"}
    made = pam.new(tmp_path / "volts", [file], columns=columns, valve="0.8 mm2 at 10 V")
    opened = SLOPE * (made.data.runs[0].inputs["u_in"].max() - BEGIN)
    assert opened == pytest.approx(0.4e-6, rel=1e-4)
    for text in ("0.8 mm2", "0.4 mm2 at 50 %"):
        made = drafted(tmp_path / text, "switches: german", valve=text)
        assert written(made)["parameters"]["valve.C_A"] == pytest.approx(0.08)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("valves: mA", "large", "is not understood; write --valve '0.8 mm2 at 250 mA'"),
        ("valves: mA", "0.8 kg at 250 mA", "cannot be converted"),
        ("valves: mA", "0.8 mm2", "state at which input"),
        ("valves: mA", "0.8 mm2 at 5 V", "state --valve at such an input"),
        ("valves: mA", "u=0.8 mm2 at 250 mA", "the bench has the valves of u_in, u_out"),
        ("switches: german", "u_in=0.8 mm2", "the bench has one area for both valves, valve.C_A"),
        ("imposed: french", "0.8 mm2 at 250 mA", "no valve whose area a data sheet states"),
    ],
)
def test_a_data_sheet_that_does_not_fit_is_refused(
    tmp_path: Path, name: str, text: str, words: str
) -> None:
    with pytest.raises(InputError, match=re.escape(words)):
        drafted(tmp_path, name, valve=text)
    assert not (tmp_path / "rig").exists()


def test_the_question_about_the_valves_can_be_typed(tmp_path: Path) -> None:
    made = drafted(tmp_path, "valves: mA")
    question = next(line for line in made.to_check if "data sheet" in line)
    for k, text in enumerate(re.findall(r"--valve ('[^']*')", question)):
        answered = drafted(tmp_path / str(k), "valves: mA", valve=shlex.split(text)[0])
        assert not any("data sheet" in line for line in answered.to_check)


def test_stated_measures_take_the_muscle_that_has_them(tmp_path: Path) -> None:
    measures = {"muscle.alpha_0": "25 deg", "muscle.D0": "12 mm", "muscle.L0": "250 mm"}
    made = drafted(tmp_path, "valves: mA", parameters={"load.m": "2 kg", **measures})
    stated = written(made)["parameters"]
    assert {stated[f"muscle.sleeve.{n}"] for n in ("alpha_0", "D0", "L0")} == {*measures.values()}
    assert stated["muscle.sleeve.turns"] == 0 and stated["muscle.mu_d"] == 0
    assert "any-geometry" in (made.folder / "experiment.toml").read_text()
    with pytest.raises(InputError, match="state three"):
        drafted(tmp_path / "one", "valves: mA", parameters={"muscle.alpha_0": "25 deg"})


def test_a_data_sheet_in_volts_says_which_columns_open_the_valves(tmp_path: Path) -> None:
    rows = ["time [s],load_cell [V],u_in [V],u_out [V],p [kPa],x [mm]"]
    p = 200 + 40 * np.sin(0.05 * np.arange(300))
    u = 4 + np.cos(0.05 * np.arange(300))
    rows += [
        f"{0.02 * k:.2f},{u[k]:.2f},{u[k]:.3f},{2 + k % 2},{p[k]:.2f},{0.1 * p[k]:.3f}"
        for k in range(300)
    ]
    file = tmp_path / "run.csv"
    file.write_text("\n".join(rows) + "\n")
    measures = {"muscle.L0": "298 mm", "muscle.D0": "15 mm", "muscle.alpha_0": "25 deg"}
    rig = {"p_supply": "600 kPa", "spring.k": "3.45 N/mm", "spring.F_0": "17 N"}
    made = pam.new(
        tmp_path / "rig", [file], valve="0.86 mm2 at 10 V from 2 V", parameters={**measures, **rig}
    )
    assert {"u_in", "u_out"} <= made.data.runs[0].inputs.keys()
    opened = SLOPE * (made.data.runs[0].inputs["u_in"] - BEGIN)
    wanted = 0.86e-6 * (2 + np.cos(0.05 * np.arange(300))) / 8
    np.testing.assert_allclose(opened, wanted, rtol=2e-3, atol=2e-9)
    assert any("valves and spring" in line for line in made.to_check)
    (load_cell,) = (guess for guess in made.guesses if guess.what == "load_cell")
    assert load_cell.why == "a voltage; a formula can scale it"


def test_the_area_of_a_switched_valve_is_where_a_fit_begins(tmp_path: Path) -> None:
    made = drafted(tmp_path, "switches: german", valve="0.8 mm2")
    limits = written(made)["fit"]["valve.C_A"]
    assert limits == {"min": pytest.approx(0.04), "max": pytest.approx(0.104)}
    assert any("free for the fit" in line and "valve.C_A" in line for line in made.to_check)
