"""What happens to supply, valves and gas from outside, and belongs to no family."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sin
from typing import ClassVar

from rig.effect import Now, Rest, State, law
from rig.flow import CP
from rig.schedule import LONGEST, Currents, SampledSchedule, Schedule
from rig.seen.none_of_these.base import Clocked, Intermittent, Strange, with_edges

_QUICK = 5e-3  # s, behind which states follow what an instrument feels at once


@law
class PumpingSupply(Clocked):
    """The compressor pumps: the supply's absolute pressure swings by a share, and no instrument sees it."""

    share: float = 0.08
    frequency: float = 0.9  # Hz
    phase: float = 0.0

    def supply(self, q: State, p: float) -> float:
        return p * (1 + self.share * sin(2 * pi * self.frequency * q[0] + self.phase))


@law
class StickyValves(Strange):
    """The valves never open twice by the same area: each command is met by a factor of its own."""

    scatter: float = 0.15
    start: int = 0

    def _factor(self, k: int) -> float:
        # the fractional parts of a multiple of an irrational number: spread evenly, and the same on every machine
        return 1 + self.scatter * (2 * ((self.start + k + 1) * 0.6180339887498949 % 1) - 1)

    def _felt(self, k: int, command: Currents) -> Currents:
        factor = self._factor(k)
        a, b = (0.145 + (u - 0.145) * factor if u > 0.145 else u for u in command)
        return a, b

    def drive(self, schedule: Schedule) -> Schedule:
        if isinstance(schedule, SampledSchedule):
            openings, opened, felt = 0, False, []
            for command in schedule.samples:
                now = max(command) > 0.145
                openings += now and not opened
                opened = now
                felt.append(self._felt(openings, command))
            return replace(schedule, samples=tuple(felt))
        return Schedule(
            schedule.starts, tuple(self._felt(k, c) for k, c in enumerate(schedule.currents))
        )


@law
class SecondConsumer(Intermittent):
    """A neighbour draws air from the same supply at times: its absolute pressure is lower by a share for a while."""

    share: float = 0.08

    def supply(self, q: State, p: float) -> float:
        return p * (1 - self.share) if self.goes(q) else p


@law
class LooseContact(Clocked):
    """The plug of the valves has a loose contact: now and then both are without current for a moment."""

    off: float = 0.08  # s
    period: float = 1.2  # s
    first: float = 0.3  # s

    def _begins(self) -> list[float]:
        return [
            self.first + k * self.period
            for k in range(int((LONGEST - self.first) / self.period) + 1)
        ]

    def drive(self, schedule: Schedule) -> Schedule:
        begins = self._begins()
        return with_edges(schedule, [*begins, *(t + self.off for t in begins)])

    def current(self, q: State, command: Currents) -> Currents:
        since = q[0] - self.first
        return (0.0, 0.0) if since >= 0 and since % self.period < self.off else command


@law
class WarmCoils(Strange):
    """The valves' coils warm the thermocouple's connector: the reading sinks, behind a lag, with their electric power.

    The state is the power by that at 0.35 A, behind the lag.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    size: float = 2.0  # K
    tau: float = 2.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (((now.command[0] ** 2 + now.command[1] ** 2) / 0.35**2 - q[0]) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature - self.size * q[0]


@law
class EmptyBottle(Clocked):
    """The bottle of compressed air runs empty: the supply's absolute pressure sinks in a run, by a share in 10 s."""

    share: float = 0.15

    def supply(self, q: State, p: float) -> float:
        return p * (1 - min(self.share * q[0] / 10.0, 0.7))


@law
class HeatLamp(Intermittent):
    """A lamp or a fan heater beside the rig goes on and off, and a part of its heat reaches the gas."""

    power: float = 0.5  # W
    period: float = 3.0  # s

    def heat(self, q: State) -> float:
        return self.power if self.goes(q) else 0.0


@law
class BufferTank(Strange):
    """The supply is a small tank that filling draws down and a thin hose refills: the supply is p (1 - q).

    The state q is the share of its gas that is missing: q' = m_net/m_tank while the muscle fills, less q/tau.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-8,)
    per_kilogram: float = 300.0  # 1/kg, one over the tank's gas
    tau: float = 3.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (max(now.net_mass_flow, 0.0) * self.per_kilogram - q[0] / self.tau,)

    def supply(self, q: State, p: float) -> float:
        return p * (1 - min(q[0], 0.8))


@law
class HotSupply(Strange):
    """The air comes hot from the compressor: what flows in brings more enthalpy, c_p m_in dT.

    State: the inflow behind 5 ms. Source: first law for an open volume.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    hotter: float = 15.0  # K, dT

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((max(now.net_mass_flow, 0.0) - q[0]) / _QUICK,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return 0.0, -CP * q[0] * self.hotter


@law
class VenturiTap(Strange):
    """The pressure tap sits in the narrow inlet, where gas is fast: it shows p - size (m/0.1 g/s)^2.

    State: the flow behind 5 ms, either way. Source: D. Bernoulli, Hydrodynamica (1738).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    size: float = 3e3  # Pa at 0.1 g/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.net_mass_flow - q[0]) / _QUICK,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge - self.size * (q[0] / 1e-4) ** 2
