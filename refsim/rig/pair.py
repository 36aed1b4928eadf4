"""Two muscles that pull a pulley against each other, each with valves of its own.

States are travel [m] and speed [m/s] of the rim, then for each muscle internal energy and the states of its effects:
both muscles have the same effects.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from rig.effect import Effect
from rig.integrate import PATIENCE, Array, integrate
from rig.muscle import ATOL, Chain, MuscleParameters
from rig.schedule import Joint, Schedule


@dataclass(frozen=True)
class PulleyParameters:
    """The wheel."""

    radius: float = 0.03  # m
    inertia: float = 2e-3  # kg m2
    friction: float = 0.02  # N m s
    contraction: float = 0.03  # m, of both muscles in the middle

    @property
    def mass(self) -> float:
        """Inertia at the rim [kg]."""
        return self.inertia / self.radius**2

    @property
    def damping(self) -> float:
        """Friction at the rim [N s/m]."""
        return self.friction / self.radius**2


@dataclass(frozen=True)
class PairTrajectory:
    """What ideal instruments read; arrays of one shape (times,)."""

    time: Array  # s
    p_1: Array  # Pa gauge
    p_2: Array  # Pa gauge
    x: Array  # m, travel of the rim


class _Side(Chain):
    """One of the muscles; in the place of its acceleration it gives the force [N] on the rim."""

    def moved(
        self, y: Sequence[float], v: float, command: Sequence[float], force: float, inertia: float
    ) -> tuple[float, float]:
        return v, force


class _Pair:
    def __init__(
        self,
        muscles: Sequence[MuscleParameters],
        pulley: PulleyParameters,
        p_supply: float,
        effects: Sequence[Effect],
    ) -> None:
        self.pulley = pulley
        self.sides = [_Side(replace(muscle, load=0.0), p_supply, effects) for muscle in muscles]
        self.own = 1 + sum(len(effect.atol) for effect in effects)

    def start(self) -> list[float]:
        """In the middle, at rest, filled with ambient air."""
        gas = [_without_motion(side.start_at(self.pulley.contraction)) for side in self.sides]
        return [0.0, 0.0, *gas[0], *gas[1]]

    def both(self, y: Sequence[float]) -> tuple[list[float], list[float]]:
        """States of both muscles as a `Chain` has them."""
        x, v, middle = y[0], y[1], self.pulley.contraction
        first, second = y[2 : 2 + self.own], y[2 + self.own :]
        return [first[0], middle + x, v, *first[1:]], [second[0], middle - x, -v, *second[1:]]

    def rates(self, y: Sequence[float], command: Sequence[float]) -> list[float]:
        """Time derivatives of all states; told are u_in and u_out of the first muscle, then of the second."""
        states = self.both(y)
        told = (command[:2], command[2:])
        rates = [side.rates(own, u) for side, own, u in zip(self.sides, states, told, strict=True)]
        inertia = self.pulley.mass
        for side, own in zip(self.sides, states, strict=True):
            inertia += side.mass + sum(effect.balanced_mass(own[1]) for effect in side.effects)
        acceleration = (rates[0][2] - rates[1][2] - self.pulley.damping * y[1]) / inertia
        return [y[1], acceleration, *_without_motion(rates[0]), *_without_motion(rates[1])]

    def reading(self, y: Sequence[float]) -> tuple[float, float, float]:
        """Both gauge pressures [Pa] and the travel [m]."""
        (first, second), x = self.both(y), y[0]
        for effect, own in zip(self.sides[0].effects, self.sides[0].slices, strict=True):
            x = effect.position_shown(first[own], x)
        return self.sides[0].reading(first)[0], self.sides[1].reading(second)[0], x


def _without_motion(y: Sequence[float]) -> list[float]:
    return [y[0], *y[3:]]


def simulate_pair(
    muscles: Sequence[MuscleParameters],
    pulley: PulleyParameters,
    p_supply: float,
    schedules: Sequence[Schedule],
    times: Array,
    effects: Sequence[Effect] = (),
    rtol: float = 1e-8,
    method: str = "BDF",
) -> PairTrajectory:
    """Simulate one run from rest in the middle at times[0], with a schedule of currents for each muscle.

    p_supply: gauge [Pa]; times: increasing, shape (n,) [s]. Raises RuntimeError when integration fails.
    """
    rig = _Pair(muscles, pulley, p_supply, effects)
    late = [schedule.delayed(sum(effect.delay() for effect in effects)) for schedule in schedules]
    for effect in effects:
        late = [effect.drive(schedule) for schedule in late]
    own = (ATOL[0], *(value for effect in effects for value in effect.atol))
    states = integrate(
        rig.rates,
        rig.start(),
        Joint(tuple(late)),
        times,
        (*ATOL[1:], *own, *own),
        rtol,
        method,
        PATIENCE,
    )
    shown = np.array([rig.reading(column) for column in states.T.tolist()])
    return PairTrajectory(times, shown[:, 0], shown[:, 1], shown[:, 2])
