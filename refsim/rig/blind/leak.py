"""Gas that gets out."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.flow import CP, P_ATM, T_ATM


@dataclass(frozen=True)
class ChangingLeak(Effect):
    """A laminar leak whose conductance follows a state of its own; left to define: by how much, and its rate."""

    family = "leak"
    conductance: float = 2e-11  # kg/(s Pa)

    def factor(self, q: State) -> float:
        """Factor on the conductance."""
        raise NotImplementedError

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.conductance * (p - P_ATM) * self.factor(q)
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)


@dataclass(frozen=True)
class MovingSeal(ChangingLeak):
    """A seal that rides up on a film while it slides: G p (1 + (|v|/v_0)^(1/2)). State: the speed behind 5 ms.

    Source: H. K. Mueller, B. S. Nau, Fluid Sealing Technology (1998): the film goes with the root of speed.
    """

    form = "moving_seal"
    atol: ClassVar[tuple[float, ...]] = (1e-8,)
    v_0: float = 5e-3  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.v - q[0]) / 5e-3,)

    def factor(self, q: State) -> float:
        return float(1 + ((q[0] * q[0] + 1e-10) ** 0.5 / self.v_0) ** 0.5)


@dataclass(frozen=True)
class CreepingSeal(ChangingLeak):
    """A soft seal that creeps into its gap under pressure and out again: G p s, s' = (1/(1 + p/p_0) - s)/tau.

    Reasoned from the set of rubber seals (A. N. Gent, Engineering with Rubber, 3rd ed., 2012).
    """

    form = "creeping_seal"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    p_0: float = 4e4  # Pa
    tau: float = 1.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (1.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((1 / (1 + max(now.p_gauge, 0.0) / self.p_0) - q[0]) / self.tau,)

    def factor(self, q: State) -> float:
        return q[0]


@dataclass(frozen=True)
class ColdSeal(Effect):
    """A seal that shrinks more than its groove when the gas is cold: G p exp(-(T - T_atm)/theta_0).

    Rubber contracts about ten times as much as metal, and a gap's flow goes with the cube of its width (O. Reynolds,
    Phil. Trans. R. Soc. 177 (1886) 157); the exponential is reasoned. The exponent stays within 3.
    """

    family = "leak"
    form = "cold_seal"
    conductance: float = 2e-11  # kg/(s Pa)
    theta_0: float = 12.0  # K

    def leak(self, p: float, temperature: float) -> float:
        cold = min(max((T_ATM - temperature) / self.theta_0, -3.0), 3.0)
        return self.conductance * (p - P_ATM) * exp(cold)
