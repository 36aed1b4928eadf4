"""Ends that are no cylinder: the muscle's pull by contraction and pressure."""

from __future__ import annotations

from math import exp, pi, sqrt

from rig.effect import Effect, law


@law
class BulgingEnds(Effect):
    """The ends hold back more, the more the middle bulges: contraction counts 1 + c eps times in the force."""

    c: float = 0.4
    length: float = 0.24  # m

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * x / self.length


@law
class SpreadEnds(Effect):
    """The ends spread linearly with pressure: contraction counts 1 + c (1 - p/p_0) times, at least once."""

    c: float = 0.15
    p_0: float = 3e5  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * max(0.0, 1 - p_gauge / self.p_0)


@law
class LooseBladder(Effect):
    """The bladder does not fill the braid before it is pressed against it: pull times 1 - c p_0/(p_0 + p).

    Muscles are built with play between bladder and braid, above all at the ends, and need some pressure before they
    pull as the cylinder does; reasoned here as a share of the braid without contact that fades with pressure.
    """

    c: float = 0.1
    p_0: float = 5e4  # Pa

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 - self.c * self.p_0 / (self.p_0 + max(p_gauge, 0.0))


@law
class ConicalEnds(Effect):
    """Between fitting and cylinder the braid is a cone, the longer the thicker the muscle: pull times 1 - c (D/D0 - 1).

    Source: N. Tsagarakis, D. G. Caldwell, Improved modelling and assessment of pneumatic muscle actuators, IEEE Int.
    Conf. Robotics and Automation (2000) 3641, whose truncated cones are taken to first order here.
    """

    c: float = 0.1
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def pull_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        wider = sqrt((self.fibre_squared - length * length) / (self.fibre_squared - self.length**2))
        return 1 - self.c * (wider - 1)


@law
class BentFibres(Effect):
    """Stiff fibres bend near the clamps over sqrt(E I/tension): contraction counts 1 + c/sqrt(1 + p/p_0) times.

    The tension of a fibre goes with pressure. Reasoned from the edge of a clamped beam under tension (S. Timoshenko,
    Strength of Materials II, 1956).
    """

    c: float = 0.15
    p_0: float = 3e4  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c / sqrt(1 + max(p_gauge, 0.0) / self.p_0)


@law
class RoundedTips(Effect):
    """The tips are rounded over a length c D and do not contract: contraction counts 1/(1 - c D/L0) times.

    Source: E. G. Hocking, N. M. Wereley, Analysis of nonlinear elastic behavior in miniature pneumatic artificial
    muscles, Smart Mater. Struct. 22 (2013) 014016, on tips whose length goes with the diameter; to first order here.
    """

    c: float = 0.6
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def shape_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        diameter = sqrt(max(self.fibre_squared - length * length, 0.0)) / (pi * self.turns)
        return 1 / (1 - self.c * diameter / self.length)


@law
class UnfoldingEnds(Effect):
    """The bladder lies in folds at its ends until a pressure opens them: pull times 1 - c/(1 + exp((p - p_0)/w)).

    Muscles need a threshold of pressure before the bladder fills the braid (C.-P. Chou, B. Hannaford, IEEE Trans.
    Robot. Autom. 12 (1996) 90); folds open about p_0, with w = p_0/4. Reasoned.
    """

    c: float = 0.15
    p_0: float = 6e4  # Pa

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 - self.c / (1 + exp(min(4 * (p_gauge / self.p_0 - 1), 60.0)))


@law
class RoundCaps(Effect):
    """Both ends are half ellipsoids, c D/2 long, instead of a cylinder's: they lack c pi D^3/12 of its volume.

    By virtual work the pull is times 1 - c D L/(3 L^2 - b^2). Source of the principle: C.-P. Chou, B. Hannaford, IEEE
    Trans. Robot. Autom. 12 (1996) 90, whose muscle is a cylinder; c = 1 are half balls.
    """

    c: float = 0.5
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def pull_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        diameter = sqrt(max(self.fibre_squared - length * length, 0.0)) / (pi * self.turns)
        room = max(3 * length * length - self.fibre_squared, 0.15 * self.fibre_squared)
        return 1 - self.c * diameter * length / room


@law
class UnevenBraid(Effect):
    """Near the clamps the braid is wound steeper, by an angle, over a share of the length: two muscles in series.

    Both feel one pull p A_0 f, so that a part at theta stretches by l, 3 l^2 cos^2 = 1 + f sin^2 of its theta; the
    parts' lengths add up. Derived from (12) of Chou and Hannaford (1996) for each part.
    """

    more: float = 0.05  # rad
    share: float = 0.2
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def _parts(self) -> tuple[tuple[float, float, float], ...]:
        """Share, square of cosine and of sine for the middle and the ends."""
        cos2 = self.length**2 / self.fibre_squared
        cos, sin = sqrt(cos2), sqrt(1 - cos2)
        turned = (
            cos - self.more * sin - self.more**2 / 2 * cos
        )  # cosine of theta + more, to second order
        steep = max(turned, 0.65) ** 2
        return (1 - self.share, cos2, 1 - cos2), (self.share, steep, 1 - steep)

    def pull_factor(self, x: float, p_gauge: float) -> float:
        parts, a = self._parts(), 1 - x / self.length
        _, cos2, sin2 = parts[0]
        alone = (3 * a * a * cos2 - 1) / sin2  # f of an even braid
        f = alone
        for _ in range(5):  # Newton's steps; the sum of lengths is concave in f
            lengths = [(s, sqrt(max(1 + f * i, 0.05) / (3 * c)), i / (6 * c)) for s, c, i in parts]
            f += (a - sum(s * part for s, part, _ in lengths)) / sum(
                s * k / part for s, part, k in lengths
            )
        return f / max(alone, 0.2)


@law
class BridgingBladder(Effect):
    """At the ends the bladder spans the step to the fitting until pressed into it: 1 + c (D/D0 - 1)/(1 + p/p_0) times.

    The contraction counts so many times: the more the step is, and the less the bladder is pressed. Reasoned from the
    ends of C.-P. Chou and B. Hannaford (1996) and the pressure in B.-S. Kang et al., IEEE ICRA (2009) 182.
    """

    c: float = 0.5
    p_0: float = 1e5  # Pa
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def shape_factor(self, x: float, p_gauge: float) -> float:
        wider = sqrt(
            (self.fibre_squared - (self.length - x) ** 2) / (self.fibre_squared - self.length**2)
        )
        return 1 + self.c * (wider - 1) / (1 + max(p_gauge, 0.0) / self.p_0)
