"""Valves: dynamics and laws of the opening."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.family_members.chance import Chance, Place, order, some
from rig.schedule import Currents, SampledSchedule, Schedule

A_FULL = 3.69e-7  # m2, (62) at 0.35 A
U_FULL, THRESHOLD = 0.35, 0.145  # A


@dataclass(frozen=True)
class ValveChain(Effect):
    """Command, coil, spool and opening of both valves, each with what it may have.

    The command comes late, the coil's current lags, the spool follows as an oscillator or not, the opening lags,
    another time in closing, at a limited rate. All times of the exhaust valve are `other` times those of the inlet.
    States of either valve: current of the coil, that of the spool and its rate, opening by that at 0.35 A.
    """

    family = "valve_dynamics"
    form = "random"
    atol: ClassVar[tuple[float, ...]] = (1e-8, 1e-8, 1e-6, 1e-7) * 2
    dead_time: float = 0.0  # s
    coil: float = 0.0  # s
    omega: float = 0.0  # rad/s, 0: the spool follows at once
    zeta: float = 0.8
    lag: float = 0.0  # s, of the opening
    travel: float = 0.0  # s, of the opening to that at 0.35 A at its greatest rate
    closing: float = 1.0  # times of closing by those of opening
    other: float = 1.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,) * 8

    def drive(self, schedule: Schedule) -> Schedule:
        if self.dead_time == 0.0:
            return schedule
        assert not isinstance(schedule, SampledSchedule)
        inlet, outlet = (
            schedule.delayed(self.dead_time),
            schedule.delayed(self.dead_time * self.other),
        )
        starts = tuple(sorted({*inlet.starts, *outlet.starts}))
        return Schedule(starts, tuple((inlet.at(t)[0], outlet.at(t)[1]) for t in starts))

    def _spool(self, q: State, command: float) -> float:
        coil = q[0] if self.coil else command
        return q[1] if self.omega else coil

    def current(self, q: State, command: Currents) -> Currents:
        return self._spool(q[:4], command[0]), self._spool(q[4:], command[1])

    def opening(self, q: State, areas: tuple[float, float]) -> tuple[float, float]:
        return (q[3] * A_FULL, q[7] * A_FULL) if self.lag or self.travel else areas

    def _rates(self, q: State, command: float, area: float, slower: float) -> tuple[float, ...]:
        coil_rate = (command - q[0]) / (slower * self.coil) if self.coil else 0.0
        coil, omega = q[0] if self.coil else command, self.omega / slower
        gap = area / A_FULL - q[3]
        time = (
            sqrt(self.lag**2 + (self.travel * gap) ** 2)
            * (self.closing if gap < 0 else 1.0)
            * slower
        )
        opening = gap / max(time, 1e-5) if self.lag or self.travel else 0.0
        return coil_rate, q[2], omega**2 * (coil - q[1]) - 2 * self.zeta * omega * q[2], opening

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        inlet = self._rates(q[:4], now.command[0], now.areas[0], 1.0)
        return *inlet, *self._rates(q[4:], now.command[1], now.areas[1], self.other)


def _time(rng: Chance) -> float:
    return order(rng, 0.015, 0.12)


DYNAMICS: dict[str, Place] = {
    "command late": lambda rng: ValveChain(dead_time=_time(rng), other=order(rng, 0.5, 2)),
    "coil": lambda rng: ValveChain(coil=_time(rng), other=order(rng, 0.5, 2)),
    "spool": lambda rng: ValveChain(omega=order(rng, 12, 60), zeta=some(rng, 0.4, 1.2)),
    "coil and spool": lambda rng: ValveChain(
        coil=_time(rng), omega=order(rng, 20, 80), zeta=some(rng, 0.5, 1.2)
    ),
    "opening": lambda rng: ValveChain(lag=_time(rng)),
    "opening, closing in another time": lambda rng: ValveChain(
        lag=_time(rng), closing=order(rng, 0.3, 3)
    ),
    "rate of the opening": lambda rng: ValveChain(
        lag=2e-3, travel=2 * _time(rng), closing=order(rng, 0.5, 2)
    ),
    "opening of one valve": lambda rng: ValveChain(lag=_time(rng), other=order(rng, 2, 8)),
    "command and opening": lambda rng: ValveChain(dead_time=_time(rng) / 2, lag=_time(rng)),
    "coil and opening": lambda rng: ValveChain(coil=_time(rng) / 2, lag=_time(rng)),
}


@dataclass(frozen=True)
class OddArea(Effect):
    """Areas by a factor on (62), of pressures, current, direction: what a valve's data sheet leaves open."""

    family = "valve_area"
    form = "random"
    back: float = 0.0  # share lost at equal pressures
    power: float = 1.0  # of the pressure ratio in that
    curve: float = 1.0  # exponent of the current above its threshold
    offset: float = 0.0  # A, what is felt on top
    push: float = 0.0  # A, what a drop of 100 kPa takes
    outlet: float = 1.0  # area of the exhaust valve by that of the inlet valve
    outlet_curve: float = 0.0  # what its exponent has more
    steep: float = 0.0  # relative growth with the upstream pressure per 100 kPa

    def current(self, q: State, command: Currents) -> Currents:
        return command[0] + self.offset, command[1] + self.offset

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        opened = [max(u - THRESHOLD, 0.0) / (U_FULL - THRESHOLD) for u in currents]
        a, b = (
            z ** (c - 1) if z > 0 else 0.0 for z, c in zip(opened, self._exponents(), strict=True)
        )
        return areas[0] * a, areas[1] * b * self.outlet

    def _exponents(self) -> tuple[float, float]:
        return self.curve, self.curve + self.outlet_curve

    def valve_factor(self, p_up: float, p_down: float) -> float:
        lost = self.back * (p_down / p_up) ** self.power
        pushed = self.push * (p_up - p_down) / 1e5 / (U_FULL - THRESHOLD)
        return float(max((1 - lost) * (1 - pushed) * exp(self.steep * (p_up - 2e5) / 1e5), 0.0))


AREAS: dict[str, Place] = {
    "pressure ratio": lambda rng: OddArea(back=some(rng, 0.1, 0.4), power=order(rng, 0.5, 4)),
    "current": lambda rng: OddArea(curve=some(rng, 0.6, 2)),
    "threshold": lambda rng: OddArea(offset=some(rng, -0.03, 0.03), outlet=some(rng, 0.8, 1.2)),
    "pressure drop": lambda rng: OddArea(push=some(rng, 0.01, 0.04)),
    "upstream pressure": lambda rng: OddArea(steep=some(rng, -0.2, 0.2)),
    "one valve": lambda rng: OddArea(outlet=some(rng, 0.7, 1.3), outlet_curve=some(rng, -0.3, 0.6)),
    "ratio and current": lambda rng: OddArea(back=some(rng, 0.1, 0.3), curve=some(rng, 0.7, 1.6)),
}


@dataclass(frozen=True)
class SeatLeak(Effect):
    """The inlet valve's seat lets through when it is shut: a further area between supply and muscle."""

    family = "valve_area"
    form = "seat"
    area: float = 2e-9  # m2
    outlet: float = 0.0  # m2

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return areas[0] + self.area, areas[1] + self.outlet


AREAS["seat"] = lambda rng: SeatLeak(order(rng, 1e-9, 1e-8))
