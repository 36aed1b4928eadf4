"""Inputs from whatever a script has, and runs by FMPy: the same numbers each way."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas
import pytest
import xarray

import pam_cosim as pam
from pam_cosim.measurement import rows_of
from pam_cosim.study.input_sources import inputs_of
from pam_cosim.study.runs import _input_series
from tests.trajectories import read_trajectory

BENCH = "TankFilling"
TIME = np.array([0.0, 1.0, 1.0, 3.0])
CURRENT = np.array([0.2, 0.2, 0.35, 0.3])
SUPPLY = np.array([1.5e5, 1.5e5, 1.8e5, 1.8e5])
EXPECTED = pam.Inputs(TIME, {"u_in": CURRENT, "p_supply": SUPPLY})


def _csv(folder: Path) -> Path:
    rows = [f"{t},{u},{p / 1e3}" for t, u, p in zip(TIME, CURRENT, SUPPLY, strict=True)]
    (folder / "u.csv").write_text("\n".join(["time [s],u_in [A],p_supply [kPa]", *rows]))
    return folder / "u.csv"


def _structured() -> np.ndarray:
    made = np.zeros(4, [("time", float), ("u_in", float), ("p_supply", float)])
    made["time"], made["u_in"], made["p_supply"] = TIME, CURRENT, SUPPLY
    return made


SOURCES: dict[str, Any] = {
    "mapping": {"time": TIME, "u_in": CURRENT, "p_supply": SUPPLY},
    "units": {"time [ms]": TIME * 1e3, "u_in [mA]": CURRENT * 1e3, "p_supply [bar]": SUPPLY / 1e5},
    "frame": pandas.DataFrame({"time": TIME, "u_in": CURRENT, "p_supply [kPa]": SUPPLY / 1e3}),
    "index": pandas.DataFrame({"u_in": CURRENT, "p_supply": SUPPLY}, index=pandas.Index(TIME)),
    "times since the start": pandas.DataFrame(
        {"u_in": CURRENT, "p_supply": SUPPLY}, index=pandas.to_timedelta(TIME, unit="s")
    ),
    "times of day": pandas.DataFrame(
        {
            "time": pandas.Timestamp("2026-03-01 08:00") + pandas.to_timedelta(TIME, unit="s"),
            "u_in": CURRENT,
            "p_supply": SUPPLY,
        }
    ),
    "structured": _structured(),
    "file": _csv,
}


@pytest.fixture(scope="module")
def reference() -> pam.Trajectory:
    return pam.simulate(BENCH, inputs=EXPECTED)


@pytest.mark.parametrize("kind", SOURCES)
def test_every_source_says_the_same(kind: str, reference: pam.Trajectory, tmp_path: Path) -> None:
    source = SOURCES[kind](tmp_path) if kind == "file" else SOURCES[kind]
    run = pam.simulate(BENCH, inputs=source)
    assert np.array_equal(run.time, reference.time)
    np.testing.assert_allclose(run["p"], reference["p"], rtol=1e-9, atol=1e-3)


def test_functions_and_constants_of_time() -> None:
    def ramp(t: float) -> float:
        return 0.2 + 0.05 * t

    run = pam.simulate(BENCH, inputs={"u_in": ramp, "p_supply": "150 kPa"}, stop_time="2 s")
    line = pam.Inputs([0.0, 2.0], {"u_in": [0.2, 0.3], "p_supply": [1.5e5, 1.5e5]})
    np.testing.assert_allclose(run["p"], pam.simulate(BENCH, inputs=line)["p"], rtol=1e-6, atol=0.1)


@pytest.mark.parametrize(
    ("head", "text"),
    [("p_supply [kPa]", "138 kPa"), ("p_supply [kPa]", "138"), ("p_supply [bar]", "138 kPa"),
     ("p_supply", "1.38 bar"), ("p_supply", "138e3")],
)  # fmt: skip
def test_a_constant_is_in_its_own_unit_or_that_of_its_head(head: str, text: str) -> None:
    made = inputs_of({head: text}, pam.describe(BENCH), lambda: np.array([0.0, 1.0]))
    assert made is not None
    np.testing.assert_allclose(made.values["p_supply"], [1.38e5, 1.38e5], rtol=1e-12)


@pytest.mark.parametrize("held", [False, True])
def test_a_run_that_is_predicted_ends_where_it_is_to_end(held: bool) -> None:
    """However long its inputs go on, and whether a row of them is after the end or one step is at it."""
    inputs = pam.Inputs(
        [0.0, 2.0, 5.0, 60.0], {"u_in": [0.3, 0.3, 0.2, 0.0]}, "previous" if held else "linear"
    )
    course, times = _input_series(pam.describe(BENCH), inputs, 5, 1)
    assert course is not None
    rows, columns = rows_of(course, times)
    np.testing.assert_allclose(rows, [0, 1, 2, 3, 4, 5, 5] if held else [0, 1, 2, 3, 4, 5])
    after = [0.3, 0.3, 0.3, 0.2] if held else [0.3 - 0.1 / 3, 0.3 - 0.2 / 3, 0.2]
    np.testing.assert_allclose(columns["u_in"], [0.3, 0.3, 0.3, *after], rtol=1e-12)


def test_patterns_of_a_sweep_begin_at_one_time() -> None:
    """Else the beginning of one would be left out without a word: all runs have the times of one."""
    early, late = ({"time": [begin, begin + 3.0], "u_in": [0.3, 0.3]} for begin in (0.0, 2.0))
    wanted = r"'early' begins at 0 s, 'late' at 2 s: all runs of a sweep begin at one time"
    with pytest.raises(pam.InputError, match=wanted):
        pam.sweep(BENCH, {"inputs": {"early": early, "late": late}}, scalars=["max(p)"], workers=1)


def test_an_earlier_run_drives_another() -> None:
    first = pam.simulate(BENCH, inputs=EXPECTED, outputs=["u_in", "p_supply"])
    again = pam.simulate(BENCH, inputs=first)
    np.testing.assert_allclose(again["p"][-1], first["p"][-1], rtol=1e-2)


def _fails(t: float) -> float:
    raise ZeroDivisionError("at half time")


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ({"time": TIME, "u_inn": CURRENT}, "no input 'u_inn'; did you mean 'u_in'"),
        ({"time": TIME, "u_in [kg]": CURRENT}, "'u_in [kg]'"),
        ({"time": TIME, "u_in": CURRENT[:2]}, "has 2 values for 4 times"),
        ({"time": TIME[::-1], "u_in": CURRENT}, "decrease"),
        ({"time": TIME, "u_in": ["a", "b", "c", "d"]}, "'u_in'"),
        ({"u_in": _fails}, "the function of the input 'u_in' fails at 0 s"),
        ({"u_in": "3 kg"}, "u_in=3 kg"),
        (3.0, "not as float"),
    ],
)
def test_what_is_no_source_is_refused(source: Any, words: str) -> None:
    with pytest.raises(pam.InputError) as refused:
        pam.simulate(BENCH, inputs=source)
    assert words in str(refused.value)


def test_a_run_goes_elsewhere(reference: pam.Trajectory, tmp_path: Path) -> None:
    frame, data = reference.to_frame(), reference.to_xarray()
    assert np.array_equal(frame["p"], reference["p"]) and frame.attrs["units"]["p"] == "Pa"
    assert np.array_equal(data["T"], reference["T"]) and data["T"].attrs["units"] == "K"
    with xarray.open_dataset(reference.save(tmp_path / "r.nc")) as read:
        assert np.array_equal(read["p"], reference["p"])
    assert np.array_equal(
        pandas.read_parquet(reference.save(tmp_path / "r.parquet"))["p [Pa]"], reference["p"]
    )
    assert np.array_equal(read_trajectory(reference.save(tmp_path / "r.csv"))["p"], reference["p"])
    pam.draw(reference, tmp_path / "r.png")
    assert (
        str(reference).startswith("2 signals at ") and "<pre>2 signals" in reference._repr_html_()
    )


def test_a_name_that_no_variable_has() -> None:
    with pytest.raises(
        pam.InputError, match="no variable 'valve.inlet.mflow'; did you mean 'valve.inlet.m_flow'"
    ):
        pam.simulate(BENCH, outputs=["valve.inlet.mflow"])
