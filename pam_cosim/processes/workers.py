"""Tasks in worker processes: a crash ends one task, not the study."""

from __future__ import annotations

import gc
import multiprocessing.resource_tracker
import os
import pickle
import signal
import time
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import partial, wraps
from importlib import import_module
from multiprocessing import active_children
from multiprocessing.process import BaseProcess
from typing import Any, ParamSpec, TypeVar

from loky import (
    get_reusable_executor,
)  # its processes do not run the user's script again, as the standard ones do
from loky.backend import resource_tracker as loky_tracker
from threadpoolctl import threadpool_limits

from pam_cosim.errors import InputError
from pam_cosim.libraries import library
from pam_cosim.processes.interrupts import sigint_blocked, sigint_unblocked
from pam_cosim.processes.safe_path import SAFE, safe_path

_IDLE = 60.0  # [s] after which a process without work ends
_GRACE = 2.0  # [s] for tasks that are interrupted to clean up
_BETWEEN = 0.05  # [s] between two interrupts
_ALONE = {
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}  # a process for each processor is enough
_LOOK = 0.5  # [s] between two looks whether the parent is still there

_running: set[Future[Any]] = set()

Task = TypeVar("Task")
Content = TypeVar("Content")
Result = TypeVar("Result")
Arguments = ParamSpec("Arguments")


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def on_one_thread(function: Callable[Arguments, Result]) -> Callable[Arguments, Result]:
    """A function whose linear algebra, of many small matrices, runs on one thread.

    On more threads than one it would spend most of the time waiting for them, and take that from the others.
    """

    @wraps(function)
    def alone(*arguments: Arguments.args, **options: Arguments.kwargs) -> Result:
        with threadpool_limits(limits=1):
            return function(*arguments, **options)

    return alone


# Ends a process when its parent ends, which may be killed; where the system does not end an orphan, idleness does. A
# text, so that a process need not load this package before it has a task.
_END_WITH_PARENT = """
import os, shutil, threading, time

def watch():
    while os.getppid() == parent:
        time.sleep(pause)
    shutil.rmtree(os.environ.get("PAM_COSIM_SCRATCH", ""), ignore_errors=True)
    os._exit(1)

threading.Thread(target=watch, daemon=True).start()
"""


def _pool(count: int) -> Executor:
    if (elsewhere := _elsewhere.get()) is not None:
        return elsewhere
    settings = {"parent": os.getpid(), "pause": _LOOK}
    pool: Executor = get_reusable_executor(
        count,
        timeout=_IDLE,
        env=_ALONE | SAFE,
        initializer=exec,
        initargs=(_END_WITH_PARENT, settings),
    )
    return pool


def _start_helpers() -> None:
    """What comes with a pool lets interrupts through once it has started: before the pool's processes, therefore."""
    with safe_path():  # they take the environment as it is
        if os.name == "posix":
            multiprocessing.resource_tracker.ensure_running()
        loky_tracker.ensure_running()


def stop_workers() -> None:
    """Ends all worker processes: their tasks are interrupted and clean up; one that does not heed is killed."""
    warnings.filterwarnings("ignore", module="loky")  # about workers that have ended
    children, deadline = active_children(), time.monotonic() + _GRACE
    while not all(future.done() for future in _running) and time.monotonic() < deadline:
        _signal(children, signal.SIGINT)
        time.sleep(_BETWEEN)
    _signal(children, getattr(signal, "SIGKILL", signal.SIGTERM))
    for child in children:
        child.join()


def _signal(children: Sequence[BaseProcess], number: int) -> None:
    for child in children:
        with suppress(OSError):
            if child.pid is not None:
                os.kill(child.pid, number)


def _interruptibly(folder: str, function: Callable[..., Result], *task: Task) -> Result | None:
    """In a worker, which may have begun elsewhere. None: interrupted, and the result is not needed.

    Args:
        folder: in which paths of the task are meant.
        function: the task.
        task: what it takes.
    """
    with suppress(KeyboardInterrupt), sigint_unblocked():
        with suppress(OSError):
            os.chdir(folder)
        return function(*task)
    return None


def _folder() -> str:
    """Where this process is; nothing, where its folder was removed."""
    try:
        return os.getcwd()
    except OSError:
        return ""


@contextmanager
def local_pool(count: int) -> Iterator[Executor]:
    """Processes of this machine that take tasks, which ``stop_workers`` ends; they are reused."""
    _start_helpers()
    with sigint_blocked():
        pool = _pool(count)
    try:
        yield _Interruptible(pool)
    finally:
        _running.clear()


