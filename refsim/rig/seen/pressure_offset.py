"""Manometers that are off."""

from __future__ import annotations

from dataclasses import dataclass
from math import asinh, exp, sinh, sqrt

from rig.effect import Effect, State


@dataclass(frozen=True)
class OffsetAndGain(Effect):
    """The pressure reading has an offset and a gain, so that it is right at p_0."""

    family = "pressure_offset"
    form = "offset_and_gain"
    gain: float = 1.05
    p_0: float = 8e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + (self.gain - 1) * (p_gauge - self.p_0)


@dataclass(frozen=True)
class CurvedPressure(Effect):
    """The pressure reading has an offset and sags in the middle: offset (1 + c (p/p_0)^2)."""

    family = "pressure_offset"
    form = "curved"
    offset: float = 3e3  # Pa
    c: float = 1.0
    p_0: float = 2e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.offset * (1 + self.c * (p_gauge / self.p_0) ** 2)


@dataclass(frozen=True)
class SaturatingPressure(Effect):
    """The pressure reading is off by an offset that fades as the pressure rises: offset exp(-p/p_0)."""

    family = "pressure_offset"
    form = "fading"
    offset: float = 5e3  # Pa
    p_0: float = 2e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.offset * exp(-p_gauge / self.p_0)


@dataclass(frozen=True)
class StiffeningDiaphragm(Effect):
    """The transducer's diaphragm stiffens: it shows r where p = r + c r^3/p_0^2, so that high pressures read low.

    Source: S. Timoshenko, S. Woinowsky-Krieger, Theory of Plates and Shells (1959), chapter 13: load over deflection
    of a clamped plate has a linear and a cubic term.
    """

    family = "pressure_offset"
    form = "stiffening"
    c: float = 0.05
    p_0: float = 1.5e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        # the real root of the cubic, whose slope is above 0 everywhere
        scale = 2 * self.p_0 / sqrt(3 * self.c)
        return scale * sinh(asinh(3 * p_gauge / (scale)) / 3)


@dataclass(frozen=True)
class BowedManometer(Effect):
    """The transducer is adjusted at both ends of its range and off in between: p + 4 bow p/p_fs (1 - p/p_fs).

    Source: IEC 61298-2, on terminal-based conformity, in which data sheets state non-linearity.
    """

    family = "pressure_offset"
    form = "bowed"
    bow: float = 3e3  # Pa
    p_fs: float = 3e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        share = p_gauge / self.p_fs
        return p_gauge + 4 * self.bow * share * (1 - share)


@dataclass(frozen=True)
class UnbalancedBridge(Effect):
    """A strain-gauge bridge with one active arm, adjusted for small pressures: it shows p/(1 + c p/p_fs).

    Source: K. Hoffmann, An Introduction to Stress Analysis and Transducer Design using Strain Gauges (1989), on the
    quarter bridge: V = e/(4 + 2 e).
    """

    family = "pressure_offset"
    form = "bridge"
    c: float = 0.03
    p_fs: float = 3e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge / (1 + self.c * p_gauge / self.p_fs)
