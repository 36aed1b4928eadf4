"""All of the benchmark in one command: python -m benchmarks.real_rigs.again FOLDER [--mirror FOLDER] [--rivals PYTHON].

Fetches the recordings, runs this software and, where the Python of their environment is named, the rival methods, and
writes ``results.json``, ``TABLE.md`` and the pictures. Without ``--rivals`` their results stay as they are, and the
pictures are left alone, unless the rivals were run in this folder before. Ends with the diagnoses by named laws alone
and with how often bands hold, which are printed and kept nowhere. Takes a quarter of an hour; all processes run one
after another.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path


def steps(folder: Path, mirror: Path | None, rivals: Path | None) -> Iterator[list[str]]:
    """The commands, in their order."""
    source = ["--mirror", str(mirror)] if mirror else []
    for module in ("fetch", "tunnel"):
        yield _module(sys.executable, module, folder, *source)
    yield _module(sys.executable, "ours", folder)
    if rivals:
        yield _module(str(rivals), "rivals", folder)
    yield _module(sys.executable, "table", folder)
    if rivals or any((folder / "results").glob("*.formula.npz")):
        yield _module(sys.executable, "pictures", folder)
    yield _module(sys.executable, "named", folder)
    yield _module(sys.executable, "bands", folder)


def _module(python: str, name: str, folder: Path, *words: str) -> list[str]:
    return [python, "-m", f"benchmarks.real_rigs.{name}", str(folder), *words]


def main() -> int:
    """The exit status of the first command that fails; else 0."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--mirror", type=Path)
    parser.add_argument("--rivals", type=Path, metavar="PYTHON")
    asked = parser.parse_args()
    for command in steps(asked.folder, asked.mirror, asked.rivals):
        print(" ".join(command), flush=True)
        done = subprocess.run(command, check=False)
        if done.returncode:
            return done.returncode
    return 0


if __name__ == "__main__":
    sys.exit(main())
