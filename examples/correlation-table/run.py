"""A table as DY Table 3 over four loads and six frequencies: python examples/correlation-table/run.py [FOLDER].

The data come from the independent vertical rig of examples/dzahir-yamamoto: random waves of pressure, whose turning
points inside the range make minor loops, and noise. The existing model is fitted to every other condition, as on a
chessboard, and judged in all of them. Writes the table into FOLDER (default: a temporary one) as CSV and picture.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "dzahir-yamamoto"), str(HERE.parent.parent)]

import vertical_rig as rig  # noqa: E402

import pam_cosim as pam  # noqa: E402
from pam_cosim.comparison import ConditionTable  # noqa: E402

LOADS = (5.0, 10.0, 20.0, 30.0)  # kg
FREQUENCIES = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0)  # Hz


def table_of(
    folder: Path, loads: Sequence[float] = LOADS, frequencies: Sequence[float] = FREQUENCIES
) -> ConditionTable:
    """The rig's measurement, the model fitted to it, and the scores by load and frequency."""
    title = f"empirical muscle at {len(loads)} loads and {len(frequencies)} frequencies"
    written = rig.write_data_set(folder / "data", loads=loads, frequencies=frequencies, title=title)
    return pam.fit(pam.read(written)).comparison.table("load.m", "frequency", "x")


def main(folder: Path) -> None:
    """Table on the screen, as CSV and as picture."""
    table = table_of(folder)
    table.to_csv(folder / "table.csv")
    pam.draw(table, folder / "table.png")
    print(table)


if __name__ == "__main__":
    with TemporaryDirectory() as place:
        main(Path(sys.argv[1] if len(sys.argv) > 1 else place))
