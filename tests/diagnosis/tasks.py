"""Tasks for worker processes; some of them end their process."""

from __future__ import annotations

import os
import signal
import time


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
    time.sleep(0.2)
    return os.getpid()
