"""What loggers of labs do: words for a valve, set points written on change, clocks that are coarse or two."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from pam_cosim.units import convert
from tests.drafting.headings import read_heading

COUNT = 500
TIME = 0.01 * np.arange(COUNT)
SET_POINT = np.repeat([0.0, 3.0, 5.0, 1.0, 2.0], 100)  # [bar]
IS_FILLED = (TIME >= 1.0) & (TIME < 2.0)
IS_EMPTIED = TIME >= 4.0


def pressure(target: np.ndarray, tau: float = 0.06) -> np.ndarray:
    """Of first order behind a course, with noise [bar]."""
    p = np.zeros(COUNT)
    for k in range(1, COUNT):
        p[k] = p[k - 1] + 0.01 / tau * (target[k - 1] - p[k - 1])
    return p + np.random.default_rng(1).normal(0.0, 0.004, COUNT)


READ = pressure(SET_POINT)
LENGTH = 10.0 * READ + np.random.default_rng(2).normal(0.0, 0.02, COUNT)  # [mm]


def write(file: Path, heading: str, row: Callable[[int], list[object]]) -> Path:
    lines = [",".join(map(str, row(k))) for k in range(COUNT)]
    file.write_text("\n".join([heading, *lines]) + "\n", encoding="utf-8")
    return file


def description(made: pam.drafting.NewDataSet) -> dict[str, Any]:
    return tomllib.loads((made.folder / "experiment.toml").read_text(encoding="utf-8"))


def why(made: pam.drafting.NewDataSet, column: str) -> str:
    (guess,) = [one for one in made.guesses if one.what == column]
    return guess.why


@pytest.mark.parametrize(("on", "off"), [("EIN", "AUS"), ("TRUE", "FALSE"), ("open", "closed")])
def test_valves_in_words(tmp_path: Path, on: str, off: str) -> None:
    def row(k: int) -> list[object]:
        valves = [on if one[k] else off for one in (IS_FILLED, IS_EMPTIED)]
        return [f"{TIME[k]:.2f}", *valves, f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"]

    file = write(tmp_path / "a.csv", "t [s],valve in,valve out,p [bar],x [mm]", row)
    made = pam.new(tmp_path / "rig", [file])
    (run,) = made.data.runs
    np.testing.assert_array_equal(run.inputs["u_in"], IS_FILLED.astype(float))
    np.testing.assert_array_equal(run.inputs["u_out"], IS_EMPTIED.astype(float))
    assert run.interpolation == "previous"


def test_a_word_in_a_column_of_numbers_is_none_of_a_switch(tmp_path: Path) -> None:
    def row(k: int) -> list[object]:
        return [f"{TIME[k]:.2f}", SET_POINT[k], "OFF" if k == 77 else f"{READ[k]:.4f}"]

    file = write(tmp_path / "a.csv", "t [s],p_set [bar],p [bar]", row)
    with pytest.raises(InputError, match=r"a\.csv:79: column 'p': 'OFF' is not a number"):
        pam.new(tmp_path / "rig", [file])


def test_another_word_in_a_column_of_a_switch(tmp_path: Path) -> None:
    def row(k: int) -> list[object]:
        word = "fault" if k == 300 else "on" if IS_FILLED[k] else "off"
        return [f"{TIME[k]:.2f}", word, f"{READ[k]:.4f}"]

    file = write(tmp_path / "a.csv", "time [s],u_in,p [bar]", row)
    text = 'model = "PneumaticMuscle.Benches.SwitchedMuscle"\n[[runs]]\nfile = "a.csv"\n'
    (tmp_path / "experiment.toml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=r"a\.csv:302: column 'u_in': 'fault' is none of .*\bon\b"):
        pam.read(tmp_path)
    assert file.is_file()


def on_change(first: object) -> Callable[[int], list[object]]:
    """Rows of which the set point stands only where it changes."""

    def row(k: int) -> list[object]:
        changes = k and SET_POINT[k] != SET_POINT[k - 1]
        set_point = SET_POINT[k] if changes else first if k == 0 else ""
        return [f"{TIME[k]:.2f}", set_point, f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"]

    return row


def test_a_set_point_that_is_logged_on_change(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "t [s],p_set [bar],p [bar],x [mm]", on_change(0.0))
    made = pam.new(tmp_path / "rig", [file])
    (run,) = made.data.runs
    np.testing.assert_allclose(run.inputs["p_set"], 1e5 * SET_POINT)
    assert run.interpolation == "previous"
    assert "495 of 500 cells are empty" in why(made, "p_set")
    assert any("keeps its value over 495 empty cells of 500" in note for note in run.notes)


def test_a_set_point_that_nothing_is_known_of_at_first(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "t [s],p_set [bar],p [bar],x [mm]", on_change(""))
    with pytest.raises(InputError, match=r"a\.csv:2: column 'p_set': .* no row above has a value"):
        pam.new(tmp_path / "rig", [file])
    assert not (tmp_path / "rig").exists()


def test_an_empty_cell_of_an_input_between_lines_is_a_slip(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "t [s],p_set [bar],p [bar],x [mm]", on_change(0.0))
    made = pam.new(tmp_path / "rig", [file])
    text = (made.folder / "experiment.toml").read_text(encoding="utf-8")
    (made.folder / "experiment.toml").write_text(
        text.replace('interpolation = "previous"', ""), encoding="utf-8"
    )
    with pytest.raises(InputError, match="the cell is empty; only measured outputs may lack"):
        pam.read(made.folder)


def test_an_input_of_a_formula_keeps_its_value(tmp_path: Path) -> None:
    def row(k: int) -> list[object]:
        return [f"{TIME[k]:.2f}", 2.0 * SET_POINT[k], f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"]

    file = write(tmp_path / "a.csv", "t [s],u [V],p [bar],x [mm]", row)
    made = pam.new(tmp_path / "rig", [file], columns={"p_set": 'u * "0.5 bar/V"'})
    assert made.data.runs[0].interpolation == "previous"


@pytest.mark.parametrize("digits", [1, 2])
def test_a_clock_too_coarse_for_its_rows(tmp_path: Path, digits: int) -> None:
    def row(k: int) -> list[object]:
        time = f"{0.4 * TIME[k]:.{digits}f}"
        return [time, SET_POINT[k], f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"]

    file = write(tmp_path / "a.csv", "t [s],p_set [bar],p [bar],x [mm]", row)
    made = pam.new(tmp_path / "rig", [file])
    assert description(made)["recording"] == {"interval": "4 ms", "ignore": ["t"]}
    np.testing.assert_allclose(made.data.runs[0].time, 0.4 * TIME)
    assert "the rows are taken to be 4 ms apart" in why(made, "t")


def test_rows_that_are_not_evenly_apart_get_no_interval(tmp_path: Path) -> None:
    def row(k: int) -> list[object]:
        time = TIME[k] + (3.0 if k > 250 else 0.0)
        return [f"{time:.1f}", SET_POINT[k], f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"]

    file = write(tmp_path / "a.csv", "t [s],p_set [bar],p [bar],x [mm]", row)
    with pytest.raises(InputError, match=r"a third row at 0 s"):
        pam.new(tmp_path / "rig", [file])


def clocks(second: Callable[[int], str]) -> Callable[[int], list[object]]:
    return lambda k: [
        f"{TIME[k]:.3f}", SET_POINT[k], f"{READ[k]:.4f}", second(k), f"{LENGTH[k]:.3f}",
    ]  # fmt: skip


def test_a_second_clock_that_runs_with_the_first(tmp_path: Path) -> None:
    file = write(
        tmp_path / "a.csv",
        "Time 1 [s],p_set [bar],p [bar],Time 2 [ms],x [mm]",
        clocks(lambda k: f"{1e3 * TIME[k] + 4.0:.1f}"),
    )
    made = pam.new(tmp_path / "rig", [file])
    assert why(made, "Time 2") == "it runs with 'Time 1', the time, 0.004 s later"
    assert set(made.data.runs[0].measurements) == {"p", "x"}


@pytest.mark.parametrize("names", [("Time 1 [s]", "Time 2 [s]"), ("X_Value", "X_Value.1")])
def test_two_clocks_in_one_file(tmp_path: Path, names: tuple[str, str]) -> None:
    heading = f"{names[0]},p_set [bar],p [bar],{names[1]},x [mm]"
    file = write(tmp_path / "a.csv", heading, clocks(lambda k: f"{2.0 * TIME[k]:.3f}"))
    second = names[1].split(" [")[0]
    made = pam.new(tmp_path / "both", [file])
    (run,) = made.data.runs
    read = np.isfinite(run.measurements["x"])
    within = TIME[-1] >= 2.0 * TIME
    np.testing.assert_allclose(run.time[read], 2.0 * TIME[within])
    np.testing.assert_allclose(1e3 * run.measurements["x"][read], LENGTH[within], atol=1e-3)
    assert np.isfinite(run.measurements["p"]).sum() == COUNT
    assert any("a.csv: several clocks" in line for line in made.to_check)
    scaled = pam.new(tmp_path / "rig2", [file], columns={"p": "p * 2"})
    read = np.isfinite(scaled.data.runs[0].measurements["p"])
    assert read.sum() == COUNT
    made = pam.new(tmp_path / "rig", [file], recording={"ignore": [second]})
    np.testing.assert_allclose(made.data.runs[0].time, TIME)


@pytest.mark.parametrize(("full", "guessed"), [(0.35, True), (1.0, False)])
def test_a_command_without_a_unit_is_a_guess_where_it_is_no_switch(
    tmp_path: Path, full: float, guessed: bool
) -> None:
    def row(k: int) -> list[object]:
        valves = [full * one[k] for one in (IS_FILLED, IS_EMPTIED)]
        return [f"{TIME[k]:.2f}", *valves, f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"]

    file = write(tmp_path / "a.csv", "t [s],valve_in,valve_out,p [bar],x [mm]", row)
    made = pam.new(tmp_path / "rig", [file])
    assert ("numbers up to 0.35 are taken as shares of one" in why(made, "valve_in")) == guessed


def test_labview_heads_the_times_of_every_channel_alike(tmp_path: Path) -> None:
    def row(k: int) -> list[object]:
        time = f"{TIME[k]:.6f}"
        return [time, SET_POINT[k], time, f"{READ[k]:.4f}", time, f"{LENGTH[k]:.3f}", ""]

    file = write(tmp_path / "a.csv", "X_Value,p_set,X_Value,p,X_Value,x,Comment", row)
    made = pam.new(tmp_path / "rig", [file])
    assert description(made)["recording"]["ignore"] == ["X_Value 2", "X_Value 3", "Comment"]
    np.testing.assert_allclose(made.data.runs[0].time, TIME)
    np.testing.assert_allclose(made.data.runs[0].inputs["p_set"], 1e5 * SET_POINT)


LABVIEW = """LabVIEW Measurement
Writer_Version\t2
Separator\tTab
X_Columns\t{mode}
Date\t2026/03/04
***End_of_Header***

