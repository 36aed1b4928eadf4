"""``compare --table``: scores by two parameters of the runs on the screen, in files, and what cannot be a table."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import Outcome

Command = Callable[..., Outcome]


@pytest.fixture
def four(data: Path) -> Path:
    """The data set with two volumes by two diameters."""
    text = (data / "experiment.toml").read_text()
    head = (
        text[: text.index("[[runs]]")]
        .replace('"tank.V" = "16.2 l"\n', "")
        .replace('"orifice.d" = "2.71 mm"\n', "")
    )
    csv = (data / "one.csv").read_bytes()
    for volume in ("16.2 l", "20 l"):
        for d in ("2.71 mm", "3 mm"):
            name = f"{volume}-{d}.csv".replace(" ", "")
            (data / name).write_bytes(csv)
            head += f'[[runs]]\nfile = "{name}"\n[runs.parameters]\n"tank.V" = "{volume}"\n"orifice.d" = "{d}"\n'
    (data / "experiment.toml").write_text(head)
    return data


def test_files(command: Command, four: Path, place: Path) -> None:
    words = ("--json", "c.json", "--table-csv", "t.csv", "--table-plot", "t.png")
    done = command("compare", four, "--table", "tank.V", "orifice.d", *words)
    assert done.status == 0, done.err
    assert "correlation of measured and modelled p" in done.out and "mean ± sd" in done.out
    written = json.loads((place / "c.json").read_text())
    assert written["runs"][3]["parameters"]["tank.V"] == pytest.approx(0.02)
    (table,) = written["tables"]
    assert table["rows"] == {"name": "tank.V", "unit": "m3", "values": [0.0162, 0.02]}
    assert table["rmse"]["values"][0][0] == written["runs"][0]["signals"]["p"]["rmse"]
    assert (
        (place / "t.csv")
        .read_text()
        .startswith("signal,statistic [unit],tank.V [m3],orifice.d = 0.00271 m")
    )
    assert (place / "t.png").read_bytes().startswith(b"\x89PNG")
