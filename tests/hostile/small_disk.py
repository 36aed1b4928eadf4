"""A disk of some kilobytes, full or read-only, that one command sees: in a name space of its own (Linux)."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Sequence
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
_SCRIPT = """
set -e
mount -t tmpfs -o size=$2k tmpfs "$1"
[ -z "$3" ] || cp -r "$3"/. "$1"
[ "$4" != read-only ] || mount -o remount,ro "$1"
[ "$4" != full ] || dd if=/dev/zero of="$1/fill" bs=1k 2>/dev/null || :
disk=$1
shift 4
set +e
"$@"
status=$?
ls -A "$disk"
exit $status
"""


@cache
def disks_can_be_made() -> bool:
    """Whether this system lets a user have one."""
    try:
        made = subprocess.run(
            ["unshare", "-rm", "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True
        )
    except OSError:
        return False
    return made.returncode == 0


def on_disk(
    disk: Path, words: Sequence[str], size: int = 16, how: str = "full", content: Path | None = None
) -> tuple[int, list[str], str]:
    """Runs Python on a disk in place of the folder ``disk``: status, lines of output with what is there then, errors.

    Args:
        disk: an empty folder.
        words: after the interpreter's name.
        size: kB.
        how: "full", "read-only" or "".
        content: a folder whose files are there before.
    """
    script = [
        "unshare",
        "-rm",
        "sh",
        "-c",
        _SCRIPT,
        "sh",
        str(disk),
        str(size),
        str(content or ""),
        how,
    ]
    made = subprocess.run(
        [*script, sys.executable, *words], capture_output=True, text=True, cwd=ROOT, timeout=300
    )
    return made.returncode, made.stdout.splitlines(), made.stderr
