"""The workbench in a real browser, for tests, pictures and measured times: which Chromium, and the command's page."""

from __future__ import annotations

import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
VARIABLE = "PAM_COSIM_CHROMIUM"
MISSING = (
    "NO BROWSER: the tests of the workbench's page are skipped. They drive a Chromium that is installed: "
    f"'apt-get install chromium' (Debian), or set {VARIABLE} to one."
)
ADDRESS = re.compile(r"http://127\.0\.0\.1:\d+/\?token=\S+")
PATIENCE = 20  # s, for the server to end


def chromium() -> str | None:
    """The program of a Chromium that is installed; none is downloaded."""
    return os.environ.get(VARIABLE) or next(
        (path for path in map(shutil.which, NAMES) if path), None
    )


@contextmanager
def serving(folder: Path, *further: str) -> Iterator[tuple[str, int]]:
    """Address and process of ``pam-cosim workbench`` on a folder, for as long as it runs."""
    command = [
        sys.executable,
        "-m",
        "pam_cosim",
        "workbench",
        str(folder),
        "--no-browser",
        *further,
    ]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as server:
        assert server.stdout is not None
        told = []
        try:
            for line in server.stdout:
                told.append(line)
                found = ADDRESS.search(line)
                if found:
                    yield found.group(), server.pid
                    break
            else:
                raise RuntimeError("the workbench did not start:\n" + "".join(told))
        finally:
            server.send_signal(signal.SIGINT)
            try:
                server.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                server.kill()
