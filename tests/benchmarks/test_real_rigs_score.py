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


def test_first_samples_that_a_method_was_given_are_not_scored_but_later_gaps_are_lost(
    tmp_path: Path,
) -> None:
    rows = read_rows(written(tmp_path))
    begun = np.where(TIME < 0.15, np.nan, 10 * TIME + 2)
    assert score(rows, {"fitted": {"a": begun}})["fitted"]["a"] == pytest.approx(0.1)
    ended = np.where(TIME > 0.8, np.nan, 10 * TIME)
    assert score(rows, {"fitted": {"a": ended}})["fitted"]["a"] == LOST
    assert score(rows, {"fitted": {"a": 1e9 * TIME}})["fitted"]["a"] == LOST


def test_repeatability_is_the_difference_of_repeats_over_the_root_of_two(tmp_path: Path) -> None:
    rows = read_rows(written(tmp_path))
    difference = np.sqrt(np.mean((2 * TIME) ** 2))
    assert rows.repeatability == pytest.approx(difference / np.sqrt(2) / 20)
    assert overall({"x": 3.0, "y": 4.0}) == pytest.approx(np.sqrt(12.5))


@pytest.mark.parametrize(("outside", "met"), [(0.04, True), (0.06, False)])
def test_the_goal_wants_half_of_the_best_rival_outside(outside: float, met: bool) -> None:
    def result(within: float, beyond: float) -> dict[str, object]:
        return {
            "scores": {"within": {"a": within}, "outside": {"b": beyond}},
            "repeatability": None,
        }

    results = {
        "hose.verdict": result(0.02, outside),
        "hose.NARX": result(0.02, 0.3),
        "hose.formula": result(0.05, 0.1),
    }
    cells, reached = table.goal(results, "hose")
    assert reached is met and cells[1] == "1.00 (NARX)" and cells[2].endswith("(formula)")


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


def test_unknown_verdicts_are_alike_but_their_families_need_not_be() -> None:
    def result(kind: str, families: str) -> dict[str, object]:
        return {"reading": f"{kind}: {families}", "named": families.split("+")}

    first, *others = table.REPEATS["jumps of the robot, three pairs"]
    results = {f"{first}.verdict": result("unknown", "line")}
    results |= {f"{name}.verdict": result("unknown", "valve") for name in others}
    ((_, alike, families, said),) = table.verdicts(results)
    assert (alike, families, said) == ("3 of 3", "2 of 3", "3 unknown")
    results[f"{first}.verdict"] = result("identified", "valve")
    ((_, alike, families, said),) = table.verdicts(results)
    assert (alike, families) == ("2 of 3", "3 of 3")
    assert said == "1 identified: valve; 2 unknown"


def test_rivals_that_were_not_run_again_keep_their_results(tmp_path: Path) -> None:
    (tmp_path / "results").mkdir()
    before = json.loads(table.KEPT.read_text(encoding="utf-8"))
    kept = table.collect(tmp_path)
    assert kept == {name: r for name, r in before.items() if r["method"] in table.RIVALS}
    assert "hose.formula" in kept and "hose.verdict" not in kept
