"""Springs and rubber: forces of the contraction alone. Positive forces oppose contraction."""

from __future__ import annotations

from math import pi, sqrt

from rig.effect import Effect, State, law


@law
class LinearSpring(Effect):
    """The bladder as a spring: k x."""

    form = "linear"
    k: float = 250.0  # N/m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * x


@law
class CubicSpring(Effect):
    """A spring that stiffens: k1 x + k3 x^3."""

    form = "cubic"
    k1: float = 120.0  # N/m
    k3: float = 5.0e4  # N/m3

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k1 * x + self.k3 * x**3


@law
class MooneyRivlin(Effect):
    """A thin incompressible Mooney-Rivlin tube that follows the braid; force by virtual work dW/dx.

    Axial stretch a = L/L0, hoop stretch c = D/D0 with D^2 = (b^2 - L^2)/(n pi)^2 at rest geometry;
    W = V_wall (C10 (a^2 + c^2 + 1/(a c)^2 - 3) + C01 (1/a^2 + 1/c^2 + (a c)^2 - 3)).
    """

    form = "mooney_rivlin"
    c10: float = 1.2e5  # Pa
    c01: float = 2.0e4  # Pa
    length: float = 0.24  # m
    diameter: float = 0.02  # m
    thickness: float = 0.254e-3  # m
    turns: float = 2.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        wall = pi * self.diameter * self.thickness * self.length
        circumference = self.turns * pi * self.diameter
        a = 1 - x / self.length
        tangent = (self.length / circumference) ** 2
        s = 1 + tangent * (1 - a * a)  # c^2
        s_a = -2 * tangent * a  # d(c^2)/da
        i1_a = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        i2_a = -2 / a**3 - s_a / s**2 + 2 * a * s + a * a * s_a
        return -wall / self.length * (self.c10 * i1_a + self.c01 * i2_a)


@law
class YoungTube(Effect):
    """A thin tube of Hooke's rubber, incompressible (Poisson 1/2), that follows the braid; force by virtual work."""

    form = "young"
    modulus: float = 5e5  # Pa
    length: float = 0.24  # m
    diameter: float = 0.02  # m
    thickness: float = 0.254e-3  # m
    turns: float = 2.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        wall = pi * self.diameter * self.thickness * self.length
        a, s, s_a = _stretches(x, self.length, self.diameter, self.turns)
        c = sqrt(s)
        along, around = a - 1, c - 1
        # plane stress with Poisson's ratio 1/2: W = (2/3) E (e1^2 + e2^2 + e1 e2)
        slope = (2 * along + around) + (2 * around + along) * s_a / (2 * c)
        return -2 / 3 * self.modulus * wall * slope / self.length


def _stretches(
    x: float, length: float, diameter: float, turns: float
) -> tuple[float, float, float]:
    """Axial stretch a, hoop stretch squared, and the latter's slope over a."""
    a = 1 - x / length
    tangent = (length / (turns * pi * diameter)) ** 2
    return a, 1 + tangent * (1 - a * a), -2 * tangent * a
