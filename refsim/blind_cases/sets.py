"""Every set by its name: those of one bench (`cases`) and those of many (`many`).

    python -m blind_cases.sets FOLDER --set tuning2 --number 7

writes one data set and prints what is hidden in it.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from blind_cases import cases, many

Case = cases.Case | many.Case
Made = cases.Made | many.Made
SETS = (*cases.SEEDS, *many.SEEDS)


def case_of(which: str, number: int) -> Case:
    """The case with this number (from 0) of a set. Raises ValueError for an unknown set or a negative number."""
    return many.case_of(which, number) if which in many.SEEDS else cases.case_of(which, number)


def outline(case: Case) -> dict[str, Any]:
    """What is known of a case before it is simulated: the description of one that could not be."""
    return many.outline(case) if isinstance(case, many.Case) else cases.outline(case)


def make(case: Case) -> Made:
    """Simulates a case. Raises RuntimeError when its hidden effect cannot be simulated at any strength."""
    return many.make(case) if isinstance(case, many.Case) else cases.make(case)


def write(made: Made, folder: Path) -> None:
    """Writes experiment.toml and the runs; nothing in them says what is hidden."""
    if isinstance(made, many.Made):
        many.write(made, folder)
    else:
        cases.write(made, folder)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line: writes one case, prints what is hidden in it."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path)
    parser.add_argument("--set", dest="which", choices=SETS, default="tuning")
    parser.add_argument("--number", type=int, default=0)
    options = parser.parse_args(arguments)
    made = make(case_of(options.which, options.number))
    write(made, options.folder)
    print(json.dumps(made.description, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
