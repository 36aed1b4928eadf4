"""Recordings in which something does not fit, or that can be meant in two ways: what is said of them."""

from __future__ import annotations

import tomllib
from datetime import datetime, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.drafting import NewDataSet
from pam_cosim.errors import InputError
from tests.drafting.labs import LENGTH, force

SET = ("p_set [bar]", "p [bar]", "x [mm]")


def written(made: NewDataSet) -> dict[str, Any]:
    return tomllib.loads((made.folder / "experiment.toml").read_text(encoding="utf-8"))


def said(made: NewDataSet, word: str) -> list[str]:
    return [line for line in made.to_check if word in line]


def write(file: Path, heading: str, rows: list[list[object]], separator: str = ",") -> Path:
    lines = [separator.join(str(cell) for cell in row) for row in rows]
    file.write_text("\n".join([heading, *lines]) + "\n", encoding="utf-8")
    return file


def steps(count: int = 400) -> list[list[object]]:
    """Set point, pressure and contraction of a muscle that is filled after a second, at 100 Hz."""
    p = np.where(np.arange(count) < 100, 0.0, 2.0)
    noise = np.random.default_rng(1).normal(0.0, 1.0, (2, count))
    return [
        [a, f"{a + 0.01 * b:.4f}", f"{10 * a + 0.02 * c:.3f}"]
        for a, b, c in zip(p, *noise, strict=True)
    ]


