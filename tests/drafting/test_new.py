"""Data sets drafted from the files of invented labs: what they are taken for, and that they are as good as by hand."""

from __future__ import annotations

import pickle
import tomllib
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.drafting import NewDataSet, UnsimulatedDraft
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from tests.drafting.labs import french, german, matlab, several, valves


def written(made: NewDataSet) -> dict[str, Any]:
    return tomllib.loads((made.folder / "experiment.toml").read_text(encoding="utf-8"))


def test_german_regulator(tmp_path: Path) -> None:
    """Semicolons, decimal commas, Latin-1, a remark, and a potentiometer that counts down from 212.5 mm."""
    files = several(
        german,
        tmp_path / "lab",
        ([2e5, 3e5, 1e5], 1),
        ([3e5, 4e5, 2e5], 3),
        ([2.5e5, 3.5e5, 1.5e5], 5),
    )
    made = pam.new(tmp_path / "my-rig", files, parameters={"load.m": "2.27 kg"}, title='a "rig"')
    content = written(made)
    assert content["title"] == 'a "rig"' and content["model"] == "MyRig.mo"
    assert content["recording"] == {"ignore": ["Bemerkung"]}
    columns = content["columns"]
    assert {name: columns[name]["column"] for name in ("time", "p_set", "p")} == {
        "time": "Zeit", "p_set": "Solldruck", "p": "Druck"
    }  # fmt: skip
    assert columns["x"]["formula"] == "-'Weg'" and columns["x"]["zero"]["from"] == "0 s"
    assert [run["role"] for run in content["runs"]] == ["fit", "fit", "holdout"]  # the middle one
    assert all(run["interpolation"] == "previous" for run in content["runs"])
    assert content["parameters"]["load.m"] == "2.27 kg" and "regulator.tau" in content["fit"]
    signals = made.data.signals
    assert signals["p"].sigma == pytest.approx(400.0, rel=0.2) and signals[
        "x"
    ].sigma == pytest.approx(5e-5, rel=0.2)
    for run in made.data.runs:
        assert abs(float(np.mean(run.measurements["x"][:100]))) < 2e-5  # its zero
        assert 0.02 < float(np.max(run.measurements["x"])) < 0.12
    text = (made.folder / "experiment.toml").read_text(encoding="utf-8")
    assert '# "muscle.L0" = "240 mm"' in text and "# guessed: held out" in text
    assert "PneumaticMuscle.Mechanics.HangingLoad" in (made.folder / "MyRig.mo").read_text()


def test_matlab_isometric(tmp_path: Path) -> None:
    """No units: the length is held in each run, so it is imposed, and the force is read."""
    files = several(matlab, tmp_path / "lab", (0.24, 1), (0.23, 2), (0.22, 3), (0.21, 4))
    made = pam.new(tmp_path / "isometric", files)
    content = written(made)
    assert content["columns"]["p"] == {"column": "Druck", "unit": "kPa"}
    assert content["columns"]["F"] == {"column": "Kraft", "unit": "N"}
    assert "'Laenge'" in content["columns"]["s"]["formula"]
    assert list(content["signals"]) == ["F"]
    lengths = [float(np.mean(run.inputs["s"])) for run in made.data.runs]
    np.testing.assert_allclose(lengths, [0.0, 0.01, 0.02, 0.03], atol=1e-4)
    starts = [run.get("parameters", {}).get("drive.s_start", "0 mm") for run in content["runs"]]
    np.testing.assert_allclose(
        [float(one.split()[0]) for one in starts], [0.0, 10.0, 20.0, 30.0], atol=0.1
    )
    assert content["runs"][0]["role"] == content["runs"][3]["role"] == "fit"
    assert made.data.signals["F"].sigma == pytest.approx(0.3, rel=0.2)


