"""A wall that stores heat."""

from __future__ import annotations

from math import expm1, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import T_ATM


@law
class StretchedWall(Effect):
    """Rubber warms as it is stretched (Gough, Joule): C T_w' = heat from gas - G_out dT + C b T_w (c - 1/c^2) c'.

    c = D/D0 is the stretch of the hoops by the braid; ideal rubber does its elastic work out of heat. Source: L. R. G.
    Treloar, The Physics of Rubber Elasticity (1975), chapter 2, whose b is shear modulus by heat capacity of volume and
    temperature; a little more for rubber that crystallises.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K
    b: float = 1e-3
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length, rest = self.length - now.x, self.fibre_squared - self.length**2
        c = sqrt(max(self.fibre_squared - length * length, 0.2 * rest) / rest)
        stretching = length / (c * rest) * now.v  # c'
        lost = self.g_out * (q[0] - T_ATM)
        warmed = self.b * q[0] * (c - 1 / c**2) * stretching
        return ((-now.heat_to_gas - lost) / self.capacity + warmed,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@law
class DampSleeve(Effect):
    """A damp sleeve in moist air loses heat by what evaporates of it: loss G_out theta (exp(dT/theta) - 1).

    theta = 15 K is where the pressure of saturated vapour has grown by e; the exponent stays within 4. Source: W. K.
    Lewis, The evaporation of a liquid into a gas, Trans. ASME 44 (1922) 325; muscles with wet sleeves have been cooled
    so.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.03  # W/K, of small differences
    theta: float = 15.0  # K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        lost = self.g_out * self.theta * expm1(min((q[0] - T_ATM) / self.theta, 4.0))
        return ((-now.heat_to_gas - lost) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]
