"""A crash ends one task, not the study."""

from __future__ import annotations

import os

import pytest

from pam_cosim.diagnosis.workers import run_tasks
from tests.diagnosis.tasks import process_of, slow_square, square_or_die


@pytest.mark.parametrize("workers", [1, 2])
def test_crash_loses_one_task_only(workers: int) -> None:
    crashed: list[int] = []
    told: list[int] = []

    def on_crash(number: int) -> int:
        crashed.append(number)
        return -1

    tasks = [1, 2, -3, 4, 5, -6, 7]
    found = run_tasks(square_or_die, tasks, on_crash, told.append, workers)
    assert found == [1, 4, -1, 16, 25, -1, 49]
    assert crashed == [-3, -6]
    assert sorted(told) == sorted(found)


def test_results_keep_the_order_of_the_tasks() -> None:
    told: list[int] = []
    assert run_tasks(slow_square, [0, 9], lambda n: -1, told.append, 2) == [0, 81]
    assert sorted(told) == [0, 81]


def test_no_tasks() -> None:
    assert run_tasks(square_or_die, [], lambda n: -1, lambda n: None) == []


def test_tasks_run_in_other_processes_and_side_by_side() -> None:
    found = run_tasks(process_of, [1, 2, 3, 4], lambda n: -1, lambda n: None, 2)
    assert os.getpid() not in found
    assert len(dict.fromkeys(found)) == 2
