"""Gas that gets out, that rests beside, and the line to the valves."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.catalogue.supply_line import Tube
from rig.effect import Effect, Now, Rest, State
from rig.family_members.chance import Chance, Place, order, some
from rig.flow import CP, CV, GAMMA, P_ATM, T_ATM, R
from rig.seen.dead_volume import Chamber, Resonator, TrappedPocket
from rig.seen.leak import ColdSeal, CreepingSeal, MovingSeal
from rig.seen.supply_line import SoftHose


@dataclass(frozen=True)
class OddLeak(Effect):
    """G 100 kPa max(q - q_0, 0)^n exp(x/x_0) (T/T_atm)^k, q the gauge pressure by 100 kPa. State: the contraction."""

    family = "leak"
    form = "random"
    atol: ClassVar[tuple[float, ...]] = (1e-8,)
    conductance: float = 1e-11  # kg/(s Pa)
    q_0: float = 0.0
    n: float = 1.0
    grows: float = 0.0  # 1/m, 1/x_0
    k: float = 0.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.v,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        over = (p - P_ATM) / 1e5 - self.q_0
        size = 0.5 * (over + sqrt(over * over + 1e-4)) if self.q_0 else abs(over)
        flow = self.conductance * 1e5 * size * sqrt(size * size + 1e-4) ** (self.n - 1)
        flow *= (
            exp(self.grows * q[0])
            * (temperature / T_ATM) ** self.k
            * (1 if self.q_0 or over > 0 else -1)
        )
        return flow, CP * flow * (temperature if flow > 0 else T_ATM)


def _conductance(rng: Chance) -> float:
    return order(rng, 6e-12, 4e-11)


LEAKS: dict[str, Place] = {
    "gauge pressure": lambda rng: OddLeak(_conductance(rng), n=some(rng, 0.5, 3)),
    "threshold": lambda rng: OddLeak(
        _conductance(rng) * 2, q_0=some(rng, 0.3, 1.2), n=some(rng, 0.7, 1.5)
    ),
    "contraction": lambda rng: OddLeak(
        _conductance(rng), n=some(rng, 0.6, 2), grows=some(rng, -30, 50)
    ),
    "temperature": lambda rng: OddLeak(_conductance(rng), n=some(rng, 0.6, 2), k=some(rng, -4, 4)),
    "threshold and contraction": lambda rng: OddLeak(
        _conductance(rng) * 2, q_0=some(rng, 0.3, 1.0), grows=some(rng, -20, 40)
    ),
    "shrinking seal": lambda rng: ColdSeal(_conductance(rng), some(rng, 15, 40)),
    "seal that slides": lambda rng: MovingSeal(
        conductance=_conductance(rng), v_0=order(rng, 2e-3, 2e-2)
    ),
    "seal that creeps": lambda rng: CreepingSeal(
        conductance=_conductance(rng) * 2, p_0=order(rng, 3e4, 2e5), tau=order(rng, 0.3, 3)
    ),
}


@dataclass(frozen=True)
class OddTube(Tube):
    """G 100 kPa u |u|^a (p_up/p_atm)^c, u = (p_a^2 - p_b^2)/(2 p_atm 100 kPa), by another factor each way."""

    form = "random"
    conductance: float = 4e-9  # kg/(s Pa)
    a: float = -0.3
    c: float = 0.0
    back: float = 1.0  # conductance in venting by that in filling

    def flow(self, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
        u = (p_a * p_a - p_b * p_b) / (2 * P_ATM * 1e5)
        flow = (
            self.conductance
            * 1e5
            * u
            * (u * u + 1e-5) ** (self.a / 2)
            * (max(p_a, p_b) / P_ATM) ** self.c
        )
        return float(flow if flow > 0 else flow * self.back)


@dataclass(frozen=True)
class OddLine(OddTube):
    """The same with the inertia of the gas in it, a line that is long. Last state: the flow."""

    form = "inertia"
    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7, 1e-10)
    inertance: float = 5e6  # 1/m, length by area

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (*super().initial(rest), 0.0)

    def into_muscle(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        return q[2], CP * q[2] * (self.node(q)[1] if q[2] > 0 else temperature)

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        p_a, t_a = self.node(q)
        settled = self.flow(p_a, t_a, p, temperature)
        drop = (p_a - p) * (q[2] / settled) ** 2 if abs(settled) > 1e-9 else 0.0
        lost = drop if q[2] * settled > 0 else -drop
        return (
            *super().line_rates(q, from_valves, p, temperature),
            (p_a - p - lost) / self.inertance,
        )


@dataclass(frozen=True)
class ColdTube(OddTube):
    """The same with gas that has the surroundings' temperature, at which it leaves either end."""

    form = "cold"
    atol: ClassVar[tuple[float, ...]] = (1e-12,)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM * self.volume / (R * T_ATM),)

    def node(self, q: State) -> tuple[float, float]:
        return q[0] * R * T_ATM / self.volume, T_ATM

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        return (from_valves[0] - self.into_muscle(q, p, temperature)[0],)


