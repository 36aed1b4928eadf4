"""What rival methods get of a rig: whole stretches of samples, and the published formula of the wind tunnel."""

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from benchmarks.real_rigs import again, formulas
from benchmarks.real_rigs.dynamic import WIDEST, measured_parts
from benchmarks.real_rigs.rows import Course

TIME = np.linspace(0, 10, 101)


def course(measured: np.ndarray, *inputs: np.ndarray) -> Course:
    return Course("c", TIME, np.column_stack(inputs or [TIME]), measured, -np.inf)


def test_a_course_is_divided_where_many_samples_are_missing_and_bridged_where_few_are() -> None:
    measured = TIME.copy()
    measured[:20] = measured[60 : 61 + WIDEST] = measured[40:45] = np.nan
    first, second = measured_parts(course(measured))
    assert (first.time[0], first.time[-1]) == (TIME[20], TIME[59])
    assert second.time[0] == TIME[61 + WIDEST] and second.time[-1] == TIME[-1]
    assert len(first.inputs) == len(first.measured) == 40
    whole = course(TIME)
    assert measured_parts(whole) == [whole]


def test_model_a2_is_what_its_equation_says() -> None:
    load = np.where(TIME < 3, 0.01, np.where(TIME < 7, 1.0, 0.0))
    pull, drag = 150.0, 1.5e-3
    found = formulas.fan(course(TIME, load, load), np.array([pull, drag]), 0)

    def rate(t: float, w: np.ndarray) -> np.ndarray:
        u = load[np.searchsorted(TIME, t, side="right") - 1]
        return np.asarray(pull * (max(u, 0.1) if u > 0 else 0.0) ** 3 - drag * w * np.abs(w))

    options = {"rtol": 1e-9, "atol": 1e-9, "max_step": 0.01}
    true = solve_ivp(rate, (0, 10), [formulas.IDLE], t_eval=TIME, **options).y[0]
    assert found == pytest.approx(true, rel=0.01)


def test_the_course_of_an_equal_fan_has_its_load_in_the_place_of_this_one() -> None:
    twin = formulas.of_twin(course(TIME, 1 + TIME, 2 + TIME, 3 + TIME))
    assert np.array_equal(twin.inputs, np.column_stack([2 + TIME, 1 + TIME, 3 + TIME]))


def test_all_is_made_again_in_order_and_rivals_only_where_they_can_be(tmp_path: Path) -> None:
    def modules(rivals: Path | None) -> list[str]:
        listed = again.steps(tmp_path, Path("mirror"), rivals)
        return [command[2].rpartition(".")[2] for command in listed]

    assert modules(None) == ["fetch", "tunnel", "ours", "table", "named", "bands"]
    every = ["fetch", "tunnel", "ours", "rivals", "table", "pictures", "named", "bands"]
    assert modules(Path("rivals/bin/python")) == every
    first = next(again.steps(tmp_path, Path("mirror"), None))
    assert first[-2:] == ["--mirror", "mirror"]
