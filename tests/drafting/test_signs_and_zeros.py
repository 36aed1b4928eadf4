"""Instruments that count the other way or from somewhere else, and several that could be meant."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.drafting import NewDataSet
from tests.drafting.labs import LENGTH, Array, force, noisy
from tests.drafting.test_doubtful_recordings import written

TIME = 0.02 * np.arange(400)
P = 1e5 * np.clip(np.sin(2.0 * (TIME - 1.0)) ** 2 * (TIME > 1.0) * 3.0, 0.0, None)  # [Pa]
X = 0.015 * (1.0 - np.cos(2.9 * np.clip(TIME - 1.0, 0.0, None)))  # [m]
PULL = np.asarray(force(P, X))


def record(file: Path, columns: dict[str, Array]) -> Path:
    rows = zip(*columns.values(), strict=True)
    text = "".join(",".join("" if v != v else f"{v:.6f}" for v in row) + "\n" for row in rows)
    file.write_text(",".join(columns) + "\n" + text, encoding="utf-8")
    return file


def course(made: NewDataSet, name: str) -> Array:
    (run,) = made.data.runs
    return {**run.inputs, **run.measurements}[name]


@pytest.mark.parametrize(
    ("heading", "read"),
    [
        ("Traverse [mm]", 100.0 - 1e3 * X),
        ("Traverse [mm]", 100.0 + 1e3 * X),
        ("Elongation [mm]", -1e3 * X),
        ("strain [%]", -100.0 * X / LENGTH),
        ("L/L0 [-]", 1.0 - X / LENGTH),
    ],
)
def test_what_a_machine_imposes_is_a_contraction_from_rest(
    tmp_path: Path, heading: str, read: Array
) -> None:
    """The pull says which way a crosshead counts, the rest at the beginning where it counts from."""
    columns = {
        "t [s]": TIME,
        "p [bar]": noisy(P / 1e5, 0.002, 1),
        "F [N]": noisy(PULL, 0.3, 2),
        heading: read,
    }
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    np.testing.assert_allclose(course(made, "s"), X, atol=1e-5)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_spring_pulls_more_the_shorter_the_muscle(tmp_path: Path, sign: float) -> None:
    """It follows the pressure, so that the muscle moved it; the pressure says which way it counts."""
    x = np.convolve(P, np.ones(9) / 9.0)[:400] * 1e-7
    columns = {
        "t [s]": TIME,
        "p [bar]": noisy(P / 1e5, 0.002, 1),
        "F [N]": noisy(2e3 * x, 0.1, 2),
        "Weg [mm]": noisy(sign * 1e3 * x, 0.02, 3),
    }
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    np.testing.assert_allclose(course(made, "x"), x, atol=2e-4)


def test_contractions_from_which_runs_set_out_are_no_zeros(tmp_path: Path) -> None:
    for i, held in enumerate((10.0, 20.0)):
        columns = {
            "t [s]": TIME,
            "p [bar]": noisy(P / 1e5, 0.002, i),
            "F [N]": noisy(np.asarray(force(P, 1e-3 * held + X)), 0.3, i + 5),
            "s [mm]": held + 1e3 * X,
        }
        record(tmp_path / f"run{i}.csv", columns)
    made = pam.new(tmp_path / "rig", sorted(tmp_path.glob("run*.csv")))
    begins = [float(run.inputs["s"][0]) for run in made.data.runs]
    assert begins == pytest.approx([0.01, 0.02])


@pytest.mark.parametrize("dead", [0.0, 1e-3])
@pytest.mark.parametrize("first", [True, False])
def test_of_two_alike_the_one_that_moves_is_the_muscles(
    tmp_path: Path, dead: float, first: bool
) -> None:
    """The other one is noise about zero, or hardly moves."""
    live = noisy(1e3 * X, 0.02, 1)
    other = noisy(1e3 * dead * X, 0.02, 2)
    pair = {"Weg 1 [mm]": live, "Weg 2 [mm]": other}
    if not first:
        pair = {"Weg 1 [mm]": other, "Weg 2 [mm]": live}
    columns = {"t [s]": TIME, "p_set [bar]": P / 1e5, "p [bar]": noisy(P / 1e5, 0.002, 3), **pair}
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    assert float(np.ptp(course(made, "x"))) == pytest.approx(0.03, rel=0.05)


@pytest.mark.parametrize("share", [0.5, 1.0])
def test_a_second_clock_that_ends_before_the_rows_do(tmp_path: Path, share: float) -> None:
    """Each clock heads the columns beside it; the shorter one leaves cells empty."""
    slow = np.where(np.arange(400) < 200, 2.0 * TIME, np.nan)
    first, second = (TIME, slow) if share < 1.0 else (slow, TIME)
    p = np.where(np.isfinite(first), P / 1e5, np.nan)
    columns = {
        "Zeit 1 [s]": first, "p_set [bar]": p, "p [bar]": p,
        "Zeit 2 [s]": second, "x [mm]": np.where(np.isfinite(second), 1e3 * X, np.nan),
    }  # fmt: skip
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    (run,) = made.data.runs
    known = np.isfinite(second)
    read = np.isfinite(run.measurements["x"]) & (run.time <= np.nanmax(second))
    rows = np.searchsorted(second[known], run.time[read])
    np.testing.assert_allclose(run.time[read], second[known][rows], atol=1e-9)
    np.testing.assert_allclose(run.measurements["x"][read], X[known][rows], atol=1e-8)
    assert read.sum() == known.sum() - (share == 1.0)  # the set point ends a sample before


def test_a_file_may_lack_the_second_clock(tmp_path: Path) -> None:
    one = {"t [s]": TIME, "p_set [bar]": P / 1e5, "p [bar]": P / 1e5}
    two = {**one, "t x [s]": 0.5 * TIME, "x [mm]": np.interp(0.5 * TIME, TIME, 1e3 * X)}
    files = [record(tmp_path / "a.csv", two), record(tmp_path / "b.csv", one)]
    made = pam.new(tmp_path / "rig", files)
    assert [sorted(run.measurements) for run in made.data.runs] == [["p", "x"], ["p"]]


def test_three_clocks_in_one_file(tmp_path: Path) -> None:
    """The set point is of the last one; each reading has rows of its own times."""
    slow, fast = 4.0 * TIME[:100], 0.25 * TIME
    empty = np.full(300, np.nan)
    columns = {
        "Time p [s]": np.append(slow, empty), "p [bar]": np.append(P[::4] / 1e5, empty),
        "Time x [ms]": 1e3 * fast, "x [mm]": np.interp(fast, TIME, 1e3 * X),
        "Time [s]": TIME, "p_set [bar]": P / 1e5,
    }  # fmt: skip
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    (run,) = made.data.runs
    for name, time, values in (("p", slow, P[::4]), ("x", fast, np.interp(fast, TIME, X))):
        read = np.isfinite(run.measurements[name])
        np.testing.assert_allclose(run.time[read], time, atol=1e-8)
        np.testing.assert_allclose(
            run.measurements[name][read], values, atol=1.0 if name == "p" else 1e-8
        )


def columns_over(time: Array) -> dict[str, Array]:
    return {"Time": time, "p_set [bar]": P / 1e5, "p [bar]": P / 1e5, "x [mm]": 1e3 * X}


@pytest.mark.parametrize("begin", [0.0, 0.5872])
def test_parts_of_a_day(tmp_path: Path, begin: float) -> None:
    file = tmp_path / "a.csv"
    record(file, columns_over(TIME))
    head, *rows = file.read_text().splitlines()
    parts = [f"{begin + t / 86400.0:.10f}" for t in TIME]
    rows = [f"{part},{row.partition(',')[2]}" for part, row in zip(parts, rows, strict=True)]
    file.write_text("\n".join([head, *rows]) + "\n")
    made = pam.new(tmp_path / "rig", [file])
    assert float(np.ptp(made.data.runs[0].time)) == pytest.approx(float(np.ptp(TIME)), rel=1e-3)
    assert any("taken as d, so that a.csv lasts 7.98 s" in line for line in made.to_check)


def test_how_long_whole_numbers_last_is_asked(tmp_path: Path) -> None:
    whole = record(tmp_path / "a.csv", columns_over(np.arange(400.0)))
    made = pam.new(tmp_path / "rig", [whole])
    assert any("taken as ms, so that a.csv lasts 0.399 s" in line for line in made.to_check)
    seconds = record(tmp_path / "b.csv", columns_over(TIME))
    made = pam.new(tmp_path / "other", [seconds])
    assert not any("lasts" in line for line in made.to_check)


def test_the_pressure_outside_that_was_recorded_is_subtracted(tmp_path: Path) -> None:
    columns = {
        "t [s]": TIME, "u_in [A]": 0.3 * (TIME > 1.0), "u_out [A]": np.zeros(400),
        "p_supply [bar]": np.full(400, 3.0), "p_abs [bar]": 0.94 + P / 1e5 + 0.5,
        "x [mm]": 1e3 * X + 5.0, "baro [mbar]": np.full(400, 940.0),
    }  # fmt: skip
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    assert made.data.runs[0].parameters["ambient.p"] == pytest.approx(94e3)
    assert float(course(made, "p")[0]) == pytest.approx(0.5e5)
    assert "94 kPa" in written(made)["columns"]["p"]["formula"]
    outside = {"ambient.p": "96 kPa"}
    made = pam.new(tmp_path / "stated", [tmp_path / "a.csv"], parameters=outside)
    assert made.data.runs[0].parameters["ambient.p"] == pytest.approx(96e3)
    assert float(course(made, "p")[0]) == pytest.approx(0.48e5)


@pytest.mark.parametrize(("noise", "between"), [(0.0, "previous"), (0.004, "linear")])
def test_what_is_read_goes_on_between_samples(tmp_path: Path, noise: float, between: str) -> None:
    """An imposed pressure that steps is held if its numbers repeat, and not if an instrument read it."""
    p = np.repeat([0.0, 2.0, 3.0, 1.0], 100)
    columns = {
        "t [s]": TIME, "p [bar]": noisy(p, noise, 1), "s [mm]": 1e3 * X,
        "F [N]": noisy(np.asarray(force(1e5 * p, X)), 0.3, 2),
    }  # fmt: skip
    made = pam.new(tmp_path / "rig", [record(tmp_path / "a.csv", columns)])
    assert made.data.runs[0].interpolation == between
