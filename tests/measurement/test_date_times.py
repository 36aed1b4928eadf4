"""Columns of dates with times of day: seconds since the first, or what to write instead."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.table import Layout
from pam_cosim.measurement.text_table import text_columns


def table_of(folder: Path, text: str, layout: Layout | None = None):
    file = folder / "run.csv"
    file.write_text(text, encoding="utf-8")
    return read_table(file, layout or Layout())


@pytest.mark.parametrize(
    ("heading", "cells"),
    [
        ("Timestamp,p [bar]", ["2024-03-12 23:59:59.990", "2024-03-13 00:00:00.000", "2024-03-13T00:00:00.015"]),
        ("t;p / bar", ["2024-03-12T10:00:00,99Z", "2024-03-12T10:00:01Z", "2024-03-12T11:00:01.015+01:00"]),
        ("t [datetime]\tp [bar]", ["2024-03-12T10:00:00.990000", "2024-03-12T10:00:01", "2024-03-12T10:00:01.015"]),
    ],
)  # fmt: skip
def test_seconds_since_the_first(tmp_path: Path, heading: str, cells: list[str]) -> None:
    separator = next(one for one in "\t;," if one in heading)
    rows = [f"{cell}{separator}{k}" for k, cell in enumerate(cells)]
    table = table_of(tmp_path, "\n".join(["2024-03-12 10:00:00", heading, *rows]))
    time, p = table.columns.values()
    assert time.unit == "s" and time.since == cells[0]
    np.testing.assert_allclose(time.values, [0.0, 0.01, 0.025], atol=1e-9)
    np.testing.assert_allclose(p.values, [0.0, 1.0, 2.0])


@pytest.mark.parametrize(
    "cells",
    [
        ["23:59:59.99", "00:00:00.000", "00:00:00.015"],
        ["9:59:59,99", "10:00:00,000", "10:00:00,015"],
        ["12.03.2024 23:59:59,99", "13.03.2024 00:00:00,000", "13.03.2024 00:00:00,015000"],
    ],
)
def test_a_time_of_day_counts_from_the_first_past_midnight(
    tmp_path: Path, cells: list[str]
) -> None:
    rows = [f"12.03.2024;{cell};{k}" for k, cell in enumerate(cells)]
    table = table_of(tmp_path, "\n".join(["Datum;Zeit;p [bar]", *rows]), Layout(ignore=("Datum",)))
    np.testing.assert_allclose(table.columns["Zeit"].values, [0.0, 0.01, 0.025], atol=1e-9)


def test_an_empty_cell_is_a_missing_date_and_another_text_an_error(tmp_path: Path) -> None:
    rows = "time,p [bar]\n2024-03-12 10:00:00,1\n,2\n2024-03-12 10:00:02,3\n"
    values = table_of(tmp_path, rows).columns["time"].values
    np.testing.assert_allclose(values, [0.0, np.nan, 2.0])
    for wrong in ("later", "2024-13-45 10:00:00", "2024-03-12T10:00:03Z"):
        with pytest.raises(InputError, match="no date and time as the first one") as caught:
            table_of(tmp_path, f"{rows}{wrong},4\n")
        assert (caught.value.line, caught.value.column) == (5, "time")


@pytest.mark.parametrize("day", ["12.03.2024", "12.3.24", "2024.03.12", "12/03/2024", "2024-03-12"])
def test_a_day_alone_is_text(tmp_path: Path, day: str) -> None:
    """It was called a number that is grouped by thousands."""
    text = f"Datum;t;p\n{day};0,5;1\n{day};1,5;2\n"
    file = tmp_path / "a.csv"
    file.write_text(text)
    assert text_columns(file, Layout()) == {"Datum": (day,)}
    with pytest.raises(InputError, match=r"is a date without a time of day.*ignore = .\"Datum\""):
        read_table(file)
