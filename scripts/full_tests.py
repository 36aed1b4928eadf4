"""Writes tests/full-tests.md: of each tenth of the full tests, when it was last run, at which commit, and how it ended.

``./scripts/test --full`` and ``--tenth N`` call it with ``before``, to say what will keep them from that, and with
``after`` and the status of the tests; the arguments of the tests follow.
"""

from __future__ import annotations

import datetime
import platform
import re
import sys
from collections.abc import Iterable, Sequence

from scripts import repository

PAGE = repository.ROOT / "tests" / "full-tests.md"
HEAD = """# When the full tests were last run

`./scripts/test --full` runs all tests marked `full` beside the quick ones, `./scripts/test --tenth N` a tenth of them.
Each writes its rows.

| tenth | ended | on | at commit | with |
|---|---|---|---|---|
"""


def tenths(asked: Sequence[str]) -> Iterable[int]:
    """Which tenths the arguments of the tests ask for as a whole; none where they choose among the tests."""
    match asked:
        case ["--full"]:
            return range(10)
        case ["--tenth", number]:
            return [int(number)]
    return []


def main(words: Sequence[str]) -> int:
    """Nothing is written where only some of the tests were run, or of what is not committed."""
    when, *asked = words
    status = asked.pop(0) if when == "after" else ""
    if not tenths(asked):
        return 0
    why = repository.missing()
    if when == "before" and why:
        print(f"the run will not be recorded in tests/full-tests.md: {why}", file=sys.stderr)
    if when == "after" and not why:  # otherwise that was said before
        record(tenths(asked), "passed" if status == "0" else "failed")
    return 0


def record(numbers: Iterable[int], outcome: str) -> None:
    """Writes rows of the page, where what was run is committed."""
    if [file for file in repository.changed() if not file.endswith(PAGE.name)]:
        print(
            "not recorded in tests/full-tests.md: there are changes that are not committed",
            file=sys.stderr,
        )
        return
    on = f"Python {platform.python_version()}, {platform.system()} {platform.machine()}"
    day = datetime.datetime.now(datetime.UTC).strftime("%Y-%m-%d")
    commit = repository.git("rev-parse", "HEAD")
    rows = dict(re.findall(r"^\| (\d) (\|.*)$", PAGE.read_text(), re.MULTILINE))
    rows |= {str(n): f"| {outcome} | {day} | `{commit}` | {on} |" for n in numbers}
    PAGE.write_text(HEAD + "".join(f"| {n} {rows[n]}\n" for n in sorted(rows)))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
