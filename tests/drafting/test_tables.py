"""Tables without time: points at rest, as files of invented labs, become data sets with no line by hand."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.drafting import NewDataSet
from pam_cosim.drafting.texts import said_in
from pam_cosim.errors import InputError
from tests.drafting.headings import HEADINGS
from tests.drafting.labs import LENGTH
from tests.drafting.tables import grid, loop, no_load, noise, write

PRESSURES = 1e5 * np.arange(0.0, 6.0)


def written(made: NewDataSet) -> dict[str, Any]:
    return tomllib.loads((made.folder / "experiment.toml").read_text(encoding="utf-8"))


def test_a_map_of_force_with_gaps_and_commas_at_the_ends(tmp_path: Path) -> None:
    """Zero force at zero pressure, ``nan``, separators at the ends of the lines, a count of rows, no units."""
    p, x, pull = grid(PRESSURES, [0.0, 0.01, 0.02, 0.03, 0.04])
    pull = pull + noise(len(p), 0.5, 1) * (p > 0)
    rows: list[list[object]] = [
        [i + 1, a / 1e3, 1e3 * b, c] for i, (a, b, c) in enumerate(zip(p, x, pull, strict=True))
    ]
    rows[7][3] = "nan"
    rows[9][1] = "nan"
    made = pam.new(
        tmp_path / "rig", [write(tmp_path / "map.csv", "Nr,pressure,contraction,force", rows, ",,")]
    )
    content = written(made)
    assert content["kind"] == "static" and content["model"].endswith("QuasiStaticIsometric")
    assert content["recording"] == {"ignore": ["Nr"], "missing": ["nan"]}
    assert content["columns"]["F"] == {"column": "force", "unit": "N"}
    assert content["runs"][0]["hold_out"] == {"p": ["200 kPa", "300 kPa"]}
    assert sum(run.sample_count("F") for run in made.data.fit_runs) == 18
    assert sum(run.sample_count("F") for run in made.data.holdout_runs) == 10
    text = str(pam.compare(made.data))
    assert "still changes" not in text and "divided by" not in text


def test_files_of_one_contraction_each_whose_names_tell_it_and_the_muscle(tmp_path: Path) -> None:
    files = []
    for percent in (0, 5, 10, 15):
        p, _, pull = grid(PRESSURES, [LENGTH * percent / 100])
        rows = list(zip(p / 1e5, pull + noise(len(p), 0.5, percent), strict=True))
        files.append(write(tmp_path / f"DMSP-20-300_eps{percent}%.csv", "p [bar],F [N]", rows))
    made = pam.new(tmp_path / "rig", files)
    content = written(made)
    assert content["parameters"] == {"muscle.sleeve.L0": "300 mm"}
    assert "Muscles.DMSP20" in (tmp_path / "rig" / "Rig.mo").read_text()
    held = [run["parameters"]["s"] for run in content["runs"]]
    assert held == ["0 mm", "15 mm", "30 mm", "45 mm"]
    assert sorted(run["role"] for run in content["runs"]) == ["fit", "fit", "fit", "holdout"]
    assert content["runs"][0]["role"] == content["runs"][3]["role"] == "fit"


@pytest.mark.parametrize(
    ("stem", "value", "unit"),
    [("map_eps=-5%", -5.0, "%"), ("map_eps=5%", 5.0, "%"), ("eps-5%", 5.0, "%"), ("eps_-5%", -5.0, "%"),
     ("map_-10mm", -10.0, "mm"), ("map -10mm", -10.0, "mm"), ("map-10mm", 10.0, "mm"), ("-10mm", -10.0, "mm"),
     ("map--10mm", -10.0, "mm"), ("map (-10mm)", -10.0, "mm"), ("map - 10mm", 10.0, "mm"),
     ("x=\N{MINUS SIGN}2,5mm", -2.5, "mm"), ("0-5bar", 5.0, "bar"), ("DMSP-20-300_-5%", -5.0, "%")],
)  # fmt: skip
def test_a_minus_in_a_name_is_no_separator(stem: str, value: float, unit: str) -> None:
    assert [(one.value, one.unit) for one in said_in(stem, HEADINGS)] == [(value, unit)]


def test_a_muscle_that_was_stretched_by_names_of_files(tmp_path: Path) -> None:
    files = []
    for percent in (-5, 5):
        p, _, pull = grid(PRESSURES, [LENGTH * percent / 100])
        rows = list(zip(p / 1e5, pull, strict=True))
        files.append(write(tmp_path / f"DMSP-20-300 eps={percent}%.csv", "p [bar],F [N]", rows))
    runs = written(pam.new(tmp_path / "rig", files))["runs"]
    assert [run["parameters"]["s"] for run in runs] == ["-15 mm", "15 mm"]


def test_a_pull_below_zero_by_names_of_files_is_turned_round(tmp_path: Path) -> None:
    files = []
    for load in (50, 100):
        rows = [[float(i), 5.0 * i - load / 50] for i in range(6)]
        files.append(write(tmp_path / f"F=-{load}N.csv", "p [bar],x [mm]", rows))
    made = pam.new(tmp_path / "rig", files)
    assert [run.parameters["F"] for run in made.data.runs] == [50.0, 100.0]


def test_one_question_where_nobody_says_at_which_contraction(tmp_path: Path) -> None:
    """The question names what to type; roles wait for the answer, which they depend on."""
    files = []
    for name, x in (("b", 0.0), ("a", 0.03), ("c", 0.01)):
        p, _, pull = grid(PRESSURES, [x])
        files.append(
            write(tmp_path / f"{name}.csv", "p [bar],F [N]", list(zip(p / 1e5, pull, strict=True)))
        )
    with pytest.raises(
        pam.InputError, match=r"contraction \(x\); say it: --parameter 'x=0 mm'.*'x@FILE=0 mm'"
    ):
        pam.new(tmp_path / "rig", files)
    assert not (tmp_path / "rig").exists()
    made = pam.new(
        tmp_path / "rig", files, parameters={"x@b": "0 mm", "x@a": "30 mm", "x@c": "10 mm"}
    )
    assert [run["role"] for run in written(made)["runs"]] == ["fit", "fit", "holdout"]
    with pytest.raises(pam.InputError, match="no recording 'd'"):
        pam.new(tmp_path / "other", files, parameters={"x@d": "0 mm"})


@pytest.mark.parametrize(
    ("column", "up", "down"),
    [("dir", 1, 0), ("dir", 0, 1), ("phase", "inflate", "deflate"), ("Richtung", "auf", "ab"),
     ("branch", "loading", "unloading"), ("way", "unloading", "loading"), ("stroke", "up", "down")],
)  # fmt: skip
def test_the_direction_by_any_word(tmp_path: Path, column: str, up: object, down: object) -> None:
    """What a word means follows from the pressure, however it is called; the rows are shuffled in no way."""
    p, x, way = loop(5e5, 11)
    rows: list[list[object]] = [
        [1, a / 1e3, 1e3 * b, up if c > 0 else down]
        for a, b, c in zip(p, x + noise(len(p), 5e-5, 2), way, strict=True)
    ]
    file = write(tmp_path / "no load.csv", f"cycle,p [kPa],contraction [mm],{column}", rows)
    made = pam.new(tmp_path / "rig", [file])
    content = written(made)
    assert content["model"].endswith("QuasiStaticIsotonic") and content["recording"] == {
        "ignore": ["cycle"]
    }
    assert content["runs"][0]["parameters"] == {"F": "0 N"}
    (told,) = [guess for guess in made.guesses if "branch" in guess.taken_as]
    assert f"{up} = up" in told.taken_as and f"{down} = down" in told.taken_as
    for run in made.data.runs:
        assert len(set(run.inputs["branch"])) == 1
        expected = no_load(np.clip(run.inputs["p"] - 3e3 * run.inputs["branch"], 0.0, None))
        np.testing.assert_allclose(run.measurements["x"], expected, atol=3e-4)


def test_rows_that_go_up_and_come_back_tell_their_direction(tmp_path: Path) -> None:
    p, x, _ = loop(5e5, 9)
    rows = list(zip(p / 1e3, 1e3 * (LENGTH - x), strict=True))
    made = pam.new(
        tmp_path / "rig",
        [write(tmp_path / "a.csv", "p [kPa],length [mm]", rows)],
        parameters={"F": "0 N"},
    )
    content = written(made)
    assert content["runs"][0]["branch"] == "order"
    assert content["columns"]["x"]["formula"].startswith('"0.24 m" - ')
    assert {float(run.inputs["branch"][0]) for run in made.data.runs} == {1.0, -1.0}


def test_a_file_without_a_header_is_one_question(tmp_path: Path) -> None:
    p, x, pull = grid(PRESSURES, [0.0, 0.01, 0.02, 0.03])
    file = write(tmp_path / "map.csv", "", list(zip(p / 1e3, 1e3 * x, pull, strict=True)))
    with pytest.raises(pam.InputError, match=r"--recording 'names=time \[s\],p \[kPa\]'"):
        pam.new(tmp_path / "rig", [file])
    for i, names in enumerate(("p [kPa], x [mm], F [N]", '["p [kPa]", "x [mm]", "F [N]"]')):
        made = pam.new(tmp_path / f"rig{i}", [file], recording={"names": names})
        assert written(made)["recording"]["names"] == ["p [kPa]", "x [mm]", "F [N]"]
        assert sum(run.sample_count("F") for run in made.data.runs) == 24


def test_pressures_that_are_held_are_nothing_over_time(tmp_path: Path) -> None:
    """Ten rows at each pressure look like steps of an input, of which points at rest have none."""
    rows = [[p, x, 0.001 * p * (40 - x)] for p in (100, 200, 300) for x in range(10)]
    file = write(tmp_path / "map.csv", "p [kPa],x [mm],F [N]", rows)
    content = written(pam.new(tmp_path / "rig", [file]))
    assert content["kind"] == "static" and "interpolation" not in content["runs"][0]


def test_a_count_is_no_clock(tmp_path: Path) -> None:
    """Neither a column of cycles, nor of numbers that rise unevenly, is a time; valves are driven over time."""
    rows = [[i // 5, (i % 3) + 0.1 * i**3, 5.0 * i, 0.1 * i] for i in range(40)]
    file = write(tmp_path / "a.csv", "cycle,code,p [kPa],x [mm]", rows)
    made = pam.new(tmp_path / "rig", [file], parameters={"F": "0 N"})
    content = written(made)
    assert content["kind"] == "static" and set(content["recording"]["ignore"]) == {"cycle", "code"}
    other = write(tmp_path / "b.csv", "valve,p [kPa],x [mm]", [[i % 2, i, i] for i in range(40)])
    with pytest.raises(pam.InputError, match="no column of time"):
        pam.new(tmp_path / "other", [other])


def test_a_fluidic_muscle_from_its_table_alone(tmp_path: Path) -> None:
    """Martens and Boblan 2017, table A1: the muscle by the file's name, and free what no rule reaches."""
    example = Path(__file__).parents[2] / "examples" / "static-map" / "map.csv"
    file = tmp_path / "DMSP-20-300.csv"
    file.write_bytes(example.read_bytes())
    made = pam.new(tmp_path / "rig", [file])
    free = set(written(made)["fit"])
    fibres, wall = (
        ("sleeve.D0", "sleeve.alpha_0"),
        ("membrane.p_0", "membrane.p_w", "membrane.eps_w"),
    )
    assert free == {f"muscle.{name}" for name in (*fibres, *wall)}
    assert made.data.parameters["muscle.sleeve.L0"] == pytest.approx(0.296)
    before, fitted = pam.compare(made.data), pam.fit(made.data).comparison
    assert before.scores["fit"]["F"].rmse == pytest.approx(18.3, abs=0.1)
    assert fitted.scores["fit"]["F"].rmse < 8.5 and fitted.scores["holdout"]["F"].rmse < 6.0


