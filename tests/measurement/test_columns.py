"""Columns renamed, ignored, derived and zeroed in ``experiment.toml``; each fault named with its line."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement import read_data_set
from pam_cosim.measurement.table import split_heading
from tests.measurement.bench import MODEL, describe

LAB = """\
Zeit [s];Druck 1;Weg (mm);Spannung [V];Bemerkung
0,0;1,0;30;0,5;
0,1;1,2;31;0,5;Anfang
0,2;2,1;29;1,5;
0,3;;28;2,5;Ende
"""
HEAD = f'model = "{MODEL}"\n'
RUN = '[[runs]]\nfile = "lab.csv"\n'
COLUMNS = """\
[recording]
ignore = ["Bemerkung"]
[columns]
time = { column = "Zeit" }
p = { column = "Druck 1", unit = "bar", zero = { from = "0 s", to = "100 ms" } }
x = { formula = '"32 mm" - Weg' }
T = { formula = '(Spannung - "0.5 V") * "10 K/V" + "20 degC"' }
"""


@pytest.fixture
def lab(tmp_path):
    def write(experiment: str, text: str = LAB):
        (tmp_path / "experiment.toml").write_text(experiment, encoding="utf-8")
        (tmp_path / "lab.csv").write_text(text, encoding="utf-8")
        return tmp_path

    return write


def test_a_lab_s_file_becomes_a_run(lab):
    data = read_data_set(lab(HEAD + COLUMNS + RUN), describe)
    run = data.runs[0]
    np.testing.assert_allclose(run.time, [0, 0.1, 0.2, 0.3])
    np.testing.assert_allclose(run.measurements["p"], [-0.1e5, 0.1e5, 1e5, np.nan], atol=1e-6)
    np.testing.assert_allclose(run.measurements["x"], [2e-3, 1e-3, 3e-3, 4e-3])
    np.testing.assert_allclose(run.measurements["T"], [293.15, 293.15, 303.15, 313.15])
    assert list(run.measurements) == ["p", "x", "T"]
    assert any("the zero of p, 1.1 bar, is the mean of 2 samples" in note for note in data.notes())
    assert any("semicolons, decimal commas" in note for note in data.notes())


def test_a_run_may_state_its_own(lab):
    own = (
        COLUMNS
        + RUN
        + "[runs.columns]\nx = { column = 3, unit = 'cm' }\n[runs.recording]\nignore = ['Be*']\n"
    )
    run = read_data_set(lab(HEAD + own), describe).runs[0]
    np.testing.assert_allclose(run.measurements["x"], [0.30, 0.31, 0.29, 0.28])


def test_a_formula_may_use_the_entries_above_it_and_signs(lab):
    text = (
        COLUMNS + "eps = { formula = \"-x / '32 mm'\" }\n".replace("'32 mm'", '\\"32 mm\\"') + RUN
    )
    run = read_data_set(lab(HEAD + text), describe).runs[0]
    np.testing.assert_allclose(run.measurements["eps"], -run.measurements["x"] / 0.032)


def test_numbers_count_the_columns_of_the_file(lab):
    text = COLUMNS.replace('["Bemerkung"]', '["Bemerkung", "Druck 1"]').replace(
        '"Druck 1", unit', "4, unit"
    )
    run = read_data_set(lab(HEAD + text + RUN), describe).runs[0]
    np.testing.assert_allclose(run.measurements["p"], [0, 0, 1e5, 2e5])


def test_a_file_without_time_has_an_interval(lab):
    text = "p [kPa];x [mm]\n0,5;1\n1,5;3\n"
    run = read_data_set(lab(HEAD + '[recording]\ninterval = "20 ms"\n' + RUN, text), describe).runs[
        0
    ]
    np.testing.assert_allclose(run.time, [0, 0.02])


# (name, text replaced, replacement, text on the line that is named, words)
FAULTS = [
    ("no such column", '"Druck 1"', '"Druck 2"', "Druck 2", ["lab.csv has no column 'Druck 2'", "did you mean"]),
    ("no such number", '"Druck 1"', "9", "column = 9", ["no column 9", "that are read: 1, 2, 3, 4"]),
    ("wrong unit", '"bar"', '"mm"', None, ["'mm'", "'Pa'"]),
    ("units in a formula", '"32 mm"', '"32 K"', "- Weg", ["units of the formula", "kelvin"]),
    ("unknown name", "- Weg", "- Wge", "Wge", ["there is no 'Wge'", "did you mean 'Weg'"]),
    ("syntax", "- Weg", "- - * Weg", "Weg", ["expected"]),



    ("a quantity that is none", '"32 mm"', '"abc"', "- Weg", ["not a number with a unit"]),
    ("a huge power", "- Weg", "- ((9^99)^99)^99 * Weg", "9^99", ["cannot be evaluated"]),
    ("deep brackets", "- Weg", "- " + "(" * 120 + "Weg" + ")" * 120, "((((", ["deep within one another"]),
    ("too long", "- Weg", "- Weg" + " + Weg" * 100, "Weg + Weg", ["300"]),
    ("unit of a formula", "- Weg'", "- Weg', unit = \"mm\"", "- Weg", ["a formula and a unit"]),
    ("no rest", '"100 ms"', '"-1 s"', "Druck 1", ["no sample in the rest interval", "0 to 0.3 s"]),

    ("half a rest", ', to = "100 ms"', "", "Druck 1", ["'to' is missing"]),
    ("misspelt key", "column = \"Zeit\"", "colum = \"Zeit\"", "colum =", ["did you mean 'column'"]),


    ("zero of a temperature", "+ \"20 degC\"'", "+ \"20 degC\"', zero = {from=0,to=1}", "degC", ["needs a unit"]),
    ("separator", "ignore", 'separator = "|"\nignore', "separator", ["'|'", "'tab'"]),
]  # fmt: skip


@pytest.mark.parametrize("case", FAULTS, ids=[case[0] for case in FAULTS])
def test_faults(lab, case):
    _, old, new, place, words = case
    experiment = HEAD + COLUMNS + RUN
    assert old in experiment
    folder = lab(experiment.replace(old, new, 1))
    with pytest.raises(InputError) as caught:
        read_data_set(folder, describe)
    error = caught.value
    if place is None:
        assert (error.file, error.line, error.column) == (folder / "lab.csv", 1, "p")
    else:
        text = (folder / "experiment.toml").read_text()
        assert (error.file, error.line) == (
            folder / "experiment.toml",
            text[: text.index(place)].count("\n") + 1,
        )
    for word in words:
        assert word in error.message


def test_a_column_that_nobody_knows_says_what_to_do(lab):
    columns = COLUMNS.replace('"Bemerkung"', '"Spannung"').replace("T =", "#")
    with pytest.raises(InputError) as caught:
        read_data_set(
            lab(HEAD + columns + RUN, LAB.replace("Anfang", "1").replace("Ende", "2")), describe
        )
    assert (caught.value.line, caught.value.column) == (1, "Bemerkung")
    assert "ignore = [...]" in caught.value.message and "[columns]" in caught.value.message


@pytest.mark.parametrize(
    ("heading", "entry", "kelvin"),
    [
        ("T [degC]", 'offset = "0.5 degC"', 293.65),
        ("T [K]", 'offset = "-273.15 K"', -253.15),
        ("T [degC]", 'offset = "0.9 degF"', 293.65),
        ("U [V]", 'column = "U", gain = "10 K/V", offset = "20 degC"', 493.15),
    ],
)
def test_the_offset_of_a_temperature(lab, heading: str, entry: str, kelvin: float) -> None:
    """0.5 degC more is 0.5 K more, and no 273.65 K; where a gain makes a temperature of volts, it is one itself."""
    text = f"time [s],{heading}\n0,20\n1,20\n"
    run = read_data_set(lab(f"{HEAD}[columns]\nT = {{ {entry} }}\n{RUN}", text), describe).runs[0]
    np.testing.assert_allclose(run.measurements["T"], kelvin)


def test_a_formula_may_read_the_time(lab) -> None:
    """It had used the column up, so that the recording had no time any more."""
    columns = "[columns]\neps = { formula = 'time / \"10 s\"' }\n"
    text = "time [s],x [mm]\n0,1\n1,2\n"
    run = read_data_set(lab(HEAD + columns + RUN, text), describe).runs[0]
    np.testing.assert_array_equal(run.time, [0.0, 1.0])
    np.testing.assert_allclose(run.measurements["eps"], [0.0, 0.1])


@pytest.mark.parametrize(
    ("heading", "parts"),
    [
        ("p (bar(a))", ("p", "bar(a)")),
        ("p(kPa abs)", ("p", "kPa abs")),
        ("p / bar (g)", ("p", "bar (g)")),
        ("p in psia", ("p", "psia")),
        ("u in (mA)", ("u in", "mA")),
        ("heat (W/(m2.K))", ("heat", "W/(m2.K)")),
        ("sensor (left)", ("sensor (left)", "")),
        ("p (10^5 Pa)", ("p (10^5 Pa)", "")),
    ],
)
def test_a_unit_in_round_brackets_or_behind_a_stroke(heading, parts):
    assert split_heading(heading) == parts
