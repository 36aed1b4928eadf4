"""What rival methods get of a rig: whole stretches of samples, and the published formula of the wind tunnel."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from benchmarks.real_rigs import formulas
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