def test_what_lies_in_the_rubber_is_offered_for_recordings_over_time_too(tmp_path: Path) -> None:
    rows = [[0.01 * i, 2.0 * min(i, 150), 0.4 * min(i, 150)] for i in range(300)]
    made = pam.new(
        tmp_path / "rig", [write(tmp_path / "MAS-10-200 run.csv", "t [s],p [kPa],F [N]", rows)]
    )
    text = (tmp_path / "rig" / "experiment.toml").read_text()
    assert '# "muscle.membrane.p_w" = { min' in text and "muscle.membrane.p_w" not in written(
        made
    ).get("fit", {})
    assert '"muscle.sleeve.L0" = "200 mm"' in text


def test_a_pressure_along_the_top(tmp_path: Path) -> None:
    """A matrix of forces, as data sheets have it, is rearranged; what the numbers are follows from the others."""
    x, p = np.arange(0.0, 0.05, 0.01), [1e5, 2e5, 3e5, 4e5]
    pull = grid(p, list(x))[2].reshape(4, 5)
    rows = [[1e3 * a, *column] for a, column in zip(x, pull.T, strict=True)]
    plain, named = (
        "contraction [mm],1 bar,2 bar,3 bar,4 bar",
        [f"F@{kilo}kPa [N]" for kilo in (100, 200, 300, 400)],
    )
    for heading in (plain, ",".join(["x [mm]", *named])):
        folder = tmp_path / heading[0]
        made = pam.new(folder, [write(tmp_path / "sheet.csv", heading, rows)])
        assert sum(run.sample_count("F") for run in made.data.runs) == 20
        told = [(run.inputs["p"][i], run.inputs["x"][i], run.measurements["F"][i])
                for run in made.data.runs for i in range(len(run.time))]  # fmt: skip
        expected = [
            (q, a, f) for q, own in zip(p, pull, strict=True) for a, f in zip(x, own, strict=True)
        ]
        np.testing.assert_allclose(sorted(told), sorted(expected), rtol=2e-3, atol=1e-9)


