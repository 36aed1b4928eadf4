"""A corpus judged in one process with limits: what came of each of its members."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

PATIENCE = 300.0  # s for all of them, beside other tests


def judged(
    module: str, folder: Path, *words: str, patience: float = PATIENCE, quiet: bool = True
) -> list[dict[str, Any]]:
    """What a module of this folder prints of the members of a corpus, a line of JSON each, in their order.

    ``quiet``: nothing may stand on standard error; else no traceback. ``patience`` in seconds.
    """
    command: Sequence[str] = [sys.executable, "-m", f"tests.hostile.{module}", str(folder), *words]
    made = subprocess.run(
        command, capture_output=True, text=True, timeout=patience, cwd=Path(__file__).parents[2]
    )
    amiss = bool(made.stderr) if quiet else "Traceback" in made.stderr
    assert made.returncode == 0 and not amiss, made.stderr[-2000:]
    return [json.loads(line) for line in made.stdout.splitlines()]
