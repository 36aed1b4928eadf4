"""Python in other processes: it loads nothing from the current folder, which may be an untrusted data set."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

SAFE = {"PYTHONSAFEPATH": "1"}
_PACKAGES = str(Path(__file__).resolve().parents[2])  # where this package lies
_lock = threading.Lock()  # the environment is that of all threads


def safe_command(module: str, *words: str) -> list[str]:
    """A command that runs a module with this process's Python."""
    return [sys.executable, "-P", "-m", module, *words]


def safe_environment() -> dict[str, str]:
    """The environment for such a command, which finds what this process finds, also without this package installed."""
    places = [place for place in sys.path if place]
    if _PACKAGES not in places:  # this process found it in the current folder
        places.append(_PACKAGES)
    return os.environ | SAFE | {"PYTHONPATH": os.pathsep.join(places)}


@contextmanager
def safe_path() -> Iterator[None]:
    """Holds for processes that others start inside, with the environment as it is."""
    name = "PYTHONSAFEPATH"
    with _lock:
        before = os.environ.get(name)
        os.environ |= SAFE
        try:
            yield
        finally:
            if before is None:
                del os.environ[name]
            else:
                os.environ[name] = before
