"""Manometers that are off."""

from __future__ import annotations

from math import tanh

from rig.effect import Effect, State, law


@law
class RangeSwitch(Effect):
    """A manometer that changes its range by itself: right below p_r, a gain of 1 + c above, rounded over 2 kPa.

    What it shows jumps by c p_r, as each range has an adjustment of its own. Source: data sheets of autoranging
    manometers, which state an error for either range.
    """

    c: float = 0.04
    p_r: float = 7e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge * (1 + self.c * (1 + tanh((p_gauge - self.p_r) / 2e3)) / 2)


@law
class CubicResidue(Effect):
    """What a parabola leaves of a transducer's curve: p + size P_3(2 p/p_fs - 1), Legendre's cubic over the range.

    It is off by -size at zero, by size at full scale, and waves in between. Source: transmitters that are linearised
    by a polynomial of second order, whose residue is the next orthogonal one; A. M. Legendre (1785).
    """

    size: float = 2e3  # Pa
    p_fs: float = 2.5e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        s = 2 * p_gauge / self.p_fs - 1
        return p_gauge + self.size * s * (5 * s * s - 3) / 2
