"""The vertical load of Dzahir and Yamamoto (2019, DY): an empirical muscle under a given pressure lifts a mass.

States are the muscle's length, the load's speed downwards and the pressure behind the regulator, then those of the
effects; the force is DY (5) in its printed variables, with the angle of the braid.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import exp, pi, radians, sin, tan, tanh

import numpy as np

from rig.effect import Effect, Now, Rest
from rig.flow import T_ATM, G
from rig.integrate import PATIENCE, Array, integrate
from rig.schedule import Course


@dataclass(frozen=True)
class EmpiricalParameters:
    """DY give no values: these are the library's, for illustration. Friction as DY (8)-(9), the predecessor's."""

    length: float = 0.3  # L0, m
    diameter: float = 0.02  # D0, m
    angle: float = radians(23)  # of the braid at rest
    irregularity: tuple[float, float] = (3.0, -2e-6)  # c_1, c_2 [1/Pa], DY (6)
    slenderness: tuple[float, float, float] = (0.3, -15.0, 0.95)  # c_3, c_4, c_5, DY (7)
    coulomb: float = 5.0  # c_c, N
    viscous: float = 20.0  # c_v, N s
    sign_width: float = 2e-3  # 1/s, rate of strain over which the sign is rounded, as DP (69) does
    stiffness: float = (
        1e10  # N/m3, of the stretched sleeve, DY (12) with the cube over the whole stretch
    )
    lag: float = 2e-3  # s, of the pressure regulator
    load: float = 10.0  # kg
    frequency: float = 0.5  # Hz, of the run's excitation

    @cached_property
    def _shape(self) -> tuple[float, float, float]:
        return pi * self.diameter**2 / 4, 3 / tan(self.angle) ** 2, 1 / sin(self.angle) ** 2

    def static_force(self, p: float, eps: float) -> float:
        """DY (5) [N] at gauge pressure p [Pa]."""
        c_1, c_2 = self.irregularity
        c_3, c_4, c_5 = self.slenderness
        area, stretch, rest = self._shape
        q = 1 + c_1 * exp(c_2 * p)
        return (c_3 * exp(c_4 * eps) + c_5) * area * p * (stretch * (1 - q * eps) ** 2 - rest)


@dataclass(frozen=True)
class VerticalTrajectory:
    """What ideal instruments read; arrays of one shape (times,)."""

    time: Array  # s
    x: Array  # m


class _Vertical:
    def __init__(self, parameters: EmpiricalParameters, effects: Sequence[Effect]) -> None:
        self.par = parameters
        self.effects = [
            effect.in_run(parameters.load * G, parameters.frequency) for effect in effects
        ]
        self.slices, at = [], 3
        for effect in self.effects:
            self.slices.append(slice(at, at + len(effect.atol)))
            at += len(effect.atol)
        self.mass = parameters.load + sum(effect.hanging_mass() for effect in self.effects)

    def start(self) -> list[float]:
        """At rest without pressure: the sleeve is stretched until it carries the load."""
        par = self.par
        carried = par.load + sum(effect.resting_mass() for effect in self.effects)
        length = par.length + (carried * G / par.stiffness) ** (1 / 3)
        rest = Rest(par.length - length, 0.0, T_ATM, (0.0, 0.0))
        return [
            length,
            0.0,
            0.0,
            *(value for effect in self.effects for value in effect.initial(rest)),
        ]

    def rates(self, y: Sequence[float], told: Sequence[float]) -> list[float]:
        """Time derivatives of all states; told is the pressure [Pa gauge]."""
        par, length, down, p = self.par, y[0], y[1], y[2]
        x, v = par.length - length, -down
        strain, rate = x / par.length, v / par.length
        pull = par.static_force(p, strain) + par.stiffness * max(0.0, -x) ** 3
        pull -= par.coulomb * tanh(rate / par.sign_width) + par.viscous * rate
        inertia = self.mass
        for effect, own in zip(self.effects, self.slices, strict=True):
            pull -= effect.force(y[own], x, v, p)
            inertia += effect.balanced_mass(x)
        now = Now(x, v, p, T_ATM, (0.0, 0.0), 0.0, 0.0)
        result = [down, (self.mass * G - pull) / inertia, (told[0] - p) / par.lag]
        for effect, own in zip(self.effects, self.slices, strict=True):
            result.extend(effect.rates(y[own], now))
        return result

    def reading(self, y: Sequence[float]) -> float:
        """The contraction [m] that the displacement sensor shows."""
        x = self.par.length - y[0]
        for effect, own in zip(self.effects, self.slices, strict=True):
            x = effect.position_shown(y[own], x)
        return x


_ATOL = (1e-9, 1e-8, 1e-3)


def simulate_vertical(
    parameters: EmpiricalParameters,
    pressure: Course,
    times: Array,
    effects: Sequence[Effect] = (),
    rtol: float = 1e-8,
    method: str = "BDF",
) -> VerticalTrajectory:
    """Simulate one run from rest without pressure at times[0].

    pressure: what the regulator is told [Pa gauge]; times: increasing, shape (n,) [s]. Raises RuntimeError when
    integration fails.
    """
    rig = _Vertical(parameters, effects)
    atol = (*_ATOL, *(value for effect in rig.effects for value in effect.atol))
    states = integrate(rig.rates, rig.start(), pressure, times, atol, rtol, method, PATIENCE)
    return VerticalTrajectory(
        times, np.array([rig.reading(column) for column in states.T.tolist()])
    )
