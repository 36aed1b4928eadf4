"""Tables without time: points at rest, as files of invented labs, become data sets with no line by hand."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.drafting import NewDataSet
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


def test_one_question_where_nobody_says_at_which_contraction(tmp_path: Path) -> None:
    """The question names what to type; roles wait for the answer, which they depend on."""
    files = []
    for name, x in (("b", 0.0), ("a", 0.03), ("c", 0.01)):
        p, _, pull = grid(PRESSURES, [x])
        files.append(
            write(tmp_path / f"{name}.csv", "p [bar],F [N]", list(zip(p / 1e5, pull, strict=True)))
        )
    with pytest.raises(
        pam.InputError, match=r"contraction \(x\); state it: --parameter 'x=0 mm'.*'x@FILE=0 mm'"
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
    [("dir", 1, 0), ("dir", 1, -1), ("phase", "inflate", "deflate"), ("Richtung", "auf", "ab"),
     ("branch", "loading", "unloading"), ("stroke", "up", "down")],
)  # fmt: skip
def test_the_direction_by_any_word(tmp_path: Path, column: str, up: object, down: object) -> None:
    """By the words of the field; of numbers, the larger is up."""
    p, x, way = loop(5e5, 11)
    rows: list[list[object]] = [
        [1, a / 1e3, 1e3 * b, up if c > 0 else down]
        for a, b, c in zip(p, x + noise(len(p), 5e-5, 2), way, strict=True)
    ]
    file = write(tmp_path / "no load.csv", f"cycle,p [kPa],contraction [mm],{column}", rows)
    made = pam.new(tmp_path / "rig", [file], parameters={"F": "0 N"})
    content = written(made)
    assert content["model"].endswith("QuasiStaticIsotonic") and content["recording"] == {
        "ignore": ["cycle"]
    }
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
        ("inflation", "deflation", ["up", "down"]),
        ("test1", "test2", ["order", "order"]),
    ):
        files = [
            write(tmp_path / f"{name}.csv", "p [bar],x [mm]", own)
            for name, own in ((up, rows), (down, rows[::-1]))
        ]
        made = pam.new(tmp_path / up, files, parameters={"F": "0 N"})
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
        rows = [
            [i + 1, bar, length, force] for i, (length, force) in enumerate(zip(*read, strict=True))
        ]
        heads = "Nr.,Druck [bar],Länge [mm],Kraft [N]"
        files.append(write(tmp_path / f"Kraft_{bar}bar.csv", heads, rows, ","))
    diagnosis = pam.diagnose(pam.new(tmp_path / "rig", files).data, explain=False)
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


def test_a_set_point_and_a_mass_serve_where_nothing_else_was_read(tmp_path: Path) -> None:
    """Of points at rest the regulator has reached its set point, and the mass of a row hangs on the muscle."""
    rows = [[bar, mass, 4 * bar - mass] for bar in (1, 2, 3, 4, 5) for mass in (1, 2, 4)]
    file = write(tmp_path / "a.csv", "p_set [bar],Masse [kg],x [mm]", rows)
    run = pam.new(tmp_path / "rig", [file]).data.runs[0]
    assert {*run.inputs} >= {"p", "F"} and run.inputs["p"].max() == 5e5
    assert run.inputs["F"].max() == pytest.approx(4 * 9.80665)
