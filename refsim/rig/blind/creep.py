"""Rubber that relaxes: forces that fade while the contraction is held. Positive forces oppose contraction."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State

_TIMES = tuple(4.0**k for k in range(-3, 3))  # of the relaxation time
_PARTS = tuple(sqrt(u) * exp(-u / 4) for u in _TIMES)
_WEIGHTS = tuple(part / sum(_PARTS) for part in _PARTS)


@dataclass(frozen=True)
class HoopRelaxation(Effect):
    """The bladder's hoops relax, not its length: k (c - q) dc/dx with q' = (c - q)/tau, c = D/D0 by the braid.

    A Maxwell element around the bladder, by virtual work; hoops stretch by two or three times of what the length
    shortens. Source of the element: N. W. Tschoegl, The Phenomenological Theory of Linear Viscoelastic Behavior (1989).
    """

    family = "creep"
    form = "hoop_relaxation"
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


@dataclass(frozen=True)
class StretchedExponential(Effect):
    """Relaxation by exp(-(t/tau)^(1/2)), as six Maxwell elements of times u tau: weights u^(1/2) exp(-u/4).

    Source: G. Williams, D. C. Watts, Trans. Faraday Soc. 66 (1970) 80; the spectrum of the exponent 1/2 is exact (C. P.
    Lindsey, G. D. Patterson, J. Chem. Phys. 73 (1980) 3348), here in steps of 4 from 1/64 to 16.
    """

    family = "creep"
    form = "stretched_exponential"
    atol: ClassVar[tuple[float, ...]] = (1e-10,) * len(_TIMES)
    k: float = 400.0  # N/m
    tau: float = 1.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,) * len(_TIMES)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return tuple((now.x - r) / (u * self.tau) for r, u in zip(q, _TIMES, strict=True))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return float(self.k * sum(w * (x - r) for r, w in zip(q, _WEIGHTS, strict=True)))
