"""Tasks in worker processes: a crash ends one task, not the study."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from typing import TypeVar

from loky import (
    ProcessPoolExecutor,
    get_reusable_executor,
)  # its processes do not run the user's script again, as the standard ones do

_IDLE = 60.0  # [s] after which a process without work ends
_LOOK = 0.5  # [s] between two looks whether the parent is still there

Task = TypeVar("Task")
Result = TypeVar("Result")


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


# Ends a process when its parent ends, which may be killed; where an orphan does not tell, idleness does it. A text, so
# that a process need not load this package before it has a task.
_END_WITH_PARENT = """
import os, threading, time

def watch():
    while os.getppid() == parent:
        time.sleep(pause)
    os._exit(1)

threading.Thread(target=watch, daemon=True).start()
"""


def _pool(count: int) -> ProcessPoolExecutor:
    known = {"parent": os.getpid(), "pause": _LOOK}
    return get_reusable_executor(count, timeout=_IDLE, initializer=exec, initargs=(_END_WITH_PARENT, known))


def wake(workers: int | None = None) -> None:
    """Starts the processes, so that they have loaded what they need when the first tasks come."""
    if workers == 0:
        return
    count = workers or processors()
    pool = _pool(count)
    for _ in range(count):
        pool.submit(processors)


def run_tasks(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    on_crash: Callable[[Task], Result],
    done: Callable[[Result], None],
    workers: int | None = None,
) -> list[Result]:
    """Runs ``function`` on every task and returns the results in the order of the tasks.

    Args:
        function: a module-level function that handles its own exceptions.
        tasks: what to run it on.
        on_crash: makes the result of a task whose process died.
        done: called with each result as it comes.
        workers: number of processes; default the processors at hand. 0: this process alone, which a crash ends.
    """
    if workers == 0:
        alone = []
        for task in tasks:
            alone.append(function(task))
            done(alone[-1])
        return alone
    results: dict[int, Result] = {}
    waiting = list(range(len(tasks)))
    # as many as ever, also for fewer tasks: a pool that shrinks has to start anew what it ended
    suspects = _attempt(function, tasks, waiting, results, done, workers or processors())
    for i in suspects:  # a broken pool does not say who broke it: try those one by one
        if _attempt(function, tasks, [i], results, done, 1):
            results[i] = on_crash(tasks[i])
            done(results[i])
    return [results[i] for i in range(len(tasks))]


def _attempt(
    function: Callable[[Task], Result],
    tasks: Sequence[Task],
    chosen: Sequence[int],
    results: dict[int, Result],
    done: Callable[[Result], None],
    count: int,
) -> list[int]:
    """Runs the chosen tasks; returns those whose pool broke."""
    lost: list[int] = []
    pool = _pool(count)
    running: dict[Future[Result], int] = {}
    for i in chosen:
        try:
            running[pool.submit(function, tasks[i])] = i
        except BrokenProcessPool:
            lost.append(i)
    while running:
        finished, _ = wait(running, return_when=FIRST_COMPLETED)
        for future in sorted(finished, key=lambda f: running[f]):
            i = running.pop(future)
            try:
                results[i] = future.result()
            except BrokenProcessPool:
                lost.append(i)
                continue
            done(results[i])
    return sorted(lost)
