"""Tables of points at rest as invented laboratories have them: the simple muscle of ``labs``, with noise."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from tests.drafting.labs import LENGTH, Array, force

HYSTERESIS = 6e3  # Pa between the way up and the way down


def grid(pressures: Sequence[float], contractions: Sequence[float]) -> tuple[Array, Array, Array]:
    """Pressure [Pa], contraction [m] and pull [N] of every pair."""
    p, x = (one.ravel() for one in np.meshgrid(pressures, contractions, indexing="ij"))
    return p, x, np.asarray(force(p, x))


def noise(count: int, sigma: float, seed: int) -> Array:
    """(n,) of that standard deviation."""
    return np.random.default_rng(seed).normal(0.0, sigma, count)


def no_load(pressures: Sequence[float], load: float = 0.0) -> Array:
    """Contraction [m] at which the muscle pulls as much as the load, with a spring of 400 N/m as its bladder."""
    at = [
        brentq(lambda x, p=p: float(force(p, x)) - 400.0 * x - load, 0.0, LENGTH / 2)
        if force(p, 0.0) > load
        else 0.0
        for p in pressures
    ]
    return np.array(at)


def loop(highest: float, count: int, load: float = 0.0) -> tuple[Array, Array, Array]:
    """Pressures up and down again, contractions with hysteresis, and 1 or -1."""
    up = np.linspace(0.0, highest, count)
    way = np.repeat([1.0, -1.0], [count, count - 1])
    p = np.concatenate([up, up[-2::-1]])
    return p, no_load(np.clip(p - way * HYSTERESIS / 2, 0.0, None), load), way


def write(file: Path, heading: str, rows: Sequence[Sequence[object]], end: str = "") -> Path:
    """A file of text with commas; ``end``: what every line ends with."""
    lines = [
        ",".join(str(cell) if isinstance(cell, str) else f"{cell:.4g}" for cell in row) + end
        for row in rows
    ]
    file.write_text(
        "\n".join([*([heading + end] if heading else []), *lines]) + "\n", encoding="utf-8"
    )
    return file
