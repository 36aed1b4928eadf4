"""Every fault gives one InputError that names file, line, column and what to do."""

from __future__ import annotations

import os

import pytest

from pam_cosim.errors import InputError, ModelError
from pam_cosim.measurement import read_data_set
from tests.measurement.bench import EXPERIMENT, RUN_01, describe

TOML, ONE, TWO = "experiment.toml", "run-01.csv", "run-02.csv"


def line(text: str, part: str) -> int:
    """Line of the first occurrence."""
    return text[: text.index(part)].count("\n") + 1


def refusal(folder) -> InputError:
    with pytest.raises(InputError) as caught:
        read_data_set(folder, describe)
    return caught.value


# (name, text replaced, replacement, line or None, column, words of the message)
CSV_FAULTS = [
    ("wrong unit", "p [kPa]", "p [kg]", 1, "p", ["'kg'", "'Pa'", "kPa"]),
    ("missing unit", "x [mm]", "x", 1, "x", ["unit is missing", "mm", "'x [unit]'"]),
    ("unknown column", "u_in [A]", "u_inn [A]", 1, "u_inn", ["did you mean 'u_in'", "p_supply"]),
    (
        "parameter as column",
        "u_in [A]",
        "load.m [kg]",
        1,
        "load.m",
        ["is a parameter", "[runs.parameters]"],
    ),
    ("no time", "time [s]", "eps", 1, None, ["'time [s]'"]),
    ("bad heading", "x [mm]", "x [mm", 1, "x [mm", ["'name [unit]'"]),
    ("empty heading", "x [mm]", "", 1, "column 6", ["column 6", "ignore"]),
    ("no header", RUN_01.split("\n")[0] + "\n", "", 1, None, ["header"]),
    ("text in a number", "1.25", "1.25mm", 5, "x", ["'1.25mm'", "not a number"]),
    ("not a number", "1.25", "NaN", 5, "x", ["not a finite number", "leave the cell empty"]),
    ("overflow", "1.25", "1e999", 5, "x", ["too large"]),
    ("decimal comma in quotes", "1.25", '"1,25"', 5, "x", ["decimal comma"]),
    ("time back", "0.2,", "0.05,", 5, "time", ["time goes back", "0.1 s", "0.05 s"]),
    ("third row at a time", "0.2,", "0.1,", 5, "time", ["third row"]),
    ("input missing", "0.1,0.35", "0.1,", 4, "u_in", ["empty", "inputs"]),
    ("ragged row", "1.25,", "", 5, None, ["6 cells", "has 7"]),
    ("open quote", "1.25", '"1.25', 5, None, ["separated by commas"]),
]


@pytest.mark.parametrize("case", CSV_FAULTS, ids=[case[0] for case in CSV_FAULTS])
def test_faults_in_a_recording(make, case):
    _, old, new, at, column, words = case
    folder = make((ONE, old, new))
    error = refusal(folder)
    assert (error.file, error.line, error.column) == (folder / ONE, at, column)
    for word in words:
        assert word in error.message


CSV_FILES = [
    ("empty", b"", None, "empty"),
    ("only header", b"time [s],p [kPa]\n", 1, "no rows"),
    ("one row", b"time [s],p [kPa]\n0,1\n", 2, "only one row"),
    ("decimal commas", b"time [s],p [kPa]\n0,5,1,5\n", 2, "decimal points"),
    ("not UTF-8", b"time [s],p [kPa]\n0,1\n1,\xb0\n", 3, "not a number"),
    ("UTF-16 without mark", "time [s],p [\u00b0]\n0,1\n".encode("utf-16-le"), 1, "UTF-8"),
    ("a picture", b"\x89PNG\r\n\x1a\n\x00\x00", 2, "UTF-8"),
]


@pytest.mark.parametrize("case", CSV_FILES, ids=[case[0] for case in CSV_FILES])
def test_files_that_are_no_recording(make, case):
    _, content, at, word = case
    folder = make()
    (folder / ONE).write_bytes(content)
    error = refusal(folder)
    assert (error.file, error.line) == (folder / ONE, at)
    assert word in error.message


