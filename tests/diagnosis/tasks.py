"""Tasks for worker processes; some of them end their process."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path


def square_or_die(number: int) -> int:
    """Negative numbers kill the process without a word."""
    if number < 0:
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number


def slow_square(number: int) -> int:
    """Small numbers take longer."""
    time.sleep(0.3 / (1 + number))
    return number * number


def process_of(number: int) -> int:
    time.sleep(1.0)  # the other process has loaded what it needs meanwhile
    return os.getpid()


def tell_and_sleep(file: str) -> str:
    """Writes the process's number and works on."""
    Path(file).write_text(str(os.getpid()))
    time.sleep(60)
    return file
