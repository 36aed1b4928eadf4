"""Headings of English, German and French labs, and descriptions of variables, mean the same things."""

from __future__ import annotations

import pytest

from tests.drafting.headings import HEADINGS, read_heading


@pytest.mark.parametrize(
    ("name", "unit", "meaning", "read_unit"),
    [
        ("Zeit", "s", "time", "s"),
        ("temps écoulé", "ms", "time", "ms"),
        ("Muskeldruck", "bar", "pressure", "bar"),
        ("Versorgungsdruck", "bar", "supply pressure", "bar"),
        ("pression d'alimentation", "kPa", "supply pressure", "kPa"),
        ("Solldruck", "bar", "set pressure", "bar"),
        ("consigne", "bar", "set pressure", "bar"),
        ("p_set", "kPa", "set pressure", "kPa"),
        ("pressure_command", "bar", "set pressure", "bar"),
        ("source_kPa_gauge", "", "supply pressure", "kPa"),
        ("knee_r_kPa_gauge", "", "pressure", "kPa"),
        ("hip_l_kPa", "", "pressure", "kPa"),
        ("CH1", "bar", "pressure", "bar"),
        ("p abs", "bar", "pressure", "bar"),
        ("x_mm", "", "contraction", "mm"),
        ("x_in", "", "contraction", "in"),
        ("pos_in", "", "contraction", "in"),
        ("u_in", "", "inlet command", ""),
        ("p_in", "", "pressure", ""),
        ("valve_pos_in", "", "inlet command", ""),
        ("Weg", "mm", "contraction", "mm"),
        ("déplacement", "mm", "contraction", "mm"),
        ("Kontraktion", "%", "ratio", "%"),
        ("Longueur", "mm", "length", "mm"),
        ("Laenge", "", "length", ""),
        ("Kraft", "N", "force", "N"),
        ("load", "kg", "force", "kg"),
        ("Raumtemperatur", "°C", "ambient temperature", "°C"),
        ("I_ein", "mA", "inlet current", "mA"),
        ("Ventilstrom Auslass", "A", "exhaust current", "A"),
        ("vanne admission", "", "inlet command", ""),
        ("valve in", "", "inlet command", ""),
        ("PWM", "%", "command", "%"),
        ("pressure V", "", "voltage", "V"),
        ("Druck", "Bar", "pressure", "bar"),
        ("Bemerkung", "", "", ""),
        ("knee_r_rad", "", "", "rad"),
        ("p_min", "", "pressure", ""),
        ("F_kg", "", "force", "kg"),
        ("load_kg", "", "force", "kg"),
        ("LOAD_KG", "", "force", "kg"),
        ("Kraft kg", "", "force", "kg"),
        ("F_g", "", "force", ""),
        ("valve_in_mA", "", "inlet current", "mA"),
        ("valve_out_ma", "", "exhaust current", "mA"),
        ("valve_A", "", "command", ""),
        ("valve_A1", "", "command", ""),
        ("T_degC", "", "temperature", "degC"),
        ("t_s", "", "time", "s"),
        ("T_amb", "", "ambient temperature", ""),
        ("T_amb_C", "", "ambient temperature", "degC"),
        ("Tamb", "degC", "ambient temperature", "degC"),
        ("p_amb", "kPa", "ambient pressure", "kPa"),
        ("p_Umg", "mbar", "ambient pressure", "mbar"),
        ("P_atm", "", "ambient pressure", ""),
        ("P_atm_kPa", "", "ambient pressure", "kPa"),
        ("Patm", "", "ambient pressure", ""),
        ("baro", "hPa", "ambient pressure", "hPa"),
        ("barometric pressure", "hPa", "ambient pressure", "hPa"),
        ("p", "atm", "pressure", "atm"),
        ("pm_atm", "", "pressure", "atm"),
        ("p1_atm", "", "pressure", "atm"),
        ("p_set_atm", "", "set pressure", "atm"),
    ],
)
def test_headings(name: str, unit: str, meaning: str, read_unit: str) -> None:
    reading = read_heading(name, unit)
    assert (str(reading.meaning), reading.unit) == (meaning, read_unit)


@pytest.mark.parametrize(
    ("name", "description", "unit", "meaning"),
    [
        ("u_in", "Current of the inlet valve", "A", "inlet current"),
        ("v2", "Command of the exhaust valve: 0 shut, 1 open", "1", "exhaust command"),
        ("q", "Gauge pressure of the source, as it droops", "Pa", "supply pressure"),
        ("p", "Gauge pressure in the muscle", "Pa", "pressure"),
        ("w", "Set point of the regulator, gauge", "Pa", "set pressure"),
        ("s", "Imposed contraction", "m", "contraction"),
        ("eps", "Contraction ratio", "1", "ratio"),
        ("L", "Length", "m", "length"),
        ("R", "Pull of the muscle", "N", "force"),
    ],
)
def test_variables(name: str, description: str, unit: str, meaning: str) -> None:
    assert str(HEADINGS.meaning_of(name, description, unit)) == meaning


def test_absolute_and_known() -> None:
    assert read_heading("Druck 1", "bar a").absolute and read_heading("p", "bar abs").absolute
    assert not read_heading("p", "bar").absolute
    for name in ("p_psia", "pressure_psia", "p_bara", "p_set_kPaa"):
        assert read_heading(name, "").absolute, name
    assert not any(read_heading(name, "").absolute for name in ("p_psi", "p_psig", "p_para"))
    assert (
        read_heading("Muskeldruck", "bar").known_share
        > read_heading("p Kanal sieben", "bar").known_share
    )


@pytest.mark.parametrize(
    ("kind", "largest", "unit"),
    [("pressure", 0.6, "MPa"), ("pressure", 6.0, "bar"), ("pressure", 600.0, "kPa"), ("force", 600.0, "N"),
     ("contraction", 0.05, "m"), ("contraction", 50.0, "mm"), ("temperature", 25.0, "degC"),
     ("temperature", 300.0, "K"),
     ("current", 0.35, "A"), ("current", 350.0, "mA"), ("ratio", 0.2, ""), ("ratio", 20.0, "%"),
     ("ambient pressure", 1.013, "bar"), ("ambient pressure", 14.7, "psi"), ("ambient pressure", 101.3, "kPa"),
     ("ambient pressure", 1013.0, "hPa"), ("ambient pressure", 101_300.0, "Pa")],
)  # fmt: skip
def test_units_by_magnitude(kind: str, largest: float, unit: str) -> None:
    assert HEADINGS.usual_unit(kind, largest) == unit
