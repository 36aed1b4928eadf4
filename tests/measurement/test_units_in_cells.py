"""Cells of a number and its unit are numbers, where a column has one unit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.table import Layout
from pam_cosim.measurement.text_table import text_columns


def written(folder: Path, text: str) -> Path:
    file = folder / "a.csv"
    file.write_text(text, encoding="utf-8")
    return file


@pytest.mark.parametrize(
    ("text", "unit"),
    [
        ("Time,p,x\n0 sec,1,2\n0.01 sec,2,3\n0.02 sec,3,4\n", "sec"),
        ("Time;p;x\n0,00 s;1;2\n0,01 s;2;3\n0,02 s;3;4\n", "s"),
        ("Time [s],p,x\n0s,1,2\n1e-2s,2,3\n2e-2s,3,4\n", "s"),
        ("Time\tp\tx\n0 s\t1 bar\t2 mm\n0.01 s\t2 bar\t3 mm\n0.02 s\t3 bar\t4 mm\n", "s"),
    ],
    ids=["points", "commas", "beside the heading's", "in all columns"],
)
def test_one_unit_in_all_cells(tmp_path: Path, text: str, unit: str) -> None:
    file = written(tmp_path, text)
    columns = read_table(file).columns
    assert columns["Time"].unit == unit and list(columns) == ["Time", "p", "x"]
    np.testing.assert_allclose(columns["Time"].values, [0.0, 0.01, 0.02])
    np.testing.assert_array_equal(columns["p"].values, [1, 2, 3])
    assert text_columns(file, Layout()) == {}


def test_cells_of_several_units_are_text(tmp_path: Path) -> None:
    file = written(tmp_path, "t,p,note\n0,1,900 ms\n1,2,1 s\n2,2,late\n")
    assert list(text_columns(file, Layout())) == ["note"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("t [ms],p,x\n0 s,1,2\n1 s,2,3\n", "the unit is 'ms' in its heading, but 's' in its cells"),
        ("t,p,x\n" + "0 s,1,2\n" * 500 + "1 min,2,3\n", "'1 min' has another unit .*, 's'"),
    ],
)
def test_units_that_contradict(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(InputError, match=words):
        read_table(written(tmp_path, text))
