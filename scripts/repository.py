"""What git says of this checkout."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def git(*words: str) -> str:
    """What git answers; empty where it fails."""
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout.strip()


def missing() -> str:
    """Why this folder has no commit of its own; empty: it has one."""
    if shutil.which("git") is None:
        return "there is no git program"
    top = git("rev-parse", "--show-toplevel")
    if not top:
        return "this folder is no git repository"
    if Path(top).resolve() != ROOT:
        return f"this folder is no git repository of its own, but lies in that of {top}"
    return "" if git("rev-parse", "--verify", "--quiet", "HEAD") else "nothing is committed"


def changed() -> list[str]:
    """Files that are not as they were committed."""
    return git("status", "--porcelain", "--untracked-files=no").splitlines()
