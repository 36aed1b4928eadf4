"""Units as people and Modelica write them."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.units import UnitError, convert, parse_quantity


@pytest.mark.parametrize(
    ("unit", "target", "factor"),
    [
        ("kPa", "Pa", 1e3), ("bar", "Pa", 1e5), ("psi", "Pa", 6894.757293168), ("barg", "Pa", 1e5),
        ("mm", "m", 1e-3), ("µm", "m", 1e-6), ("l", "m3", 1e-3), ("L", "m3", 1e-3), ("cm^3", "m3", 1e-6),
        ("mA", "A", 1e-3), ("percent", "1", 0.01), ("%", "", 0.01), ("-", "1", 1.0), ("ms", "s", 1e-3),
        ("W/(m2.K)", "W/(m2.K)", 1.0), ("mW/(cm2.K)", "W/(m2.K)", 10.0), ("W/(m^2*degC)", "W/(m2.K)", 1.0),
        ("N.s/m", "N.s/m", 1.0), ("N s/mm", "N.s/m", 1e3), ("kg/(m.s2)", "Pa", 1.0), ("m2", "m2", 1.0),
        ("N/mm²", "Pa", 1e6), ("m·s⁻¹", "m/s", 1.0), ("bar(g)", "Pa", 1e5), ("mbar g", "Pa", 100.0),
        ("MPag", "Pa", 1e6), ("mil", "m", 2.54e-5), ("kp", "N", 9.80665),
        ("1/s", "Hz", 1.0), ("s-1", "1/s", 1.0), ("m**2", "m2", 1.0), ("J/(kg.K)", "J/(kg.K)", 1.0),
    ],
)  # fmt: skip
def test_factors(unit, target, factor):
    np.testing.assert_allclose(
        convert([0.0, 2.0, np.nan], unit, target), [0.0, 2.0 * factor, np.nan], rtol=1e-9
    )


def test_temperatures_have_an_origin_and_differences_none():
    assert float(convert(20.0, "degC", "K")) == pytest.approx(293.15)
    assert float(convert(68.0, "degF", "K")) == pytest.approx(293.15)
    assert float(convert(68.0, "℉", "K")) == pytest.approx(float(convert(20.0, "℃", "K")))
    assert parse_quantity("20 °C", "K") == pytest.approx(293.15)
    assert parse_quantity("0.5 degC", "K", difference=True) == pytest.approx(0.5)
    assert parse_quantity("0.5 K", "K", difference=True) == pytest.approx(0.5)
    assert parse_quantity("0.9 degF", "K", difference=True) == pytest.approx(0.5)


@pytest.mark.parametrize("unit", ["psia", "bara", "bar(a)", "kPa abs", "mbar (abs)", "MPa_abs"])
def test_absolute_pressures_are_refused_with_a_way_out(unit):
    with pytest.raises(UnitError, match=r'absolute.*offset = "-101.325 kPa" under \[columns\]'):
        convert(1.0, unit, "Pa")


@pytest.mark.parametrize(
    "unit", ["kg", "KPa", "(((", "m^", "m/", "9**9**9", "x" * 100, "Pa;", "delta"]
)
def test_units_that_do_not_fit_a_pressure(unit):
    with pytest.raises(UnitError):
        convert(1.0, unit, "Pa")


@pytest.mark.parametrize(
    ("value", "unit", "target", "expected"),
    [
        (60.0, "rpm", "Hz", 1.0),
        (60.0, "cycles/min", "Hz", 1.0),
        (1.0, "Hz", "rad/s", 2 * np.pi),
        (2.0, "kHz", "rad/s", 4e3 * np.pi),
        (360.0, "deg/s", "Hz", 1.0),
        (3.0, "Hz/V", "rad/(s.V)", 6 * np.pi),
        (60.0, "rpm", "rad/s", 2 * np.pi),
        (2.0, "kHz", "Hz", 2e3),
        (2.0, "Hz", "1/s", 2.0),
    ],
)
def test_a_hertz_is_a_turn_a_second(value: float, unit: str, target: str, expected: float) -> None:
    """pint takes a radian for the number 1, so 60 rpm were 6.28 Hz."""
    assert float(convert(value, unit, target)) == pytest.approx(expected)