SIGNAL = "[signals.p]"

# (name, text replaced, replacement, text on the line that is named, words of the message)
TOML_FAULTS = [
    ("syntax", "title = ", "title := ", "title := ", ["not valid TOML"]),
    ("unknown key", "title =", "titel =", "titel", ["unknown key 'titel'", "did you mean 'title'"]),
    ("missing bound", "min = 0.5, ", "", '"valve.C_A"', ["'min' is missing"]),
    (
        "missing file",
        '\nfile = "run-02.csv"',
        " # second",
        "[[runs]] # second",
        ["'file' is missing"],
    ),
    ("unquoted name", '"load.m" = "2.27', 'load.m = "2.27', "load.m", ["quotes"]),
    (
        "one run table",
        EXPERIMENT[EXPERIMENT.index("[[runs]]") :],
        '[runs]\nfile="run-01.csv"',
        "[runs]",
        ["[[runs]]"],
    ),
    ("role", '"holdout"', '"test"', "role", ["'test'", "'fit' or 'holdout'"]),
    ("signals as value", '[signals.p]\nsigma = "0.5 kPa"', "[signals]\np = 5", "p = 5", ["table"]),
    ("truth as value", '"2.27 kg"', "true", '"load.m"', ["number"]),
    (
        "unknown bench",
        "Rig.Benches.Isotonic",
        "Rig.Isotonc",
        "model =",
        ["'Rig.Isotonc'", "no class"],
    ),
    ("no bench", 'model = "Rig.Benches.Isotonic"', "", None, ["model is missing"]),
    (
        "unknown parameter",
        '"load.m" = "2',
        '"load.mm" = "2',
        "load.mm",
        ["'load.mm'", "did you mean 'load.m'"],
    ),
    ("unknown signal", "signals.x", "signals.y", "signals.y", ["no output 'y'", "eps"]),
    ("number without unit", '"2.27 kg"', "2.27", '"load.m"', ["needs a unit", '"2.27 kg"']),
    ("text without number", '"2.27 kg"', '"heavy"', '"load.m"', ["'heavy'", '"0.7 kg"']),
    ("decimal comma", '"2.27 kg"', '"2,27 kg"', '"load.m"', ["decimal comma"]),
    ("wrong dimension", '"2.27 kg"', '"2.27 N"', '"load.m"', ["'N'", "'kg'"]),
    ("unit on a pure number", '"10 %"', '"10 mm"', '"muscle.mu_fb" = {', ["without dimension"]),
    ("huge integer", "= 0.015", "= 1" + "0" * 400, '"muscle.mu_fb"', ["too large"]),
    (
        "outside the range",
        '"2.27 kg"',
        '"-2.27 kg"',
        '"load.m"',
        ["'-2.27 kg'", "range, 0 to inf kg"],
    ),
    ("reversed bounds", "min = 0.5", "min = 0.95", '"valve.C_A"', ["reversed"]),
    (
        "start outside",
        "max = 0.9",
        "max = 0.9, start = 1",
        '"valve.C_A"',
        ["start value", "outside"],
    ),
    ("start twice", '"10 %"', '"10 %", start = 0.01', '"muscle.mu_fb" = {', ["keep one"]),
    (
        "free and fixed in a run",
        '"load.m" = "5 kg"',
        '"valve.C_A" = 0.6',
        '"valve.C_A" = 0.6',
        ["free"],
    ),
    ("sigma zero", '"0.5 kPa"', '"0 kPa"', 'sigma = "0 kPa"', ["greater than zero"]),
    ("sigma in a wrong unit", '"0.5 kPa"', '"0.5 mm"', 'sigma = "0.5 mm"', ["sigma of p", "'mm'"]),
    ("no such run", "run-02.csv", "run-03.csv", "run-03.csv", ["does not exist"]),
    ("folder up", "run-02.csv", "../run-02.csv", "../run-02.csv", ["leaves the folder"]),
    ("absolute", "run-02.csv", "/etc/passwd", "/etc/passwd", ["leaves the folder"]),
    ("zero byte", "run-02.csv", "\\u0000", "u0000", ["not visible"]),
    ("listed twice", "run-02.csv", "./run-01.csv", "./run-01.csv", ["listed twice"]),
    *(
        (f"{key} {name}", SIGNAL, f"[{table}]\n{key} = {value}\n{SIGNAL}", f"{key} =", words)
        for table, key, name, value, words in (
            (
                "recording",
                "names",
                "as text",
                '"p"',
                ['names must be a list of texts such as ["time [s]"'],
            ),
            (
                "recording",
                "names",
                "of a number",
                "[1]",
                ["names must be a list", "'1' is not in quotes"],
            ),
            ("recording", "header_line", "as text", '"3"', ["'3' is not a whole number"]),
            (
                "effects",
                "expect",
                "of a number",
                "[2]",
                ["expect must be a list", "'2' is not in quotes"],
            ),
            (
                "columns",
                "p",
                "as number",
                "{ column = 1.5 }",
                ["'column': '1.5' is neither the name of a column"],
            ),
            ("columns", "p", "as truth", "{ column = true }", ["nor its number, such as 2"]),
            ("columns", "p", "hidden", r'{ column = "\u001b" }', ["'column': the character"]),
            ("columns", "p", "fitted", '{ fit = "x" }', ["write true, false, 'gain' or 'offset'"]),
        )
    ),
    ("truth in words", "title =", 'periodic = "no"\ntitle =', "periodic", ["write true or false"]),
    ("loggers as a value", "role =", "loggers = 3\nrole =", "loggers", ["[[runs.loggers]]"]),
    (
        "table of a text",
        "[signals.p]",
        '[recording]\ntable = "rig"\n[signals.p]',
        "table =",
        ["table selects one of several", "run-01.csv has only one"],
    ),
    (
        "no fit run",
        'file = "run-01.csv"',
        'file = "run-01.csv"\nrole = "holdout"',
        "[[runs]]",
        ["at least"],
    ),
]


