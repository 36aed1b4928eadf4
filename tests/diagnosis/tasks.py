"""Tasks for worker processes; some of them end their process."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path

from pam_cosim.simulation import Simulator


def square_or_die(number: int) -> int:
    """Negative numbers kill the process without a word."""
    if number < 0:
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number


def slow_square(number: int) -> int:
    """Small numbers take longer."""
    time.sleep(0.3 / (1 + number))
    return number * number


def process_beside_another(folder: str) -> int:
    """Waits until two processes have come to the folder."""
    Path(folder, str(os.getpid())).touch()
    end = time.monotonic() + 30
    while len(os.listdir(folder)) < 2 and time.monotonic() < end:
        time.sleep(0.02)
    return os.getpid()


def simulate_so_often(task: tuple[str, int]) -> int:
    """Simulates an FMU some times."""
    path, count = task
    with Simulator(Path(path)) as simulator:
        for _ in range(count):
            simulator.run([0.0, 1.0])
    return count
