"""How much a search may take, and how much it took."""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from typing import TypeVar

from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting import FitOptions
from pam_cosim.measurement import DataSet
from pam_cosim.processes.workers import run_tasks
from pam_cosim.simulation import Simulator

Task = TypeVar("Task")
Result = TypeVar("Result")


@dataclass
class Effort:
    """The limits of a search and what it took so far; all searches of a diagnosis share one.

    Attributes:
        deadline: of ``time.monotonic``, after which no more models are tried.
        most_simulations: likewise; unlike a deadline it ends a search at the same model on every machine.
        simulations: runs that were simulated so far, with sensitivities or without.
    """

    deadline: float = math.inf
    most_simulations: float = math.inf
    simulations: int = 0

    @classmethod
    def of(cls, data: DataSet, deadline: float, simulations: int | None) -> Effort:
        """The effort of a diagnosis; where no limit is stated, so many simulations as its rows allow.

        Args:
            data: the measurement. deadline: infinite where none is stated. simulations: at most; None: not stated.
        """
        if simulations is None and deadline == math.inf:
            rows = [len(run.time) for run in data.fit_runs]
            simulations = CRITERIA.search.effort * len(rows) // max(sum(rows), 1)
        return cls(deadline, math.inf if simulations is None else simulations)

    def affords(self, simulations: int) -> bool:
        """Whether so many more reach no limit."""
        return self.deadline == math.inf and self.simulations + simulations < self.most_simulations

    @property
    def spent(self) -> bool:
        """Whether a limit is reached."""
        return self.simulations >= self.most_simulations or time.monotonic() >= self.deadline

    def part(self, share: float) -> Effort:
        """An effort that may take so much of what this one took, and ends with it."""
        simulations_left = min(share * self.simulations, self.most_simulations - self.simulations)
        return Effort(self.deadline, simulations_left)

    def bounded(self, options: FitOptions) -> FitOptions:
        """Options of a fit that ends where this effort is spent, and looks for no other place to start from."""
        return replace(
            options,
            simulations=self.most_simulations - self.simulations,
            deadline=self.deadline,
            screened_starts=0,
            second_look=False,
        )

    @contextmanager
    def counting(self) -> Iterator[None]:
        """Counts what this process simulates meanwhile."""
        before = Simulator.simulations
        try:
            yield
        finally:
            self.simulations += Simulator.simulations - before

    def run_tasks(
        self,
        function: Callable[[Task], Result],
        tasks: Sequence[Task],
        on_crash: Callable[[Task], Result],
        done: Callable[[Result], None],
        workers: int | None,
    ) -> list[Result]:
        """The same as ``processes.workers.run_tasks``; what the tasks simulate is counted."""
        results = run_tasks(
            partial(_counted, function),
            tasks,
            lambda task: (on_crash(task), 0),
            lambda counted: done(counted[0]),
            workers,
        )
        self.simulations += sum(simulations for _, simulations in results)
        return [result for result, _ in results]


def _counted(function: Callable[[Task], Result], task: Task) -> tuple[Result, int]:
    """The result of a task, and how many runs it simulated."""
    before = Simulator.simulations
    return function(task), Simulator.simulations - before
