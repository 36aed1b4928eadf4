"""Ends that are no cylinder: the muscle's pull by contraction and pressure."""

from __future__ import annotations

from math import pi, sqrt

from rig.effect import Effect, law


@law
class SlantedEnds(Effect):
    """Between fitting and cylinder the braid is a frustum of one slant, c = 2/tan of it: by virtual work.

    Both frusta lack c pi/24 (D - D0)^2 (2 D + D0) of a cylinder's volume, so that the pull is times
    1 - c (D - D0) L/(3 L^2 - b^2), D by the braid. Source of the shape: N. Tsagarakis, D. G. Caldwell, IEEE Int. Conf.
    Robotics and Automation (2000) 3641.
    """

    c: float = 1.0
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def pull_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        now, rest = (
            sqrt(max(self.fibre_squared - part * part, 0.0)) / (pi * self.turns)
            for part in (length, self.length)
        )
        room = max(3 * length * length - self.fibre_squared, 0.15 * self.fibre_squared)
        return 1 - self.c * (now - rest) * length / room


@law
class ThroughRod(Effect):
    """A rod, as that of a displacement sensor, passes through one end: its area lacks the pressure that pulls.

    The pull is less by p c pi D0^2/4 whatever the contraction, times 1 - c (b^2 - L0^2)/(3 L^2 - b^2). Source: forces
    on the end plugs in C.-P. Chou, B. Hannaford, IEEE Trans. Robot. Autom. 12 (1996) 90; the rod is reasoned.
    """

    c: float = 0.1  # area of the rod by that of the muscle at rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def pull_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        room = max(3 * length * length - self.fibre_squared, 0.15 * self.fibre_squared)
        return 1 - self.c * (self.fibre_squared - self.length**2) / room
