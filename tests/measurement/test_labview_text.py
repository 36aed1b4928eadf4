"""Rows of LabVIEW's texts lack cells that say nothing: of comments, and of times that follow from an interval."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.measurement.formats import read_table

ABOVE = """LabVIEW Measurement\t
X_Columns\tNo
***End_of_Header***\t
\t
Channels\t1\t
Samples\t3\t
X_Dimension\tTime\t
X0\t{begin}\t
Delta_X\t{steps}
***End_of_Header***\t
X_Value\tp [bar]\tComment
"""


def table(folder: Path, rows: str, begin: str = "0,5E+0", steps: str = "0,010000\t") -> dict:
    file = folder / "a.lvm"
    file.write_text(ABOVE.format(begin=begin, steps=steps) + rows)
    return {name: column.values for name, column in read_table(file).columns.items()}


@pytest.mark.parametrize("rows", ["\t0,1\n\t0,2\n\t0,3\n", "\t0,1\t\n\t0,2\n\t0,3\t\n"])
def test_times_follow_from_the_interval(tmp_path: Path, rows: str) -> None:
    read = table(tmp_path, rows)
    np.testing.assert_allclose(read["X_Value"], [0.5, 0.51, 0.52])
    np.testing.assert_allclose(read["p"], [0.1, 0.2, 0.3])
    assert np.isnan(read["Comment"]).all()


def test_channels_with_intervals_of_their_own_have_no_common_time(tmp_path: Path) -> None:
    rows = "\t0.1\t0.2\t0.5\t\n\t0.3\t0.4\t0.6\t\n"
    file = tmp_path / "a.lvm"
    above = ABOVE.format(begin="0.0\t0.0", steps="0.01\t0.02\t").replace(
        "[bar]", "[bar]\tx [mm]\tF [N]"
    )
    file.write_text(above + rows)
    assert np.isnan(read_table(file).columns["X_Value"].values).all()
