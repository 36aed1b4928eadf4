"""Springs and rubber: forces of the contraction alone. Positive forces oppose contraction."""

from __future__ import annotations

from math import atan, exp, log, log1p, pi, sqrt

from rig.effect import Effect, State, law

_TRELOAR = (
    (6.3e5, 1.3),
    (1.2e3, 5.0),
    (-1e4, -2.0),
)  # Pa and exponents of vulcanised natural rubber
_TRELOAR_MODULUS = sum(mu * alpha for mu, alpha in _TRELOAR) / 2  # Pa


@law
class ExponentialSpring(Effect):
    """A spring that stiffens exponentially: F0 (exp(x/x0) - 1)."""

    form = "exponential"
    f0: float = 5.0  # N
    x0: float = 0.04  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f0 * (exp(x / self.x0) - 1)


@law
class ArctanSpring(Effect):
    """A spring that yields: F0 atan(x/x0)."""

    f0: float = 12.0  # N
    x0: float = 0.02  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f0 * atan(x / self.x0)


@law
class LogSpring(Effect):
    """A spring that softens slowly: F0 ln(1 + x/x0)."""

    f0: float = 8.0  # N
    x0: float = 0.015  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f0 * log1p(x / self.x0) if x > 0 else self.f0 * x / self.x0


@law
class LockingSpring(Effect):
    """Chains that lock: k x/(1 - (x/x_lock)^2), finite up to 0.97 x_lock."""

    k: float = 120.0  # N/m
    x_lock: float = 0.12  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        share = min(abs(x) / self.x_lock, 0.97)
        return self.k * x / (1 - share * share)


@law
class BraidedTube(Effect):
    """A thin tube of rubber that follows the braid; left to define: its law."""

    length: float = 0.24  # m
    diameter: float = 0.02  # m
    thickness: float = 0.254e-3  # m
    turns: float = 2.0

    @property
    def tangent(self) -> float:
        """Square of length by turned girth: the hoop stretch squared is 1 + tangent (1 - axial stretch squared)."""
        return (self.length / (self.turns * pi * self.diameter)) ** 2

    @property
    def wall(self) -> float:
        """Volume of the rubber [m3]."""
        return pi * self.diameter * self.thickness * self.length


@law
class GentTube(BraidedTube):
    """A thin tube of Gent's rubber that follows the braid: W = -mu J/2 ln(1 - (I1 - 3)/J), by virtual work.

    Its chains have a finite length, so that it locks at I1 = 3 + J; finite here up to 0.95 J.
    Source: A. N. Gent, A new constitutive relation for rubber, Rubber Chem. Technol. 69 (1996) 59.
    """

    mu: float = 2.4e5  # Pa
    limit: float = 5.0  # J

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        invariant = a * a + s + 1 / (a * a * s)
        slope = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        used = min((invariant - 3) / self.limit, 0.95)
        return -self.wall / self.length * self.mu / 2 * slope / (1 - used)


@law
class OgdenTube(BraidedTube):
    """A thin tube of Ogden's rubber that follows the braid: W = sum mu/alpha (a^alpha + c^alpha + (a c)^-alpha - 3).

    Axial stretch a, hoop stretch c; Ogden's three terms for Treloar's rubber, times one factor; by virtual work.
    Source: R. W. Ogden, Large deformation isotropic elasticity, Proc. R. Soc. Lond. A 326 (1972) 565.
    """

    modulus: float = 2.4e5  # Pa, shear modulus at rest

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        c = sqrt(1 + tangent * (1 - a * a))
        c_a = -tangent * a / c
        thinner = c + a * c_a  # slope of a c
        slope = sum(
            mu * (a ** (alpha - 1) + c ** (alpha - 1) * c_a - (a * c) ** (-alpha - 1) * thinner)
            for mu, alpha in _TRELOAR
        )
        return float(-self.wall / self.length * self.modulus / _TRELOAR_MODULUS * slope)


