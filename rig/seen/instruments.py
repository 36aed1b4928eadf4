"""Thermometers that come late and a manometer whose line is bent."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import P_ATM

State = Sequence[float]
_SHELLS = 4


@dataclass(frozen=True)
class PottedBead(Effect):
    """A junction in the middle of a ball of potting, into which heat diffuses: four shells, the middle one is read.

    tau is radius squared over diffusivity (3 s for 0.6 mm of epoxy); slow changes come tau/6 late.
    Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids (1959), chapter 9, in finite volumes.
    """

    family = "thermocouple_lag"
    form = "potted"
    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _SHELLS
    tau: float = 1.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * _SHELLS

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        edges = [k / _SHELLS for k in range(_SHELLS + 1)]
        inward = [0.0]
        inward += [r * r * _SHELLS * (b - a) for r, a, b in zip(edges[1:-1], q[:-1], q[1:], strict=True)]
        inward.append(2 * _SHELLS * (now.temperature - q[-1]))
        volumes = [(b**3 - a**3) / 3 for a, b in zip(edges[:-1], edges[1:], strict=True)]
        gained = zip(inward[1:], inward[:-1], volumes, strict=True)
        return tuple((outer - inner) / volume / self.tau for outer, inner, volume in gained)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class BuoyantBead(Effect):
    """Around the bead the gas conducts and rises: T' = (T_gas - T)/tau (1 + a ((p/p_atm)^2 |T_gas - T|/10 K)^(1/4)).

    Source: T. Yuge, Experiments on heat transfer from spheres, J. Heat Transf. 82 (1960) 214: Nu = 2 + 0.43 Ra^(1/4).
    """

    family = "thermocouple_lag"
    form = "buoyant"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.3  # s
    a: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        off = now.temperature - q[0]
        rayleigh = (1 + now.p_gauge / P_ATM) ** 2 * (off * off + 1e-4) ** 0.5 / 10
        return (off / self.tau * (1 + self.a * rayleigh**0.25),)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class BowedManometer(Effect):
    """The transducer is adjusted at both ends of its range and off in between: p + 4 bow p/p_fs (1 - p/p_fs).

    Source: IEC 61298-2, on terminal-based conformity, in which data sheets state non-linearity.
    """

    family = "pressure_offset"
    form = "bowed"
    bow: float = 3e3  # Pa
    p_fs: float = 3e5  # Pa, full scale

    def pressure_reading(self, p_gauge: float) -> float:
        share = p_gauge / self.p_fs
        return p_gauge + 4 * self.bow * share * (1 - share)
