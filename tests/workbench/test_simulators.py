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
    def simulated(instance: Instance, data: Any, values: dict[str, float], runs: list[Any]) -> Any:
        names = [run.name for run in runs]
        assert instance.lock.acquire(blocking=False), "asked twice at once"
        try:
            if values.get("breaks") and "run 1" in names:
                raise SimulationFailure("it broke")
            threading.Event().wait(0.02)
            return tuple(f"{run} simulated" for run in names), dict.fromkeys(names, "begins")
        finally:
            instance.lock.release()

    monkeypatch.setattr(simulators, "simulated", simulated)
    monkeypatch.setattr(simulators, "processors", lambda: 3)
    return []


def recordings(count: int) -> Any:
    return SimpleNamespace(runs=[SimpleNamespace(name=f"run {i}") for i in range(count)])


def several(made: list[Instance]) -> Simulators:
    def another() -> Instance:
        made.append(Instance())
        return made[-1]

    return Simulators(another(), another)


def test_runs_come_back_in_their_order_and_all_instances_are_freed(made: list[Instance]) -> None:
    together = several(made)
    data = recordings(7)
    simulated = together.run(data, {})
    assert simulated.runs == tuple(f"run {i} simulated" for i in range(7))
    assert len(simulated.starts) == 7
    assert len(made) == 3
    together.close()
    assert all(instance.closed for instance in made)


def test_a_run_that_breaks_down_is_named_and_leaves_no_instance_at_work(
    made: list[Instance],
) -> None:
    together = several(made)
    data = recordings(4)
    for _ in range(3):
        broken = together.run(data, {"breaks": 1.0})
        assert list(broken.failures) == ["run 1"] and len(broken.runs) == 3
        assert len(together.run(data, {}).runs) == 4
    together.close()


def test_one_run_needs_one_instance(made: list[Instance]) -> None:
    together = several(made)
    together.run(recordings(1), {})
    assert len(made) == 1
    together.close()
