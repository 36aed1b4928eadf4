"""Forms that nobody who works on the diagnosis has looked at lie apart, packed: nobody opens them by accident.

    python -m blind_cases.apart pack build/score3      # what a folder holds -> refsim/score3_forms.zip
    python -m blind_cases.apart unpack build/score3    # for who writes the forms of a score, and no one else

The archive holds a package `score3_forms`: the forms, their lines of the table (`lines`), and what each must give by a
limit or by what it conserves (`checks`). It is imported when a set asks for it; the folder is not committed.
"""

from __future__ import annotations

import argparse
import importlib
import sys
import zipfile
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

ARCHIVE = Path(__file__).parents[1] / "score3_forms.zip"
PACKAGE = ARCHIVE.stem
_TIME = (1980, 1, 1, 0, 0, 0)  # of each file in it: the same folder gives the same archive


def module(name: str) -> ModuleType:
    """A module of the archive. Raises FileNotFoundError where the archive is not beside the package."""
    if not ARCHIVE.exists():
        raise FileNotFoundError(f"{ARCHIVE} is not there: the set is made from a checkout only")
    if str(ARCHIVE) not in sys.path:
        sys.path.append(str(ARCHIVE))
    return importlib.import_module(f"{PACKAGE}.{name}")


def pack(folder: Path, archive: Path = ARCHIVE) -> None:
    """Writes the package that lies in a folder into an archive, in one order and with one time."""
    files = sorted((folder / PACKAGE).rglob("*.py"), key=lambda file: file.as_posix())
    with zipfile.ZipFile(archive, "w") as packed:
        for file in files:
            entry = zipfile.ZipInfo(file.relative_to(folder).as_posix(), _TIME)
            entry.compress_type, entry.create_system = zipfile.ZIP_DEFLATED, 3
            entry.external_attr = 0o644 << 16
            packed.writestr(entry, file.read_bytes(), compresslevel=9)


def unpack(folder: Path, archive: Path = ARCHIVE) -> None:
    """Writes the package of an archive into a folder."""
    with zipfile.ZipFile(archive) as packed:
        packed.extractall(folder)


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=("pack", "unpack"))
    parser.add_argument("folder", type=Path)
    options = parser.parse_args(arguments)
    {"pack": pack, "unpack": unpack}[options.what](options.folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