Channels\t3
Samples\t500\t500\t500
Date\t2026/03/04\t2026/03/04\t2026/03/04
Y_Unit_Label\tbar\tkPa\t{unit}
X_Dimension\tTime\tTime\tTime
X0\t0.0E+0\t0.0E+0\t0.0E+0
Delta_X\t0.010000\t0.010000\t0.010000
***End_of_Header***
X_Value\tp_set\tp\tx\tComment
"""


def labview(file: Path, times: bool, unit: str) -> Path:
    """As LabVIEW writes it: units of the channels stand in a block of its own words above the names."""
    rows = "".join(
        f"{f'{TIME[k]:.6f}' if times else ''}\t{SET_POINT[k]:.6f}\t{100 * READ[k]:.6f}\t{LENGTH[k]:.6f}\t\n"
        for k in range(COUNT)
    )
    file.write_text(LABVIEW.format(mode="One" if times else "No", unit=unit) + rows)
    return file


@pytest.mark.parametrize("times", [True, False])
def test_units_of_labview_stand_above_the_names(tmp_path: Path, times: bool) -> None:
    file = labview(tmp_path / "a.lvm", times, "mm")
    made = pam.new(tmp_path / "rig", [file], recording={} if times else {"interval": "10 ms"})
    (run,) = made.data.runs
    np.testing.assert_allclose(run.time, TIME, atol=1e-9)
    np.testing.assert_allclose(run.measurements["p"], 1e5 * READ, rtol=1e-3, atol=1e3)
    assert not [one for one in made.guesses if "no unit is written" in one.why]


def test_a_label_of_labview_that_is_no_unit_is_passed_over(tmp_path: Path) -> None:
    made = pam.new(tmp_path / "rig", [labview(tmp_path / "a.lvm", True, "Ruler No. 3")])
    assert "no unit is written" in why(made, "x")
    np.testing.assert_allclose(made.data.runs[0].measurements["x"], 1e-3 * LENGTH, atol=1e-6)


@pytest.mark.parametrize("name", ["X_Value", "Time"])
def test_an_empty_column_of_times_makes_no_points_at_rest(tmp_path: Path, name: str) -> None:
    file = write(tmp_path / "a.csv", f"{name},p [bar],x [mm]", lambda k: ["", READ[k], LENGTH[k]])
    with pytest.raises(InputError, match="has no value in any row; state --recording interval="):
        pam.new(tmp_path / "rig", [file])
    made = pam.new(tmp_path / "rig", [file], recording={"ignore": [name]}, parameters={"F": "0 N"})
    assert made.data.is_static


def test_other_headings_may_not_stand_twice(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "t [s],p,p", lambda k: [TIME[k], READ[k], READ[k]])
    with pytest.raises(InputError, match="column 'p': this column occurs twice in the header"):
        pam.new(tmp_path / "rig", [file])
    file.write_text("X,CH1,CH2,\n" + file.read_text().replace("t [s],p,p", "t [s],p,p,"))
    with pytest.raises(InputError, match=r"rename one; .*--recording 'header_line=1'"):
        pam.new(tmp_path / "rig", [file])


@pytest.mark.parametrize(
    ("name", "unit", "meaning"),
    [
        ("Pist", "", "pressure"),
        ("Pmus", "kPa", "pressure"),
        ("pdes", "", "set pressure"),
        ("Sollwert", "bar", "set pressure"),
        ("Istwert", "bar", "pressure"),
        ("pression des muscles", "bar", "pressure"),
        ("F", "KN", "force"),
    ],
)
def test_words(name: str, unit: str, meaning: str) -> None:
    assert str(read_heading(name, unit).meaning) == meaning


@pytest.mark.parametrize(
    ("unit", "pascals"),
    [("barü", 1e5), ("bar ü", 1e5), ("atü", 98066.5), ("mWS", 9806.65), ("Torr", 133.32236842)],
)
def test_units_of_old_gauges(unit: str, pascals: float) -> None:
    assert convert(1.0, unit, "Pa") == pytest.approx(pascals)
    heading = read_heading("p", unit)
    assert convert(1.0, heading.unit, "Pa") == pytest.approx(pascals) and not heading.absolute


def test_a_length_asks_for_no_other_bench_than_a_contraction(tmp_path: Path) -> None:
    """In the middle of motion, with names that no bench has."""
    course = 3.0 + np.sin(2.0 * np.pi * 0.5 * TIME + 1.0)
    p = pressure(course)
    rows = [
        f"{TIME[k]:.2f},{course[k]:.4f},{p[k]:.4f},{200.0 - 10.0 * p[k]:.3f}"
        for k in range(100, COUNT)
    ]
    file = tmp_path / "a.csv"
    file.write_text("\n".join(["t [s],p_ref [bar],p_bar,L_mm", *rows]) + "\n", encoding="utf-8")
    made = pam.new(tmp_path / "rig", [file])
    assert set(made.data.runs[0].measurements) == {"p", "x"}
    assert any("regulator and hanging-load" in line for line in made.to_check)


def test_a_contraction_below_zero_is_asked_about(tmp_path: Path) -> None:
    course = 3.0 + np.sin(2.0 * np.pi * 0.5 * TIME + 1.0)
    p = pressure(course)
    for name, zero in (("far", 30.0), ("right", 0.0)):
        rows = [
            f"{TIME[k]:.2f},{course[k]:.4f},{p[k]:.4f},{10.0 * p[k] - zero:.3f}"
            for k in range(100, COUNT)
        ]
        file = tmp_path / f"{name}.csv"
        file.write_text(
            "\n".join(["t [s],p_set [bar],p [bar],x [mm]", *rows]) + "\n", encoding="utf-8"
        )
        made = pam.new(tmp_path / f"rig-{name}", [file])
        told = [line for line in made.to_check if line.startswith("x goes down to -")]
        assert len(told) == (zero > 0.0)


@pytest.mark.parametrize("order", [(0, 1, 2, 3), (0, 2, 1, 3)], ids=["pairs", "times first"])
def test_a_set_point_with_times_of_its_own_stands_at_them(
    tmp_path: Path, order: tuple[int, ...]
) -> None:
    """The times of a set point are no set point: they are compared with the others as any clock."""
    names = ("p_set.Time", "p_set.Data [bar]", "p.Time", "p.Data [bar]")

    def row(k: int) -> list[object]:
        cells = [f"{2.0 * TIME[k]:.2f}", SET_POINT[k], f"{TIME[k]:.2f}", READ[k]]
        return [cells[i] for i in order]

    heading = ",".join(names[i] for i in order)
    (run,) = pam.new(tmp_path / "rig", [write(tmp_path / "a.csv", heading, row)]).data.runs
    assert run.inputs["p_set"].max() == 5e5 and run.time[-1] == pytest.approx(2.0 * TIME[-1])
    assert run.time[np.argmax(run.inputs["p_set"])] == pytest.approx(4.0)


def test_one_command_for_two_valves_is_asked_about(tmp_path: Path) -> None:
    """A spool that fills above zero and vents below: its halves open the valves, and the pressure is read."""
    spool = np.where(IS_FILLED, 0.6, 0.0) - np.where(IS_EMPTIED, 0.5, 0.0)
    p = pressure(np.where(TIME < 1.0, 0.0, np.where(IS_EMPTIED, 0.0, 3.0)), 0.3)

    def row(k: int) -> list[object]:
        return [f"{TIME[k]:.2f}", spool[k], f"{p[k]:.4f}", f"{10.0 * p[k]:.3f}"]

    made = pam.new(tmp_path / "rig", [write(tmp_path / "a.csv", "t [s],spool,p [bar],x [mm]", row)])
    (run,) = made.data.runs
    np.testing.assert_allclose(run.inputs["u_in"], np.clip(spool, 0.0, None))
    np.testing.assert_allclose(run.inputs["u_out"], np.clip(-spool, 0.0, None))
    assert "p" in run.measurements
    assert any(line.startswith("does one command, spool, drive both") for line in made.to_check)


def test_a_unit_that_is_no_time_makes_no_clock(tmp_path: Path) -> None:
    """Rows that are counted in hertz: the file has no time, and the message says what to state."""
    heading = "sweep [Hz],u_in [A],p [bar],x [mm]"
    file = write(tmp_path / "a.csv", heading, lambda k: [k, 0.1, READ[k], LENGTH[k]])
    with pytest.raises(InputError, match="no column of time among sweep"):
        pam.new(tmp_path / "rig", [file])


def test_files_of_two_loggers_are_one_recording_each(tmp_path: Path) -> None:
    files = []
    for run in ("01", "02"):
        files.append(
            write(
                tmp_path / f"daq-{run}.csv",
                "t [s],p_set [bar],p [bar]",
                lambda k: [f"{TIME[k]:.2f}", SET_POINT[k], f"{READ[k]:.4f}"],
            )
        )
    for run in ("01", "02"):
        file = tmp_path / f"camera-{run}.csv"
        rows = [f"{0.033 * k:.3f},{np.interp(0.033 * k, TIME, LENGTH):.3f}" for k in range(151)]
        file.write_text("\n".join(["t [s],marker x [mm]", *rows]) + "\n")
        files.append(file)
    made = pam.new(tmp_path / "rig", files)
    assert [run.name for run in made.data.runs] == ["daq-01", "daq-02"]
    assert {file.name for file in made.folder.glob("*.csv")} == {"daq-01.csv", "daq-02.csv"}
    assert any("daq-01.csv with camera-01.csv" in line for line in made.to_check)
    run = made.data.runs[0]
    read = np.isfinite(run.measurements["x"])
    assert read.sum() == 151
    np.testing.assert_allclose(
        1e3 * run.measurements["x"][read], np.interp(run.time[read], TIME, LENGTH), atol=1e-3
    )
    assert np.isfinite(run.measurements["p"]).sum() >= COUNT - 1


def test_files_with_the_same_quantities_stay_recordings_of_their_own(tmp_path: Path) -> None:
    files = [
        write(
            tmp_path / f"{name}-1.csv",
            "t [s],p_set [bar],p [bar],x [mm]",
            lambda k: [f"{TIME[k]:.2f}", SET_POINT[k], f"{READ[k]:.4f}", f"{LENGTH[k]:.3f}"],
        )
        for name in ("slow", "quick")
    ]
    assert len(pam.new(tmp_path / "rig", files).data.runs) == 2