def test_two_runs_of_valves(tmp_path: Path) -> None:
    """Units in their own row; a ready bench fits, and two runs are both fitted."""
    files = several(valves, tmp_path / "lab", (0.35, 1), (0.32, 4))
    made = pam.new(tmp_path / "rig", files)
    content = written(made)
    assert content["model"].endswith("Isotonic") and not list(made.folder.glob("*.mo"))
    named = {one["column"] for one in content["columns"].values()}
    assert named == {"t", "I_in", "I_out", "Vordruck", "pm", "Kontraktion"}
    assert [run["role"] for run in content["runs"]] == ["fit", "fit"]
    assert any("held out" in line for line in made.to_check)
    assert made.data.runs[0].inputs["u_in"].max() == pytest.approx(0.35)
    assert made.data.runs[0].time[-1] == pytest.approx(4.99)


@pytest.mark.full
def test_twenty_runs_with_loads_in_their_names(tmp_path: Path) -> None:
    masses = [2.5, 5.0, 7.5, 10.0]
    courses = [
        ([1e5 + 2e4 * (i % 7), 2e5 + 3e4 * (i % 5), 1e5 * (i % 3)], i, masses[i % 4])
        for i in range(20)
    ]
    made = pam.new(tmp_path / "rig", several(french, tmp_path / "lab", *courses))
    content = written(made)
    assert [run["parameters"]["load.m"] for run in content["runs"]] == [
        f"{masses[i % 4]:g} kg" for i in range(20)
    ]
    assert sum(run["role"] == "holdout" for run in content["runs"]) == 5
    assert content["columns"]["p"] == {"column": "pression"} and list(content["signals"]) == ["x"]
    fitted = [run.parameters["load.m"] for run in made.data.fit_runs]
    assert {min(fitted), max(fitted)} == {2.5, 10.0}


def test_what_the_user_says_counts(tmp_path: Path) -> None:
    text = "time [s],Druck 1 [bar],Druck 2 [bar],Weg [mm]\n"
    text += "".join(
        f"{0.01 * i},{min(i / 50, 3):.3f},{min(i / 40, 3):.3f},{min(i / 20, 20):.3f}\n"
        for i in range(300)
    )
    (tmp_path / "a.csv").write_text(text)
    guessed = pam.new(tmp_path / "one", [tmp_path / "a.csv"])
    assert any("may be meant instead" in guess.why for guess in guessed.guesses)
    other = next(
        n for n in ("Druck 1", "Druck 2") if written(guessed)["columns"]["p"]["column"] != n
    )
    said = pam.new(
        tmp_path / "two", [tmp_path / "a.csv"], columns={"p": other, "x": "2 * Weg"}, model="VerticalLoad",
        recording={"decimal": "."},
    )  # fmt: skip
    assert written(said)["columns"]["p"]["column"] == other
    assert written(said)["columns"]["x"]["formula"] == "2 * Weg"
    assert written(said)["model"] == "PneumaticMuscle.Benches.VerticalLoad"
    assert said.data.runs[0].measurements["x"].max() == pytest.approx(0.03, rel=0.01)


def test_supply_absolute_pressure_and_a_single_switch(tmp_path: Path) -> None:
    """The supply is the pressure that stays above; an absolute gauge reads the ambient at rest."""
    time = 0.002 * np.arange(1500)
    p = 1.013 + 3.0 * (1.0 - np.exp(-np.clip(time - 1.0, 0.0, None) / 0.2))
    rng = np.random.default_rng(1)
    rows = np.column_stack(
        [time, time > 1.0, 6.0 + rng.normal(0, 0.01, 1500), p + rng.normal(0, 0.003, 1500)]
    )
    x = 40.0 * (p - 1.013) / 3.0 + rng.normal(0, 0.02, 1500)
    text = "t [s];Ventil;P1 [bar];P2 [bar];Weg [mm]\n"
    text += "".join(
        f"{a:.3f};{b:.0f};{c:.4f};{d:.4f};{e:.3f}\n"
        for (a, b, c, d), e in zip(rows, x, strict=True)
    )
    (tmp_path / "a.csv").write_text(text)
    made = pam.new(tmp_path / "rig", [tmp_path / "a.csv"])
    content = written(made)
    assert (
        content["columns"]["p_supply"]["column"] == "P1"
        and content["columns"]["u_in"]["column"] == "Ventil"
    )
    assert "zero" in content["columns"]["p"]
    assert float(np.mean(made.data.runs[0].measurements["p"][:300])) == pytest.approx(0.0, abs=50.0)
    assert any("u_out" in line for line in made.to_check)
    assert any("if p_supply is too, take the ambient" in line for line in made.to_check)


