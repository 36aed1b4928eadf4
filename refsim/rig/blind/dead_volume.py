"""Gas that takes no part in contraction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.flow import CP, CV, GAMMA, P_ATM, T_ATM, R


@dataclass(frozen=True)
class Pocket(Effect):
    """A rigid side volume without heat exchange (states: mass, energy, then others); left to define: the flow."""

    family = "dead_volume"
    volume: float = 1.5e-5  # m3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1))

    def inside(self, q: State) -> float:
        """Absolute pressure in it [Pa]."""
        return (GAMMA - 1) * q[1] / self.volume

    def flow(self, q: State, p: float) -> float:
        """Gas [kg/s] from the muscle at p [Pa]."""
        raise NotImplementedError

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        flow = self.flow(q, p)
        return flow, CP * flow * (temperature if flow > 0 else q[1] / (CV * q[0]))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return self.exchange(q, now.p_gauge + P_ATM, now.temperature)


@dataclass(frozen=True)
class TrappedPocket(Pocket):
    """A pocket behind a lip of the bladder, which opens to fill it and lets out slowly: G in, share G out.

    Reasoned from folds at the end plugs; any lip seal is a check valve one way.
    """

    form = "trapped_pocket"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    conductance: float = 6e-9  # kg/(s Pa)
    share: float = 0.1

    def flow(self, q: State, p: float) -> float:
        flow = self.conductance * (p - self.inside(q))
        return flow if flow > 0 else self.share * flow


@dataclass(frozen=True)
class Resonator(Pocket):
    """A chamber behind a neck whose gas has inertia: I m' = p - p_side - m/G. Third state: the flow in the neck.

    The inertance I is length over section of the neck (1e5/m for 0.3 m of 2 mm bore). Source: H. von Helmholtz, Die
    Lehre von den Tonempfindungen (1863).
    """

    form = "resonator"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7, 1e-10)
    inertance: float = 1e5  # 1/m
    conductance: float = 2e-8  # kg/(s Pa)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (*super().initial(rest), 0.0)

    def flow(self, q: State, p: float) -> float:
        return q[2]

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        p = now.p_gauge + P_ATM
        return (
            *super().rates(q, now),
            (p - self.inside(q) - q[2] / self.conductance) / self.inertance,
        )
