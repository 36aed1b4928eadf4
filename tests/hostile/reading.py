"""Runs ``pam-cosim`` on hostile data sets in one process with limits, and says in lines of JSON what came of each.

``python -m tests.hostile.reading FOLDER COMMAND...``: of every folder in it, such as ``compare`` or ``check``.
"""

from __future__ import annotations

import contextlib
import io
import json
import os
import resource
import shutil
import signal
import sys
import time
import traceback
from pathlib import Path
from types import FrameType

from pam_cosim.cli.app import main as command
from tests.hostile.corpora.data_sets import GOOD, Content, E, R, experiment

MEMORY = 2_000_000_000  # bytes of address space beyond what is loaded
ENDLESS = 60  # s of processor time, after which it counts as such


def make(folder: Path, changes: dict[str, Content]) -> Path:
    """A good data set with some of its files changed."""
    folder.mkdir(parents=True)
    for name, content in ({E: experiment(), R: GOOD} | changes).items():
        if callable(content):
            content(folder / name)
        else:
            (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)
    return folder


def _endless(number: int, frame: FrameType | None) -> None:
    raise SystemExit("endless")


def outcome(words: list[str], name: str) -> dict[str, object]:
    """What the command comes to."""
    out, err, before = io.StringIO(), io.StringIO(), time.process_time()
    signal.setitimer(signal.ITIMER_VIRTUAL, ENDLESS)
    defect, status = "", -1
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = command(words)
    except BaseException as problem:
        if os.environ.get("TRACEBACK"):
            traceback.print_exc(file=sys.__stderr__)
        defect = f"{type(problem).__name__}: {str(problem)[:300]}"
    signal.setitimer(signal.ITIMER_VIRTUAL, 0)
    return {
        "name": name,
        "status": status,
        "defect": defect,
        "said": err.getvalue()[-3000:],
        "seconds": time.process_time() - before,
        "peak": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000,
    }


def main() -> None:
    """Tells every outcome as it comes."""
    signal.signal(signal.SIGVTALRM, _endless)
    place, *words = sys.argv[1:]
    with contextlib.redirect_stdout(io.StringIO()):
        command(["compare", str(make(Path(place) / "first", {}))])  # builds the model
    shutil.rmtree(Path(place) / "first")
    most = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize() + MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    for folder in sorted(p for p in Path(place).iterdir() if p.is_dir()):
        before = sorted(p.name for p in folder.iterdir())
        told = outcome([words[0], str(folder), *words[1:]], folder.name)
        print(
            json.dumps(told | {"new": sorted({p.name for p in folder.iterdir()} - set(before))}),
            flush=True,
            file=sys.__stdout__,
        )


if __name__ == "__main__":
    main()