def test_runs_that_differ(tmp_path: Path) -> None:
    """A clock that runs on from file to file, a signal that one file lacks; parts that the user names."""
    files = []
    for number in range(3):
        time = 100.0 * number + 0.01 * np.arange(400)
        p = 100.0 * (number + 1) * np.clip(0.01 * np.arange(400) - 1.0, 0.0, 1.0)
        x = 7.0 + p / 10 + np.random.default_rng(number).normal(0.0, 0.02, 400)
        columns = {"t [s]": time, "p_set [kPa]": p, "x [mm]": x} | (
            {"F [N]": x + p} if number < 2 else {}
        )
        rows = "".join(
            ",".join(f"{v:.4f}" for v in row) + "\n" for row in zip(*columns.values(), strict=True)
        )
        files.append(tmp_path / f"run{number}.csv")
        files[-1].write_text(",".join(columns) + "\n" + rows)
    made = pam.new(tmp_path / "rig", files, model="regulator and spring")
    content = written(made)
    assert "Mechanics.Spring" in next(made.folder.glob("*.mo")).read_text()
    assert [run["columns"]["x"]["zero"]["from"] for run in content["runs"]] == [
        "0 s",
        "100 s",
        "200 s",
    ]
    for run in made.data.runs:
        assert abs(float(np.mean(run.measurements["x"][:90]))) < 1e-5
    assert ["F" in run.measurements for run in made.data.runs] == [True, True, False]


def test_a_fixed_length_that_nobody_recorded(tmp_path: Path) -> None:
    time = 0.01 * np.arange(600)
    p = np.clip(time - 1.0, 0.0, 3.0)
    rows = "".join(f"{t:.2f},{w:.3f},{w:.3f},{80 * w:.2f}\n" for t, w in zip(time, p, strict=True))
    (tmp_path / "a.csv").write_text("t [s],setpoint [bar],pressure [bar],force [N]\n" + rows)
    made = pam.new(tmp_path / "rig", [tmp_path / "a.csv"])
    assert "Mechanics.ImposedLength" in next(made.folder.glob("*.mo")).read_text()
    assert any("input s" in line for line in made.to_check)


def test_columns_that_are_parameters(tmp_path: Path) -> None:
    """A mass and a room's temperature that loggers repeat in every row; a column that is called like a unit."""
    rows = "".join(
        f"{0.1 * i:.1f};{min(i, 99)};{min(i, 99) / 3:.2f};5;{22 + 0.01 * (i % 2)};1\n"
        for i in range(120)
    )
    (tmp_path / "a.csv").write_text(
        "t [s];p [kPa];x [mm];Masse [kg];Raumtemperatur [degC];mm\n" + rows
    )
    made = pam.new(tmp_path / "rig", [tmp_path / "a.csv"])
    own = written(made)["runs"][0]["parameters"]
    assert own["load.m"] == "5 kg" and own["ambient.T"].startswith("295.15")
    assert sorted(written(made)["recording"]["ignore"]) == ["Masse", "Raumtemperatur", "mm"]


def logged(file: Path, heads: str, further: str) -> Path:
    """A muscle that is filled by 100 kPa while further columns stay as they are."""
    rows = (f"{0.1 * i:.1f};{min(i, 99)};{min(i, 99) / 3:.2f};{further}\n" for i in range(120))
    file.write_text(f"t [s];p [kPa];x [mm];{heads}\n" + "".join(rows))
    return file


@pytest.mark.parametrize(
    ("heads", "rows"),
    [("T_amb [degC];p_amb [kPa]", "22;98.5"), ("Tamb [K];P_atm [bar]", "295.15;0.985"),
     ("T_amb;P_atm", "22;985"), ("T_amb_C;patm_kPa", "22;98.5"), ("T_Umg [degC];baro [hPa]", "22;985")],
)  # fmt: skip
def test_what_is_around_the_rig_is_no_signal(tmp_path: Path, heads: str, rows: str) -> None:
    made = pam.new(tmp_path / "rig", [logged(tmp_path / "a.csv", heads, rows)])
    (run,) = made.data.runs
    assert run.parameters["ambient.T"] == pytest.approx(295.15)
    assert run.parameters["ambient.p"] == pytest.approx(98_500.0)
    assert {*run.inputs, *run.measurements} == {"p", "x"}


