"""Units of Modelica as FMI unit definitions."""

from __future__ import annotations

import pytest

from pam_cosim.units import UnitError, base_unit, quotient


@pytest.mark.parametrize(
    ("text", "exponents"),
    [
        ("1", {}),
        ("Pa", {"kg": 1, "m": -1, "s": -2}),
        ("N.s/m", {"kg": 1, "s": -1}),
        ("W/(m2.K)", {"kg": 1, "s": -3, "K": -1}),
        ("J/(kg.K)", {"m": 2, "s": -2, "K": -1}),
        ("kg.m2", {"kg": 1, "m": 2}),
        ("m.s-2", {"m": 1, "s": -2}),
        ("1/s", {"s": -1}),
        ("Hz", {"s": -1}),
        ("rad/s", {"rad": 1, "s": -1}),
        ("V/A", {"kg": 1, "m": 2, "s": -3, "A": -2}),
    ],
)
def test_si_units(text: str, exponents: dict[str, int]) -> None:
    unit = base_unit(text)
    assert dict(unit.exponents) == exponents
    assert (unit.factor, unit.offset) == (1.0, 0.0)


@pytest.mark.parametrize(
    ("display", "unit", "value", "shown"),
    [
        ("bar", "Pa", 250e3, 2.5),
        ("degC", "K", 293.15, 20.0),
        ("mm", "m", 0.0125, 12.5),
        ("kN/m", "N/m", 1500.0, 1.5),
        ("deg", "rad", 3.141592653589793, 180.0),
        ("l/min", "m3/s", 1e-3 / 60, 1.0),
    ],
)
def test_display_units(display: str, unit: str, value: float, shown: float) -> None:
    factor, offset = base_unit(display).display(base_unit(unit))
    assert factor * value + offset == pytest.approx(shown, rel=1e-12, abs=1e-9)


@pytest.mark.parametrize("text", ["", "N*m", "m/s/s", "kg/m.s", "wibble", "m^2", "(m"])
def test_an_unknown_unit_is_named(text: str) -> None:
    with pytest.raises(UnitError, match="unit"):
        base_unit(text)


@pytest.mark.parametrize(
    ("unit", "by", "text"),
    [
        ("m", "s", "m/s"), ("m/s", "s", "m/s2"), ("J/(kg.K)", "kg", "J/(kg2.K)"), ("Pa", "1", "Pa"),
        ("1", "s", "1/s"), ("N", "N", "1"), ("m.s-2", "m", "1/s2"), ("kg/s", "kg/m", "m/s"),
    ],
)  # fmt: skip
def test_quotients_are_units_again(unit: str, by: str, text: str) -> None:
    assert quotient(unit, by) == text
    exponents = dict(base_unit(unit).exponents)
    for symbol, power in base_unit(by).exponents:
        exponents[symbol] = exponents.get(symbol, 0) - power
    assert {s: n for s, n in exponents.items() if n} == dict(base_unit(text).exponents)
