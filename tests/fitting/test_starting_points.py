"""Which of several points a fit starts from."""

from __future__ import annotations

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fitting.solve import _starts


class Seen:
    """Costs of points, by a glance at two runs and by all."""

    def __init__(self, glances: list[float], costs: list[float]) -> None:
        self.glances, self.costs = glances, costs

    def is_over(self) -> bool:
        """Nothing limits it."""
        return False

    def start_afresh(self, z: Array) -> None:
        """They have no start values."""

    def glance(self, z: Array) -> float:
        return self.glances[int(z[0])]

    def squares(self, z: Array) -> float:
        return self.costs[int(z[0])]


def order(glances: list[float], costs: list[float]) -> list[int]:
    points = [np.array([float(i)]) for i in range(len(glances))]
    return [int(z[0]) for z in _starts(Seen(glances, costs), points)]  # type: ignore[arg-type]


def test_the_best_by_a_glance_goes_first() -> None:
    assert order([3.0, 1.0, 2.0], [30.0, 10.0, 20.0]) == [1, 2, 0]


def test_the_stated_start_goes_first_where_all_runs_say_so() -> None:
    """A parameter that acts in other runs than the two that a glance sees."""
    assert order([3.0, 2.9, 4.0], [10.0, 5000.0, 20.0]) == [0, 1, 2]


def test_points_that_cannot_be_simulated_are_left_out() -> None:
    assert order([np.inf, 2.0, 1.0], [1.0, 2.0, np.inf]) == [1]