def test_a_gauge_pressure_around_the_rig_is_none_of_the_atmosphere(tmp_path: Path) -> None:
    made = pam.new(tmp_path / "rig", [logged(tmp_path / "a.csv", "p_amb [kPa]", "0")])
    assert "ambient.p" not in made.data.runs[0].parameters


def test_texts_that_look_like_numbers_are_read_back(tmp_path: Path) -> None:
    """A column and a group of a file that are called by numbers, and a number for missing samples."""
    with h5py.File(tmp_path / "a.h5", "w") as file:
        for name, scale in (("t [s]", 0.1), ("p [kPa]", 1.0), ("x [mm]", 0.3), ("101", 0.0)):
            file[f"1/{name}"] = scale * np.arange(99)
        file["2/t [s]"] = np.arange(3.0)
    stated = {"table": "1", "missing": "-999"}
    made = pam.new(tmp_path / "rig", [tmp_path / "a.h5"], recording=stated)
    assert written(made)["recording"] == {"table": "1", "missing": ["-999"], "ignore": ["101"]}


@pytest.mark.parametrize(
    ("example", "bench", "others"),
    [pytest.param("jumping-robot", "SwitchedMuscle", "", marks=pytest.mark.full),
     ("tank-discharge", "VesselOrifice", ""),
     ("chamber-leak/chambers/Prusa", "ClosedVessel", "VesselOrifice")],
)  # fmt: skip
def test_recordings_of_others(tmp_path: Path, example: str, bench: str, others: str) -> None:
    """Measurements of the examples find their benches; a vessel that empties is none that is shut."""
    folder = Path(__file__).parents[2] / "examples" / example
    runs = tomllib.loads((folder / "experiment.toml").read_text())["runs"]
    made = pam.new(tmp_path / "rig", [folder / run["file"] for run in runs])
    assert made.model == f"PneumaticMuscle.Benches.{bench}"
    assert any(others in line for line in made.to_check)


def test_one_quantity_by_two_names(tmp_path: Path) -> None:
    rows = "0,1,2\n1,3,4\n2,5,5\n"
    (tmp_path / "a.csv").write_text("t [s],p [kPa],x [mm]\n" + rows)
    (tmp_path / "b.csv").write_text("t [s],Druck [kPa],x [mm]\n" + rows)
    with pytest.raises(pam.InputError, match="a.csv calls the pressure 'p'"):
        pam.new(tmp_path / "rig", [tmp_path / "a.csv", tmp_path / "b.csv"])
    assert not (tmp_path / "rig").exists()


def test_texts_of_files_are_data(tmp_path: Path) -> None:
    """Names that would end a string, a comment or a pattern."""
    heading = 'time [s],p [kPa],x [mm],"note ""a"" * = [x]\' #"\n'
    rows = "".join(f"{i},{2 * i},{0.1 * i},{i % 7}\n" for i in range(100))
    file = tmp_path / 'a "b" #.csv'
    file.write_text(heading.replace("[x]", "x") + rows)
    made = pam.new(tmp_path / "new\x1b[31m rig'", [file], title='"]\n[evil]\nx = 1')
    content = written(made)
    assert "evil" not in content and content["title"] == '"]\n[evil]\nx = 1'
    assert len(content["recording"]["ignore"]) == 1
    assert made.data.runs[0].measurements["x"].max() > 0


def test_a_draft_that_cannot_be_simulated_survives_pickling() -> None:
    """A process that drafts for another one sends the draft with the error."""
    interface = Interface("Bench")
    made = NewDataSet(Path("rig"), None, "Bench", (), ("which load?",), ())  # type: ignore[arg-type]
    error = UnsimulatedDraft(InputError("fails", "a.csv", 3, "p"), made, "title", interface)
    copy = pickle.loads(pickle.dumps(error))
    assert str(copy) == str(error) == "a.csv:3: column 'p': fails"
    assert (copy.new_data_set, copy.text, copy.interface) == (made, "title", interface)
