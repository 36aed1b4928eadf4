"""OpenModelica's compiler, where it is on the path and starts (README.md)."""

from __future__ import annotations

import shutil
import subprocess

WHY_NOT = "OpenModelica's omc is not on the path, or does not start"


def _program() -> str | None:
    found = shutil.which("omc")
    starts = found and subprocess.run([found, "--version"], capture_output=True, check=False)
    return found if starts and starts.returncode == 0 else None


OMC = _program()
