"""Runs side by side: each instance of the model does one thing at a time, and what comes of it is in order."""

from __future__ import annotations

import threading
from types import SimpleNamespace
from typing import Any

import pytest

from pam_cosim.errors import SimulationFailure
from pam_cosim.simulation import Simulator
from pam_cosim.workbench import simulators
from pam_cosim.workbench.simulators import Simulators


class Instance(Simulator):
    """A model that simulates nothing, and notices when it is asked twice at once."""

    def __init__(self) -> None:
        self.lock, self.closed = threading.Lock(), False

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[Instance]:
    def simulated(instance: Instance, data: Any, values: dict[str, float], runs: list[str]) -> Any:
        assert instance.lock.acquire(blocking=False), "asked twice at once"
        try:
            if values.get("breaks") and "run 1" in runs:
                raise SimulationFailure("it broke")
            threading.Event().wait(0.02)
            return tuple(f"{run} simulated" for run in runs), dict.fromkeys(runs, "begins")
        finally:
            instance.lock.release()

    monkeypatch.setattr(simulators, "simulated", simulated)
    monkeypatch.setattr(simulators, "processors", lambda: 3)
    return []


def several(made: list[Instance]) -> Simulators:
    def another() -> Instance:
        made.append(Instance())
        return made[-1]

    return Simulators(another(), another)


def test_runs_come_back_in_their_order_and_all_instances_are_freed(made: list[Instance]) -> None:
    together = several(made)
    data = SimpleNamespace(runs=[f"run {i}" for i in range(7)])
    runs, starts = together.run(data, {})  # type: ignore[arg-type]
    assert runs == tuple(f"run {i} simulated" for i in range(7)) and len(starts) == 7
    assert len(made) == 3
    together.close()
    assert all(instance.closed for instance in made)


def test_a_run_that_breaks_down_leaves_no_instance_at_work(made: list[Instance]) -> None:
    together = several(made)
    data = SimpleNamespace(runs=[f"run {i}" for i in range(4)])
    for _ in range(3):
        with pytest.raises(SimulationFailure, match="it broke"):
            together.run(data, {"breaks": 1.0})  # type: ignore[arg-type]
        assert len(together.run(data, {})[0]) == 4  # type: ignore[arg-type]
    together.close()


def test_one_run_needs_one_instance(made: list[Instance]) -> None:
    together = several(made)
    together.run(SimpleNamespace(runs=["run 0"]), {})  # type: ignore[arg-type]
    assert len(made) == 1
    together.close()
