"""Numbers whose thousands are grouped: read where a column leaves no doubt, else refused as before."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement.formats import read_table


@pytest.mark.parametrize(
    ("cells", "decimal"),
    [
        (["999.5", "1,234.5", "1,235"], "."),
        (["0.000", "500.000", "1.000.000"], "."),
        (["999,5", "1.234,5", "12.345,25"], ","),
        (["999,5", "1 234,5", "1 235"], ","),
        (["999.5", "1'234.5", "1'235'000"], "."),
        (["1\u202f234,5", "1\u202f235,5", "1\u202f236,5"], ","),
    ],
)
def test_a_column_of_grouped_numbers(tmp_path: Path, cells: list[str], decimal: str) -> None:
    file = tmp_path / "a.csv"
    rows = [f"{cell};{k}{decimal}5" for k, cell in enumerate(cells)]
    file.write_text("\n".join(["t [ms];p [bar]", *rows]) + "\n", encoding="utf-8")
    sign = next(
        s
        for s in (",", ".", " ", "'", "\u202f")
        if s != decimal or cells[0] == "0.000"
        if s in "".join(cells)
    )
    wanted = [float(cell.replace(sign, "").replace(",", ".")) for cell in cells]
    table = read_table(file)
    np.testing.assert_allclose(table.columns["t"].values, wanted)
    np.testing.assert_allclose(table.columns["p"].values, [0.5, 1.5, 2.5])


def test_a_long_column_is_read_alike_in_all_blocks(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    rows = [f"{k * 50:,};{k}".replace(",", ".") for k in range(41_000)]
    file.write_text("t [ms];p [bar]\n" + "\n".join(rows) + "\n", encoding="utf-8")
    np.testing.assert_allclose(read_table(file).columns["t"].values, 50.0 * np.arange(41_000))


def test_what_may_have_decimals_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text("t [s];p [bar]\n0.5;1,234\n1.5;2,345\n", encoding="utf-8")
    with pytest.raises(InputError, match="may be grouped by thousands, or have a decimal comma"):
        read_table(file)


def test_blanks_stand_between_a_quote_and_the_separator(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text(
        '"time [s]" , "p, of the muscle [kPa]" , x\n0, 1, 2\n1, 2, 3\n', encoding="utf-8"
    )
    assert list(read_table(file).columns) == ["time", "p, of the muscle", "x"]
