"""A crash ends one task, not the study."""

from __future__ import annotations

import os
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from pam_cosim.diagnosis.search.trial import Trial, attempted
from pam_cosim.errors import ModelChange
from pam_cosim.processes.workers import on_one_thread, run_tasks
from tests.diagnosis.tasks import process_beside_another, slow_square, square_or_die


@pytest.mark.full
@pytest.mark.parametrize("workers", [1, 2])
def test_crash_loses_one_task_only(workers: int) -> None:
    crashed: list[int] = []
    told: list[int] = []

    def on_crash(number: int) -> int:
        crashed.append(number)
        return -1

    tasks = [1, 2, -3, 4, 5, -6, 7]
    results = run_tasks(square_or_die, tasks, on_crash, told.append, workers)
    assert results == [1, 4, -1, 16, 25, -1, 49]
    assert crashed == [-3, -6]
    assert sorted(told) == sorted(results)


def test_results_keep_the_order_of_the_tasks() -> None:
    told: list[int] = []
    assert run_tasks(slow_square, [0, 9], lambda n: -1, told.append, 2) == [0, 81]
    assert sorted(told) == [0, 81]


def test_tasks_run_in_other_processes_and_side_by_side(tmp_path: Path) -> None:
    results = run_tasks(
        process_beside_another, [str(tmp_path)] * 2, lambda _: -1, lambda _: None, 2
    )
    assert os.getpid() not in results
    assert len(dict.fromkeys(results)) == 2


def test_linear_algebra_keeps_to_one_thread_and_is_given_back_the_others() -> None:
    def threads() -> list[int]:
        return [pool["num_threads"] for pool in threadpool_info()]

    np.linalg.inv(np.eye(2))  # loads the linear algebra
    with threadpool_limits(limits=2):
        before = threads()
        assert set(on_one_thread(threads)()) == {1}
        assert threads() == before


def test_a_model_that_changes_ends_the_study(monkeypatch: pytest.MonkeyPatch) -> None:
    """Effects that could not be built any more counted as tried, and the verdict named what was left."""

    def changed(*arguments: object, **options: object) -> None:
        raise ModelChange("a Modelica file changed since this began: begin again")

    monkeypatch.setattr("pam_cosim.diagnosis.search.trial.build_source", changed)
    composition = SimpleNamespace(parameters={}, text="", name="Rig")
    data = SimpleNamespace(differentiated=(), fit_runs=())
    fields = {"composition": composition, "data": data, "files": (), "library": ""}
    trial = cast(Trial, SimpleNamespace(**fields, reference=None))
    with pytest.raises(ModelChange):
        attempted(trial, lambda *_: None, brief=True)
