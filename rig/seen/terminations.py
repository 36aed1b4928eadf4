"""Tips and folds at the muscle's ends, and a sled that it pulls from the side. Positive forces oppose contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, pi, sqrt

from rig.effect import Effect

State = Sequence[float]


@dataclass(frozen=True)
class RoundedTips(Effect):
    """The tips are rounded over a length c D and do not contract: contraction counts 1/(1 - c D/L0) times.

    Source: E. G. Hocking, N. M. Wereley, Analysis of nonlinear elastic behavior in miniature pneumatic artificial
    muscles, Smart Mater. Struct. 22 (2013) 014016, on tips whose length goes with the diameter; to first order here.
    """

    family = "end_shape"
    form = "rounded_tips"
    c: float = 0.6
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def shape_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        diameter = sqrt(max(self.fibre_squared - length * length, 0.0)) / (pi * self.turns)
        return 1 / (1 - self.c * diameter / self.length)


@dataclass(frozen=True)
class UnfoldingEnds(Effect):
    """The bladder lies in folds at its ends until a pressure opens them: pull times 1 - c/(1 + exp((p - p_0)/w)).

    Muscles need a threshold of pressure before the bladder fills the braid (C.-P. Chou, B. Hannaford, IEEE Trans.
    Robot. Autom. 12 (1996) 90); folds open about p_0, with w = p_0/4. Reasoned.
    """

    family = "end_shape"
    form = "unfolding"
    c: float = 0.15
    p_0: float = 6e4  # Pa

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 - self.c / (1 + exp(min(4 * (p_gauge / self.p_0 - 1), 60.0)))


@dataclass(frozen=True)
class SideSled(Effect):
    """A sled on a level rail d beside the way, drawn along it by a cord: inertia m (a + x)^2/(d^2 + (a + x)^2).

    The cord's length sqrt(d^2 + (a + x)^2) grows with the load's way; the force m'(x) v^2/2 goes with it (Lagrange).
    """

    family = "moving_mass"
    form = "side_sled"
    m: float = 4.0  # kg
    a: float = 0.04  # m
    d: float = 0.08  # m

    def balanced_mass(self, x: float) -> float:
        along = (self.a + x) ** 2
        return self.m * along / (self.d**2 + along)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m * (self.a + x) * self.d**2 / (self.d**2 + (self.a + x) ** 2) ** 2 * v * v
