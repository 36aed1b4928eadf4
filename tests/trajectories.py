"""What ``Trajectory.to_csv`` wrote, for tests."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np

from pam_cosim.simulation import Trajectory


def read_trajectory(path: Path) -> Trajectory:
    """The trajectory in a CSV file, with the units of its headings."""
    with path.open(newline="", encoding="utf-8") as file:
        heads, *rows = csv.reader(file)
    named = [head.removesuffix("]").partition(" [") for head in heads]
    columns = np.array(rows, dtype=float).reshape(-1, len(heads)).T
    pairs = [(name, unit) for name, _, unit in named[1:]]
    values = {name: column for (name, _), column in zip(pairs, columns[1:], strict=True)}
    return Trajectory(columns[0], values, dict(pairs))
