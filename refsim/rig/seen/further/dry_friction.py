"""Dry friction: by the direction of motion and the way since it turned. Positive forces oppose contraction."""

from __future__ import annotations

from math import exp, log, sqrt, tanh

from rig.effect import Effect, State, law


@law
class RubberSliding(Effect):
    """Rubber that slides has a speed of most friction: F_c (1 - a + a exp(-h^2 ln^2(|v|/v_m))) tanh(v/width).

    The bell over the logarithm of speed is the rubber's loss. Source: A. R. Savkoor, On the friction of rubber, Wear 8
    (1965) 222, by the measurements of K. A. Grosch, Proc. R. Soc. Lond. A 274 (1963) 21.
    """

    f_c: float = 8.0  # N, at the speed v_m
    a: float = 0.5
    v_m: float = 0.03  # m/s
    h: float = 0.6
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        decades = self.h * log(sqrt(v * v + 1e-10) / self.v_m)
        bell = exp(-min(decades * decades, 50.0))
        return self.f_c * (1 - self.a + self.a * bell) * tanh(v / self.width)


@law
class GuardTube(Effect):
    """The muscle bulges into its guard tube and rubs on it: F over(D/D0 - 1 - gap) tanh(v/width), D by the braid.

    over(y) = (y + sqrt(y^2 + 0.01^2))/2 is what the tube squeezes, which the wall takes as a bed of springs. Reasoned
    from Winkler's bed with Amontons' law (K. L. Johnson, Contact Mechanics, 1985); rigs with guides around the muscle
    have it.
    """

    f: float = 40.0  # N, for a squeeze by the whole diameter
    gap: float = 0.05
    width: float = 5e-4  # m/s
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        wider = sqrt((self.fibre_squared - length * length) / (self.fibre_squared - self.length**2))
        y = wider - 1 - self.gap
        return self.f * (y + sqrt(y * y + 1e-4)) / 2 * tanh(v / self.width)
