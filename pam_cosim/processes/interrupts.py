"""Other processes of a command: an interrupt reaches them through the command alone, and none of them outlives it."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from threading import current_thread, main_thread
from types import FrameType

_MASKS = hasattr(signal, "pthread_sigmask")  # Windows has none
_INTERRUPT = (signal.SIGINT,)


@contextmanager
def sigint_blocked() -> Iterator[None]:
    """Threads and processes that are started inside do not hear the terminal's interrupt; this one hears it afterwards.

    Raises:
        KeyboardInterrupt: at the end, if one came.
    """
    if not _MASKS:
        yield
        return
    heard: list[int] = []  # by other threads, which may not be deaf
    handler = signal.getsignal(signal.SIGINT) if current_thread() is main_thread() else None
    if handler is not None:
        signal.signal(signal.SIGINT, lambda number, frame: heard.append(number))
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, _INTERRUPT)
    try:
        yield
    finally:
        if handler is not None:
            signal.signal(signal.SIGINT, handler)
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        if heard:
            os.kill(os.getpid(), signal.SIGINT)


@contextmanager
def sigint_unblocked() -> Iterator[None]:
    """In the main thread of a deaf process: what is inside can be interrupted, once; earlier interrupts do not count.

    Another thread, such as one of a process of Dask, hears no interrupts.

    Raises:
        KeyboardInterrupt: it was.
    """
    if not _MASKS or current_thread() is not main_thread():
        yield
        return
    while signal.SIGINT in signal.sigpending():
        signal.sigwait(_INTERRUPT)
    before = signal.signal(signal.SIGINT, _once)
    try:
        signal.pthread_sigmask(signal.SIG_UNBLOCK, _INTERRUPT)
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_BLOCK, _INTERRUPT)
        signal.signal(signal.SIGINT, before)


def _once(number: int, frame: FrameType | None) -> None:
    signal.pthread_sigmask(
        signal.SIG_BLOCK, _INTERRUPT
    )  # what is interrupted may clean up in peace
    raise KeyboardInterrupt


def run_tool(
    command: Sequence[str],
    folder: Path,
    environment: Mapping[str, str],
    patience: float | None = None,
) -> subprocess.CompletedProcess[str]:
    """Runs a program to its end in ``folder``; whatever interrupts that ends the program and all that it started.

    Raises:
        subprocess.TimeoutExpired: it took longer than ``patience`` [s].
    """
    group: dict[str, int] = {"process_group": 0} if os.name == "posix" else {}
    process = subprocess.Popen(
        command,
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        **group,
    )  # type: ignore[call-overload]
    try:
        out, err = process.communicate(timeout=patience)
    except BaseException:
        with suppress(OSError):
            if group:
                os.killpg(process.pid, signal.SIGKILL)
            process.kill()
        process.wait()
        raise
    return subprocess.CompletedProcess(command, process.returncode, out, err)
