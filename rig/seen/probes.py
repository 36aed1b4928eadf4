"""Thermometers with a slow amplifier or a long wire, and a manometer whose bridge is not linear."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import T_ATM

State = Sequence[float]
_PIECES = 4


@dataclass(frozen=True)
class ThreePoles(Effect):
    """The thermocouple's amplifier filters out the mains by three equal poles, and what it shows is late.

    Source: data sheets of thermocouple converters; three poles in series are the usual critically damped filter
    (U. Tietze, C. Schenk, Electronic Circuits, 2008, chapter 13).
    """

    family = "thermocouple_lag"
    form = "three_poles"
    atol: ClassVar[tuple[float, ...]] = (1e-6,) * 3
    tau: float = 0.06  # s, of each pole

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 3

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        before = (now.temperature, q[0], q[1])
        return tuple((a - b) / self.tau for a, b in zip(before, q, strict=True))

    def reading(self, q: State, temperature: float) -> float:
        return q[2]


@dataclass(frozen=True)
class LongWire(Effect):
    """A bare wire from the fitting to its junction: tau T_i' = T_gas - T_i + k (T_(i-1) - 2 T_i + T_(i+1)).

    Four pieces from the root, which is at ambient temperature, to the tip; k is the square of the fin's decay length by
    that of a piece. Source: D. Bradley, K. J. Matthews, Measurement of high gas temperatures with fine wire
    thermocouples, J. Mech. Eng. Sci. 10 (1968) 299, in finite volumes.
    """

    family = "thermocouple_lag"
    form = "long_wire"
    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _PIECES
    tau: float = 0.15  # s
    k: float = 1.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * _PIECES

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        # along the wire towards the tip; from the root to the first middle it is half as far
        along = [2 * self.k * (T_ATM - q[0])]
        along += [self.k * (a - b) for a, b in zip(q[:-1], q[1:], strict=True)]
        along.append(0.0)
        pieces = zip(q, along[:-1], along[1:], strict=True)
        return tuple((now.temperature - t + came - went) / self.tau for t, came, went in pieces)

    def reading(self, q: State, temperature: float) -> float:
        return q[-1]


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

    def pressure_reading(self, p_gauge: float) -> float:
        return p_gauge / (1 + self.c * p_gauge / self.p_fs)
