"""Cases that were made before they are diagnosed, so that what is changed in the software is tried in less time.

    python -m blind_cases.prepared --set tuning2 --cases 80 --jobs 2

makes them under build/, where `one` and `score` find them. A change in the rig or in what composes the cases makes
others. The description of a case, which says what is hidden, lies beside its data set, not in it.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import shutil
import sys
import tempfile
import traceback
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from blind_cases.apart import ARCHIVE
from blind_cases.cases import SEEDS, case_of, make, write

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build" / "hidden-effects-cases"


@cache
def _version() -> str:
    """Changes with whatever a case is made by."""
    own = [file for file in Path(__file__).parent.glob("*.py") if file != Path(__file__)]
    state = hashlib.sha256()
    for file in sorted([*own, ARCHIVE, *(ROOT / "refsim" / "rig").rglob("*.py")]):
        state.update(file.relative_to(ROOT).as_posix().encode() + b"\0" + file.read_bytes())
    return state.hexdigest()[:16]


def _place(which: str, number: int) -> Path:
    return FOLDER / _version() / f"{which}-{number}"


def prepare(which: str, number: int) -> None:
    """Makes a case, unless it is there. Raises RuntimeError where its hidden effect cannot be simulated."""
    place = _place(which, number)
    if place.exists():
        return
    place.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=place.parent) as scratch:
        folder = Path(scratch) / "case"
        description = _made_now(which, number, folder / "data")
        (folder / "description.json").write_text(json.dumps(description))
        with suppress(OSError):  # somebody else was faster
            folder.rename(place)


def made_case(which: str, number: int, folder: Path) -> dict[str, Any]:
    """Writes the data set of a case, prepared or made now; its description. Raises as ``prepare``."""
    place = _place(which, number)
    if place.exists():
        shutil.copytree(place / "data", folder, dirs_exist_ok=True)
        return dict(json.loads((place / "description.json").read_text()))
    return _made_now(which, number, folder)


def _made_now(which: str, number: int, folder: Path) -> dict[str, Any]:
    made = make(case_of(which, number))
    write(made, folder)
    return made.description


def _outcome(which: str, number: int) -> str:
    try:
        prepare(which, number)
    except Exception:
        return f"{number}: {traceback.format_exc().splitlines()[-1]}"
    return f"{number}: there"


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--set", dest="which", choices=SEEDS, required=True)
    parser.add_argument("--cases", type=int, default=80, help="how many, from --first on")
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args(arguments)
    numbers = range(options.first, options.first + options.cases)
    with ProcessPoolExecutor(options.jobs) as pool:
        for line in pool.map(_outcome, [options.which] * len(numbers), numbers):
            print(line, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
