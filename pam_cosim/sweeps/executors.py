"""Where runs are made: this process, processes of this machine, or any executor, a Dask cluster among them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import replace
from typing import Any

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.processes.interrupts import sigint_blocked
from pam_cosim.processes.workers import executor_of, local_pool, processors, running_tasks
from pam_cosim.sweeps.records import RunResult
from pam_cosim.sweeps.task import Batch, SweepJob, forget_foreign, make_runs

_BATCH = 0.3  # [s] of work that is handed out at once, and lost at most where the program is killed
_OPENINGS = 5  # as much work as opening a model takes, at least
_WORTH = 2.0  # [s] of work from which on further processes are started, which takes a second
_AHEAD = 2  # batches that wait for each process

Say = Callable[[Sequence[RunResult]], None]


def run_all(
    job: SweepJob, runs: Sequence[int], points: Array, executor: Any, workers: int | None, say: Say
) -> None:
    """Makes the runs; ``say`` gets them as they come, in any order.

    Args:
        job: the sweep.
        runs: numbers of the runs to make.
        points: (all runs, names) what is varied [SI].
        executor: None: processes of this machine; an executor of ``concurrent.futures``; a Dask client or the address
            of a Dask scheduler.
        workers: of this machine; default: as many as there are processors; 1: this process alone.

    Raises:
        InputError: no such executor.
        SimulationFailure: a process of the executor died; earlier reports remain.
    """
    if executor is None:
        try:
            _run_here(job, list(runs), points, workers, say)
        finally:
            forget_foreign()
        return
    with executor_of(executor) as (pool, count):
        _feed(replace(job, content=job.fmu.read_bytes()), runs, points, pool, count, say, None)


def _run_here(
    job: SweepJob, remaining: list[int], points: Array, workers: int | None, say: Say
) -> None:
    """In this process, and as soon as it is worth them in others of this machine."""
    first = make_runs(job, remaining, points[remaining], _BATCH)
    say(first.rows)
    remaining = remaining[len(first.rows) :]
    rate = first.running / len(first.rows)
    if remaining and (workers == 1 or rate * len(remaining) < _WORTH):
        for part in _parts(remaining, max(1, int(_BATCH / max(rate, 1e-9)))):
            say(make_runs(job, part, points[part]).rows)
        return
    if remaining:
        count = min(workers or processors(), len(remaining))
        with local_pool(count) as pool:
            _feed(job, remaining, points, pool, count, say, first)


def _parts(runs: Sequence[int], size: int) -> Iterator[list[int]]:
    for i in range(0, len(runs), size):
        yield list(runs[i : i + size])


def _feed(
    job: SweepJob,
    runs: Sequence[int],
    points: Array,
    pool: Executor,
    count: int,
    say: Say,
    earlier_batch: Batch | None,
) -> None:
    """Hands out batches that take a part of a second each, a few ahead of what is done."""
    remaining, size = list(runs), _size(earlier_batch)
    waiting: dict[Future[Batch], list[int]] = {}
    try:
        while remaining or waiting:
            while remaining and len(waiting) < _AHEAD * count:
                part, remaining = remaining[:size], remaining[size:]
                with sigint_blocked():
                    waiting[pool.submit(make_runs, job, part, points[part])] = part
            running_tasks(waiting)
            for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                batch = future.result()
                del waiting[future]
                size = _size(batch)
                say(batch.rows)
    except BrokenExecutor as problem:
        raise SimulationFailure(
            f"a worker process has ended ({problem}); the same command continues the sweep"
        ) from problem
    finally:
        for future in waiting:
            future.cancel()


def _size(batch: Batch | None) -> int:
    """Runs of the next batch, from the time of an earlier one."""
    if batch is None:
        return 1
    rate = batch.running / max(1, len(batch.rows))
    return max(1, int(max(_BATCH, _OPENINGS * batch.opening) / max(rate, 1e-9)))
