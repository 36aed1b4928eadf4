"""Springs and rubber: forces of the contraction alone. Positive forces oppose contraction."""

from __future__ import annotations

from math import exp, sqrt

from rig.effect import Effect, State, law
from rig.seen.elasticity import BraidedTube


@law
class DemirayTube(BraidedTube):
    """A thin tube that stiffens as tissue does and follows the braid: W = mu/(2 b) (exp(b (I1 - 3)) - 1).

    By virtual work; the exponent stays within 5. Source: H. Demiray, A note on the elasticity of soft biological
    tissues, J. Biomech. 5 (1972) 309.
    """

    mu: float = 2.0e5  # Pa
    b: float = 0.8

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        invariant = a * a + s + 1 / (a * a * s)
        slope = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        stiffer = exp(min(self.b * (invariant - 3), 5.0))
        return -self.wall / self.length * self.mu / 2 * stiffer * slope


@law
class SetBraid(Effect):
    """Stiff fibres that were set as the braid lies at rest: they are bent more the thicker it gets.

    A fibre on the cylinder has the curvature k = 2 pi n sqrt(b^2 - L^2)/b^2, and its bending energy goes with
    (k - k_0)^2, so that the force is F (1 - k_0/k) L/L0. Derived by virtual work; source of the energy: A. E. H. Love,
    A Treatise on the Mathematical Theory of Elasticity (1927), chapter 19, on helical wires.
    """

    f: float = 20.0  # N
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        straighter = sqrt(
            (self.fibre_squared - self.length**2) / (self.fibre_squared - length * length)
        )
        return self.f * (1 - straighter) * length / self.length
