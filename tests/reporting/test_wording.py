from __future__ import annotations

import pytest

from pam_cosim.fitting import Estimate
from pam_cosim.reporting.account.wording import (
    estimate_texts,
    number,
    quantity_text,
    remark,
    unit_text,
)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"), (1.0, "1.00"), (0.19996, "0.200"), (9.996, "10.0"), (99.95, "100"), (999.6, "1000"),
        (-5200.4, "−5200"), (0.00123, "0.00123"), (0.00099999, "0.00100"), (1.234e-5, "1.23×10⁻⁵"),
        (2.5e7, "2.50×10⁷"), (-3e-9, "−3.00×10⁻⁹"), (float("nan"), "–"), (float("inf"), "–"), (None, "–"),
    ],
)  # fmt: skip
def test_numbers(value, text):
    assert number(value) == text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (84e3, "Pa", "84.0 kPa"),
        (2e-4, "m", "0.200 mm"),
        (0.3, "K", "0.300 K"),
        (0.7, "1", "0.700"),
        (3.0, "", "3.00"),
    ],
)
def test_quantities(value, unit, text):
    assert quantity_text(value, unit).replace("\u00a0", " ") == text


def test_units_have_superscripts():
    assert unit_text("W/(m2.K)") == "W/(m²·K)"
    assert unit_text("kg.m-3") == "kg·m⁻³"
    assert unit_text("m3") == "L"


def test_the_interval_decides_the_digits():
    assert estimate_texts(Estimate(0.71234567, 0.7119, 0.7127, "1")) == (
        "0.7123",
        "0.7119 to 0.7127",
    )
    assert estimate_texts(Estimate(0.71234567, 0.7021, 0.7225, "1")) == ("0.712", "0.702 to 0.723")
    assert estimate_texts(Estimate(812.3, 804.1, 820.5, "N/m")) == ("812", "804 to 820")
    assert estimate_texts(Estimate(0.7, 0.1, 1.3, "1")) == ("0.70", "0.10 to 1.30")
    assert estimate_texts(Estimate(2e-7, 1e-7, 3e-7, "m2")) == ("0.20", "0.10 to 0.30")
    assert estimate_texts(Estimate(2e-9, 1e-9, 3e-9, "s")) == ("2.0×10⁻⁹", "1.0×10⁻⁹ to 3.0×10⁻⁹")
    assert estimate_texts(Estimate(0.7, 0.7, 0.7, "1", at_bound=True)) == (
        "0.700",
        "0.700 to 0.700",
    )
    assert estimate_texts(Estimate(0.7, 0.0, 1.0, "1", determined=False)) == ("0.700", "–")
    assert estimate_texts(Estimate(0.0, -1.0, 1.0, "Pa"))[0] == "0"


def test_remarks():
    assert remark(Estimate(1, 0, 2)) == ""
    assert remark(Estimate(1, 0, 2, at_bound=True)) == "at its bound"
    assert remark(Estimate(1, 0, 2, determined=False)) == "not determined by these data"
