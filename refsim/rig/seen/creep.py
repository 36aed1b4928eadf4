"""Rubber that relaxes: forces that fade while the contraction is held. Positive forces oppose contraction."""

from __future__ import annotations

from math import exp, expm1, sinh, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import T_ATM

_TIMES = tuple(4.0**k for k in range(-3, 3))  # of the relaxation time
_PARTS = tuple(sqrt(u) * exp(-u / 4) for u in _TIMES)
_WEIGHTS = tuple(part / sum(_PARTS) for part in _PARTS)

_DECADES = tuple(0.1 * 10 ** (0.625 * i) for i in range(5))  # s
_WLF = (
    6.4,
    142.0,
)  # [-] and [K]: the universal constants 17.44 and 51.6 K, moved from -70 degC, latex's, to 20 degC


@law
class FractionalCreep(Effect):
    """Relaxation by a power of time, as five Maxwell elements from 0.1 s to 31.6 s: weights tau^-a."""

    atol: ClassVar[tuple[float, ...]] = (1e-10,) * 5
    k: float = 200.0  # N/m, at 1 s
    a: float = 0.3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,) * 5

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return tuple((now.x - r) / tau for r, tau in zip(q, _DECADES, strict=True))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return float(
            self.k * sum((x - r) * tau**-self.a for r, tau in zip(q, _DECADES, strict=True))
        )


@law
class EyringCreep(Effect):
    """A Maxwell element whose dashpot thins when it is loaded: q' = (x_0/tau) sinh((x - q)/x_0)."""

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 2.0  # s
    x_0: float = 0.015  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self.x_0 / self.tau * sinh(max(-20.0, min(20.0, (now.x - q[0]) / self.x_0))),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@law
class FungCreep(Effect):
    """Quasi-linear viscoelasticity: one relaxation time acts on a spring that stiffens, e = x_0 (exp(x/x_0) - 1).

    Source: Y. C. Fung, Biomechanics: Mechanical Properties of Living Tissues (1981), section 7.6.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 200.0  # N/m
    tau: float = 1.5  # s
    x_0: float = 0.04  # m

    def _stretch(self, x: float) -> float:
        return self.x_0 * expm1(min(x / self.x_0, 6.0))

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (self._stretch(rest.x),)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self._stretch(now.x) - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (self._stretch(x) - q[0])


@law
class FlowingRubber(Effect):
    """A spring whose dashpot flows by a power m of its load: q' = e/tau (d + (e/x_0)^2)^((m - 1)/2), force k e.

    e = x - q. The exponent is 2 to 5 for filled rubber, so that relaxation is quick at first and has a long tail.
    Source: J. S. Bergstrom, M. C. Boyce, Constitutive modeling of the large strain time-dependent behavior of
    elastomers, J. Mech. Phys. Solids 46 (1998) 931; d = 0.01 keeps a little flow at rest.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 2.0  # s
    x_0: float = 0.015  # m
    m: float = 3.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        stretched = now.x - q[0]
        return (stretched / self.tau * (0.01 + (stretched / self.x_0) ** 2) ** ((self.m - 1) / 2),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@law
class SlowRecovery(Effect):
    """Rubber that recovers later than it gave way: a Maxwell element with tau under load and r tau after it.

    Source: A. N. Gent, Engineering with Rubber, 3rd ed. (2012), on creep and its incomplete recovery.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.0  # s
    r: float = 4.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        stretched = now.x - q[0]
        return (stretched / (self.tau if stretched > 0 else self.r * self.tau),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@law
class HardeningCreep(Effect):
    """A spring k e whose dashpot hardens as it flows: q' = e/tau (x_0/(x_0 + |q|))^m, e = x - q.

    Primary creep by strain hardening, as of cords and braids of polyethylene or polyamide. Source: F. H. Norton, The
    Creep of Steel at High Temperatures (1929), with the hardening of R. W. Bailey, Proc. Inst. Mech. Eng. 131 (1935)
    131; here with a load to the first power.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 0.3  # s
    x_0: float = 5e-3  # m
    m: float = 2.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau * (self.x_0 / (self.x_0 + abs(q[0]))) ** self.m,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@law
class WarmCreep(Effect):
    """A Maxwell element of rubber that flows quicker when the gas is warm: tau 10^(-c1 theta/(c2 + theta)).

    theta is half of what the gas is above ambient, as in the middle of a thin bladder. Source: M. L. Williams,
    R. F. Landel, J. D. Ferry, The temperature dependence of relaxation mechanisms in amorphous polymers, J. Am. Chem.
    Soc. 77 (1955) 3701.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.5  # s, at ambient temperature

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        theta = max(-60.0, (now.temperature - T_ATM) / 2)
        shift = 10 ** (-_WLF[0] * theta / (_WLF[1] + theta))
        return ((now.x - q[0]) / (self.tau * shift),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@law
class HoopRelaxation(Effect):
    """The bladder's hoops relax, not its length: k (c - q) dc/dx with q' = (c - q)/tau, c = D/D0 by the braid.

    A Maxwell element around the bladder, by virtual work; hoops stretch by two or three times of what the length
    shortens. Source of the element: N. W. Tschoegl, The Phenomenological Theory of Linear Viscoelastic Behavior (1989).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    k: float = 2.0  # J
    tau: float = 1.5  # s
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def _hoop(self, x: float) -> float:
        at_rest = self.fibre_squared - self.length**2
        return sqrt((self.fibre_squared - (self.length - x) ** 2) / at_rest)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (self._hoop(rest.x),)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self._hoop(now.x) - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        c = self._hoop(x)
        return self.k * (c - q[0]) * (self.length - x) / (c * (self.fibre_squared - self.length**2))


@law
class StretchedExponential(Effect):
    """Relaxation by exp(-(t/tau)^(1/2)), as six Maxwell elements of times u tau: weights u^(1/2) exp(-u/4).

    Source: G. Williams, D. C. Watts, Trans. Faraday Soc. 66 (1970) 80; the spectrum of the exponent 1/2 is exact (C. P.
    Lindsey, G. D. Patterson, J. Chem. Phys. 73 (1980) 3348), here in steps of 4 from 1/64 to 16.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-10,) * len(_TIMES)
    k: float = 400.0  # N/m
    tau: float = 1.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,) * len(_TIMES)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return tuple((now.x - r) / (u * self.tau) for r, u in zip(q, _TIMES, strict=True))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return float(self.k * sum(w * (x - r) for r, w in zip(q, _WEIGHTS, strict=True)))