@law
class SlackCord(Effect):
    """An elastic cord that hangs slack at rest and comes taut at x_0, rounded over 1 mm: k (x - x_0) beyond.

    Return springs and safety cords are fastened with play; reasoned here.
    """

    k: float = 400.0  # N/m
    x_0: float = 0.02  # m
    rounded: float = 1e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        over = x - self.x_0
        return self.k * (over + sqrt(over * over + self.rounded * self.rounded)) / 2


@law
class YeohTube(BraidedTube):
    """A thin tube of Yeoh's rubber that follows the braid: W = c1 J - r2 c1 J^2 + r3 c1 J^3, J = I1 - 3.

    The second coefficient is negative and the third positive for filled rubber: soft in between, stiff in the end.
    Source: O. H. Yeoh, Some forms of the strain energy function for rubber, Rubber Chem. Technol. 66 (1993) 754.
    """

    c1: float = 1.2e5  # Pa
    r2: float = 0.08
    r3: float = 0.01

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        j = a * a + s + 1 / (a * a * s) - 3
        j_a = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        return (
            -self.wall / self.length * self.c1 * (1 - 2 * self.r2 * j + 3 * self.r3 * j * j) * j_a
        )


@law
class SideSpring(Effect):
    """A spring from the load to a post beside the rig: k x (1 - l/sqrt(d^2 + x^2)).

    It lies across the way at rest, d long and l unstretched, so that it pulls along the way only once it is turned.
    The large-displacement truss of every textbook, e.g. J. M. T. Thompson, G. W. Hunt, Elastic Instability Phenomena
    (1984).
    """

    k: float = 1000.0  # N/m
    d: float = 0.08  # m
    unstretched: float = 0.9  # l by d

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * x * (1 - self.unstretched * self.d / sqrt(self.d * self.d + x * x))


@law
class EightChain(BraidedTube):
    """A thin tube of rubber, eight chains of N links in each cell: dW/dI1 = mu/6 (3 - y^2)/(1 - y^2), y^2 = I1/(3 N).

    The inverse of Langevin's function is Cohen's y (3 - y^2)/(1 - y^2); finite here up to y^2 = 0.94.
    Source: E. M. Arruda, M. C. Boyce, A three-dimensional constitutive model for the large stretch behavior of rubber
    elastic materials, J. Mech. Phys. Solids 41 (1993) 389; A. Cohen, Rheol. Acta 30 (1991) 270.
    """

    mu: float = 2.0e5  # Pa
    links: float = 3.0  # N

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        invariant = a * a + s + 1 / (a * a * s)
        slope = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        used = min(invariant / (3 * self.links), 0.94)
        return -self.wall / self.length * self.mu / 6 * (3 - used) / (1 - used) * slope


@law
class PrestretchedTube(BraidedTube):
    """A neo-Hookean bladder that was mounted a times longer than it lies free; by virtual work, I1 of both stretches.

    Its hoops are unstretched in the muscle at rest; its volume is that of the free tube of the braid's length by a.
    Source: C. S. Kothera, M. Jangid, J. Sirohi, N. M. Wereley, Experimental characterization and static modeling of
    McKibben actuators, J. Mech. Des. 131 (2009) 091010, on bladders that are strained before use.
    """

    mu: float = 2.4e5  # Pa
    prestretch: float = 1.1  # a

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent, square = 1 - x / self.length, self.tangent, self.prestretch**2
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        slope = 2 * square * a + s_a - (2 / (a**3 * s) + s_a / (a * s) ** 2) / square
        return -self.wall / self.prestretch / self.length * self.mu / 2 * slope


@law
class LogarithmicTube(BraidedTube):
    """A thin tube of rubber with the energy 2 mu (l (ln l - 1)) of each stretch l, by virtual work.

    Source: K. C. Valanis, R. F. Landel, The strain-energy function of a hyperelastic material in terms of the
    extension ratios, J. Appl. Phys. 38 (1967) 2997.
    """

    mu: float = 2.4e5  # Pa

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        c = sqrt(1 + tangent * (1 - a * a))
        c_a = -tangent * a / c
        thinner = -(c + a * c_a) / (a * c) ** 2  # slope of the wall's stretch 1/(a c)
        slope = log(a) + log(c) * c_a - log(a * c) * thinner
        return -self.wall / self.length * 2 * self.mu * slope
