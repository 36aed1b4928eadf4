"""Valves that follow their command late."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from rig.effect import Effect, Now, Rest, State
from rig.schedule import LONGEST, Currents, SampledSchedule, Schedule


@dataclass(frozen=True)
class PressedPlunger(Effect):
    """The muscle's pressure holds the exhaust's plunger: it opens (1 + p/p_0) times later and shuts as much sooner.

    The inlet valve has the plain lag. Reasoned: pressure on the seat's area counts against the coil while the plunger
    opens and with the spring while it shuts (P. Beater, Pneumatic Drives, 2007).
    """

    family = "valve_dynamics"
    form = "pressed_plunger"
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


@dataclass(frozen=True)
class SeatAdhesion(Effect):
    """A plunger that its seat holds by the squeezed film: a lag of tau (1 + c/(1 + (h/h_0)^2)) with the lift h.

    h is the current above the threshold of 0.145 A by 0.205 A, so it comes off late and settles slowly. Source: J.
    Stefan, Versuche ueber die scheinbare Adhaesion, Sitzungsber. Akad. Wiss. Wien 69 (1874) 713; the way down is
    rounded here, the cube of the gap would never let it shut.
    """

    family = "valve_dynamics"
    form = "seat_adhesion"
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


@dataclass(frozen=True)
class AveragedCommand(Effect):
    """The valves' amplifier passes on the mean of the command over the last while, as digital ones with a filter do.

    A step becomes a ramp. Source: A. V. Oppenheim, R. W. Schafer, Discrete-Time Signal Processing (1989), chapter 2.
    """

    family = "valve_dynamics"
    form = "averaged_command"
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
