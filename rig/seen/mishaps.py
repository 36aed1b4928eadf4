"""Effects in no family: what heats, holds or feeds the rig from outside, and instruments that disturb themselves.

As those of `strange`, `faults` and `disturbances`, each is kept away from what a family says.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Now, Rest
from rig.seen.faults import Intermittent
from rig.seen.strange import Strange

State = Sequence[float]


@dataclass(frozen=True)
class HeatLamp(Intermittent):
    """A lamp or a fan heater beside the rig goes on and off, and a part of its heat reaches the gas."""

    form = "heat_lamp"
    power: float = 0.5  # W
    period: float = 3.0  # s

    def heat(self, q: State) -> float:
        return self.power if self.goes(q) else 0.0


@dataclass(frozen=True)
class BufferTank(Strange):
    """The supply is a small tank that filling draws down and a thin hose refills: the supply is p (1 - q).

    The state q is the share of its gas that is missing: q' = m_net/m_tank while the muscle fills, less q/tau.
    """

    form = "buffer_tank"
    atol: ClassVar[tuple[float, ...]] = (1e-8,)
    per_kilogram: float = 300.0  # 1/kg, one over the tank's gas
    tau: float = 3.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (max(now.net_mass_flow, 0.0) * self.per_kilogram - q[0] / self.tau,)

    def supply(self, q: State, p: float) -> float:
        return p * (1 - min(q[0], 0.8))


@dataclass(frozen=True)
class SaggingExcitation(Strange):
    """The valves draw from the supply of the pressure transducer, whose gain sags with their currents.

    The state is the sum of the currents by 0.35 A behind 5 ms.
    """

    form = "sagging_excitation"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    share: float = 0.03

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (sum(rest.currents) / 0.35,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((sum(now.command) / 0.35 - q[0]) / 5e-3,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge * (1 - self.share * q[0])


@dataclass(frozen=True)
class HoldingMagnet(Strange):
    """The load rests on a magnetic plate and comes off it with a jerk: F/(1 + x/d)^2 off the plate."""

    form = "holding_magnet"
    size: float = 8.0  # N
    d: float = 1e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size / (1 + max(x, 0.0) / self.d) ** 2


@dataclass(frozen=True)
class OwnClock(Strange):
    """The displacement is logged by a device with a clock of its own, which goes wrong more and more in a run.

    What stands at t was at t (1 + skew), x + skew t v to first order. States: the time, and x behind 5 ms for v.
    """

    form = "own_clock"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    skew: float = 0.01

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return 1.0, (now.x - q[1]) / 5e-3

    def position_shown(self, q: State, x: float) -> float:
        return x + self.skew * q[0] * (x - q[1]) / 5e-3


@dataclass(frozen=True)
class SelfHeating(Strange):
    """A resistance thermometer whose measuring current heats it where no gas flows: T + dT/(1 + (|m|/m_0)^(1/2)).

    The state is the size of the flow behind 50 ms.
    """

    form = "self_heating"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    size: float = 2.0  # K
    m_0: float = 3e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((abs(now.net_mass_flow) - q[0]) / 0.05,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.size / (1 + sqrt(max(q[0], 0.0) / self.m_0))
