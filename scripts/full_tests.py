"""Writes tests/full-tests.md: which version all tests passed of.

``./scripts/test --full`` calls it with ``before``, to say what will keep it from that, and when they have passed with
``after``; the arguments of the tests follow.
"""

from __future__ import annotations

import datetime
import platform
import sys
from collections.abc import Sequence

from scripts import repository

PAGE = repository.ROOT / "tests" / "full-tests.md"
TITLE = "# When the full tests last passed\n\n"


def main(words: Sequence[str]) -> int:
    """Nothing is written where only some of the tests were run, or of what is not committed."""
    when, *asked = words
    if asked != ["--full"]:
        return 0
    why = repository.missing()
    if when == "before" and why:
        print(f"a pass will not be recorded in tests/full-tests.md: {why}", file=sys.stderr)
    if when == "after" and not why:  # otherwise that was said before
        record()
    return 0


def record() -> None:
    """Writes the page, where what passed is committed."""
    if repository.changed():
        print(
            "not recorded in tests/full-tests.md: there are changes that are not committed",
            file=sys.stderr,
        )
        return
    on = f"Python {platform.python_version()}, {platform.system()} {platform.machine()}"
    day = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
    commit = repository.git("rev-parse", "HEAD")
    PAGE.write_text(
        f"{TITLE}`./scripts/test --full` passed on {day} at commit `{commit}` ({on}).\n"
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
