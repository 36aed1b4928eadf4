"""The process of one FMU that is not trusted: requests to it, and what becomes of it."""

from __future__ import annotations

import contextlib
import math
import os
import pickle
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pam_cosim.processes import watchdog
from pam_cosim.processes.memory import MOST_MEMORY
from pam_cosim.processes.safe_path import safe_command, safe_environment
from pam_cosim.simulation.driver import RunProgress
from pam_cosim.simulation.failure import ProcessFailure
from pam_cosim.simulation.native import prepare_driver

CO_SIMULATION = "pam_cosim.simulation.worker:unlimited"
EXCHANGE = "pam_cosim.simulation.exchange_simulator:ExchangeSimulator"
_TICKS = 4  # looks at the progress within the limit, at least
_LONGEST_TICK = 1.0  # [s]
_LEAST_SILENCE, _MOST_SILENCE = 5.0, 20.0  # [s] of the watchdog, after which it is ended


class FmuProcess:
    """Starts the FMU's process at the first request, and again when it has ended.

    Args:
        path: the FMU.
        timeout: [s] without progress, after which the process is ended.
        make: module and name of what runs the FMU there.
    """

    def __init__(self, path: Path, timeout: float, make: str = CO_SIMULATION) -> None:
        self.path, self.timeout, self._make = path, timeout, make
        self._process: subprocess.Popen[bytes] | None = None
        self._never_loaded = False
        self._fmu_pid = self._silence = (
            0  # of the FMU's process; beats without a sign of the watchdog
        )

    def close(self) -> None:
        """Frees the FMU and ends its process, even if it does not respond; the next run starts another."""
        if self._process is not None and self._process.stdin is not None:
            with contextlib.suppress(OSError):
                watchdog.write_frame(self._process.stdin, watchdog.CLOSE)
        self._end()

    def _end(self) -> None:
        """Ends the process; at once, where it was not asked before to close."""
        process, self._process = self._process, None
        if process is None:
            return
        assert process.stdin is not None and process.stdout is not None
        with contextlib.suppress(OSError):
            process.stdin.close()
        process.stdout.close()
        process.wait()

    def answer(
        self, call: str | Callable[..., Any], arguments: dict[str, Any], alone: bool = True
    ) -> Any:
        """The answer of the FMU's process to a call; where not ``alone``, it continues from the previous call.

        Args:
            call: a function of the simulator there, or a function that takes the model and ``arguments["positional"]``.
        """
        if not alone and (self._process is None or self._process.poll() is not None):
            raise ProcessFailure(f"the run of {self.path.name} has ended with its process")
        kind, answer = self._ask({"call": call, "arguments": arguments})
        if kind == "error":
            raise answer
        return answer

    def _ask(self, request: dict[str, Any]) -> tuple[str, Any]:
        if self._never_loaded:
            raise self._late(None, request)
        if self._process is not None and self._process.poll() is not None:
            self._end()
        process = self._process = self._process or start_watched(
            self.path, self.timeout, self._make
        )
        assert process.stdin is not None and process.stdout is not None
        try:
            with contextlib.suppress(OSError):  # it has ended: the answer has the reason
                watchdog.write_frame(process.stdin, watchdog.REQUEST, pickle.dumps(request))
            kind, content = self._next_frame(process)
        except EOFError:
            self._end()
            raise ProcessFailure(f"the process that watches {self.path.name} has ended") from None
        except BaseException:
            self._end()
            raise
        if kind == watchdog.ANSWER:
            return self._unpacked(content)
        self._end()
        if kind == watchdog.LATE:
            progress = pickle.loads(content) if content else None
            self._never_loaded = bool(content) and progress is None
            raise self._late(progress, request)
        raise ProcessFailure(
            f"{self.path.name} crashed its process ({cause_of_end(int(content))}){_memory(content)}"
        )

    def _next_frame(self, process: subprocess.Popen[bytes]) -> tuple[bytes, bytes]:
        """The next message that is no sign of life; the end of a watchdog that gives none ends this."""
        assert process.stdout is not None
        answered = threading.Event()
        clock = threading.Thread(target=self._end_silent, args=(process, answered), daemon=True)
        clock.start()
        try:
            while True:
                self._silence = 0
                kind, content = watchdog.read_frame(process.stdout)
                if kind != watchdog.ALIVE:
                    return kind, content
                self._fmu_pid = int(content)
        finally:
            answered.set()

    def _end_silent(self, process: subprocess.Popen[bytes], answered: threading.Event) -> None:
        """Ends a watchdog that is silent, and the FMU's process; counts beats, for this process may stop too."""
        most = max(_LEAST_SILENCE, min(self.timeout, _MOST_SILENCE)) / watchdog.BEAT
        while not answered.wait(watchdog.BEAT):
            self._silence += 1
            if self._silence > most:
                process.kill()
                with contextlib.suppress(OSError, AttributeError):
                    os.killpg(self._fmu_pid, signal.SIGKILL)
                return

    def _unpacked(self, content: bytes) -> tuple[str, Any]:
        """An answer as the FMU's process packed it, unless the FMU wrote into it."""
        try:
            kind, answer = pickle.loads(content)
        except Exception:
            self._end()
            raise ProcessFailure(
                f"{self.path.name} has written into the files of its process"
            ) from None
        return kind, answer

    def _late(self, progress: RunProgress | None, request: dict[str, Any]) -> ProcessFailure:
        place = (
            progress.function
            if progress
            else "while it was loaded"
            if self._never_loaded
            else "while it was made anew"
        )
        reason = (
            f"{self.path.name} was ended: no progress for {self.timeout:g} s, {place}; "
            "a longer time limit (--timeout) may help"
        )
        return ProcessFailure(
            reason, progress.time if progress else None, request["arguments"].get("parameters")
        )


def start_watched(path: Path, timeout: float, make: str) -> subprocess.Popen[bytes]:
    """The watchdog of a process that answers requests to an FMU."""
    prepare_driver()  # not within the time limit
    limit = timeout if math.isfinite(timeout) else 0.0
    tick = min(_LONGEST_TICK, timeout / _TICKS)
    answering = safe_command("pam_cosim.simulation.worker", str(path), str(tick), make)
    command = [sys.executable, "-I", "-S", str(Path(watchdog.__file__)), str(limit), *answering]
    # a session of its own: an interrupt from the terminal is this process's alone, which then ends the others
    return subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env=safe_environment(),
        start_new_session=True,
    )


def cause_of_end(code: int) -> str:
    """Of a process, by its exit status."""
    if code >= 0:
        return f"exit status {code}"
    try:
        return f"signal {signal.Signals(-code).name}"
    except ValueError:
        return f"signal {-code}"


def _memory(content: bytes) -> str:
    """A hint where the end may come of too little memory."""
    return (
        f"; it may use {MOST_MEMORY / 1e9:g} GB of memory at most"
        if int(content) in (-6, -11, 134, 139)
        else ""
    )
