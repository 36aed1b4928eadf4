"""Data sets of which rows are cut."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

Rows = list[str]
Keep = Callable[[float, float, float], bool]
"""(time, begin, end) of a row and of its run -> whether it is kept."""


def cut_files(
    source: Path, folder: Path, keep: Callable[[np.random.Generator], Keep], seed: int
) -> Path:
    """A copy of a data set whose recordings lack rows; the same seed cuts the same rows."""
    folder.mkdir(parents=True)
    shutil.copy(source / "experiment.toml", folder)
    for number, file in enumerate(sorted(source.glob("*.csv"))):
        head, *rows = file.read_text().splitlines()
        kept = keep(np.random.default_rng([seed, number]))
        (folder / file.name).write_text("\n".join([head, *_kept(rows, kept)]) + "\n")
    return folder


def _kept(rows: Sequence[str], keep: Keep) -> Rows:
    times = [float(row.split(",")[0]) for row in rows]
    return [row for row, time in zip(rows, times, strict=True) if keep(time, times[0], times[-1])]
