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
from pam_cosim.processes.workers import run_tasks
from pam_cosim.simulation import Simulator

Task = TypeVar("Task")
Result = TypeVar("Result")
Simulated = tuple[int, int]
"""How many runs a process has simulated, and how many rows these have."""


@dataclass
class Effort:
    """The limits of a search and what it took so far; all searches of a diagnosis share one.

    Attributes:
        deadline: of ``time.monotonic``, after which no more models are tried.
        most_simulations: likewise; unlike a deadline it ends a search at the same model on every machine.
        patience: rows that are simulated without visible progress before there is no hope for more.
        simulations: runs that were simulated so far, with sensitivities or without; ``rows`` of these, which say what
            they cost; ``rows_of_progress``: how many there were at the last visible progress.
    """

    deadline: float = math.inf
    most_simulations: float = math.inf
    patience: float = math.inf
    simulations: int = 0
    rows: int = 0
    rows_of_progress: int = 0

    @classmethod
    def of(cls, deadline: float, simulations: int | None) -> Effort:
        """The effort with the limits that are stated, or with the usual patience where none is.

        Args:
            deadline: infinite where none is stated. simulations: at most; None: not stated.
        """
        if simulations is None and deadline == math.inf:
            return cls(patience=CRITERIA.search.patience)
        return cls(deadline, math.inf if simulations is None else simulations)

    def affords(self, simulations: int) -> bool:
        """Whether so many more reach no limit."""
        return self.deadline == math.inf and self.simulations + simulations < self.most_simulations

    @property
    def spent(self) -> bool:
        """Whether a limit is reached."""
        return self.simulations >= self.most_simulations or time.monotonic() >= self.deadline

    @property
    def hopeless(self) -> bool:
        """Whether there was no visible progress for too long."""
        return self.rows - self.rows_of_progress >= self.patience

    def note_progress(self) -> None:
        """Takes note that the error fell visibly."""
        self.rows_of_progress = self.rows

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
        before = _simulated()
        try:
            yield
        finally:
            self._add(before, _simulated())

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
            lambda task: (on_crash(task), (0, 0), (0, 0)),
            lambda counted: done(counted[0]),
            workers,
        )
        for _, before, after in results:
            self._add(before, after)
        return [result for result, _, _ in results]

    def _add(self, before: Simulated, after: Simulated) -> None:
        self.simulations += after[0] - before[0]
        self.rows += after[1] - before[1]


def _simulated() -> Simulated:
    return Simulator.simulations, Simulator.rows


def _counted(function: Callable[[Task], Result], task: Task) -> tuple[Result, Simulated, Simulated]:
    """The result of a task, and what this process had simulated before and after."""
    before = _simulated()
    return function(task), before, _simulated()
