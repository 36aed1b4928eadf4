"""Draws the pictures of docs/validation.md and prints the sentences of that page that rest on the same runs.

Run as ``python scripts/pictures.py [FOLDER]`` (docs/pictures); takes about half a minute the first time.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT)]

import matplotlib.pyplot as plt  # noqa: E402

from scripts.validation import empirical, exponent, muscle, slides  # noqa: E402
from scripts.validation.drawing import STYLE  # noqa: E402

Drawer = Callable[[Path], list[str]]
DRAWERS: tuple[Drawer, ...] = (
    exponent.phantom_flow, exponent.tank_curves, exponent.polytropic_exponent, muscle.gas_temperature,
    muscle.temperature_band, muscle.bladder_friction, muscle.butyl_pressure, muscle.butyl_slow_rise,
    empirical.loads_and_rates, empirical.force_dynamics, slides.two_lengths, slides.force_grid, slides.shapes,
    slides.lumped_step,
)  # fmt: skip


def drawn(folder: Path) -> list[str]:
    """Draws all pictures into a folder; returns the sentences."""
    folder.mkdir(parents=True, exist_ok=True)
    with plt.rc_context(STYLE):
        return [sentence for draw in DRAWERS for sentence in draw(folder)]


if __name__ == "__main__":
    print(*drawn(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "docs" / "pictures"), sep="\n")
