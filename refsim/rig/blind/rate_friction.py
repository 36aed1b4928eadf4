"""Friction that grows with the speed. Positive forces oppose contraction."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.flow import T_ATM


@dataclass(frozen=True)
class ThinningOil(Effect):
    """A dashpot of silicone oil, which thins when sheared: c v (1 + (v/v_0)^2)^((n - 1)/2).

    Source: P. J. Carreau, Rheological equations from molecular network theories, Trans. Soc. Rheol. 16 (1972) 99.
    """

    family = "rate_friction"
    form = "carreau"
    c: float = 400.0  # N s/m
    v_0: float = 0.02  # m/s
    n: float = 0.5

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return float(self.c * v * (1 + (v / self.v_0) ** 2) ** ((self.n - 1) / 2))


@dataclass(frozen=True)
class WarmGrease(Effect):
    """Grease between the fibres that thins as the gas warms the bladder: c v exp(-theta/theta_0).

    State: theta [K], half of what the gas is above ambient, behind tau. Source: O. Reynolds, Phil. Trans. R. Soc. 177
    (1886) 157, on viscosity by temperature.
    """

    family = "rate_friction"
    form = "warm_grease"
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


@dataclass(frozen=True)
class TurningCrossings(Effect):
    """Greased crossings, which pressure presses together, turn on each other: c p v sin^2(theta_0)/sin^2(theta).

    Fibres turn at v/(b sin(theta)), and the power of a crossing goes with pressure and the square of that. Derived by
    virtual power; the pressure as in D. Reynolds et al., Ann. Biomed. Eng. 31 (2003) 310, whose damping goes with it.
    """

    family = "rate_friction"
    form = "turning_crossings"
    c: float = 3e-3  # N s/(m Pa), at rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        rest = self.fibre_squared - self.length**2
        return self.c * max(p_gauge, 0.0) * v * rest / (self.fibre_squared - (self.length - x) ** 2)
