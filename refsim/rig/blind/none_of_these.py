"""Effects that belong to none of the sixteen families: the right answer is that something unknown is missing."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sqrt, tanh
from typing import ClassVar

from rig.effect import Now, Rest, State
from rig.flow import CP, G
from rig.schedule import LONGEST, Schedule
from rig.seen.none_of_these.base import Clocked, Strange, with_edges

_QUICK = 5e-3  # s, behind which states follow what an instrument feels at once


@dataclass(frozen=True)
class CompliantFrame(Strange):
    """The beam that carries the muscle bends under its pull, and the ruler stands on the floor: it shows x - F/k.

    State: the bending behind 5 ms. Source: Hooke's law; the pull by virtual work as in the base model.
    """

    form = "compliant_frame"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    compliance: float = 3e-5  # m/N
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length = self.length - now.x
        pull = now.p_gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return ((self.compliance * pull - q[0]) / _QUICK,)

    def position_shown(self, q: State, x: float) -> float:
        return x - q[0]


@dataclass(frozen=True)
class GroundLoop(Strange):
    """The coils' return currents lift the thermocouple's ground, one way or the other: T + size (u_in - u_out)/0.35 A.

    State: the difference of the currents behind 5 ms. Source: R. Morrison, Grounding and Shielding (2007).
    """

    form = "ground_loop"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    size: float = 2.0  # K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (((now.command[0] - now.command[1]) / 0.35 - q[0]) / _QUICK,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.size * q[0]


@dataclass(frozen=True)
class HotSupply(Strange):
    """The air comes hot from the compressor: what flows in brings more enthalpy, c_p m_in dT.

    State: the inflow behind 5 ms. Source: first law for an open volume.
    """

    form = "hot_supply"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    hotter: float = 15.0  # K, dT

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((max(now.net_mass_flow, 0.0) - q[0]) / _QUICK,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return 0.0, -CP * q[0] * self.hotter


@dataclass(frozen=True)
class VenturiTap(Strange):
    """The pressure tap sits in the narrow inlet, where gas is fast: it shows p - size (m/0.1 g/s)^2.

    State: the flow behind 5 ms, either way. Source: D. Bernoulli, Hydrodynamica (1738).
    """

    form = "venturi_tap"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    size: float = 3e3  # Pa at 0.1 g/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.net_mass_flow - q[0]) / _QUICK,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge - self.size * (q[0] / 1e-4) ** 2


@dataclass(frozen=True)
class Detent(Strange):
    """A ball snaps into a notch of the guide: F u exp((1 - u^2)/2), u = (x - x_1)/w; against, then with the motion."""

    form = "detent"
    size: float = 10.0  # N
    x_1: float = 0.025  # m
    width: float = 1.5e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        u = (x - self.x_1) / self.width
        return self.size * u * exp((1 - min(u * u, 400.0)) / 2)


@dataclass(frozen=True)
class SlowReel(Strange):
    """The ruler's string is wound up by a weak reel: it follows down no faster than v_r. State: what it shows."""

    form = "slow_reel"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    fastest: float = 0.03  # m/s, v_r

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        gap = (now.x - q[0]) / 1e-3
        return (gap if gap > 0 else gap / sqrt(1 + (gap / self.fastest) ** 2),)

    def position_shown(self, q: State, x: float) -> float:
        return q[0]


@dataclass(frozen=True)
class ResidualCharge(Strange):
    """The logger's multiplexer takes some charge from the ruler's channel to the thermocouple's: it shows T + c x.

    State: the contraction. Source: data sheets of scanning loggers, on settling between channels.
    """

    form = "residual_charge"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    per_metre: float = 30.0  # K/m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.v,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.per_metre * q[0]


@dataclass(frozen=True)
class FrozenDisplay(Strange):
    """The ruler's display freezes for a moment now and then. States: the time, and what it shows (behind 5 ms)."""

    form = "frozen_display"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    off: float = 0.1  # s
    period: float = 1.2  # s
    first: float = 0.4  # s

    def _begins(self) -> list[float]:
        return [
            self.first + k * self.period
            for k in range(int((LONGEST - self.first) / self.period) + 1)
        ]

    def drive(self, schedule: Schedule) -> Schedule:
        begins = self._begins()
        return with_edges(schedule, [*begins, *(t + self.off for t in begins)])

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        since = q[0] - self.first
        frozen = since >= 0 and since % self.period < self.off
        return 1.0, 0.0 if frozen else (now.x - q[1]) / _QUICK

    def position_shown(self, q: State, x: float) -> float:
        return q[1]


@dataclass(frozen=True)
class DrippingLoad(Clocked):
    """The load is a bucket that drips: its weight falls with time. What inertia it loses is left out, it is minor."""

    form = "dripping_load"
    rate: float = 0.02  # kg/s

    def resting_mass(self) -> float:
        """Nothing but the load rests at the start; a rig without one does not drip."""
        return 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return -self.rate * q[0] * G


@dataclass(frozen=True)
class SettlingRope(Strange):
    """The knots of a new rope settle when it first carries the load, which stays lower by s from then on.

    s' = (size - s)/tau while the load is off the stop, rounded over 0.3 mm at 1 mm. State: s.
    """

    form = "settling_rope"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    size: float = 1.5e-3  # m
    tau: float = 0.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        carried = (1 + tanh((now.x - 1e-3) / 3e-4)) / 2
        return ((self.size - q[0]) / self.tau * carried,)

    def position_shown(self, q: State, x: float) -> float:
        return x - q[0]


@dataclass(frozen=True)
class LostCounts(Strange):
    """The ruler's counter misses a share of its counts while the load is fast. State: the way that it missed."""

    form = "lost_counts"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    share: float = 0.05
    fast: float = 0.04  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        missing = (1 + tanh((abs(now.v) / self.fast - 1) * 10)) / 2
        return (self.share * missing * now.v,)

    def position_shown(self, q: State, x: float) -> float:
        return x - q[0]
