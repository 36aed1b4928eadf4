"""Rubber tubes that follow the braid: forces of the contraction alone. Positive forces oppose contraction."""

from __future__ import annotations

from dataclasses import dataclass
from math import log, sqrt

from rig.effect import State
from rig.seen.elasticity import BraidedTube


@dataclass(frozen=True)
class EightChain(BraidedTube):
    """A thin tube of rubber, eight chains of N links in each cell: dW/dI1 = mu/6 (3 - y^2)/(1 - y^2), y^2 = I1/(3 N).

    The inverse of Langevin's function is Cohen's y (3 - y^2)/(1 - y^2); finite here up to y^2 = 0.94.
    Source: E. M. Arruda, M. C. Boyce, A three-dimensional constitutive model for the large stretch behavior of rubber
    elastic materials, J. Mech. Phys. Solids 41 (1993) 389; A. Cohen, Rheol. Acta 30 (1991) 270.
    """

    family = "elasticity"
    form = "eight_chain"
    mu: float = 2.0e5  # Pa
    links: float = 3.0  # N

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        invariant = a * a + s + 1 / (a * a * s)
        slope = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        used = min(invariant / (3 * self.links), 0.94)
        return -self.wall / self.length * self.mu / 6 * (3 - used) / (1 - used) * slope


@dataclass(frozen=True)
class PrestretchedTube(BraidedTube):
    """A neo-Hookean bladder that was mounted a times longer than it lies free; by virtual work, I1 of both stretches.

    Its hoops are unstretched in the muscle at rest; its volume is that of the free tube of the braid's length by a.
    Source: C. S. Kothera, M. Jangid, J. Sirohi, N. M. Wereley, Experimental characterization and static modeling of
    McKibben actuators, J. Mech. Des. 131 (2009) 091010, on bladders that are strained before use.
    """

    family = "elasticity"
    form = "prestretched"
    mu: float = 2.4e5  # Pa
    prestretch: float = 1.1  # a

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent, square = 1 - x / self.length, self.tangent, self.prestretch**2
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        slope = 2 * square * a + s_a - (2 / (a**3 * s) + s_a / (a * s) ** 2) / square
        return -self.wall / self.prestretch / self.length * self.mu / 2 * slope


@dataclass(frozen=True)
class LogarithmicTube(BraidedTube):
    """A thin tube of rubber with the energy 2 mu (l (ln l - 1)) of each stretch l, by virtual work.

    Source: K. C. Valanis, R. F. Landel, The strain-energy function of a hyperelastic material in terms of the
    extension ratios, J. Appl. Phys. 38 (1967) 2997.
    """

    family = "elasticity"
    form = "valanis_landel"
    mu: float = 2.4e5  # Pa

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        c = sqrt(1 + tangent * (1 - a * a))
        c_a = -tangent * a / c
        thinner = -(c + a * c_a) / (a * c) ** 2  # slope of the wall's stretch 1/(a c)
        slope = log(a) + log(c) * c_a - log(a * c) * thinner
        return -self.wall / self.length * 2 * self.mu * slope