def test_the_unit_of_the_values_is_guessed_where_none_is_written(tmp_path: Path) -> None:
    rows = [[250 - 5 * i, 20 - i, 40 - 2 * i, 60 - 3 * i] for i in range(8)]
    file = write(tmp_path / "map.csv", "Length [mm],20 psi,40 psi,60 psi", rows)
    made = pam.new(tmp_path / "rig", [file])
    copy = (tmp_path / "rig" / "map.csv").read_text(encoding="utf-8")
    assert copy.splitlines()[0] == '"Length [mm]",p [psi],F'
    assert any(
        "no unit is written; numbers up to 60 are taken as N" in one.why for one in made.guesses
    )
    scaled = pam.new(tmp_path / "kgf", [file], columns={"F": 'F * "1 kgf"'})
    largest = max(float(run.measurements["F"].max()) for run in scaled.data.runs)
    assert largest == pytest.approx(60 * 9.80665)


def test_an_unknown_unit_of_the_values_is_no_guess(tmp_path: Path) -> None:
    heads = ",".join(["x [mm]", *(f"F@{bar}bar [Newt]" for bar in (1, 2, 3))])
    file = write(tmp_path / "map.csv", heads, [[i, 9 - i, 19 - i, 29 - i] for i in range(8)])
    with pytest.raises(InputError, match="unit 'Newt' is unknown"):
        pam.new(tmp_path / "rig", [file])


