"""Curves that are printed in a notebook, back to numbers: the centre of a coloured line in each column of a picture."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO

import matplotlib.image
import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Ticks = Sequence[tuple[float, float]]  # value, pixel

LEAST_COLOUR = 0.12  # share of a line's colour in a pixel; less is the rim of another line


def picture(notebook: bytes, cell: int) -> Array:
    """(rows, columns, 3) the picture that a cell of a notebook shows, on white.

    Raises:
        ValueError: the cell shows none.
    """
    for output in json.loads(notebook)["cells"][cell].get("outputs", []):
        if "image/png" in output.get("data", {}):
            pixels = np.asarray(
                matplotlib.image.imread(BytesIO(base64.b64decode(output["data"]["image/png"]))),
                float,
            )
            opaque = pixels[..., 3:]
            return pixels[..., :3] * opaque + (1 - opaque)
    raise ValueError(f"cell {cell} of the notebook shows no picture")


@dataclass(frozen=True)
class Panel:
    """Axes of a picture: rows within the frame, and where the ticks are."""

    rows: tuple[int, int]
    across: Ticks
    up: Ticks
    count: int

    @property
    def columns(self) -> Array:
        """(count,) pixel columns of the samples 0, 1, ..."""
        values, pixels = np.array(self.across).T
        return np.polyval(np.polyfit(values, pixels, 1), np.arange(self.count))

    def course(self, image: Array, colour: str, others: Sequence[str], first: float) -> Array:
        """(count,) values of the line of a colour, from the row ``first`` on; NaN where it is not seen."""
        share = _share(image[self.rows[0] : self.rows[1]], colour, others)
        columns = np.arange(int(self.columns[0]) - 1, int(self.columns[-1]) + 3)
        centres, last = np.full(len(columns), np.nan), first - self.rows[0]
        for place, column in enumerate(columns):
            found = _centre(share[:, column], last)
            if found is not None:
                centres[place] = last = found
        seen = np.isfinite(centres)
        rows = np.interp(self.columns, columns[seen], centres[seen] + self.rows[0])
        rows[np.interp(self.columns, columns, seen.astype(float)) < 1] = np.nan
        values, pixels = np.array(self.up).T
        return np.polyval(np.polyfit(pixels, values, 1), rows)


def _share(box: Array, colour: str, others: Sequence[str]) -> Array:
    """Share of a colour in each pixel, beside those of other lines, of black and of white."""
    paints = [*(_rgb(one) - 1 for one in (colour, *others)), np.full(3, -1.0)]
    mixed = np.linalg.lstsq(np.array(paints).T, (box - 1).reshape(-1, 3).T, rcond=None)[0]
    share = np.clip(mixed[0].reshape(box.shape[:2]), 0, 1)
    return np.where(share < LEAST_COLOUR, 0.0, share)


def _rgb(colour: str) -> Array:
    return np.array([int(colour[i : i + 2], 16) / 256 for i in (1, 3, 5)])


def _centre(column: Array, last: float, farthest: float = 14) -> float | None:
    """Middle of the stretch of colour that is nearest to where the line was; None: there is none near."""
    rows = np.nonzero(column)[0]
    if not len(rows):
        return None
    stretches = np.split(rows, np.nonzero(np.diff(rows) > 1)[0] + 1)
    nearest = min(stretches, key=lambda s: max(s[0] - last, last - s[-1], 0))
    if max(nearest[0] - last, last - nearest[-1]) > farthest:
        return None
    return float(column[nearest] @ nearest / column[nearest].sum())