@contextmanager
def executor_of(executor: Any) -> Iterator[tuple[Executor, int]]:
    """An executor and the number of its processes, if it is known.

    Args:
        executor: of ``concurrent.futures``; a Dask client or the address of a Dask scheduler.

    Raises:
        InputError: no such executor.
    """
    if isinstance(executor, Executor):
        yield executor, getattr(executor, "_max_workers", None) or processors()
        return
    client, is_own = executor, False
    if isinstance(executor, str):
        client, is_own = _client(executor), True
    if not hasattr(client, "get_executor"):
        raise InputError(
            "an executor of concurrent.futures is needed, a Dask client, or the address of a Dask scheduler"
        )
    try:
        with client.get_executor(pure=False) as pool:
            yield pool, max(1, sum(client.nthreads().values()))
    finally:
        if is_own:
            client.close()


def _client(address: str) -> Any:
    client = library("distributed").Client
    try:
        return client(address, timeout="10s")
    except (OSError, ValueError, TimeoutError) as problem:
        raise InputError(f"there is no Dask scheduler at '{address}': {problem}") from None


_elsewhere: ContextVar[Executor | None] = ContextVar("elsewhere", default=None)


@contextmanager
def working_on(executor: Any) -> Iterator[None]:
    """Meanwhile ``run_tasks`` takes an executor (``executor_of``) for processes of this machine; None: these.

    Raises:
        InputError: no such executor.
    """
    if executor is None:
        yield
        return
    with executor_of(executor) as (pool, _):
        token = _elsewhere.set(_OnOneThread(pool))
        try:
            yield
        finally:
            _elsewhere.reset(token)


class _OnOneThread(Executor):
    """Processes of elsewhere, whose linear algebra is as that of the processes of this machine."""

    def __init__(self, pool: Executor) -> None:
        self._pool = pool

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        return self._pool.submit(_alone, partial(fn, *args, **kwargs))


def _alone(task: Callable[[], Result]) -> Result:
    with threadpool_limits(limits=1):
        return task()


class _Interruptible(Executor):
    """Processes whose tasks can be interrupted and clean up."""

    def __init__(self, pool: Executor) -> None:
        self._pool = pool

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = self._pool.submit(
            _interruptibly, _folder(), partial(fn, *args, **kwargs)
        )
        return future


def running_tasks(futures: Iterable[Future[Any]]) -> None:
    """Names the tasks that ``stop_workers`` has to wait for."""
    _running.clear()
    _running.update(futures)


def wake(workers: int | None = None, module: str = __name__) -> None:
    """Starts the processes and lets them load a module, so that they are ready when the first tasks come."""
    if workers == 0 or _elsewhere.get() is not None:
        return
    count = workers or processors()
    _start_helpers()
    with sigint_blocked():
        pool = _pool(count)
        for _ in range(count):
            pool.submit(_load, module)


def _load(module: str) -> None:
    import_module(module)
    gc.freeze()  # what is loaded stays: it is not searched for garbage


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
        inline = []
        for task in tasks:
            inline.append(_sent(function(_sent(task))))
            done(inline[-1])
        return inline
    results: dict[int, Result] = {}
    waiting = list(range(len(tasks)))
    # as many as ever, also for fewer tasks: a pool that shrinks has to start again what it ended
    suspects = _attempt(function, tasks, waiting, results, done, workers or processors())
    for i in suspects:  # a broken pool does not say who broke it: try those one by one
        if _attempt(function, tasks, [i], results, done, 1):
            results[i] = on_crash(tasks[i])
            done(results[i])
    return [results[i] for i in range(len(tasks))]


def _sent(value: Content) -> Content:
    """What would arrive in another process: arrays lie in memory as they do there, and sums round as they do there."""
    try:
        copy: Content = pickle.loads(pickle.dumps(value))
    except (pickle.PicklingError, AttributeError, TypeError):  # it could not be sent
        return value
    return copy


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
    running: dict[Future[Result], int] = {}
    folder = _folder()
    _start_helpers()
    with sigint_blocked():
        submit: Callable[..., Future[Result]] = _pool(count).submit
        for i in chosen:
            try:
                running[submit(_interruptibly, folder, function, tasks[i])] = i
            except BrokenProcessPool:
                lost.append(i)
    try:
        _collect(running, results, lost, done)
    except BaseException:
        for future in running:
            future.cancel()
        raise
    return sorted(lost)


def _collect(
    running: dict[Future[Result], int],
    results: dict[int, Result],
    lost: list[int],
    done: Callable[[Result], None],
) -> None:
    """Takes each result as it comes out of ``running``, until nothing is left there."""
    _running.update(running)
    while running:
        finished, _ = wait(running, return_when=FIRST_COMPLETED)
        for future in sorted(finished, key=lambda f: running[f]):
            i = running.pop(future)
            _running.discard(future)
            try:
                results[i] = future.result()
            except BrokenProcessPool:
                lost.append(i)
                continue
            done(results[i])
