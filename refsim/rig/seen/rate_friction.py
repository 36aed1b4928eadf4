"""Friction that grows with the speed. Positive forces oppose contraction."""

from __future__ import annotations

from math import asinh, exp, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import T_ATM


@law
class Eyring(Effect):
    """Friction that saturates: c v_0 asinh(v/v_0)."""

    c: float = 500.0  # N s/m
    v_0: float = 0.01  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * self.v_0 * asinh(v / self.v_0)


@law
class GrowingViscous(Effect):
    """Viscous friction that grows with contraction: c v (1 + x/x_0)."""

    c: float = 120.0  # N s/m
    x_0: float = 0.02  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1 + max(x, 0.0) / self.x_0)


@law
class OneSidedViscous(Effect):
    """A damper that works mainly in contraction: c v, and share c v in extension."""

    c: float = 300.0  # N s/m
    share: float = 0.3

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1.0 if v > 0 else self.share)


@law
class FilmFriction(Effect):
    """Fibres that slide on a film of grease: c sqrt(p |v|) sign v, smooth below 1 mm/s.

    On a full film the coefficient of friction goes as the square root of viscosity times speed over pressure (the
    rising branch of the Stribeck curve), so the force, coefficient times pressure, goes as sqrt(p |v|).
    Source: B. J. Hamrock, S. R. Schmid, B. O. Jacobson, Fundamentals of Fluid Film Lubrication, 2nd ed. (2004).
    """

    c: float = 0.12  # N/sqrt(Pa m/s)
    eps: float = 1e-3  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * sqrt(max(p_gauge, 0.0)) * v / sqrt(sqrt(v * v + self.eps * self.eps))


@law
class OrificeDamper(Effect):
    """A dashpot whose oil is pressed through a hole: c v (1 + |v|/v_0), the square from the oil's inertia."""

    c: float = 100.0  # N s/m
    v_0: float = 0.02  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1 + abs(v) / self.v_0)


@law
class EddyBrake(Effect):
    """A geared eddy-current brake: c v/(1 + (v/v_k)^2), which brakes most at its critical speed v_k.

    Source: W. R. Smythe, On eddy currents in a rotating disk, Trans. AIEE 61 (1942) 681.
    """

    c: float = 300.0  # N s/m
    v_k: float = 0.08  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v / (1 + (v / self.v_k) ** 2)


@law
class ShearedMatrix(Effect):
    """A braid in a soft viscous matrix, which its fibres shear as they turn: c v/sin^2 of the braid angle.

    The fibres turn by v/(b sin), and the work on the matrix goes with the square of that. Derived by virtual power.
    """

    c: float = 60.0  # N s/m
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v / (1 - (self.length - x) ** 2 / self.fibre_squared)


@law
class ThixotropicGrease(Effect):
    """Grease that breaks down when sheared and sets again at rest: c v (r + (1 - r) s), s' = (1 - s)/tau - s |v|/d.

    Source: F. Moore, The rheology of ceramic slips and bodies, Trans. Brit. Ceram. Soc. 58 (1959) 470; J. Mewis,
    N. J. Wagner, Thixotropy, Adv. Colloid Interface Sci. 147 (2009) 214.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    c: float = 400.0  # N s/m, of grease that has set
    r: float = 0.3
    d: float = 0.01  # m
    tau: float = 2.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (1.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((1 - q[0]) / self.tau - q[0] * abs(now.v) / self.d,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (self.r + (1 - self.r) * q[0])


@law
class ViscousBladder(Effect):
    """The bladder's rubber is viscous beside its springiness (Kelvin-Voigt) and follows the braid.

    The power is 4 eta times the wall's volume times (e_a^2 + e_h^2 + e_a e_h), with the rates of stretching e_a = -v/L
    along and e_h = L v/(b^2 - L^2) around. Derived by virtual power; source of the power: G. K. Batchelor, An
    Introduction to Fluid Dynamics (1967), section 3.4.
    """

    eta: float = 1e5  # Pa s
    wall: float = 3.8e-6  # m3, volume of the rubber
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        around = length / (self.fibre_squared - length * length)
        along = -1 / length
        return 4 * self.eta * self.wall * v * (along * along + around * around + along * around)


@law
class ThinningOil(Effect):
    """A dashpot of silicone oil, which thins when sheared: c v (1 + (v/v_0)^2)^((n - 1)/2).

    Source: P. J. Carreau, Rheological equations from molecular network theories, Trans. Soc. Rheol. 16 (1972) 99.
    """

    c: float = 400.0  # N s/m
    v_0: float = 0.02  # m/s
    n: float = 0.5

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return float(self.c * v * (1 + (v / self.v_0) ** 2) ** ((self.n - 1) / 2))


@law
class WarmGrease(Effect):
    """Grease between the fibres that thins as the gas warms the bladder: c v exp(-theta/theta_0).

    State: theta [K], half of what the gas is above ambient, behind tau. Source: O. Reynolds, Phil. Trans. R. Soc. 177
    (1886) 157, on viscosity by temperature.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    c: float = 300.0  # N s/m, at ambient temperature
    theta_0: float = 10.0  # K
    tau: float = 0.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (((now.temperature - T_ATM) / 2 - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * exp(min(max(-q[0] / self.theta_0, -3.0), 3.0))


@law
class TurningCrossings(Effect):
    """Greased crossings, which pressure presses together, turn on each other: c p v sin^2(theta_0)/sin^2(theta).

    Fibres turn at v/(b sin(theta)), and the power of a crossing goes with pressure and the square of that. Derived by
    virtual power; the pressure as in D. Reynolds et al., Ann. Biomed. Eng. 31 (2003) 310, whose damping goes with it.
    """

    c: float = 3e-3  # N s/(m Pa), at rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        rest = self.fibre_squared - self.length**2
        return self.c * max(p_gauge, 0.0) * v * rest / (self.fibre_squared - (self.length - x) ** 2)
