"""A muscle whose contraction is imposed and whose pull is measured, driven by valve currents.

What moves the load end follows its command through a critically damped filter, here as two lags in a row of one time
constant: the states are internal energy, contraction, and the place between the lags.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from rig.effect import Effect
from rig.flow import P_ATM
from rig.integrate import PATIENCE, Array, integrate
from rig.muscle import ATOL, Chain, MuscleParameters
from rig.schedule import Course, Joint, Schedule

OPEN_CURRENT = (
    1e-5 + 2.61e-7
) / 1.80e-6  # A, at which (62) opens the 10 mm2 of an on-off valve of calibration 1


@dataclass(frozen=True)
class HeldTrajectory:
    """What ideal instruments read, and the contraction; arrays of one shape (times,)."""

    time: Array  # s
    p: Array  # Pa gauge
    pull: Array  # N
    temperature: Array  # K
    x: Array  # m


class HeldChain(Chain):
    """`Chain` with an imposed contraction; told are both currents and the contraction wanted [m]."""

    def __init__(
        self, parameters: MuscleParameters, p_supply: float, effects: Sequence[Effect], lag: float
    ) -> None:
        super().__init__(parameters, p_supply, effects)
        self.lag = lag

    def start(self) -> list[float]:
        """At rest without contraction, filled with ambient air."""
        return self.start_at(0.0)

    def at_rest(self, x: float) -> tuple[float, float]:
        """Both places."""
        return x, x

    def motion(self, y: Sequence[float]) -> tuple[float, float]:
        """Contraction [m] and its speed [m/s]."""
        return y[1], (y[2] - y[1]) / self.lag

    def net_force(self, x: float, v: float, pull: float) -> float:
        """What the drive holds against moves nothing."""
        return 0.0

    def moved(
        self, y: Sequence[float], v: float, command: Sequence[float], force: float, inertia: float
    ) -> tuple[float, float]:
        """Time derivatives of the two places."""
        return v, (command[2] - y[2]) / self.lag

    def reading_of_pull(self, y: Sequence[float]) -> float:
        """What the load cell shows [N]."""
        x, v = self.motion(y)
        return self.forces(y, x, v, self.gas(y)[0] - P_ATM)[0]


def simulate_held(
    parameters: MuscleParameters,
    p_supply: float,
    schedule: Schedule,
    contraction: Course,
    times: Array,
    effects: Sequence[Effect] = (),
    lag: float = 5e-3,
    rtol: float = 1e-8,
    method: str = "BDF",
) -> HeldTrajectory:
    """Simulate one run from rest without contraction at times[0].

    p_supply: gauge [Pa]; lag: of the drive [s]; times: increasing, shape (n,) [s]. Raises RuntimeError when
    integration fails.
    """
    rig = HeldChain(parameters, p_supply, effects, lag)
    late = schedule.delayed(sum(effect.delay() for effect in rig.effects))
    for effect in rig.effects:
        late = effect.drive(late)
    atol = (*ATOL[:2], ATOL[1], *(value for effect in rig.effects for value in effect.atol))
    states = integrate(
        rig.rates, rig.start(), Joint((late, contraction)), times, atol, rtol, method, PATIENCE
    )
    columns = states.T.tolist()
    shown = np.array([rig.reading(column) for column in columns])
    pull = np.array([rig.reading_of_pull(column) for column in columns])
    return HeldTrajectory(times, shown[:, 0], pull, shown[:, 2], states[1])


def switched(commands: Schedule) -> Schedule:
    """The currents [A] of on-off valves from their commands, 0 shut and 1 open."""
    return Schedule(
        commands.starts, tuple((OPEN_CURRENT * a, OPEN_CURRENT * b) for a, b in commands.currents)
    )
