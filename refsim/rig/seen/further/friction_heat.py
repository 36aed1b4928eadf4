"""Heat of friction that reaches the gas."""

from __future__ import annotations

from math import cosh, log
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law

_TIMES = tuple(6.0**k for k in range(-2, 3))  # of the time of diffusion
_PARTS = tuple(1 / cosh(log(u) / 2) for u in _TIMES)
_WEIGHTS = tuple(part / sum(_PARTS) for part in _PARTS)


@law
class ThinningWall(Effect):
    """Heat of friction comes through a bladder that thins as it stretches, a lag: tau (t/t_0)^2 = tau (L0 D0/L D)^2.

    The time of diffusion goes with the square of the thickness, and the rubber keeps its volume; friction heats in both
    directions. State: the heat that arrives [W]. Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids
    (1959), chapter 3, in one lump.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    share: float = 1.0
    tau: float = 0.3  # s, at rest
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        rubbed = max(now.p_gauge, 0.0) * (self.crossing * now.v**2 + self.covered * abs(now.v))
        square = (self.length - now.x) ** 2
        rest = self.length**2 * (self.fibre_squared - self.length**2)
        thinner = rest / max(square * (self.fibre_squared - square), 0.1 * rest)
        return ((self.share * rubbed - q[0]) / (self.tau * thinner),)

    def heat(self, q: State) -> float:
        return q[0]


@law
class DeepContact(Effect):
    """Contacts lie on a body that takes up heat to any depth and gives it off late: share by 1/(1 + sqrt(s tau)).

    s is the rate of change; five lags of times u tau with weights 1/cosh(ln(u)/2) stand for the root. Friction heats in
    both directions. States: their heats [W] before weighting. Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat
    in Solids (1959), chapter 2; the spectrum is that of K. S. Cole, R. H. Cole, J. Chem. Phys. 9 (1941) 341.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-6,) * len(_TIMES)
    share: float = 1.0
    tau: float = 0.2  # s
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,) * len(_TIMES)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        rubbed = max(now.p_gauge, 0.0) * (self.crossing * now.v**2 + self.covered * abs(now.v))
        return tuple(
            (self.share * rubbed - r) / (u * self.tau) for r, u in zip(q, _TIMES, strict=True)
        )

    def heat(self, q: State) -> float:
        return float(sum(w * r for w, r in zip(_WEIGHTS, q, strict=True)))
