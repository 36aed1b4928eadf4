"""The score of the benchmark with rigs of others: what counts, what is lost, and when the goal is met."""

import json
from pathlib import Path

import numpy as np
import pytest

from benchmarks.real_rigs import table
from benchmarks.real_rigs.folders import Rig, Run, write_rig
from benchmarks.real_rigs.rows import LOST, overall, read_rows, score
from tests.documentation.pages import absent, other_numbers

TIME = np.linspace(0, 1, 11)


def written(folder: Path) -> Path:
    def run(name: str, size: float, score_from: float = -np.inf) -> Run:
        return Run(name, {"time [s]": TIME, "p [kPa]": size * TIME}, score_from)

    runs = {"fitted": [run("a", 10), run("b", 12)], "outside": [run("c", 20, 0.5)]}
    rig = Rig("r", "a rig", "p", (), 'model = "M"', runs, 0.1, repeats=(("a", "b"),))
    write_rig(folder, rig)
    return folder / "r"


def test_errors_are_in_ranges_over_what_is_scored(tmp_path: Path) -> None:
    rows = read_rows(written(tmp_path))
    assert rows.range == 20
    early = np.where(TIME < 0.5, 1e6, 0.0)  # before it is scored nothing counts
    found = score(rows, {"fitted": {"a": 10 * TIME + 2}, "outside": {"c": 20 * TIME + early + 4}})
    assert found["fitted"]["a"] == pytest.approx(0.1)
    assert found["outside"]["c"] == pytest.approx(0.2)
    assert found["fitted"]["b"] == LOST  # a run that nobody predicted


def test_repeatability_is_the_difference_of_repeats_over_the_root_of_two(tmp_path: Path) -> None:
    rows = read_rows(written(tmp_path))
    difference = np.sqrt(np.mean((2 * TIME) ** 2))
    assert rows.repeatability == pytest.approx(difference / np.sqrt(2) / 20)
    assert overall({"x": 3.0, "y": 4.0}) == pytest.approx(np.sqrt(12.5))


def test_the_page_is_made_from_the_results_that_are_kept() -> None:
    import json

    results = json.loads(table.KEPT.read_text(encoding="utf-8"))
    assert (table.HERE / "TABLE.md").read_text(encoding="utf-8") == table.page(results)


def test_the_table_on_the_page_is_that_of_the_results() -> None:
    results = json.loads(table.KEPT.read_text(encoding="utf-8"))
    rows = {}
    for rig in (*table.DYNAMIC, *table.STATIC):
        smallest = [
            table.best(results, rig, methods, role)
            for methods in (("base",), table.RIVALS, ("verdict",))
            for role in ("within", "outside")
        ]
        rows[rig] = [100 * found[0] for found in smallest if found is not None]
    assert other_numbers("real-rigs.md", rows) == []


def test_the_verdicts_of_repeats_on_the_page_are_those_of_the_results() -> None:
    results = json.loads(table.KEPT.read_text(encoding="utf-8"))
    rows = table.verdicts(results)
    assert len(rows) == len(table.REPEATS)
    counts = [[int(n) for n in row[1].split(" of ")] for row in rows]
    alike, every = (sum(column) for column in zip(*counts, strict=True))
    families = sum(int(row[2].split(" of ")[0]) for row in rows)
    total = f"| {alike} of {every} ({100 * alike / every:.0f} %) | {families} of {every} "
    cells = [f"| {row[1]}, `" for row in rows] + [f"| {row[2]} |" for row in rows]
    assert absent([total, *cells], "real-rigs.md") == []
