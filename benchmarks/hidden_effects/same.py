"""Whether two versions of the program say the same of the same cases, number for number.

    python -m benchmarks.hidden_effects.score --set tuning3 --cases 10 --out before.jsonl
    git checkout OTHER; python -m benchmarks.hidden_effects.score --set tuning3 --cases 10 --out after.jsonl
    python -m benchmarks.hidden_effects.same before.jsonl after.jsonl

Prints every value that differs, by its place in the JSON; the status is 1 where one does. Times are not compared.
"""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from benchmarks.results import Result, read_results

_COMPARED = ("case", "diagnosis", "error")


def differences(before: Any, after: Any, place: str = "") -> Iterator[str]:
    """``place: before -> after`` for each value that is not equal to the last bit; NaN is equal to NaN."""
    if isinstance(before, dict) and isinstance(after, dict):
        for name in dict.fromkeys([*before, *after]):
            inner = f"{place}.{name}" if place else str(name)
            yield from differences(before.get(name, "nothing"), after.get(name, "nothing"), inner)
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        for i, (one, other) in enumerate(zip(before, after, strict=True)):
            yield from differences(one, other, f"{place}[{i}]")
    elif not _equal(before, after):
        yield f"{place}: {before} -> {after}"


def _equal(before: Any, after: Any) -> bool:
    both = isinstance(before, float) and isinstance(after, float)
    return bool(before == after) or (both and math.isnan(before) and math.isnan(after))


def compared(before: dict[int, Result], after: dict[int, Result]) -> Iterator[str]:
    """Differences of the cases that both have, with the case's number in front."""
    for number in sorted(before.keys() & after.keys()):
        first, second = (
            {key: result.get(key) for key in _COMPARED}
            for result in (before[number], after[number])
        )
        yield from (f"case {number}: {text}" for text in differences(first, second))


def main(arguments: Sequence[str] | None = None) -> int:
    """Reads two files of results and compares them."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("before", type=Path)
    parser.add_argument("after", type=Path)
    chosen = parser.parse_args(arguments)
    before, after = read_results(chosen.before), read_results(chosen.after)
    both = before.keys() & after.keys()
    if not both:
        print("the two files have no case in common", file=sys.stderr)
        return 2
    lines = list(compared(before, after))
    print(*lines, sep="\n", end="\n" if lines else "")
    alone = len(before.keys() ^ after.keys())
    print(f"{len(both)} cases compared, {len(lines)} values differ; {alone} cases in one file only")
    return 1 if lines else 0


if __name__ == "__main__":
    sys.exit(main())
