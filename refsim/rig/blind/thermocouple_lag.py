"""Thermometers that come late."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State


@dataclass(frozen=True)
class Compensated(Effect):
    """A thermocouple whose amplifier makes up for a part of its lag: q + r tau q', q' = (T - q)/tau.

    Source: C. E. Shepard, I. Warshawsky, Electrical techniques for compensation of thermal time lag of thermocouples,
    NACA TN 2703 (1952): the lag in use is never that for which the network was set.
    """

    family = "thermocouple_lag"
    form = "compensated"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.2  # s
    r: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0] + self.r * (temperature - q[0])


@dataclass(frozen=True)
class Recess(Effect):
    """The bead sits in a recess, whose gas flow renews: T_r' = (T - T_r)/tau (1 + |m|/m_0), the bead behind tau/5.

    States: recess and bead. Reasoned: diffusion renews a recess at rest, and flow past it in proportion.
    """

    family = "thermocouple_lag"
    form = "recess"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.4  # s
    m_0: float = 4e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        renewed = 1 + abs(now.net_mass_flow) / self.m_0
        return (now.temperature - q[0]) * renewed / self.tau, (q[0] - q[1]) * 5 / self.tau

    def reading(self, q: State, temperature: float) -> float:
        return q[1]


@dataclass(frozen=True)
class BesselFilter(Effect):
    """The thermocouple's amplifier has a Bessel filter of second order: tau^2 q'' = T - q - sqrt(3) tau q'.

    States: reading and its rate. Source: U. Tietze, C. Schenk, Electronic Circuits (2008), chapter 13.
    """

    family = "thermocouple_lag"
    form = "bessel"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-5)
    tau: float = 0.1  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return q[1], ((now.temperature - q[0]) / self.tau - 3**0.5 * q[1]) / self.tau

    def reading(self, q: State, temperature: float) -> float:
        return q[0]
