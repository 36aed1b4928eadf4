"""Valves that follow their command late."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt
from typing import ClassVar

import numpy as np

from rig.effect import Effect, Now, Rest, State, law
from rig.schedule import LONGEST, Currents, SampledSchedule, Schedule


@law
class SlowRateValve(Effect):
    """The current that acts moves at a limited rate: u' = rate tanh((command - u)/u_0)."""

    atol: ClassVar[tuple[float, ...]] = (1e-8, 1e-8)
    time_per_amp: float = 0.3  # s/A
    u_0: float = 0.01  # A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        gap = (command - u) / self.u_0
        return gap / sqrt(1 + gap * gap) / self.time_per_amp

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class DelayedLagValve(Effect):
    """A dead time and then a first-order lag, of equal size."""

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.03  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def delay(self) -> float:
        return self.tau

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.command[0] - q[0]) / self.tau, (now.command[1] - q[1]) / self.tau

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class TwoSpeedValve(Effect):
    """The currents act through a lag that is `ratio` times longer when they fall than when they rise."""

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.06  # s
    ratio: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        return (command - u) / (self.tau if command > u else self.ratio * self.tau)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class EddyValve(Effect):
    """A part of the magnetic force comes at once, the rest when eddy currents in the iron have died away.

    Reasoned from the diffusion of flux into a solid core: its skin follows the coil, its inside comes late.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.1  # s
    at_once: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.command[0] - q[0]) / self.tau, (now.command[1] - q[1]) / self.tau

    def current(self, q: State, command: Currents) -> Currents:
        a, b = (
            self.at_once * u + (1 - self.at_once) * late for u, late in zip(command, q, strict=True)
        )
        return a, b


@law
class SaturatingCoil(Effect):
    """The coil's inductance falls as its iron saturates, L/(1 + (u/u_s)^2): u' = (command - u)(1 + (u/u_s)^2)/tau.

    Source: N. D. Vaughan, J. B. Gamble, The modeling and simulation of a proportional solenoid valve, J. Dyn. Syst.
    Meas. Control 118 (1996) 120, on the inductance that depends on the current.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.1  # s
    u_s: float = 0.2  # A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        return (command - u) * (1 + (u / self.u_s) ** 2) / self.tau

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class PilotStage(Effect):
    """The spool moves by what flows through a pilot orifice, the root of what it is off: u' = sqrt(u_r |e|) sign(e)/T.

    e = command - u, smooth below 2 mA. The spool arrives in a finite time, 2 T after a step of u_r.
    Source: H. E. Merritt, Hydraulic Control Systems (1967), chapter 7, on two-stage valves.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-8, 1e-8)
    time: float = 0.04  # s, T
    u_r: float = 0.35  # A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        off = command - u
        return sqrt(self.u_r) * off / sqrt(sqrt(off * off + 4e-6)) / self.time

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class HeldCommand(Effect):
    """The output stage passes a command on once in a cycle and holds it in between.

    Programmable controllers and fieldbus valve terminals have cycles of 10 to 100 ms. Source: K. J. Astrom,
    B. Wittenmark, Computer-Controlled Systems (1997), chapter 2, on zero-order hold.
    """

    cycle: float = 0.05  # s
    first: float = 0.5  # of the cycle

    def drive(self, schedule: Schedule) -> Schedule:
        starts: list[float] = []
        felt: list[Currents] = []
        for k in range(int(LONGEST / self.cycle)):
            t = (self.first + k) * self.cycle
            command = schedule.at(t)
            if not felt or command != felt[-1]:
                starts.append(t)
                felt.append(command)
        return Schedule(tuple(starts), tuple(felt))


@law
class ThreeLags(Effect):
    """Driver, coil and spool follow one another, three equal first-order lags in series.

    Source: H. E. Merritt, Hydraulic Control Systems (1967), chapter 5, on the chain from amplifier to spool.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,) * 6
    tau: float = 0.02  # s, of each

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,) * 6

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        before = (now.command[0], q[0], q[1], now.command[1], q[3], q[4])
        return tuple((a - b) / self.tau for a, b in zip(before, q, strict=True))

    def current(self, q: State, command: Currents) -> Currents:
        return q[2], q[5]


@law
class PressedPlunger(Effect):
    """The muscle's pressure holds the exhaust's plunger: it opens (1 + p/p_0) times later and shuts as much sooner.

    The inlet valve has the plain lag. Reasoned: pressure on the seat's area counts against the coil while the plunger
    opens and with the spring while it shuts (P. Beater, Pneumatic Drives, 2007).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.05  # s
    p_0: float = 8e4  # Pa

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        pressed = 1 + max(now.p_gauge, 0.0) / self.p_0
        gap = now.command[1] - q[1]
        return (now.command[0] - q[0]) / self.tau, gap / self.tau * (
            1 / pressed if gap > 0 else pressed
        )

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class SeatAdhesion(Effect):
    """A plunger that its seat holds by the squeezed film: a lag of tau (1 + c/(1 + (h/h_0)^2)) with the lift h.

    h is the current above the threshold of 0.145 A by 0.205 A, so it comes off late and settles slowly. Source: J.
    Stefan, Versuche ueber die scheinbare Adhaesion, Sitzungsber. Akad. Wiss. Wien 69 (1874) 713; the way down is
    rounded here, the cube of the gap would never let it shut.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.02  # s
    c: float = 4.0
    h_0: float = 0.2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def _rate(self, command: float, u: float) -> float:
        lift = max(u - 0.145, 0.0) / 0.205
        return (command - u) / (self.tau * (1 + self.c / (1 + (lift / self.h_0) ** 2)))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self._rate(now.command[0], q[0]), self._rate(now.command[1], q[1])

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class AveragedCommand(Effect):
    """The valves' amplifier passes on the mean of the command over the last while, as digital ones with a filter do.

    A step becomes a ramp. Source: A. V. Oppenheim, R. W. Schafer, Discrete-Time Signal Processing (1989), chapter 2.
    """

    window: float = 0.08  # s

    def drive(self, schedule: Schedule) -> Schedule:
        fine, every = 1e-3, 5  # s; samples of the mean are 5 ms apart
        times = np.arange(round(LONGEST / fine)) * fine
        commands = np.array([schedule.at(float(t)) for t in times])
        total = np.vstack(
            [np.zeros(2), np.cumsum(commands, axis=0) * fine]
        )  # up to the end of each slot
        edges = np.arange(len(total)) * fine
        early = np.maximum(edges - self.window, 0.0)
        before = np.stack([np.interp(early, edges, total[:, k]) for k in (0, 1)], axis=1)
        mean = ((total - before) / self.window)[::every]
        # before the first sample the currents are those of the first
        mean += np.outer(np.maximum(1 - edges[::every] / self.window, 0.0), commands[0])
        rows = [(float(a), float(b)) for a, b in mean]
        joined = SampledSchedule.joined(rows, every * fine)
        starts = {round(t + late, 9) for t in schedule.starts for late in (0.0, self.window)}
        return replace(joined, starts=tuple(sorted(starts)))