def test_rows_without_a_time_are_asked_about(tmp_path: Path) -> None:
    rows = [[k, *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", ",".join(["sample", *SET]), rows)
    made = pam.new(tmp_path / "rig", [file])
    assert written(made)["kind"] == "static"
    assert len(said(made, "each row is taken for a point at rest")) == 1
    made = pam.new(tmp_path / "over-time", [file], recording={"interval": "10 ms"})
    assert "kind" not in written(made) and not said(made, "point at rest")


def test_dates_are_the_time_where_no_number_is(tmp_path: Path) -> None:
    begin = datetime(2024, 3, 12, 14, 5)
    dates = [str(begin + timedelta(milliseconds=10 * k + 1)) for k in range(400)]
    rows = [[date, *row] for date, row in zip(dates, steps(), strict=True)]
    file = write(tmp_path / "a.csv", ",".join(["Timestamp", *SET]), rows)
    made = pam.new(tmp_path / "rig", [file])
    assert "kind" not in written(made) and len(made.data.runs) == 1
    np.testing.assert_allclose(made.data.runs[0].time, 0.01 * np.arange(400), atol=1e-9)
    rows = [[date, 10 * k, *row] for k, (date, row) in enumerate(zip(dates, steps(), strict=True))]
    file = write(tmp_path / "b.csv", ",".join(["Timestamp", "Time_ms", *SET]), rows)
    made = pam.new(tmp_path / "both", [file])
    assert written(made)["columns"]["time"]["column"] == "Time_ms"
    assert written(made)["recording"]["ignore"] == ["Timestamp"]
    made = pam.new(tmp_path / "said", [file], recording={"ignore": ["Timestamp"]})
    assert written(made)["recording"]["ignore"] == ["Timestamp"]


def test_times_of_day_make_no_points_at_rest(tmp_path: Path) -> None:
    rows = [[f"14:{k % 60:02d}", *row] for k, row in enumerate(steps(50))]
    file = write(tmp_path / "a.csv", ",".join(["Uhrzeit", *SET]), rows)
    with pytest.raises(InputError, match="'Uhrzeit': .*interval='1 ms'.*'ignore=Uhrzeit'"):
        pam.new(tmp_path / "rig", [file])
    known = {"recording": {"ignore": ["Uhrzeit"]}, "parameters": {"F": "0 N"}}
    made = pam.new(tmp_path / "rig", [file], **known)
    assert written(made)["kind"] == "static"


def lift(folder: Path, name: str, hertz: float, missing: range = range(0)) -> Path:
    """A load that a muscle lifts and lowers, never without pressure; LabVIEW's column of time."""
    t = 0.005 * np.arange(800)
    p = 3e5 + 1e5 * np.sin(2 * np.pi * hertz * t)
    x = 0.02 + 0.005 * np.sin(2 * np.pi * hertz * t)
    pull = 30.0 + 2.0 * np.sin(2 * np.pi * hertz * t) + 0 * np.asarray(force(p, x))
    noise = np.random.default_rng(int(10 * hertz)).normal(0.0, 1.0, (3, 800))
    rows: list[list[object]] = [
        [f"{a:.4f}", "NaN" if i in missing else f"{b / 6894.757:.3f}", f"{c / 6894.757 + 0.05 * k:.3f}",
         f"{1e3 * (LENGTH - d) + 0.05 * m:.3f}", f"{e / 9.81 + 0.01 * n:.4f}"]
        for i, (a, b, c, d, e, k, m, n) in enumerate(zip(t, p, p, x, pull, *noise, strict=True))
    ]  # fmt: skip
    heading = "X_Value\tp_set (psi)\tp (psi)\tLength (mm)\tLoad cell (kg)"
    return write(folder / name, heading, rows, "\t")


def test_a_length_that_follows_the_pressure_is_not_imposed(tmp_path: Path) -> None:
    made = pam.new(tmp_path / "rig", [lift(tmp_path, "a.lvm", 1.0)])
    assert written(made)["columns"]["time"] == {"column": "X_Value", "unit": "s"}
    assert set(made.data.runs[0].measurements) == {"p", "x", "F"}
    assert said(made, "put together from regulator and hanging-load")
    (line,) = said(made, "in no row is the muscle without pressure")
    assert line.startswith("x is counted from the longest length")
    assert not said(made, "left out")


def test_what_is_lost_of_a_recording_is_said(tmp_path: Path) -> None:
    files = [lift(tmp_path, f"{h}.lvm", h, range(300, 340)) for h in (0.5, 1.0)]
    made = pam.new(tmp_path / "rig", files)
    for word in ("left out: 40 of 800 rows", "pauses once"):
        (line,) = said(made, word)
        assert line.startswith("0.5, 1.0: ")


def test_why_the_time_is_the_time_says_nothing_of_lengths(tmp_path: Path) -> None:
    made = pam.new(tmp_path / "rig", [lift(tmp_path, "a.lvm", 1.0)], columns={"time": "X_Value"})
    (guess,) = [one for one in made.guesses if one.what == "X_Value"]
    assert guess.why == "guessed: no unit is written; steps of 0.005 are taken as s"


def test_which_of_three_sines_is_held_out(tmp_path: Path) -> None:
    """By how they are driven, not by where in its period a recording happens to begin."""
    made = pam.new(tmp_path / "rig", [lift(tmp_path, f"{h}.lvm", h) for h in (0.5, 1.0, 1.5)])
    (role,) = [one for one in made.guesses if one.taken_as == "holdout"]
    assert role.what == "1.0.lvm" and "start" not in role.why
    assert not ("lies within" in role.why and "beyond" in role.why)


SLEEVE = {"muscle.sleeve.L0": "200 mm", "muscle.sleeve.alpha_0": "25 deg"}


def test_measures_of_a_sleeve_that_follow_are_zero(tmp_path: Path) -> None:
    rows: list[list[object]] = [[0.01 * k, *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", ",".join(["t [s]", *SET]), rows)
    stated = SLEEVE | {"muscle.sleeve.D0": "14 mm"}
    made = pam.new(tmp_path / "rig", [file], muscle="any-geometry", parameters=stated)
    assert written(made)["parameters"]["muscle.sleeve.turns"] == 0
    with pytest.raises(InputError, match="sleeve.D0=0 or --parameter muscle.sleeve.turns=0"):
        pam.new(tmp_path / "two", [file], muscle="any-geometry", parameters=SLEEVE)
    said_so = SLEEVE | {"muscle.sleeve.turns": "0"}
    made = pam.new(tmp_path / "three", [file], muscle="any-geometry", parameters=said_so)
    assert len(written(made)["parameters"]) == 3


@pytest.mark.parametrize(
    "heading", ["Set pressure (m)", "Solldruck [mm]", "Kraft [bar]", "Kraft [mA]"]
)
def test_a_unit_of_another_quantity_than_the_name_says(tmp_path: Path, heading: str) -> None:
    rows: list[list[object]] = [[0.01 * k, *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", ",".join(["t [s]", heading, "p [bar]", "x [mm]"]), rows)
    with pytest.raises(InputError, match=r"its name means (pressure|force), its unit .* means"):
        pam.new(tmp_path / "rig", [file])
    name = heading.split(" [")[0].split(" (")[0]
    made = pam.new(tmp_path / "rig", [file], recording={"ignore": [name]})
    assert written(made)["recording"]["ignore"] == [name]


def test_a_current_of_a_transmitter_is_no_valve_s_and_wants_a_scale(tmp_path: Path) -> None:
    bar: list[list[object]] = [[0.01 * k, *row] for k, row in enumerate(steps())]
    signal: list[list[object]] = [[t, p_set, 4 + 2 * float(str(p)), x] for t, p_set, p, x in bar]
    heads = "t [s],p_set [bar],Pressure [mA],x [mm]"
    file = write(tmp_path / "a.csv", heads, signal)
    with pytest.raises(InputError, match="its name means pressure, .* scale the signal, as in"):
        pam.new(tmp_path / "rig", [file])
    scaled = pam.new(tmp_path / "rig", [file], columns={"p": '(Pressure - "4 mA") * "0.5 bar/mA"'})
    expected = [1e5 * float(str(p)) for _, _, p, _ in bar]
    np.testing.assert_allclose(scaled.data.runs[0].measurements["p"], expected, atol=1e-3)


@pytest.mark.parametrize(
    ("heading", "taken"),
    [
        ("Compression [mm]", "not read"),
        ("Drucksensor [V]", "not read"),
        ("Kraft [kg]", "F [kg] (measured)"),
        ("Druckventil [mA]", "not read"),
    ],
)
def test_names_that_leave_a_doubt_go_by_their_unit(
    tmp_path: Path, heading: str, taken: str
) -> None:
    """What a pull in kg is in newtons is beyond doubt; nothing else replaces what was recognised."""
    rows: list[list[object]] = [[0.01 * k, *row, row[2]] for k, row in enumerate(steps())]
    heads = ",".join(["t [s]", "p_set [bar]", "p [bar]", "x [mm]", heading])
    made = pam.new(tmp_path / "rig", [write(tmp_path / "a.csv", heads, rows)])
    doubtful = heading.partition(" ")[0]
    assert {g.what: g.taken_as for g in made.guesses}[doubtful] == taken
    read = made.data.runs[0].measurements
    assert {*read} == {"p", "x"} | ({"F"} if taken != "not read" else set())
    if "F" in read:
        np.testing.assert_allclose(read["F"], 9.80665 * np.array([r[-1] for r in rows], float))


@pytest.mark.parametrize("name", ["Pset_psi", "pSet_psi", "Psoll [psi]", "Pref (psi)"])
def test_set_pressures(tmp_path: Path, name: str) -> None:
    rows: list[list[object]] = [[0.01 * k, *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", f"t [s],{name},P_psi,x [mm]", rows)
    made = pam.new(tmp_path / "rig", [file])
    by_name = {one.taken_as.split(" ")[0]: one.what for one in made.guesses}
    assert by_name["p_set"] == name.split(" ")[0] and by_name["p"] == "P_psi"


def test_files_of_two_loggers_are_not_drafted_together(tmp_path: Path) -> None:
    camera = write(tmp_path / "cam.csv", "t_ms,contraction_mm", [[k, k] for k in range(9)])
    card = write(tmp_path / "daq.csv", "Time (s),Pressure (kPa)", [[k, k] for k in range(9)])
    with pytest.raises(InputError, match="no column 't_ms', which is the time in cam.csv") as told:
        pam.new(tmp_path / "rig", [camera, card])
    assert "Time, Pressure" in told.value.message and "data set of their own" in told.value.message


def test_columns_without_a_value(tmp_path: Path) -> None:
    rows: list[list[object]] = [[0.01 * k, a, "NaN", c] for k, (a, _, c) in enumerate(steps(600))]
    file = write(tmp_path / "a.csv", ",".join(["t [s]", *SET]), rows)
    made = pam.new(tmp_path / "rig", [file])
    (guess,) = [one for one in made.guesses if one.what == "p"]
    assert guess.why == "it has no value in any of 600 rows"
    empty = [[row[0], "NaN", "NaN", "NaN"] for row in rows]
    with pytest.raises(InputError, match="it has no value in any of 600 rows"):
        pam.new(tmp_path / "none", [write(tmp_path / "b.csv", ",".join(["t [s]", *SET]), empty)])


def test_two_rows(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", ",".join(["t [s]", *SET]), [[0, 0, 0, 0], [1, 1, 1, 1]])
    made = pam.new(tmp_path / "rig", [file])
    assert said(made, "two rows determine neither noise nor parameters")


def test_what_drives_a_rig_is_asked_and_no_column_suggested_that_is_none(tmp_path: Path) -> None:
    rows: list[list[object]] = [[0.1 * k, 500, k, k + 1] for k in range(50)]
    heads = "t [s],source [kPa],knee_p [kPa],hip_p [kPa]"
    with pytest.raises(
        InputError, match="lacks the inputs u; state what columns are, or the bench"
    ):
        pam.new(tmp_path / "rig", [write(tmp_path / "a.csv", heads, rows)])


@pytest.mark.parametrize(("least", "bench"), [(0.0, "VesselOrifice"), (4.0, "ClosedVessel")])
def test_a_vessel_that_empties_is_not_closed(tmp_path: Path, least: float, bench: str) -> None:
    t = 0.1 * np.arange(300)
    p = 1.01325 + least + (6.7 - least) * np.exp(-t / 3.0)
    rows: list[list[object]] = [[f"{a:.2f}", f"{b:.4f}"] for a, b in zip(t, p, strict=True)]
    file = write(tmp_path / "a.csv", "time_s,pressure_bar_abs", rows)
    assert pam.new(tmp_path / "rig", [file]).model == f"PneumaticMuscle.Benches.{bench}"


def appended(file: Path, heading: str, first: list[str], drift: float, digits: str = "g") -> Path:
    """Three experiments one after another, as a logger appends them: to 100, 200 and 300 kPa.

    Args:
        file: to be written.
        heading: of the table.
        first: what stands in the column beside the time in each experiment.
        drift: of the zeros, from one to the next [kPa]; a quarter of it in millimetres.
        digits: how times are written.
    """
    time = 0.01 * np.arange(300)
    lines = [heading]
    for number, level in enumerate((100.0, 200.0, 300.0)):
        p_set = np.where(time > 1.0, level, 0.0)
        p = level * (1.0 - np.exp(-np.clip(time - 1.0, 0.0, None) / 0.1))
        noise = np.random.default_rng(number).normal(0.0, 0.05, (2, 300))
        read = (p_set, p + drift * number + noise[0], 0.1 * p + drift / 4 * number + noise[1])
        lines += [
            f"{t:{digits}},{first[number]},{','.join(f'{v:.6g}' for v in row)}"
            for t, row in zip(time, zip(*read, strict=True), strict=True)
        ]
    file.write_text("\n".join(lines))
    return file


def test_a_file_in_which_the_time_begins_anew_holds_several_runs(tmp_path: Path) -> None:
    heading = "Time [s],Experiment,p_set [kPa],p [kPa],x [mm]"
    file = appended(tmp_path / "all.csv", heading, ["1", "2", "3"], 0.0)
    made = pam.new(tmp_path / "rig", [file], roles={"all part 3": "fit"})
    assert [len(run.time) for run in made.data.runs] == [300, 300, 300]
    assert [run.inputs["p_set"].max() for run in made.data.runs] == pytest.approx([1e5, 2e5, 3e5])
    assert [run.role for run in made.data.runs] == ["fit", "holdout", "fit"]
    roles = {"all part 2": "holdout", "all part*": "fit"}
    again = pam.new(tmp_path / "again", [file], roles=roles)
    assert [run.role for run in again.data.runs] == ["fit", "holdout", "fit"]
    with pytest.raises(pam.InputError, match=r"there is no recording 'test\*'"):
        pam.new(tmp_path / "none", [file], roles={"test*": "fit"})
    assert "because the time goes back" in (tmp_path / "rig" / "experiment.toml").read_text()


def test_each_experiment_of_a_file_has_a_zero_and_values_of_its_own(tmp_path: Path) -> None:
    heading = "Time [s],Masse [kg],p_set [kPa],p [kPa],x [mm]"
    file = appended(tmp_path / "all.csv", heading, ["1", "2", "3"], 2.0)
    runs = pam.new(tmp_path / "rig", [file]).data.runs
    assert [run.parameters["load.m"] for run in runs] == [1.0, 2.0, 3.0]
    for run in runs:
        rest = run.time < run.time[0] + 0.8
        assert abs(run.measurements["p"][rest].mean()) < 50.0
        assert abs(run.measurements["x"][rest].mean()) < 0.05e-3


def test_rows_of_several_experiments_are_not_taken_to_be_evenly_apart(tmp_path: Path) -> None:
    heading = "Time [s],Experiment,p_set [kPa],p [kPa],x [mm]"
    file = appended(tmp_path / "all.csv", heading, ["1", "2", "3"], 0.0, ".1f")
    with pytest.raises(InputError, match="a third row at 0 s"):
        pam.new(tmp_path / "rig", [file])


def test_a_word_among_numbers_is_asked_about(tmp_path: Path) -> None:
    """It was no number, and nothing said what to do; words that are known need not be stated again."""
    cells = dict.fromkeys(range(300, 310), "OVLD") | {315: "-"}
    rows = [[0.01 * k, a, cells.get(k, b), c] for k, (a, b, c) in enumerate(steps())]
    file = write(tmp_path / "a.csv", ",".join(["time [s]", *SET]), rows)
    with pytest.raises(InputError, match=r"'OVLD' is not a number.*--recording 'missing=OVLD'"):
        pam.new(tmp_path / "rig", [file])
    made = pam.new(tmp_path / "rig", [file], recording={"missing": "OVLD"})
    assert written(made)["recording"]["missing"] == ["OVLD", "-"]
    assert made.data.runs[0].sample_count("p") == len(rows) - 11


def test_lines_that_a_logger_cut_short_are_said(tmp_path: Path) -> None:
    rows = [[0.01 * k, *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", "31,0.1\nReady\n" + ",".join(["time [s]", *SET]), rows)
    file.write_text(file.read_text() + "40")
    made = pam.new(tmp_path / "rig", [file])
    assert len(made.data.runs[0].time) == len(rows)
    assert len(said(made, "left out: the row above the header")) == 1
    assert len(said(made, "left out: the last line, 404, which was cut short")) == 1


@pytest.mark.parametrize("name", ["time_us", "micros"])
def test_a_full_counter_parts_no_recording(tmp_path: Path, name: str) -> None:
    rows = [[(2**32 - 10**6 + 10_000 * k) % 2**32, *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", ",".join([name, *SET]), rows)
    made = pam.new(tmp_path / "rig", [file])
    (run,) = made.data.runs
    np.testing.assert_allclose(np.diff(run.time), 0.01)
    assert len(said(made, "a: a counter was full once")) == 1


@pytest.mark.parametrize("place", [1, 2], ids=["p_set", "p"])
def test_a_number_that_marks_missing_samples_is_named(tmp_path: Path, place: int) -> None:
    """As `compare` names it, with what to say; the noise is not called none."""
    rows = [[0.01 * k, f"{2 * k:.1f}", *row[1:]] for k, row in enumerate(steps())]
    for k in (60, 61, 250):
        rows[k][place] = 9999
    rows[80][3] = "-"
    file = write(tmp_path / "a.csv", ",".join(["time [s]", "p_set [kPa]", *SET[1:]]), rows)
    made = pam.new(tmp_path / "rig", [file])
    (line,) = said(made, "marks a missing sample")
    assert "is 9999 in 3 of 400 samples" in line
    assert line.endswith("add --recording 'missing=-,9999'")
    if place == 2:
        (sigma,) = [one for one in made.guesses if one.what == "sigma of p"]
        assert "no noise" not in sigma.why
    made = pam.new(tmp_path / "known", [file], recording={"missing": "-,9999"})
    assert not said(made, "marks a missing sample")
    assert written(made)["recording"]["missing"] == ["-", "9999"]


@pytest.mark.parametrize("units", [("s", "s"), ("s", "min")], ids=["one unit", "two units"])
def test_times_with_units_make_no_points_at_rest(tmp_path: Path, units: tuple[str, str]) -> None:
    rows = [[f"{0.01 * k:.2f} {units[k // 200]}", *row] for k, row in enumerate(steps())]
    file = write(tmp_path / "a.csv", ",".join(["Time", *SET]), rows)
    if units[0] != units[1]:
        with pytest.raises(InputError, match=r"'Time': this text states when.*'ignore=Time'"):
            pam.new(tmp_path / "rig", [file])
        return
    made = pam.new(tmp_path / "rig", [file])
    np.testing.assert_allclose(made.data.runs[0].time, 0.01 * np.arange(400), atol=1e-9)
