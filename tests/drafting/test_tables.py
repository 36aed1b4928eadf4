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
    made = pam.new(tmp_path / "rig", [write(tmp_path / "map.csv", "Nr,pressure,contraction,force", rows, ",,")])
    content = written(made)
    assert content["kind"] == "static" and content["model"].endswith("QuasiStaticIsometric")
    assert content["recording"] == {"ignore": ["Nr"], "missing": ["nan"]}
    assert content["columns"]["F"] == {"column": "force", "unit": "N"}
    assert content["runs"][0]["hold_out"] == {"x": ["20 mm"]}
    assert sum(run.sample_count("F") for run in made.data.fit_runs) == 23
    assert len(made.data.holdout_runs) == 1
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


def test_one_question_where_nobody_says_at_which_contraction(tmp_path: Path) -> None:
    """The question names what to type; roles wait for the answer, which they depend on."""
    files = []
    for name, x in (("b", 0.0), ("a", 0.03), ("c", 0.01)):
        p, _, pull = grid(PRESSURES, [x])
        files.append(write(tmp_path / f"{name}.csv", "p [bar],F [N]", list(zip(p / 1e5, pull, strict=True))))
    with pytest.raises(pam.InputError, match=r"contraction \(x\); say it: --parameter 'x=0 mm'.*'x@FILE=0 mm'"):
        pam.new(tmp_path / "rig", files)
    assert not (tmp_path / "rig").exists()
    made = pam.new(tmp_path / "rig", files, parameters={"x@b": "0 mm", "x@a": "30 mm", "x@c": "10 mm"})
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
    assert content["model"].endswith("QuasiStaticIsotonic") and content["recording"] == {"ignore": ["cycle"]}
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
    made = pam.new(tmp_path / "rig", [write(tmp_path / "a.csv", "p [kPa],length [mm]", rows)], parameters={"F": "0 N"})
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
        assert len(made.data.runs) == 4


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
