"""The current folder is somebody else's data set: Python files in it are not run by the processes that are started."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from pam_cosim.processes.safe_path import safe_command, safe_environment

ROOT = Path(__file__).parents[2]
HARM = "open({!r}, 'a').write(__name__)\nraise ImportError(__name__)\n"
TASKS = """
import operator
from pam_cosim.processes.workers import run_tasks

if __name__ == "__main__":
    print(run_tasks(operator.neg, [1, 2], str, str, 1))
"""
WATCHED = """
import sys
from pathlib import Path
from pam_cosim.simulation.fmu_process import CO_SIMULATION, FmuProcess, start_watched
from pam_cosim.processes import watchdog

if __name__ == "__main__":
    process = start_watched(Path("none.fmu"), 60.0, CO_SIMULATION)
    watchdog.write_frame(process.stdin, watchdog.CLOSE)
    print(watchdog.read_frame(process.stdout) if process.wait(60) else "closed")
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A data set with files that have names of Python's modules, and tell when they are run."""
    folder = tmp_path / "data"
    folder.mkdir()
    for module in ("pickle", "queue", "threading", "tempfile", "loky", "numpy", "pam_cosim"):
        (folder / f"{module}.py").write_text(HARM.format(str(tmp_path / "harm")))
    return folder


def run(script: str, folder: Path) -> str:
    """What a script prints that lies elsewhere and runs in a folder."""
    file = folder.parent / "script.py"
    file.write_text(script)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    environment.pop("PYTHONSAFEPATH", None)  # what is tested sets it
    done = subprocess.run(
        [sys.executable, str(file)],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout.strip()


def test_workers_run_nothing_that_lies_there(folder: Path) -> None:
    assert run(TASKS, folder) == "[-1, -2]"
    assert not (folder.parent / "harm").exists()


def test_processes_of_fmus_run_nothing_that_lies_there(folder: Path) -> None:
    assert run(WATCHED, folder) == "closed"
    assert not (folder.parent / "harm").exists()


def test_a_package_in_the_current_folder_of_the_user_is_found(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A notebook in a checkout that is not installed: the package is found by an empty place in the path."""
    monkeypatch.setattr(sys, "path", ["", *(place for place in sys.path if place != str(ROOT))])
    words = safe_command("pam_cosim.processes.safe_path")
    assert words[1:3] == ["-P", "-m"]
    places = safe_environment()["PYTHONPATH"].split(os.pathsep)
    assert str(ROOT) in places and "" not in places
    subprocess.run(words, cwd=tmp_path, env=safe_environment(), check=True, timeout=60)
