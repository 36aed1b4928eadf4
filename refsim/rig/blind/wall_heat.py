"""A wall that stores heat."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.flow import T_ATM


@dataclass(frozen=True)
class ExhaustDraught(Effect):
    """The exhaust blows along the muscle and cools its wall: loss g_out dT (1 + c a) with the exhaust's opening a.

    a is the current above the threshold of 0.145 A by 0.205 A. Source: heat balance of a lump; the draught is reasoned.
    """

    family = "wall_heat"
    form = "exhaust_draught"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K, without draught
    c: float = 5.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        blown = 1 + self.c * max(now.command[1] - 0.145, 0.0) / 0.205
        return ((-now.heat_to_gas - self.g_out * blown * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class ClosingGap(Effect):
    """A muscle in a guard tube, which it fills as it bulges: loss g_out dT (1 + x/x_0).

    Still air conducts across the gap, the better the narrower it is; to first order in the contraction. Reasoned.
    """

    family = "wall_heat"
    form = "closing_gap"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K, at rest
    x_0: float = 0.01  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        nearer = 1 + max(now.x, 0.0) / self.x_0
        return ((-now.heat_to_gas - self.g_out * nearer * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class TwoPatches(Effect):
    """A wall of bare patches and of ones that fibres thicken, side by side: shares s and 1 - s of the inner surface.

    States: their temperatures; the thick ones have `ratio` times the capacity and the same loss. `coefficient` is the
    base model's between gas and wall. Source: heat balance of two lumps side by side.
    """

    family = "wall_heat"
    form = "two_patches"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.2  # J/K, of the bare patches
    ratio: float = 5.0
    share: float = 0.5
    g_out: float = 0.02  # W/K, of both together
    coefficient: float = 9.8  # W/(m2 K)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    fibre_area: float = 0.0133  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length = self.length - now.x
        girth = sqrt(self.fibre_squared - length * length) / self.turns
        inside = self.coefficient * max(0.0, girth * length - self.fibre_area)
        bare, thick = (inside * (now.temperature - t) - self.g_out * (t - T_ATM) for t in q)
        return self.share * bare / self.capacity, (1 - self.share) * thick / (
            self.ratio * self.capacity
        )

    def wall_temperature(self, q: State, outside: float) -> float:
        return self.share * q[0] + (1 - self.share) * q[1]
