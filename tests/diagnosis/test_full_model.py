"""Effects of a full model begin near their absence, in a coordinate that has a value at every bound."""

from __future__ import annotations

import math

import pytest

from pam_cosim.diagnosis.search.full_model import near_absence
from pam_cosim.fitting import Free


@pytest.mark.parametrize("low", [0.0, -5.0, 0.1])
@pytest.mark.parametrize("absent", [0.0, 1e7])
def test_every_bound_has_a_coordinate(low: float, absent: float) -> None:
    """A ceiling that is away at infinity and may be as low as zero had none: the logarithm of zero."""
    free = near_absence(Free("high", low, 1e6, 3e5, "Pa"), absent)
    coordinates = [free.to_z(value) for value in (free.low, free.start, free.high)]
    assert all(map(math.isfinite, coordinates)) and coordinates == sorted(coordinates)
    assert abs(free.start - absent) < abs(3e5 - absent)
