"""What a search took, and that a limit in simulations ends it at the same model everywhere."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.selection import select_effects
from pam_cosim.simulation import Simulator
from tests.diagnosis.linear_world import world
from tests.diagnosis.tasks import simulate_so_often


def test_an_effort_is_spent_at_either_limit() -> None:
    assert Effort().affords(10**9) and not Effort().spent
    assert Effort(deadline=time.monotonic()).spent
    assert not Effort(deadline=time.monotonic() + 1e6).spent
    few = Effort(most_simulations=3)
    assert few.affords(2) and not few.affords(3) and not few.spent
    few.simulations = 3
    assert few.spent


@pytest.mark.parametrize("workers", [0, 2])
def test_what_tasks_simulate_is_counted_in_whatever_process(
    workers: int, bench: Callable[[str], Path]
) -> None:
    effort, heard = Effort(), list[int]()
    tasks = [(str(bench("TankFilling")), count) for count in (1, 3)]
    assert effort.run_tasks(simulate_so_often, tasks, lambda _: -1, heard.append, workers) == [1, 3]
    assert effort.simulations == 4 and effort.rows >= 4
    assert sorted(heard) == [1, 3]
    with effort.counting(), Simulator(bench("TankFilling")) as simulator:
        simulator.run([0.0, 1.0])
    assert effort.simulations == 5


def test_a_limit_of_simulations_ends_the_search() -> None:
    pair = world({"LinearBladder": 5.0, "ThermocoupleLag": 5.0})
    pair.effort.most_simulations, pair.effort.simulations = 10, 10
    selection = select_effects(pair, pair.fitted(()))
    assert selection.untried and not pair.tried


@pytest.mark.parametrize(("most", "looked_at"), [(10**6, 30), (10, CRITERIA.search.first_tried)])
def test_the_first_effects_are_looked_at_whatever_the_effort(
    most: int, looked_at: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    search = replace(world({"LinearBladder": 5.0}), data=SimpleNamespace(fit_runs=[None]))
    search.effort.most_simulations, search.effort.simulations = most, 10
    monkeypatch.setattr(search.effort, "run_tasks", lambda look, trials, *_: [*map(look, trials)])
    trials: Any = range(30)
    assert [*search._run_probes(lambda trial: trial, trials)] == [*range(looked_at)]


def test_a_search_that_nobody_limits_ends_without_progress() -> None:
    usual = Effort.of(math.inf, None)
    assert not usual.spent and usual.affords(10**9)
    usual.rows = CRITERIA.search.patience
    assert usual.hopeless and not usual.spent
    usual.note_progress()
    assert not usual.hopeless
    assert Effort.of(1.0, None) == Effort(1.0)
    assert Effort.of(math.inf, 7) == Effort(most_simulations=7)


def test_what_no_progress_left_is_listed() -> None:
    pair = world({"LinearBladder": 5.0, "ThermocoupleLag": 5.0})
    pair.effort.patience = 0
    selection = select_effects(pair, pair.fitted(()))
    assert selection.untried
