"""Half widths of a band with another model error than the one that it was made with."""

from __future__ import annotations

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fitting import Discrepancy


def with_discrepancy(
    width: Array | float,
    included: Discrepancy | None,
    wanted: Discrepancy | None,
    duration: float = 0.0,
) -> Array:
    """Half widths with another discrepancy than the one that is in them; of a mean over ``duration`` [s], or a value.

    Args:
        width: half widths, of readings or of their mean.
        included: the discrepancy that the band was made with. wanted: the other one; None: none.
        duration: of the mean; 0: of a value.
    """
    squares = np.asarray(width) ** 2
    squares = squares - (included.reach(duration) ** 2 if included else 0.0)
    squares = squares + (wanted.reach(duration) ** 2 if wanted else 0.0)
    return np.sqrt(np.maximum(squares, 0.0))
