"""Ends that are no cylinder: the muscle's pull by contraction and pressure."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, pi, sqrt

from rig.effect import Effect


@dataclass(frozen=True)
class BulgingEnds(Effect):
    """The ends hold back more, the more the middle bulges: contraction counts 1 + c eps times in the force."""

    family = "end_shape"
    form = "bulging"
    c: float = 0.4
    length: float = 0.24  # m

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * x / self.length


@dataclass(frozen=True)
class SpreadEnds(Effect):
    """The ends spread linearly with pressure: contraction counts 1 + c (1 - p/p_0) times, at least once."""

    family = "end_shape"
    form = "spread"
    c: float = 0.15
    p_0: float = 3e5  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * max(0.0, 1 - p_gauge / self.p_0)


@dataclass(frozen=True)
class LooseBladder(Effect):
    """The bladder does not fill the braid before it is pressed against it: pull times 1 - c p_0/(p_0 + p).

    Muscles are built with play between bladder and braid, above all at the ends, and need some pressure before they
    pull as the cylinder does; reasoned here as a share of the braid without contact that fades with pressure.
    """

    family = "end_shape"
    form = "loose_bladder"
    c: float = 0.1
    p_0: float = 5e4  # Pa

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 - self.c * self.p_0 / (self.p_0 + max(p_gauge, 0.0))


@dataclass(frozen=True)
class ConicalEnds(Effect):
    """Between fitting and cylinder the braid is a cone, the longer the thicker the muscle: pull times 1 - c (D/D0 - 1).

    Source: N. Tsagarakis, D. G. Caldwell, Improved modelling and assessment of pneumatic muscle actuators, IEEE Int.
    Conf. Robotics and Automation (2000) 3641, whose truncated cones are taken to first order here.
    """

    family = "end_shape"
    form = "conical"
    c: float = 0.1
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def pull_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        wider = sqrt((self.fibre_squared - length * length) / (self.fibre_squared - self.length**2))
        return 1 - self.c * (wider - 1)


@dataclass(frozen=True)
class BentFibres(Effect):
    """Stiff fibres bend near the clamps over sqrt(E I/tension): contraction counts 1 + c/sqrt(1 + p/p_0) times.

    The tension of a fibre goes with pressure. Reasoned from the edge of a clamped beam under tension (S. Timoshenko,
    Strength of Materials II, 1956).
    """

    family = "end_shape"
    form = "bent_fibres"
    c: float = 0.15
    p_0: float = 3e4  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c / sqrt(1 + max(p_gauge, 0.0) / self.p_0)


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
