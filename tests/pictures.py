"""Whether a picture shows something."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.image import imread

_LEAST = (
    1e-4  # of the pixels: a few marks over several axes; those of empty axes have no colour at all
)


def drawn(picture: Path) -> bool:
    """Whether enough pixels are coloured: axes, grids and letters are black and grey."""
    coloured = np.ptp(imread(picture)[..., :3], axis=-1) > 0.25
    return float(np.mean(coloured)) > _LEAST
