"""Data sets from which a beginning, or a part in the middle, is cut."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

Rows = list[str]
Keep = Callable[[float, float, float], bool]
"""(time, begin, end) of a row and of its run -> whether it is kept."""

PAUSE = 0.2  # of a run's duration
EARLIEST, LATEST = 0.15, 0.6  # of a run's duration, between which it is cut


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


def without_beginning(source: Path, folder: Path, seed: int) -> Path:
    """Each recording from a random time on."""

    def keep(random: np.random.Generator) -> Keep:
        share = random.uniform(EARLIEST, LATEST)
        return lambda time, begin, end: time >= begin + share * (end - begin)

    return cut_files(source, folder, keep, seed)


def in_pieces(source: Path, folder: Path, seed: int) -> Path:
    """Each recording with a pause of a fifth of it, at a random time; its pieces begin anew."""

    def keep(random: np.random.Generator) -> Keep:
        share = random.uniform(EARLIEST, LATEST)
        return lambda time, begin, end: not share <= (time - begin) / (end - begin) <= share + PAUSE

    made = cut_files(source, folder, keep, seed)
    text = (made / "experiment.toml").read_text()
    (made / "experiment.toml").write_text(f'gaps = "split"\n{text}')
    return made
