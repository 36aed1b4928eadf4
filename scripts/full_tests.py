"""Writes docs/full-tests.md: which version all tests passed of; ``./scripts/test --full`` calls it when they have."""

from __future__ import annotations

import datetime
import platform
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "full-tests.md"
TITLE = "# When the full tests last passed\n\n"


def git(*words: str) -> str:
    """What git answers; empty where there is no repository."""
    return subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True).stdout.strip()


def main(words: Sequence[str]) -> int:
    """Nothing is written where only some of the tests were run, or of what is not committed."""
    if list(words) != ["--full"]:
        return 0
    if git("status", "--porcelain", "--untracked-files=no"):
        print(
            "not recorded in docs/full-tests.md: there are changes that are not committed",
            file=sys.stderr,
        )
        return 0
    on = f"Python {platform.python_version()}, {platform.system()} {platform.machine()}"
    day = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
    PAGE.write_text(
        f"{TITLE}`./scripts/test --full` passed on {day} at commit `{git('rev-parse', 'HEAD')}` ({on}).\n"
    )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
