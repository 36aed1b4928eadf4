"""What the scripts of the examples share: where measurements of others lie, and how tables are written."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
VARIABLE = "PAM_COSIM_DATA"


def raw_folder(name: str, argument: str | None = None) -> Path | None:
    """The folder with the raw files of one source; None where there is none.

    It is looked for under ``argument``, the environment variable PAM_COSIM_DATA, or ``../shared/data`` beside the
    checkout, in this order; the first that is given counts.
    """
    base = Path(argument or os.environ.get(VARIABLE) or ROOT.parent / "shared" / "data")
    folder = base / name
    return folder if folder.is_dir() else None


def asked_for() -> str | None:
    """The path on the command line, if any."""
    return sys.argv[1] if len(sys.argv) > 1 else None


def write_table(path: Path, columns: Mapping[str, Sequence[float]], source: str) -> None:
    """A CSV file; NaN becomes an empty cell, numbers keep six digits."""
    rows = zip(*columns.values(), strict=True)
    lines = [*(f"# {line}" for line in source.splitlines()), ",".join(columns)]
    lines += [",".join("" if np.isnan(v) else f"{v:.6g}" for v in row) for row in rows]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def markdown_table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """A table of Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(c) for c in line) + " |" for line in lines)