@dataclass(frozen=True)
class SupplyHose(Effect):
    """The supply sags while the inlet valve is open, behind a lag: a hose or a regulator before the valve.

    State: share of the supply's absolute pressure that is lost.
    """

    family = "supply_line"
    form = "supply_hose"
    atol: ClassVar[tuple[float, ...]] = (1e-8,)
    droop: float = 0.1  # share of absolute pressure lost at 0.1 g/s
    tau: float = 0.02  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self.droop * max(now.net_mass_flow, 0.0) / 1e-4 - q[0]) / self.tau,)

    def supply(self, q: State, p: float) -> float:
        return p * (1 - min(q[0], 0.9))


def _tube(rng: Chance) -> dict[str, float]:
    return {
        "volume": order(rng, 2e-6, 1e-5),
        "conductance": order(rng, 1.2e-9, 4e-9),
        "a": some(rng, -0.5, 0.05),
    }


LINES: dict[str, Place] = {
    "resistance": lambda rng: OddTube(**_tube(rng), c=some(rng, -0.5, 0.5)),
    "each way": lambda rng: OddTube(**_tube(rng), back=order(rng, 0.4, 2.5)),
    "heat": lambda rng: ColdTube(**_tube(rng)),
    "length": lambda rng: OddLine(**_tube(rng), inertance=order(rng, 1e6, 1e7)),
    "before the valve": lambda rng: SupplyHose(some(rng, 0.05, 0.2), order(rng, 0.005, 0.1)),
    "hose that widens": lambda rng: SoftHose(
        volume=order(rng, 2e-6, 1.2e-5),
        area=order(rng, 3e-7, 8e-7),
        expansion=order(rng, 1e-6, 6e-6),
    ),
}


@dataclass(frozen=True)
class SoftSpace(Effect):
    """A space at the muscle whose gas follows at once, V_0 + V_p q^n: states of its gas lag by 2 ms.

    States: its pressure; what flows is its gain. Temperature as the muscle's.
    """

    family = "dead_volume"
    form = "soft"
    stiff = True
    atol: ClassVar[tuple[float, ...]] = (1e-1,)
    v_0: float = 5e-6  # m3
    v_p: float = 2e-6  # m3
    n: float = 1.0
    lag: float = 2e-3  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (P_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.p_gauge + P_ATM - q[0]) / self.lag,)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        gauge = max((q[0] - P_ATM) / 1e5, 0.0)
        volume = self.v_0 + self.v_p * gauge**self.n
        slope = self.v_p * self.n * max(gauge, 1e-4) ** (self.n - 1) / 1e5 if gauge > 0 else 0.0
        rate = (p - q[0]) / self.lag
        work = (CV * volume / R + GAMMA / (GAMMA - 1) * q[0] * slope) * rate
        return work / (CP * temperature), work


DEAD: dict[str, Place] = {
    "space": lambda rng: SoftSpace(order(rng, 3e-6, 3e-5), 0.0),
    "elastic space": lambda rng: SoftSpace(
        order(rng, 3e-6, 1e-5), order(rng, 2e-6, 2e-5), some(rng, 0.6, 1.6)
    ),
    "behind an opening": lambda rng: Chamber(order(rng, 5e-6, 4e-5), order(rng, 3e-10, 5e-9)),
    "opening, each way": lambda rng: TrappedPocket(
        volume=order(rng, 5e-6, 3e-5),
        conductance=order(rng, 1e-9, 1e-8),
        share=order(rng, 0.05, 0.5),
    ),
    "inertia": lambda rng: Resonator(
        volume=order(rng, 5e-6, 3e-5),
        inertance=order(rng, 5e4, 3e5),
        conductance=order(rng, 1e-8, 5e-8),
    ),
}
