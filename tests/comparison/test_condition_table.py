"""Scores by two parameters of the runs, against numbers computed by hand and the printed Table 3."""

from __future__ import annotations

import csv
import importlib.util
import json
import sys
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim import InputError
from pam_cosim.comparison import Comparison, Condition, ConditionTable, compare
from pam_cosim.files import write_json
from pam_cosim.model.interface import Variable
from tests.comparison.fake import FakeSimulator, data_set, run
from tests.documentation.pages import other_pictures, text_of

TIME = [0.0, 1.0, 2.0, 3.0]
UNITS = {"load.m": Variable("load.m", "kg"), "frequency": Variable("frequency", "Hz")}
X = {"x": Variable("x", "m")}
EXAMPLE = Path(__file__).parents[2] / "examples" / "correlation-table" / "run.py"


@pytest.fixture
def comparison() -> Comparison:
    """Model: the load at every time but the last; two loads, two frequencies, one condition twice, one missing."""

    def conditions(load: float, frequency: float) -> dict[str, float]:
        return {"load.m": load, "frequency": frequency}

    simulator = FakeSimulator(
        lambda t, known: {"x": known["load.m"] * np.array([1.0, 1.0, 1.0, 2.0])}, X
    )
    simulator.interface.parameters.update(UNITS)
    runs = [
        run("a", TIME, parameters=conditions(1, 0.5), x=[1, 1, 1, 3]),
        run("b", TIME, parameters=conditions(1, 2), x=[1, 1, 1, 2]),
        run("c", TIME, parameters=conditions(10, 0.5), x=[10, 10, 10, 24]),
        run("d", TIME, parameters=conditions(10 * (1 + 1e-15), 0.5), x=[12, 10, 10, 20]),
    ]
    return compare(simulator, data_set(runs, {"x": 2.0}))


def test_cells_by_hand(comparison: Comparison) -> None:
    table = comparison.table("load.m", "frequency")
    assert table.rows == Condition("load.m", "kg", (1.0, 10.0))
    assert table.columns == Condition("frequency", "Hz", (0.5, 2.0))
    np.testing.assert_array_equal(table.samples, [[4, 4], [8, 0]])
    np.testing.assert_allclose(table.rmse, [[0.5, 0.0], [np.sqrt((16 + 4) / 8), np.nan]])
    np.testing.assert_allclose(table.chi2_reduced, table.rmse**2 / 4)
    modelled, measured = [10.0, 10, 10, 20] * 2, [10.0, 10, 10, 24, 12, 10, 10, 20]
    assert table.correlation[1, 0] == pytest.approx(np.corrcoef(modelled, measured)[0, 1])
    mean, deviation = table.by_row("rmse")
    np.testing.assert_allclose(mean, [0.25, np.sqrt(2.5)])
    np.testing.assert_allclose(deviation, [0.25, 0.0])


def test_printed_table_of_dzahir_and_yamamoto() -> None:
    """Columns of DY Table 3. The printed means of 1.5 and 2 Hz, 0.843 and 0.752, are not those of the printed cells."""
    cells = np.array(
        [[.929, .894, .815, .732], [.937, .903, .825, .739], [.952, .883, .847, .763], [.955, .898, .839, .741],
         [.941, .895, .853, .797], [.948, .904, .861, .799]]
    )  # fmt: skip
    loads, rates = (
        Condition("load", "kg", (5, 10, 15, 20, 25, 30)),
        Condition("frequency", "Hz", (0.5, 1, 1.5, 2)),
    )
    table = ConditionTable("DY", "x", "m", loads, rates, cells, cells, cells, np.ones(cells.shape))
    mean, deviation = table.by_column("correlation")
    np.testing.assert_allclose(mean, [0.944, 0.896, 0.840, 0.762], atol=5e-4)
    np.testing.assert_allclose(deviation, [0.009, 0.007, 0.016, 0.027], atol=5e-4)
    assert "0.9437 ± 0.0090" in str(table)


def test_files(comparison: Comparison, tmp_path: Path) -> None:
    table = comparison.table("load.m", "frequency", "x")
    table.to_csv(tmp_path / "t.csv")
    head, *rows = csv.reader((tmp_path / "t.csv").open())
    assert head[:4] == ["signal", "statistic [unit]", "load.m [kg]", "frequency = 0.5 Hz"]
    assert head[4:] == ["frequency = 2.0 Hz", "mean", "sd"]
    assert rows[4] == ["x", "rmse [m]", "1.0", "0.5", "0.0", "0.25", "0.25"]
    assert rows[5][:5] == ["x", "rmse [m]", "10.0", repr(float(table.rmse[1, 0])), ""]
    pam.draw(table, tmp_path / "t.png")
    assert (tmp_path / "t.png").read_bytes().startswith(b"\x89PNG")
    write_json(tmp_path / "c.json", comparison.as_dict() | {"table": table.as_dict()})
    written = json.loads((tmp_path / "c.json").read_text())
    assert written["runs"][1]["parameters"] == {"load.m": 1, "frequency": 2}
    assert written["table"]["rmse"]["values"][1][1] is None
    again = pam.load(pam.save(table, tmp_path / "t.npz"))
    assert str(again) == str(table) and again.rows == table.rows


def test_names_that_cannot_be(comparison: Comparison) -> None:
    for rows, columns, signal, message in (
        (
            "load",
            "frequency",
            None,
            "no parameter 'load' to make a table by; did you mean 'load.m'",
        ),
        ("load.m", "load.m", None, "'load.m' on both sides"),
        ("load.m", "frequency", "y", "no run has samples of 'y'"),
    ):
        with pytest.raises(InputError, match=message):
            comparison.table(rows, columns, signal)


@pytest.mark.full
def test_example(tmp_path: Path) -> None:
    """Friction that grows by load and frequency, which the model lacks: the error grows towards that corner."""
    spec = importlib.util.spec_from_file_location("example_correlation_table", EXAMPLE)
    assert spec is not None and spec.loader is not None
    example = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = example
    spec.loader.exec_module(example)
    example.main(tmp_path)
    (tmp_path / "table.png").rename(tmp_path / "correlation-table.png")
    assert other_pictures(tmp_path, by_processor=True) == []
    rows = list(csv.reader((tmp_path / "table.csv").open()))
    assert len(rows) == 1 + 3 * (4 + 2) and len(rows[0]) == 3 + 6 + 2
    correlations = np.array([[float(v) for v in row[3:9]] for row in rows[1:5]])
    assert correlations.argmin() == correlations.size - 1
    errors = np.array([[float(v) for v in row[3:9]] for row in rows[13:17]])
    page = text_of("fitting.md")
    assert f"The correlation is {correlations.min():.3f} or more everywhere" in page
    assert f"right at 10 kg and 1.5 Hz ({errors.min():.1f})" in page and errors.argmin() == 6 + 4
    assert f"{errors.max():.0f} at 30 kg and 2 Hz" in page and errors.argmax() == errors.size - 1
