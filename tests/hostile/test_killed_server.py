"""A server that is killed leaves no process behind, be its job at work or held where it was."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

SERVER = """
import pickle, sys, time
from pam_cosim.workbench.job_process import Worker
worker = Worker()
process = worker.wake()
if sys.argv[1] == "held":
    assert worker.hold()
elif sys.argv[1] == "resumed":
    assert worker.hold()
    worker.go_on()
print(process.pid, flush=True)
time.sleep(60)
"""
PATIENCE = 30.0  # s


def alive(group: int) -> bool:
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


@pytest.mark.full
@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="processes cannot be held here")
@pytest.mark.parametrize("way", ("held", "resumed", "at work"))
def test_jobs_end_with_the_server(way: str) -> None:
    place = Path(__file__).parents[2]
    with subprocess.Popen(
        [sys.executable, "-c", SERVER, way], stdout=subprocess.PIPE, text=True, cwd=place
    ) as server:
        assert server.stdout is not None
        job = int(server.stdout.readline())
        assert alive(job)
        server.kill()
    deadline = time.monotonic() + PATIENCE
    try:
        while alive(job):
            assert time.monotonic() < deadline, f"the job is left ({way})"
            time.sleep(0.1)
    finally:
        if alive(job):
            os.killpg(job, signal.SIGKILL)
