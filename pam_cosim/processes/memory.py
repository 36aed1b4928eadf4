"""How much memory a process with an FMU of another tool may take, where the system has such a limit."""

from __future__ import annotations

import contextlib
import os
import sys

VARIABLE = "PAM_COSIM_FMU_MEMORY"


def _asked() -> float:
    """Bytes: the limit in the environment [GB], or the default."""
    with contextlib.suppress(ValueError):
        limit = float(os.environ.get(VARIABLE, ""))
        if 0 < limit < 1e6:
            return limit * 1e9
    return 2e9


MOST_MEMORY = _asked()
"""Bytes of data in addition to the loaded program."""


def limit_memory() -> None:
    """Lets this process and those that it starts have no more data than that; on Linux alone."""
    if not sys.platform.startswith("linux"):
        return
    import resource

    most = int(MOST_MEMORY) + _data()
    hard = resource.getrlimit(resource.RLIMIT_DATA)[1]
    if hard == resource.RLIM_INFINITY or most < hard:
        with contextlib.suppress(OSError, ValueError):
            resource.setrlimit(resource.RLIMIT_DATA, (most, most))


def _data() -> int:
    """Bytes of data that this process has already."""
    with (
        contextlib.suppress(OSError, ValueError, IndexError),
        open("/proc/self/status", encoding="ascii") as status,
    ):
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith("VmData"))
    return 0