def test_what_the_first_heading_says_holds_for_those_of_a_value_alone(tmp_path: Path) -> None:
    rows = [[m, 40 - 5 * m, 50 - 3 * m, 56 - 2 * m] for m in (0.5, 1, 2, 4)]
    heads = "Load (kg),Contraction (mm) @ 100 kPa,@ 200 kPa,@ 300 kPa"
    data = pam.new(tmp_path / "rig", [write(tmp_path / "iso.csv", heads, rows)]).data
    told = {
        (round(float(run.inputs["p"][i])), round(1e3 * float(run.measurements["x"][i]), 6))
        for run in data.runs
        for i in range(len(run.time))
    }
    assert told == {(int(1e5 * k), row[k]) for row in rows for k in (1, 2, 3)}


def test_both_ways_beside_one_another(tmp_path: Path) -> None:
    rows = [[100.0 * i, 240.0 - 5 * i, 238.0 - 5 * i] for i in range(6)]
    file = write(tmp_path / "loop.csv", "p [kPa],L_inflate [mm],L_deflate [mm]", rows)
    made = pam.new(tmp_path / "rig", [file], parameters={"F": "0 N"})
    up, down = sorted(made.data.runs, key=lambda run: -run.inputs["branch"][0])
    np.testing.assert_allclose(down.measurements["x"] - up.measurements["x"], 2e-3, atol=1e-9)


def test_pressures_by_names_of_files_and_loads_by_masses(tmp_path: Path) -> None:
    files = []
    for bar in (1, 2, 3, 4):
        _, x, pull = grid([1e5 * bar], [0.0, 0.01, 0.02, 0.03])
        rows = [[i + 1, 240 - 1e3 * a, b] for i, (a, b) in enumerate(zip(x, pull, strict=True))]
        files.append(write(tmp_path / f"Kraft_{bar}bar.csv", "Nr.,Länge [mm],Kraft [N]", rows))
    runs = written(pam.new(tmp_path / "rig", files))["runs"]
    assert [run["parameters"]["p"] for run in runs] == ["100 kPa", "200 kPa", "300 kPa", "400 kPa"]
    rows = [[m, 50.0 * i, way, 5.0 * i] for m in (1, 5, 10) for i in range(8) for way in ("U", "D")]
    file = write(tmp_path / "isotonic.csv", "weight (kg),pressure (kPa),dir,shortening (mm)", rows)
    made = pam.new(tmp_path / "isotonic", [file])
    assert {round(float(run.inputs["F"][0]), 1) for run in made.data.runs} == {9.8, 49.0, 98.1}
    assert {float(run.inputs["branch"][0]) for run in made.data.runs} == {1.0, -1.0}