@pytest.mark.parametrize("case", TOML_FAULTS, ids=[case[0] for case in TOML_FAULTS])
def test_faults_in_the_experiment(make, case):
    _, old, new, place, words = case
    folder = make((TOML, old, new))
    error = refusal(folder)
    text = (folder / TOML).read_text()
    assert error.file == folder / TOML
    assert error.line == (None if place is None else line(text, place))
    for word in words:
        assert word in error.message


def test_a_syntax_error_has_a_column(make):
    assert refusal(make((TOML, "title = ", "title := "))).column == 7


def test_a_model_error_stays_one_and_names_the_line(make):
    error = refusal(make((TOML, "Rig.Benches.Isotonic", "Nothing")))
    assert isinstance(error, ModelError)
    assert str(error).startswith(f"{error.file}:3: ")


def test_a_chosen_model_is_not_the_files_fault(make):
    with pytest.raises(ModelError) as caught:
        read_data_set(make(), describe, model="Nothing")
    assert caught.value.file is None


def test_a_signal_nobody_measured(make):
    folder = make((ONE, "x [mm]", "eps [%]"))
    error = refusal(folder)
    assert error.line == line(EXPERIMENT, "[signals.x]")
    assert "no run has a sample" in error.message


@pytest.mark.skipif(not hasattr(os, "symlink"), reason="needs symbolic links")
def test_a_link_out_of_the_folder(make, tmp_path):
    (tmp_path / "secret.csv").write_text(RUN_01)
    folder = make()
    (folder / TWO).unlink()
    (folder / TWO).symlink_to(tmp_path / "secret.csv")
    error = refusal(folder)
    assert error.line == line(EXPERIMENT, "run-02.csv")
    assert "leaves the folder" in error.message


def test_no_data_set_there(tmp_path):
    assert refusal(tmp_path).file == tmp_path
    assert "pam-cosim new NEW-FOLDER RECORDINGS" in refusal(tmp_path).message
    assert refusal(tmp_path / "nowhere").file == tmp_path / "nowhere"
    assert "folder" in refusal(tmp_path / ("x" * 5000)).message
