"""Units as labs spell them are read as they were meant, and never replaced by a guess."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from tests.drafting.headings import read_heading
from tests.tiers import quick

AMBIENT = 101_325.0
TIME = np.arange(0.0, 4.0, 0.01)
PRESSURE = 1.5e5 * (1.0 - np.cos(TIME))
CONTRACTION = 0.02 * (1.0 - np.cos(TIME - 0.2))


def drafted(
    tmp_path: Path,
    heads: str,
    *,
    p: Callable[[np.ndarray], np.ndarray] = lambda p: p / 1e5,
    x: Callable[[np.ndarray], np.ndarray] = lambda x: x * 1e3,
    time: Callable[[np.ndarray], np.ndarray] = lambda t: t,
    **wishes: object,
) -> pam.DataSet:
    """A data set of a file with the columns time, set point, pressure and contraction; its set point has 1 bar."""
    rows = zip(time(TIME), np.ones_like(TIME), p(PRESSURE), x(CONTRACTION), strict=True)
    lines = [heads, *(",".join(f"{value:.17g}" for value in row) for row in rows)]
    file = tmp_path / "run.csv"
    file.write_text("\n".join(lines), encoding="utf-8")
    return pam.new(tmp_path / "rig", [file], **wishes).data  # type: ignore[arg-type]


def remarks(tmp_path: Path) -> str:
    """The text of the description in one line."""
    text = (tmp_path / "rig" / "experiment.toml").read_text(encoding="utf-8")
    return " ".join(text.replace("\n#", "").split())


@pytest.mark.parametrize(
    ("unit", "factor", "ambient"),
    [
        ("bar(g)", 1e5, 0.0),
        ("MPa (g)", 1e6, 0.0),
        ("PSIG", 6894.757293168, 0.0),
        ("N/mm²", 1e6, 0.0),
        ("kg/cm2", 98066.5, 0.0),
        ("Mbar", 100.0, 0.0),
        ("bara", 1e5, AMBIENT),
        ("mbar(a)", 100.0, AMBIENT),
        ("psia", 6894.757293168, AMBIENT),
        ("kPa abs", 1e3, AMBIENT),
    ],
)
def test_a_pressure_is_gauge_whatever_its_unit_says(
    tmp_path: Path, unit: str, factor: float, ambient: float
) -> None:
    heads = f"time [s],p_set [bar],p [{unit}],x [mm]"
    data = drafted(tmp_path, heads, p=lambda p: (p + ambient) / factor)
    np.testing.assert_allclose(data.runs[0].measurements["p"], PRESSURE, atol=1e-6 * factor)


@pytest.mark.parametrize(
    "name",
    quick(
        ["p_abs", "pAbs", "pabs", "P_ABS", "Absolutdruck", "p_absolute"], "p_abs", "Absolutdruck"
    ),
)
def test_a_name_says_that_a_pressure_is_absolute(tmp_path: Path, name: str) -> None:
    heads = f"time [s],p_set [bar],{name} [bar],x [mm]"
    data = drafted(tmp_path, heads, p=lambda p: (p + AMBIENT) / 1e5)
    np.testing.assert_allclose(data.runs[0].measurements["p"], PRESSURE, atol=0.1)


@pytest.mark.parametrize(
    ("name", "factor"),
    [
        ("p_psia", 6894.757293168),
        ("pressure_bara", 1e5),
        ("Pressure (kPa(a))", 1e3),
        ("Pressure (bar a)", 1e5),
    ],
)
def test_a_unit_in_a_name_says_that_a_pressure_is_absolute(
    tmp_path: Path, name: str, factor: float
) -> None:
    heads = f"time [s],p_set [bar],{name},x [mm]"
    data = drafted(tmp_path, heads, p=lambda p: (p + AMBIENT) / factor)
    np.testing.assert_allclose(data.runs[0].measurements["p"], PRESSURE, atol=0.1)


def test_a_shut_off_valve_is_not_absolute() -> None:
    assert not read_heading("Druck nach Absperrventil", "bar").absolute


@pytest.mark.parametrize("unit", ["psy", "barr", "inWC", "1e5 Pa"])
def test_an_unknown_unit_is_not_replaced_by_a_guess(tmp_path: Path, unit: str) -> None:
    with pytest.raises(InputError, match=f"column 'p': unit '{unit}' is unknown") as raised:
        drafted(tmp_path, f"time [s],p_set [bar],p [{unit}],x [mm]")
    assert raised.value.line == 1 and not (tmp_path / "rig").exists()


def test_a_column_of_a_formula_is_named_in_it_and_not_a_part_of_another_name(
    tmp_path: Path,
) -> None:
    heads = "time [s],p_set [bar],p [psy],Weg_p [mm]"
    with pytest.raises(InputError, match="column 'p': unit 'psy' is unknown"):
        drafted(tmp_path, heads, columns={"x": "2 * Weg_p"})


def test_counts_want_a_scale(tmp_path: Path) -> None:
    heads, scale = "time [s],p_set [bar],p [bar],x [counts]", {"x": 'x * "0.02 mm"'}
    with pytest.raises(InputError, match="the size of its counts is not stated"):
        drafted(tmp_path, heads, x=lambda x: x / 2e-5)
    data = drafted(tmp_path, heads, x=lambda x: x / 2e-5, columns=scale)
    np.testing.assert_allclose(data.runs[0].measurements["x"], CONTRACTION, atol=1e-9)


@pytest.mark.parametrize(
    ("head", "said"),
    [
        ("x [px]", "the size of its px is not stated; scale it, as in --column 'x=x "),
        ("length_px", "the size of its px is not stated"),
        ("Force [mV/V]", "the size of its mV/V is not stated; scale it, as in --column 'F=Force "),
    ],
)
def test_pixels_and_bridges_want_a_scale(tmp_path: Path, head: str, said: str) -> None:
    with pytest.raises(InputError, match=said):
        drafted(tmp_path, f"time [s],p_set [bar],p [bar],{head}", x=lambda x: x / 2e-5)


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("Pressure (100 kPa)", "100 kPa"),
        ("Pressure (x10^5 Pa)", "x10^5 Pa"),
        ("p / 10^5 Pa", "10^5 Pa"),
        ("p in 0.1 MPa", "0.1 MPa"),
        ("Stroke (1/10 mm)", "1/10 mm"),
        ("Stroke (mm/10)", "mm/10"),
        ("x (10^-3 m)", "10^-3 m"),
        ("Time(100us)", "100us"),
        ("t (1e-3 s)", "1e-3 s"),
        ("Time_10ms", "10ms"),
        ("Pressure (0-10 bar)", ""),
        ("Pressure_10bar", ""),
        ("Force (3 bar)", ""),
        ("valve (100%)", ""),
        ("t2_ms", ""),
    ],
)
def test_a_unit_with_a_factor_is_known_as_such(name: str, unit: str) -> None:
    assert read_heading(name, "").unknown == unit


def test_a_factor_before_a_unit_wants_a_scale(tmp_path: Path) -> None:
    heads = "time [s],p_set [bar],Pressure (10^5 Pa),x [mm]"
    with pytest.raises(InputError, match="its unit '10\\^5 Pa' has a factor.* scale it, as in"):
        drafted(tmp_path, heads)
    data = drafted(tmp_path, heads, columns={"p": "'Pressure (10^5 Pa)' * \"1e5 Pa\""})
    np.testing.assert_allclose(data.runs[0].measurements["p"], PRESSURE, atol=0.1)


@pytest.mark.parametrize("heads", ["time [ticks]", "Time (10 ms)"])
def test_a_time_whose_unit_nobody_knows_is_not_taken_for_seconds(
    tmp_path: Path, heads: str
) -> None:
    with pytest.raises(InputError, match="column '[tT]ime.*': .*unit '(ticks|10 ms)'"):
        drafted(tmp_path, f"{heads},p_set [bar],p [bar],x [mm]")


def test_a_value_is_no_unit() -> None:
    assert not read_heading("@ 200 kPa", "").meaning


def test_a_set_point_is_absolute_where_the_pressure_is(tmp_path: Path) -> None:
    time = 0.01 * np.arange(600)
    p_set = AMBIENT + np.where(time > 2.0, 2e5, 0.0)
    p = AMBIENT + 2e5 * (1.0 - np.exp(-np.clip(time - 2.0, 0.0, None) / 0.1))
    noise = np.random.default_rng(3).normal(0.0, 1.0, (2, 600))
    columns = [time, p_set, p + 100.0 * noise[0], 1e-7 * (p - AMBIENT) + 1e-5 * noise[1]]
    lines = [",".join(f"{v:.17g}" for v in row) for row in np.column_stack(columns)]
    (tmp_path / "a.csv").write_text("\n".join(["time [s],p_set [Pa],p [Pa],x [m]", *lines]))
    run = pam.new(tmp_path / "rig", [tmp_path / "a.csv"]).data.runs[0]
    assert run.inputs["p_set"][0] == pytest.approx(0.0, abs=1e-6)
    assert run.inputs["p_set"][-1] == pytest.approx(2e5)


@pytest.mark.parametrize("head", ["x [Zoll]", "x's course [INCH]", "length [Zoll]"])
def test_what_no_formula_can_hold_is_scaled_and_turned(tmp_path: Path, head: str) -> None:
    """A unit or a name that a formula cannot read, of a position that falls where the pressure rises."""
    data = drafted(tmp_path, f"time [s],p_set [bar],p [bar],{head}", x=lambda x: (0.2 - x) / 0.0254)
    x = data.runs[0].measurements["x"]
    np.testing.assert_allclose(x - x.mean(), CONTRACTION - CONTRACTION.mean(), atol=1e-6)


@pytest.mark.parametrize("head", ["strain [%]", "strain's course [%]", "strain_pct"])
def test_a_strain_that_falls_where_the_pressure_rises_is_turned_round(
    tmp_path: Path, head: str
) -> None:
    """By its formula, and by its gain where no formula can hold it."""
    data = drafted(tmp_path, f"time [s],p_set [bar],p [bar],{head}", x=lambda x: -x / 0.24e-2)
    x = data.runs[0].measurements["x"]
    np.testing.assert_allclose(x - x.mean(), CONTRACTION - CONTRACTION.mean(), atol=1e-6)
    assert "its sign is turned round" in remarks(tmp_path)


@pytest.mark.parametrize(
    ("name", "turned"), [("x [mm]", True), ("strain [%]", True), ("length [mm]", False)]
)
def test_a_length_says_itself_which_way_it_counts(tmp_path: Path, name: str, turned: bool) -> None:
    drafted(tmp_path, f"time [s],p_set [bar],p [bar],{name}", x=lambda x: 100 - 1e3 * x)
    assert ("its sign is turned round" in remarks(tmp_path)) == turned


@pytest.mark.full
@pytest.mark.parametrize(
    ("first", "factor", "unit"),
    [(0.0, 1e3, "ms"), (0.0, 1e6, "us"), (1.7e9, 1e3, "ms"), (1.7e9, 1e6, "us"), (0.0, 1e9, "ns")],
)
def test_whole_numbers_of_time(tmp_path: Path, first: float, factor: float, unit: str) -> None:
    data = drafted(
        tmp_path, "time,p_set [bar],p [bar],x [mm]", time=lambda t: np.round((first + t) * factor)
    )
    content = tomllib.loads((tmp_path / "rig/experiment.toml").read_text(encoding="utf-8"))
    assert content["columns"]["time"]["unit"] == unit
    assert float(np.ptp(data.runs[0].time)) == pytest.approx(3.99, rel=1e-6)


def test_days_of_a_spreadsheet(tmp_path: Path) -> None:
    data = drafted(
        tmp_path, "Time,p_set [bar],p [bar],x [mm]", time=lambda t: 45_323.5 + t / 86_400
    )
    assert float(np.ptp(data.runs[0].time)) == pytest.approx(3.99, rel=1e-4)


def test_a_file_named_twice_does_not_count_twice(tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    file.write_text("time [s],p_set [bar],p [bar],x [mm]\n0,1,0,0\n1,1,1,9\n")
    with pytest.raises(InputError, match="named twice"):
        pam.new(tmp_path / "rig", [file, tmp_path / "." / "run.csv"])


def test_times_of_day_beside_two_valves_are_refused_in_words(tmp_path: Path) -> None:
    file = tmp_path / "run.csv"
    file.write_text("time,u_in [A],u_out [A],p [kPa],x [mm]\n" + "12:00 PM,0.1,0,5,1\n" * 9)
    with pytest.raises(InputError, match="'time' is text: dates are read as 2024-"):
        pam.new(tmp_path / "rig", [file])
