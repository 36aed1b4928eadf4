"""The process between a study and an FMU that is not trusted: it relays, watches the clock and cleans up.

It runs no foreign code and imports the standard library alone. So nothing that an FMU does, such as to hold the
interpreter's lock while it is loaded, can keep it from ending the FMU's process: when that makes no progress, and when
the study has ended, for whatever reason. It reports that it is alive; where it is silent, for the FMU may have stopped
it, the study ends both.

``python watchdog.py LIMIT COMMAND...``: the command's last argument will be a folder of its own.
"""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time
from queue import Empty, SimpleQueue
from typing import IO

# Kinds of frames, on both sides of the watchdog; the last three are its own.
REQUEST, CLOSE = b"r", b"c"
PROGRESS, ANSWER = b"p", b"a"
LATE, CRASHED, ALIVE = b"l", b"x", b"v"
_GONE = b"g"  # no frame: the study has ended

_KINDS = frozenset((REQUEST, CLOSE, PROGRESS, ANSWER, LATE, CRASHED, ALIVE))
_LONGEST = 1 << 34  # bytes of a message
BEAT = 1.0  # [s] between two signs that the watchdog itself is alive, while the FMU has something to do
_MOST_LINES, _LONGEST_LINE = 200, 1000  # of what the FMU prints, that are shown
GRACE = 5.0  # [s] for an FMU to be freed after its last run
_DYING = 1.0  # [s] between the end of a process's output and its own end
_HEAD = struct.Struct("<cQ")


def write_frame(stream: IO[bytes], kind: bytes, content: bytes = b"") -> None:
    """Writes one message at once.

    Raises:
        OSError: the reader has gone.
    """
    stream.write(_HEAD.pack(kind, len(content)) + content)
    stream.flush()


def read_frame(stream: IO[bytes]) -> tuple[bytes, bytes]:
    """The next message: its kind and content.

    Raises:
        EOFError: there is none, or not all of it, or something else.
    """
    head = stream.read(_HEAD.size)
    if len(head) < _HEAD.size:
        raise EOFError
    kind, length = _HEAD.unpack(head)
    if (
        kind not in _KINDS or length > _LONGEST
    ):  # another program has written here, such as an FMU into every file
        raise EOFError
    content = stream.read(length)
    if len(content) < length:
        raise EOFError
    return kind, content


class Watchdog:
    """One FMU's process from its start to its end.

    Args:
        process: the FMU's process.
        limit: seconds without a sign of progress, while there is something to do, after which it is ended; 0: none.
    """

    def __init__(self, process: subprocess.Popen[bytes], limit: float) -> None:
        assert process.stdin is not None and process.stdout is not None
        self.process, self.limit = process, limit
        self._requests, self._answers = process.stdin, process.stdout
        self.events: SimpleQueue[tuple[bytes, bytes]] = SimpleQueue()
        self._doing = b""
        self._writing = threading.Lock()
        self.say(ALIVE, str(process.pid).encode())
        self._relays = [
            threading.Thread(target=f, daemon=True)
            for f in (self._relay_requests, self._relay_answers, self._relay_text)
        ]
        for relay in self._relays:
            relay.start()

    def say(self, kind: bytes, content: bytes) -> None:
        """Writes a message to the study, which may have ended."""
        with self._writing, contextlib.suppress(OSError):
            write_frame(sys.stdout.buffer, kind, content)

    def _relay_text(self) -> None:
        """Shows some lines of what the FMU prints: neither commands of terminals nor messages that it diverted."""
        assert self.process.stderr is not None
        lines = iter(lambda: self.process.stderr.readline(_LONGEST_LINE), b"")  # type: ignore[union-attr]
        texts = (line.decode("utf-8", "replace").rstrip().replace("\t", " ") for line in lines)
        for number, text in enumerate(text for text in texts if text.isprintable()):
            with contextlib.suppress(OSError):
                if number < _MOST_LINES:
                    print(text, file=sys.stderr, flush=True)

    def _relay_requests(self) -> None:
        with contextlib.suppress(EOFError, OSError):
            while True:
                kind, content = read_frame(sys.stdin.buffer)
                self.events.put((kind, b""))
                if kind == CLOSE:
                    self._requests.close()
                    return
                write_frame(self._requests, kind, content)
        self.events.put((_GONE, b""))

    def _relay_answers(self) -> None:
        with contextlib.suppress(EOFError, OSError):
            while True:
                kind, content = read_frame(self._answers)
                self.events.put((kind, content if kind == PROGRESS else b""))
                if kind == ANSWER:
                    self.say(kind, content)
        self.events.put((CRASHED, b""))

    def watch(self) -> tuple[bytes, bytes]:
        """Waits for the end: the kind of it, and what the FMU was doing last."""
        limit = self.limit or None
        deadline: float | None = None
        started = closing = busy = False
        while True:
            remaining_time = BEAT if deadline is None else min(BEAT, max(0.0, deadline - _now()))
            try:
                kind, content = self.events.get(timeout=remaining_time if busy or closing else None)
            except Empty:
                if deadline is not None and _now() >= deadline:
                    return _GONE if closing else LATE, self._doing
                self.say(ALIVE, str(self.process.pid).encode())
                continue
            if kind in (_GONE, CRASHED):
                return CLOSE if closing else kind, self._doing
            if kind in (PROGRESS, REQUEST):
                self._doing = content
            busy = kind == REQUEST or (busy and kind != ANSWER)
            started = started or kind == PROGRESS  # what comes before is no call of the FMU
            if kind == CLOSE:
                closing, deadline = True, _now() + GRACE
            elif not closing:
                deadline = _now() + limit if limit and started and kind != ANSWER else None

    def end(self, patience: float) -> int:
        """Ends the process, after some seconds in which it may end by itself, and what it started.

        Returns its exit status, negative for a signal.
        """
        with contextlib.suppress(subprocess.TimeoutExpired):
            self.process.wait(patience)
        with contextlib.suppress(
            OSError, AttributeError
        ):  # none is left; a platform without process groups
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.kill()
        status = self.process.wait()
        for relay in self._relays[1:]:
            relay.join(_DYING)
        return status


def _now() -> float:
    return time.monotonic()


def main(limit: float, command: list[str]) -> None:
    """Starts the command, serves it, ends it, removes its folder and reports its outcome."""
    folder = tempfile.mkdtemp(prefix="pam-cosim-fmu-")
    try:
        process = subprocess.Popen(
            [*command, folder],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        watchdog = Watchdog(process, limit)
        signal.signal(signal.SIGTERM, lambda *_: watchdog.events.put((_GONE, b"")))
        kind, doing = watchdog.watch()
        status = watchdog.end(_DYING if kind in (CRASHED, CLOSE) else 0.0)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    if (
        kind == _GONE and "PAM_COSIM_SCRATCH" in os.environ
    ):  # the command's own folder, if it was killed (``command``)
        shutil.rmtree(os.environ["PAM_COSIM_SCRATCH"], ignore_errors=True)
    if kind in (LATE, CRASHED):
        watchdog.say(kind, doing if kind == LATE else str(status).encode())
    os._exit(0)  # a thread may still read or write


if __name__ == "__main__":
    main(float(sys.argv[1]), sys.argv[2:])
