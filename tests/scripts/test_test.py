"""./scripts/test, with programs in place of those of .venv."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.documentation.pages import ROOT

PATIENCE = 120.0  # [s] on a machine that does much else
# an interrupt is heard, also where these tests run with it ignored
STARTER = "import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_DFL); os.execvp(sys.argv[1], sys.argv[1:])"
SHELLS = [shell for shell in ("sh", "dash", "bash") if shutil.which(shell)]

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a script for a POSIX shell")


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """The script with what it calls: mypy writes its number to a file, pytest that it has begun."""
    programs = tmp_path / ".venv" / "bin"
    for folder in (programs, tmp_path / "scripts", tmp_path / "temporary"):
        folder.mkdir(parents=True)
    shutil.copy(ROOT / "scripts" / "test", tmp_path / "scripts" / "test")
    for name, lines in {
        "ruff": "exit 0",
        "mypy": 'echo $$ >mypy.new; mv mypy.new mypy; [ ! -e slow ] || exec sleep 600; echo "no issues"',
        "python": 'echo "$*" >>calls; case "$*" in *pytest*) touch begun; '
        "[ ! -e slow ] || exec sleep 600; exit 3 ;; esac",
    }.items():
        (programs / name).write_text(f"#!/bin/sh\n{lines}\n")
        (programs / name).chmod(0o755)
    return tmp_path


def started(checkout: Path, shell: str, *words: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-c", STARTER, shell, str(checkout / "scripts" / "test"), *words],
        env=os.environ | {"PYTHON": "true", "TMPDIR": str(checkout / "temporary")},
        start_new_session=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


@pytest.mark.parametrize("shell", SHELLS)
def test_its_status_is_that_of_the_tests(checkout: Path, shell: str) -> None:
    script = started(checkout, shell, "--full")
    said, _ = script.communicate(timeout=PATIENCE)
    assert script.returncode == 3 and "no issues" in said
    assert not list((checkout / "temporary").iterdir())
    calls = (checkout / "calls").read_text().splitlines()
    assert [call for call in calls if "full_tests" in call] == [
        "-m scripts.full_tests before --full",
        "-m scripts.full_tests after 3 --full",
    ]
