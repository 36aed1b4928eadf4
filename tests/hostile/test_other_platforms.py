"""What a platform without POSIX lacks is not needed: no run on Windows, but what would stop one at once."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

IMPORT_ALL = """
import asyncio, importlib, multiprocessing, os, pkgutil, signal, sys
import casadi, fmpy, h5netcdf, h5py, loky, matplotlib.pyplot, pandas, pint, pyarrow, scipy.optimize, typer
import scipy.signal, scipy.stats, starlette.applications, uvicorn, websockets, xarray
for name in ("fcntl", "resource", "pwd", "grp", "termios", "pty", "tty"):
    sys.modules[name] = None
for name in ("SIGKILL", "SIGHUP", "SIGSTOP", "SIGCONT", "SIGALRM", "pthread_sigmask", "sigpending", "sigwait"):
    delattr(signal, name)
for name in ("killpg", "fork", "getuid", "geteuid", "setsid", "getpgid", "mkfifo", "sched_getaffinity", "O_NOFOLLOW",
             "O_NONBLOCK", "uname", "getloadavg", "sysconf"):
    delattr(os, name)
import pam_cosim
for module in pkgutil.walk_packages(pam_cosim.__path__, "pam_cosim."):
    if not module.name.endswith("__main__"):
        importlib.import_module(module.name)
print(len([name for name in sys.modules if name.startswith("pam_cosim.")]))
"""

WORK = """
import tempfile
from pathlib import Path
from pam_cosim.cli.app import main
place = Path(tempfile.mkdtemp())
assert main(["effects"]) == 0
assert main(["sweep", "VesselOrifice", "--vary", "tank.V=10 l,16 l", "-o", str(place / "sweep.csv")]) == 0
assert (place / "sweep.csv").read_text().count("\\n") > 2
"""


def environment(**more: str) -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT), **more}


@pytest.mark.full
def test_every_module_loads_and_works_without_what_windows_lacks() -> None:
    script = IMPORT_ALL.replace("", "").replace("WORK", WORK)
    done = subprocess.run(
        [sys.executable, "-c", script],
        env=environment(),
        capture_output=True,
        text=True,
        timeout=300,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    assert int(done.stdout.split()[0]) > 400


@pytest.mark.parametrize("encoding", ["cp1252", "ascii"])
def test_letters_that_a_terminal_lacks_end_nothing(encoding: str) -> None:
    """Arrows and Greek letters are in what is printed; Windows' usual encoding has none."""
    script = (
        "import sys; sys.argv = ['pam-cosim', '--version']; from pam_cosim.cli import process\n"
    )
    script += "try:\n    process.run()\nfinally:\n    print('24.1 \\u2192 0.986, \\u03c7')\n"
    script += "    print('\\u2192', file=sys.stderr)"
    done = subprocess.run(
        [sys.executable, "-c", script],
        env=environment(PYTHONIOENCODING=f"{encoding}:strict"),
        capture_output=True,
    )
    assert done.returncode == 0, done.stderr
    assert b"24.1 ? 0.986, ?" in done.stdout
