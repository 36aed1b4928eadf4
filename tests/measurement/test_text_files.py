"""Texts as loggers and spreadsheets write them arrive as the same numbers; what is ambiguous is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.table import Layout

PLAIN = "time [s],p [kPa],T [°C]\n0.0,1.5,20\n0.1,,20.5\n0.2,-3.25e1,21\n"
EXPECTED = {
    "time": ("s", [0, 0.1, 0.2]),
    "p": ("kPa", [1.5, np.nan, -32.5]),
    "T": ("°C", [20, 20.5, 21]),
}


def semicolons(text: str) -> str:
    return text.replace(",", ";").replace(".", ",")


def tabs(text: str) -> str:
    return text.replace(",", "\t")


def units_below(text: str) -> str:
    return text.replace("time [s],p [kPa],T [°C]", "time,p,T\ns,kPa,°C")


VARIANTS = {
    "as documented": PLAIN.encode(),
    "semicolons and decimal commas": semicolons(PLAIN).encode(),
    "tabs": tabs(PLAIN).encode(),
    "byte order mark": PLAIN.encode("utf-8-sig"),
    "UTF-16": PLAIN.encode("utf-16"),
    "UTF-32": PLAIN.encode("utf-32"),
    "Latin-1": PLAIN.encode("latin-1"),
    "units in their own row": units_below(PLAIN).encode(),
    "units in round brackets": PLAIN.replace("[", "(").replace("]", ")").encode(),
    "units after a stroke": b"time / s,p in kPa,T / degC\n0.0,1.5,20\n0.1,,20.5\n0.2,-3.25e1,21\n",
    "lines above": f"Test 12\nDate: 2024-02-01, 10:30\n\nRate,1000\n{PLAIN}".encode(),
    "lines above, as wide": b"Name,A. Smith,\nmuscle,latex,3\n" + units_below(PLAIN).encode(),
    "comments": f"# rig, 3\n% of MATLAB\n// of C\n{PLAIN}# the end\n".encode(),
    "header as a comment": f"# rig, 3\n# {PLAIN}".encode(),
    "separators at the ends of lines": PLAIN.replace("\n", ",\n").encode(),
    "separator stated by the file": b"sep=;\n" + semicolons(PLAIN).encode(),
    "quotes": semicolons(PLAIN).replace("p [kPa]", '"p\n[kPa]"').replace("1,5", '"1,5"').encode(),
    "old line ends": PLAIN.replace("\n", "\r").encode(),
}


@pytest.mark.parametrize("content", VARIANTS.values(), ids=VARIANTS.keys())
def test_variants_hold_the_same_numbers(tmp_path, content):
    file = tmp_path / "run.csv"
    file.write_bytes(content)
    table = read_table(file)
    assert list(table.columns) == list(EXPECTED)
    for name, (unit, values) in EXPECTED.items():
        assert table.columns[name].unit.replace("degC", "°C") == unit
        np.testing.assert_array_equal(table.columns[name].values, values)


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_utf_16_without_a_mark_is_named(tmp_path, encoding):
    file = tmp_path / "run.csv"
    file.write_bytes(PLAIN.encode(encoding))
    with pytest.raises(InputError, match=f'encoding = "{encoding}"'):
        read_table(file)
    assert list(read_table(file, Layout(encoding=encoding)).columns) == list(EXPECTED)


@pytest.mark.parametrize("decimal", [".", ","])
def test_a_number_may_stand_for_a_missing_sample(tmp_path, decimal):
    """It was read as a sample, whatever was stated; a clock that passes the number keeps it."""
    text = "t;x\n0;1.5\n1;-999\n2;-999.0\n3;-9.99e2\n4;3\n".replace(".", decimal)
    file = tmp_path / "run.csv"
    file.write_text(text)
    table = read_table(file, Layout(missing=frozenset({"-999", "3"})))
    np.testing.assert_array_equal(table.columns["x"].values, [1.5, np.nan, np.nan, np.nan, np.nan])
    np.testing.assert_array_equal(table.columns["t"].values, [0, 1, 2, 3, 4])
    assert set(table.missing) == {"-999", "3"}


def written(tmp_path, text: str | bytes, **stated) -> dict[str, list[float]]:
    file = tmp_path / "run.txt"
    file.write_bytes(text if isinstance(text, bytes) else text.encode())
    return {
        name: list(column.values)
        for name, column in read_table(file, Layout(**stated)).columns.items()
    }


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a,b\n1,234\n2,345\n", {"a": [1, 2], "b": [234, 345]}),
        ("a;b\n1,234;0,5\n", {"a": [1.234], "b": [0.5]}),
        ("a;b\n0,001;1,234\n", {"a": [0.001], "b": [1.234]}),
        ("a\tb\n1,234\t1,2345\n", {"a": [1.234], "b": [1.2345]}),
        ("a b\n1,234 1,25\n", {"a": [1.234], "b": [1.25]}),
        ("a;b\n1;2\n3;4\n", {"a": [1, 3], "b": [2, 4]}),
        ("a,b,c,d\n1,5,2,5\n", {"a": [1], "b": [5], "c": [2], "d": [5]}),
    ],
)
def test_a_comma_separates_or_is_decimal_by_what_fits_the_header(tmp_path, text, expected):
    assert written(tmp_path, text) == expected


def test_ignored_columns_may_hold_text(tmp_path):
    text = "t;p;remark;aux 1\n0,5;1;ok, fine;-\n1,5;2;;x\n"
    assert written(tmp_path, text, ignore=("remark", "aux*")) == {"t": [0.5, 1.5], "p": [1, 2]}
    assert written(tmp_path, text, ignore=("*",), required=frozenset({"p"})) == {"p": [1, 2]}


# (name, text, stated, line, column, words)
FAULTS = [
    (
        "ambiguous comma",
        "a;b\n1,234;2,345\n",
        {},
        2,
        None,
        ["'1,234'", "thousands", 'decimal = ","'],
    ),
    ("ambiguous point", "a;b\n1.234;2.345\n", {}, 2, None, ["'1.234'", 'decimal = "."']),
    ("two signs", "a;b\n0,5;1\n1,5;2.5\n", {}, 3, "b", ["'2.5'", "decimal point"]),
    ("thousands", "a;b\n0,5;1\n1,5;1.0021,5\n", {}, 3, "b", ["thousands"]),
    ("first row at fault", "a;b\n0,5;x\n1,5;2\n", {}, 2, "b", ["'x'", "not a number"]),
    ("a word", "a;b\n0,5;1\n1,5;OVLD\n", {}, 3, "b", ["'OVLD'", 'missing = ["OVLD"]']),
    ("no header", "0;1\n1;2\n", {}, 1, None, ["names = ["]),
    ("no rows", "just a letter\nof two lines\n", {}, 2, None, ["no rows"]),
    ("unlike units", "a [ms];b\ns;kPa\n0;1\n", {}, 1, "a", ["'ms'", "'s'"]),
    ("header not there", "a;b\n0;1\n", {"header_line": 9}, 2, None, ["no rows"]),
    ("unknown encoding", "a;b\n0;1\n", {"encoding": "klingon"}, None, None, ["'klingon'"]),
    ("wrong encoding", b"a;b\n0;\xe4\n", {"encoding": "ascii"}, 2, None, ["ascii"]),
]


@pytest.mark.parametrize("case", FAULTS, ids=[case[0] for case in FAULTS])
def test_faults(tmp_path, case):
    _, text, stated, line, column, words = case
    with pytest.raises(InputError) as caught:
        written(tmp_path, text, **stated)
    error = caught.value
    assert (error.file, error.line, error.column) == (tmp_path / "run.txt", line, column)
    for word in words:
        assert word in error.message


@pytest.mark.parametrize(
    ("head", "header_line", "units_line", "words"),
    [
        (
            "s,kPa\ntime,p",
            None,
            1,
            "no line above it holds names; state theirs too, such as header_line = 2",
        ),
        ("time [s],p [kPa]", None, 1, "next to the names, such as 'p [kPa]', leave units_line out"),
        (
            "time [s],p [kPa]",
            1,
            1,
            "header_line and units_line are both 1; where units stand next to",
        ),
    ],
)
def test_a_row_of_units_without_names_above(
    tmp_path: Path, head: str, header_line: int | None, units_line: int, words: str
) -> None:
    (tmp_path / "a.csv").write_text(f"{head}\n0,1\n1,2\n")
    with pytest.raises(InputError) as caught:
        read_table(tmp_path / "a.csv", Layout(header_line=header_line, units_line=units_line))
    assert words in caught.value.message and "None" not in caught.value.message


@pytest.mark.parametrize("cut", ["0,3", "0,"])
def test_a_last_line_that_was_cut_short_is_left_out(tmp_path: Path, cut: str) -> None:
    file = tmp_path / "a.csv"
    file.write_text(f"t,p,x\n0.1,1,2\n0.2,3,4\n{cut}")
    table = read_table(file)
    assert list(table.columns["x"].values) == [2, 4]
    assert "left out: the last line, 4, which was cut short as the recording stopped" in table.notes
    file.write_text(f"t,p,x\n0.1,1,2\n0.2,3,4\n{cut}\n")  # whoever wrote it went on
    with pytest.raises(InputError, match="this row has 2 cells, the header has 3"):
        read_table(file)
