"""Manometers that are off."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sin, sqrt

from rig.effect import Effect, State


@dataclass(frozen=True)
class RestingPointer(Effect):
    """A gauge that was set to zero against its stop: off by a constant once it has left it, offset (1 - exp(-p/p_0)).

    Source: pressure gauges with a stop pin, whose zero says nothing of their offset (EN 837-1).
    """

    family = "pressure_offset"
    form = "resting_pointer"
    offset: float = 4e3  # Pa
    p_0: float = 2e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge - self.offset * (1 - exp(-max(p_gauge, -1e4) / self.p_0))


@dataclass(frozen=True)
class WrongKnot(Effect):
    """A scaling table with a wrong upper part: the gain is 1 + c above p_k, rounded over 3 kPa.

    Reasoned from transmitters that are scaled by a table of points.
    """

    family = "pressure_offset"
    form = "wrong_knot"
    c: float = 0.08
    p_k: float = 8e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        over = p_gauge - self.p_k
        return p_gauge + self.c * (over + sqrt(over * over + 9e6)) / 2


@dataclass(frozen=True)
class EccentricPointer(Effect):
    """A dial that is not centred on its pointer, read by eye or camera: p + size (sin(phi + phi_0) - sin(phi_0)).

    phi runs over three quarters of a turn to full scale. Reasoned from the error of eccentricity of divided circles.
    """

    family = "pressure_offset"
    form = "eccentric_pointer"
    size: float = 3e3  # Pa
    phi_0: float = 1.0  # rad
    p_fs: float = 2.5e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        phi = 1.5 * pi * p_gauge / self.p_fs
        return p_gauge + self.size * (sin(phi + self.phi_0) - sin(self.phi_0))