def test_a_short_rest_is_one(tmp_path: Path) -> None:
    """Six rows that stay where they are tell no noise, and are a start at rest."""
    rows = [[0.1 * i, 20.0 * max(i - 6, 0), 0.5 * max(i - 6, 0)] for i in range(40)]
    made = pam.new(tmp_path / "still", [write(tmp_path / "a.csv", "t [s],p [kPa],x [mm]", rows)])
    assert not any("not at rest" in line for line in made.to_check)
    rows = [[0.1 * i, 20.0 * i + 5.0, 0.5 * i] for i in range(40)]
    made = pam.new(tmp_path / "moving", [write(tmp_path / "b.csv", "t [s],p [kPa],x [mm]", rows)])
    assert any("not at rest" in line for line in made.to_check)


def test_a_table_that_repeats_the_muscle_and_its_length_in_every_row(tmp_path: Path) -> None:
    rows = [
        ["MAS-20", 250.0, p, e, p * (3 - e / 9)]
        for p in (100.0, 200.0, 300.0, 400.0)
        for e in (0.0, 5.0, 10.0, 15.0)
    ]
    made = pam.new(
        tmp_path / "rig",
        [write(tmp_path / "a.csv", "muscle,length_mm,p_kPa,contraction_pct,force_N", rows)],
    )
    assert "Muscles.MAS20" in (tmp_path / "rig" / "Rig.mo").read_text()
    assert written(made)["parameters"] == {"muscle.sleeve.L0": "250 mm"}
    assert {round(1e3 * float(x), 6) for run in made.data.runs for x in run.inputs["s"]} == {
        0.0,
        12.5,
        25.0,
        37.5,
    }


def test_a_way_for_each_file(tmp_path: Path) -> None:
    """By their names, or by the order of their rows."""
    rows = [[float(i), 5.0 * i] for i in range(6)]
    for up, down, told in (
        ("inflation_0N", "deflation_0N", ["up", "down"]),
        ("test1_0N", "test2_0N", ["order", "order"]),
    ):
        files = [
            write(tmp_path / f"{name}.csv", "p [bar],x [mm]", own)
            for name, own in ((up, rows), (down, rows[::-1]))
        ]
        made = pam.new(tmp_path / up, files)
        assert [run["branch"] for run in written(made)["runs"]] == told
        assert [float(run.inputs["branch"][0]) for run in made.data.runs] == [1.0, -1.0]
        assert all(run.parameters["F"] == 0.0 for run in made.data.runs)


@pytest.mark.full
def test_tables_of_a_press_come_to_a_verdict_with_no_line_by_hand(tmp_path: Path) -> None:
    """A muscle of another form than the library's: what is found meets a pressure that was never fitted."""
    files, sigma = [], 0.6
    for bar in (1, 2, 3, 4):
        p, x, pull = grid([1e5 * bar], list(np.arange(0.0, 0.045, 0.005)))
        read = 240 - 1e3 * x, pull + noise(len(p), sigma, bar)
        rows = [[i + 1, length, force] for i, (length, force) in enumerate(zip(*read, strict=True))]
        files.append(write(tmp_path / f"Kraft_{bar}bar.csv", "Nr.,Länge [mm],Kraft [N]", rows, ","))
    diagnosis = pam.diagnose(pam.new(tmp_path / "rig", files).data)
    assert diagnosis.verdict.kind in ("identified", "ambiguous") and diagnosis.path
    before, after = (
        c.scores["holdout"]["F"].rmse
        for c in (diagnosis.base.comparison, diagnosis.final.comparison)
    )
    assert after < 3 * sigma and after < before / 20
    assert {"pressure_sensor_lag", "temperature_sensor", "creep"} <= set(diagnosis.not_tried)


@pytest.mark.parametrize("least", [0.0, 1.013e5, 2e5])
def test_pressures_that_begin_at_that_of_the_atmosphere_are_asked_about(
    tmp_path: Path, least: float
) -> None:
    p, x, pull = grid(PRESSURES, [0.0, 0.01, 0.02, 0.03])
    rows = list(zip((p + least) / 1e5, 1e3 * x, pull + noise(len(p), 0.5, 1), strict=True))
    file = write(tmp_path / "map.csv", "p [bar],x [mm],F [N]", rows)
    made = pam.new(tmp_path / "rig", [file])
    asked = [line for line in made.to_check if "the gauge is an absolute one" in line]
    assert len(asked) == (least == 1.013e5)
