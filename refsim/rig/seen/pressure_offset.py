"""Manometers that are off."""

from __future__ import annotations

from math import asinh, exp, pi, sin, sinh, sqrt

from rig.effect import Effect, State, law


@law
class OffsetAndGain(Effect):
    """The pressure reading has an offset and a gain, so that it is right at p_0."""

    gain: float = 1.05
    p_0: float = 8e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + (self.gain - 1) * (p_gauge - self.p_0)


@law
class CurvedPressure(Effect):
    """The pressure reading has an offset and sags in the middle: offset (1 + c (p/p_0)^2)."""

    offset: float = 3e3  # Pa
    c: float = 1.0
    p_0: float = 2e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.offset * (1 + self.c * (p_gauge / self.p_0) ** 2)


@law
class SaturatingPressure(Effect):
    """The pressure reading is off by an offset that fades as the pressure rises: offset exp(-p/p_0)."""

    offset: float = 5e3  # Pa
    p_0: float = 2e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.offset * exp(-p_gauge / self.p_0)


@law
class StiffeningDiaphragm(Effect):
    """The transducer's diaphragm stiffens: it shows r where p = r + c r^3/p_0^2, so that high pressures read low.

    Source: S. Timoshenko, S. Woinowsky-Krieger, Theory of Plates and Shells (1959), chapter 13: load over deflection
    of a clamped plate has a linear and a cubic term.
    """

    c: float = 0.05
    p_0: float = 1.5e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        # the real root of the cubic, whose slope is above 0 everywhere
        scale = 2 * self.p_0 / sqrt(3 * self.c)
        return scale * sinh(asinh(3 * p_gauge / (scale)) / 3)


@law
class BowedManometer(Effect):
    """The transducer is adjusted at both ends of its range and off in between: p + 4 bow p/p_fs (1 - p/p_fs).

    Source: IEC 61298-2, on terminal-based conformity, in which data sheets state non-linearity.
    """

    bow: float = 3e3  # Pa
    p_fs: float = 3e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        share = p_gauge / self.p_fs
        return p_gauge + 4 * self.bow * share * (1 - share)


@law
class UnbalancedBridge(Effect):
    """A strain-gauge bridge with one active arm, adjusted for small pressures: it shows p/(1 + c p/p_fs).

    Source: K. Hoffmann, An Introduction to Stress Analysis and Transducer Design using Strain Gauges (1989), on the
    quarter bridge: V = e/(4 + 2 e).
    """

    c: float = 0.03
    p_fs: float = 3e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge / (1 + self.c * p_gauge / self.p_fs)


@law
class RestingPointer(Effect):
    """A gauge that was set to zero against its stop: off by a constant once it has left it, offset (1 - exp(-p/p_0)).

    Source: pressure gauges with a stop pin, whose zero says nothing of their offset (EN 837-1).
    """

    offset: float = 4e3  # Pa
    p_0: float = 2e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge - self.offset * (1 - exp(-max(p_gauge, -1e4) / self.p_0))


@law
class WrongKnot(Effect):
    """A scaling table with a wrong upper part: the gain is 1 + c above p_k, rounded over 3 kPa.

    Reasoned from transmitters that are scaled by a table of points.
    """

    c: float = 0.08
    p_k: float = 8e4  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        over = p_gauge - self.p_k
        return p_gauge + self.c * (over + sqrt(over * over + 9e6)) / 2


@law
class EccentricPointer(Effect):
    """A dial that is not centred on its pointer, read by eye or camera: p + size (sin(phi + phi_0) - sin(phi_0)).

    phi runs over three quarters of a turn to full scale. Reasoned from the error of eccentricity of divided circles.
    """

    size: float = 3e3  # Pa
    phi_0: float = 1.0  # rad
    p_fs: float = 2.5e5  # Pa, full scale

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        phi = 1.5 * pi * p_gauge / self.p_fs
        return p_gauge + self.size * (sin(phi + self.phi_0) - sin(self.phi_0))
