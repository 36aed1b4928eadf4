"""Something that takes long, in a process of its own that can be held, let go on, and ended."""

from __future__ import annotations

import contextlib
import os
import pickle
import signal
import subprocess
import threading
from collections.abc import Callable
from typing import Any

from pam_cosim.processes.safe_path import safe_command, safe_environment
from pam_cosim.processes.watchdog import ANSWER, read_frame, write_frame

CAN_HOLD = hasattr(signal, "SIGSTOP")
_PATIENCE = 2.0  # [s] for the process to end when there are no more requests

Heard = Callable[[object], None]
Done = Callable[[bool, Any], None]


class JobEnded(RuntimeError):
    """The process ended before it answered."""


class Worker:
    """A process that is started when first needed, kept for the next job, and restarted after it was ended."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._lock = threading.Lock()
        self._turn = threading.Lock()  # of who is answered: one job at a time
        self._guard: subprocess.Popen[bytes] | None = None
        self.held = False

    def wake(self) -> subprocess.Popen[bytes]:
        """The process, started where there is none; it loads while others go on."""
        with self._lock:
            if self._process is None or self._process.poll() is not None:
                self.held = False
                self._process = subprocess.Popen(
                    safe_command("pam_cosim.workbench.worker"),
                    env=safe_environment(),
                    stdin=subprocess.PIPE,
                    stdout=subprocess.PIPE,
                    start_new_session=True,
                )
            return self._process

    def run(
        self, job: str, data: Any, model: str, options: dict[str, Any], heard: Heard, on_end: Done
    ) -> None:
        """Begins a job; what it tells and how it ends is told to the two functions, from another thread.

        ``on_end`` is called with whether it went well, and the result or the exception; not at all after ``end``.
        """
        process = self.wake()
        content = pickle.dumps((job, data, model, options))
        threading.Thread(
            target=self._follow, args=(process, content, heard, on_end), daemon=True
        ).start()

    def _follow(
        self, process: subprocess.Popen[bytes], content: bytes, heard: Heard, on_end: Done
    ) -> None:
        assert process.stdin is not None and process.stdout is not None
        try:
            with self._turn:
                write_frame(process.stdin, b"r", content)  # waits until the process has loaded
                while True:
                    kind, content = read_frame(process.stdout)
                    message = pickle.loads(content)
                    if kind == ANSWER:
                        break
                    heard(message)
        except (EOFError, OSError, ValueError):
            with contextlib.suppress(
                subprocess.TimeoutExpired
            ):  # it is ending, and the next job needs to know
                process.wait(_PATIENCE)
            if self._process is process:
                on_end(False, JobEnded("the process that did it ended without a word"))
            return
        if self._process is process:
            on_end(*message)

    def hold(self) -> bool:
        """Lets the process and all that it started stand still where they are; False where that cannot be done."""
        process = self._process
        if CAN_HOLD and process is not None:
            self._guard = self._guard or _guardian(process.pid)
            self.held = self._signal("SIGSTOP")
        return self.held

    def go_on(self) -> None:
        """Lets them go on from there."""
        self._signal("SIGCONT")
        self.held = False
        self._dismiss()

    def _dismiss(self) -> None:
        """Ends who watches over processes that stand still."""
        guard, self._guard = self._guard, None
        if guard is not None:
            guard.kill()
            guard.wait()
            if guard.stdin is not None:
                guard.stdin.close()

    def end(self) -> None:
        """Ends the process and all that it started."""
        self._dismiss()
        with self._lock:
            process, self._process = self._process, None
        if process is None:
            return
        with contextlib.suppress(OSError, AttributeError):
            os.killpg(process.pid, signal.SIGKILL)
        process.kill()
        process.wait(_PATIENCE)
        for stream in (process.stdin, process.stdout):
            if stream is not None:
                with contextlib.suppress(OSError):
                    stream.close()
        self.held = False

    def _signal(self, name: str) -> bool:
        process = self._process
        if process is None or process.poll() is not None:
            return False
        with contextlib.suppress(OSError, AttributeError):  # a platform without such signals
            os.killpg(process.pid, getattr(signal, name))
            return True
        return False


def _guardian(group: int) -> subprocess.Popen[bytes]:
    """Ends a group of processes when this one is gone, however it ended: those that stand still cannot look for it."""
    return subprocess.Popen(
        ["/bin/sh", "-c", f"read line; kill -9 -{group}"],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
