"""The command ``pam-cosim`` as a process that can be interrupted at any moment and leaves nothing behind.

What it loads takes a second, in which it can be interrupted too: so it loads little before it listens.
"""

from __future__ import annotations

import errno
import gc
import io
import os
import signal
import sys
import time
from collections.abc import Callable
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sys import UnraisableHookArgs

_SIGNALS = (signal.SIGINT, signal.SIGTERM)
_AGAIN = 0.05  # [s] after which an ignored interrupt is repeated
_LAST = 1.0  # [s] for an interrupted command to end by itself once everything is cleaned up
_ABANDONED = 86_400.0  # [s] after which the folder of a process that is no more is removed
_OBJECTS = 50_000  # that are new when a search for cycles begins: what is loaded has few, and stays
_PATIENCE = 5.0  # [s] after an interrupt in which another one does not disturb the cleaning up


class _Command:
    """One run of the command, with a folder for every temporary file that it or its processes make."""

    def __init__(self) -> None:
        self.scratch = ""
        self.loading = True
        self.number = 0  # of the signal that interrupted it; 0: none did
        self.time = -_PATIENCE

    def interrupt(self, number: int, frame: FrameType | None) -> None:
        """Handler of a signal: what has begun cleans up; before, there is nothing but the folder."""
        if time.monotonic() - self.time < _PATIENCE:
            return
        self.number, self.time = number, time.monotonic()
        if self.loading:
            self.remove_scratch()
            os.write(2, b"pam-cosim: interrupted; nothing was written\n")
            os._exit(128 + number)
        raise KeyboardInterrupt

    def raise_again(self, ignored: UnraisableHookArgs) -> None:
        """An interrupt at a place that cannot be left, such as a destructor, is repeated."""
        if isinstance(ignored.exc_value, KeyboardInterrupt):
            self.time = -_PATIENCE
            _later(_AGAIN, os.kill, os.getpid(), self.number)
        else:
            sys.__unraisablehook__(ignored)

    def run(self) -> int:
        """The status with which to exit."""
        for number in _SIGNALS:
            signal.signal(number, self.interrupt)
        sys.unraisablehook = self.raise_again
        self.make_scratch()
        # what tracks semaphores removes them also where this process ends without a word, and need not say so
        quiet = "ignore:resource_tracker:UserWarning"
        os.environ["PYTHONWARNINGS"] = ",".join(
            filter(None, (os.environ.get("PYTHONWARNINGS"), quiet))
        )
        from pam_cosim.cli.app import load, main
        from pam_cosim.cli.commands.common import interrupted

        load(sys.argv[1:])
        gc.freeze()  # what is loaded stays: no search for cycles has to look at it
        self.loading = False
        try:
            status = main()
        except BaseException:  # an interrupt may come out of a library as another exception
            if not self.number:
                raise
            status = interrupted()
        return 128 + self.number if self.number and status else status

    def make_scratch(self) -> None:
        """A folder that ``tempfile`` uses, in this process and in those that it starts."""
        import tempfile

        # an interrupt waits meanwhile: tempfile writes a file to see whether it can
        masks = hasattr(signal, "pthread_sigmask")  # Windows has none
        before = signal.pthread_sigmask(signal.SIG_BLOCK, _SIGNALS) if masks else set()
        _remove_abandoned(tempfile.gettempdir())
        name = os.path.join(tempfile.gettempdir(), f"pam-cosim-{os.getpid()}-{os.urandom(4).hex()}")
        self.scratch = name  # before it is made: an interrupt finds it
        os.mkdir(name, 0o700)
        os.environ["TMPDIR"] = tempfile.tempdir = name
        os.environ["PAM_COSIM_SCRATCH"] = name  # for those that outlive a command that is killed
        if masks:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)

    def remove_scratch(self) -> None:
        """Removes all temporary files."""
        import shutil

        if self.scratch:
            shutil.rmtree(self.scratch, ignore_errors=True)


def _remove_abandoned(place: str) -> None:
    """Removes the folders of commands that were killed."""
    if os.name != "posix":  # elsewhere a look at a process ends it
        return
    for entry in os.scandir(place):
        kind, *parts = entry.name.rsplit("-", 2)
        if kind != "pam-cosim" or len(parts) < 2 or not parts[0].isdecimal():
            continue
        try:
            if time.time() - entry.stat(follow_symlinks=False).st_mtime > _ABANDONED:
                os.kill(int(parts[0]), 0)
        except ProcessLookupError:
            import shutil

            shutil.rmtree(entry.path, ignore_errors=True)
        except (OSError, OverflowError):  # it belongs to another process, or has ended
            continue


def run() -> None:
    """Entry point of the command line."""
    gc.set_threshold(_OBJECTS)
    _print_somewhere()
    _print_what_can_be_printed()
    command = _Command()
    try:
        status = command.run()
        sys.stdout.flush()
    except OSError as problem:
        if problem.filename is not None:
            raise
        status = _could_not_print(problem)
    finally:
        for number in _SIGNALS:
            signal.signal(number, signal.SIG_IGN)
        command.remove_scratch()
    if command.number:  # threads of libraries may wait for processes that have been ended
        _later(_LAST, os._exit, status)
    gc.freeze()  # the interpreter's own search for cycles at its end takes a fifth of a short run
    sys.exit(status)


def _print_somewhere() -> None:
    """Output is discarded if the caller has closed it."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w", encoding="utf-8"))  # noqa: SIM115 - until the process ends


def _could_not_print(problem: OSError) -> int:
    """What is printed went to a full disk, or to a program that ended: one line, and no second try at the end."""
    if not isinstance(problem, BrokenPipeError):
        what = "a temporary file" if problem.errno == errno.EFBIG else "what is printed"
        print(f"pam-cosim: {what} cannot be written: {problem.strerror}", file=sys.stderr)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    return 2


def _print_what_can_be_printed() -> None:
    """A letter that a terminal of Windows, or a file for it, does not have becomes a question mark and ends nothing."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def _later(seconds: float, function: Callable[..., None], *arguments: object) -> None:
    """Calls the function after some seconds, if this process has not ended by then."""
    import threading

    timer = threading.Timer(seconds, function, arguments)
    timer.daemon = True
    timer.start()
