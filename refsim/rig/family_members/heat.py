"""The gas's energy, the wall, heat of friction, and the thermocouple."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.family_members.chance import Chance, Place, order, some
from rig.flow import P_ATM, T_ATM, R
from rig.seen.gas_energy import InletJet


@dataclass(frozen=True)
class OddGas(Effect):
    """Mass and energy balance with film h (p/p_atm)^a (|dT|/10 K)^d + h_1 (|m_jet|/0.1 g/s)^k, times (T/T_atm)^t.

    The jet dies away in tau. States: mass, jet.
    """

    family = "gas_energy"
    form = "random"
    energy_balance = True
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h: float = 15.0  # W/(m2 K)
    a: float = 0.0
    d: float = 0.0
    t: float = 0.0
    h_1: float = 0.0  # W/(m2 K)
    k: float = 0.8
    tau: float = 0.05  # s
    wall: float = 1.8e-3  # m2 K/W

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return rest.gas_mass, 0.0

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.net_mass_flow - q[1]) / self.tau

    def temperature(self, q: State, pressure_volume: float, polytropic: float) -> float:
        return pressure_volume / (q[0] * R)

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        off = sqrt((temperature - T_ATM) ** 2 + 1.0) / 10
        film = self.h * (p / P_ATM) ** self.a * off**self.d
        film += self.h_1 * ((q[1] ** 2 + 1e-16) / 1e-8) ** (self.k / 2)
        return float(1 / (2 / (film * (temperature / T_ATM) ** self.t) + self.wall))


def _film(rng: Chance) -> float:
    return order(rng, 5, 60)


GASES: dict[str, Place] = {
    "pressure": lambda rng: OddGas(_film(rng), a=some(rng, -0.3, 1)),
    "temperature": lambda rng: OddGas(_film(rng), d=some(rng, 0, 0.4), t=some(rng, -2, 2)),
    "flow": lambda rng: OddGas(
        _film(rng), h_1=order(rng, 10, 100), k=some(rng, 0.4, 1), tau=order(rng, 0.01, 0.5)
    ),
    "all": lambda rng: OddGas(
        _film(rng),
        some(rng, 0, 0.6),
        some(rng, 0, 0.3),
        some(rng, -1, 1),
        order(rng, 10, 60),
        some(rng, 0.5, 1),
    ),
    "jet of the inlet": lambda rng: InletJet(
        h=_film(rng), h_1=order(rng, 10, 100), tau=order(rng, 0.05, 0.5)
    ),
}


@dataclass(frozen=True)
class OddWall(Effect):
    """A wall of three layers; the outer one loses g dT (|dT|/10 K)^n. States: their temperatures."""

    family = "wall_heat"
    form = "random"
    atol: ClassVar[tuple[float, ...]] = (1e-6,) * 3
    capacity: tuple[float, float, float] = (0.3, 0.3, 0.3)  # J/K
    between: tuple[float, float] = (0.1, 0.1)  # W/K
    g: float = 0.03  # W/K
    n: float = 0.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,) * 3

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        first, second = self.between[0] * (q[0] - q[1]), self.between[1] * (q[1] - q[2])
        warm = q[2] - T_ATM
        lost = self.g * warm * ((warm * warm + 1e-4) / 100) ** (self.n / 2)
        flows = (-now.heat_to_gas - first, first - second, second - lost)
        return tuple(flow / c for flow, c in zip(flows, self.capacity, strict=True))

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


def _layers(rng: Chance, low: float, high: float) -> tuple[float, float, float]:
    return order(rng, low, high), order(rng, low, high), order(rng, low, high)


WALLS: dict[str, Place] = {
    "one layer": lambda rng: OddWall((order(rng, 0.1, 2), 1e-3, 1e-3), (20.0, 20.0), order(rng, 0.01, 0.1)),
    "two layers": lambda rng: OddWall(
        (order(rng, 0.1, 1), order(rng, 0.1, 2), 1e-3), (order(rng, 0.03, 0.5), 20.0), order(rng, 0.01, 0.1)),
    "three layers": lambda rng: OddWall(
        _layers(rng, 0.05, 1), (order(rng, 0.03, 0.5), order(rng, 0.03, 0.5)), order(rng, 0.01, 0.1)),
    "loss by the difference": lambda rng: OddWall(
        (order(rng, 0.1, 1), 0.2, 1e-3), (0.2, 20.0), order(rng, 0.02, 0.1), some(rng, 0.1, 0.8)),
}  # fmt: skip


@dataclass(frozen=True)
class OddFrictionHeat(Effect):
    """Shares of both powers of friction heat the gas, others in extension; a part of it late. State: the late heat.

    The late part follows the crossings' power, c p v^2, as its lag knows no other.
    """

    family = "friction_heat"
    form = "random"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    fibre: float = 1.0
    bladder: float = 1.0
    fibre_back: float = 1.0  # share in extension by that in contraction
    bladder_back: float = 0.0
    late: float = 0.0  # share of the crossings' power that comes late
    tau: float = 0.3  # s
    crossing: float = 2.4e-3  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self.late * self.crossing * max(now.p_gauge, 0.0) * now.v**2 - q[0]) / self.tau,)

    def friction_heat(self, fibre: float, bladder: float) -> float:
        if bladder > 0:
            return self.fibre * fibre + self.bladder * bladder
        return self.fibre * self.fibre_back * fibre - self.bladder * self.bladder_back * bladder

    def heat(self, q: State) -> float:
        return q[0]


RUBBED: dict[str, Place] = {
    "crossings": lambda rng: OddFrictionHeat(some(rng, 0.4, 1), 0.0, some(rng, 0, 1)),
    "bladder": lambda rng: OddFrictionHeat(0.0, some(rng, 0.4, 1), 1.0, some(rng, 0, 1)),
    "both": lambda rng: OddFrictionHeat(
        some(rng, 0.3, 1), some(rng, 0.3, 1), some(rng, 0, 1), some(rng, 0, 1)
    ),
    "late": lambda rng: OddFrictionHeat(0.0, 0.0, late=some(rng, 0.5, 1), tau=order(rng, 0.05, 1)),
}


@dataclass(frozen=True)
class OddThermocouple(Effect):
    """Bead, sheath and stem: exchange p^n + b |m/0.1 g/s|^k (1 + side sgn m), less radiation, drawn to the stem.

    States: sheath, junction, stem.
    """

    family = "thermocouple_lag"
    form = "random"
    atol: ClassVar[tuple[float, ...]] = (1e-6,) * 3
    tau: float = 0.5  # s
    n: float = 0.0
    b: float = 0.0
    k: float = 0.5
    side: float = 0.0
    radiation: float = 0.0
    junction: float = 0.0  # s
    stem: float = 0.0
    tau_stem: float = 5.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 3

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow = now.net_mass_flow / 1e-4
        exchange = (1 + max(now.p_gauge, -9e4) / P_ATM) ** self.n
        if self.b:
            size = sqrt(flow * flow + 1e-6)
            exchange += self.b * size**self.k * (1 + self.side * flow / size)
        sheath = (
            exchange * (now.temperature - q[0])
            - self.radiation * (q[0] - T_ATM)
            - self.stem * (q[0] - q[2])
        )
        junction = (q[0] - q[1]) / self.junction if self.junction else 0.0
        return sheath / self.tau, junction, (now.temperature - q[2]) / self.tau_stem

    def reading(self, q: State, temperature: float) -> float:
        return q[1] if self.junction else q[0]


def _bead(rng: Chance) -> float:
    return order(rng, 0.1, 3)


BEADS: dict[str, Place] = {
    "pressure": lambda rng: OddThermocouple(_bead(rng), n=some(rng, -0.2, 0.8)),
    "flow": lambda rng: OddThermocouple(
        _bead(rng), b=order(rng, 0.3, 5), k=some(rng, 0.3, 0.9), side=some(rng, -0.9, 0.9)),
    "sheath": lambda rng: OddThermocouple(_bead(rng), junction=order(rng, 0.02, 0.3)),
    "stem": lambda rng: OddThermocouple(_bead(rng), stem=order(rng, 0.1, 1), tau_stem=order(rng, 1, 20)),
    "radiation and flow": lambda rng: OddThermocouple(
        _bead(rng), some(rng, 0, 0.5), order(rng, 0.3, 3), some(rng, 0.4, 0.8), radiation=order(rng, 0.02, 0.3)),
}  # fmt: skip


@dataclass(frozen=True)
class OddManometer(Effect):
    """The reading is offset + gain p + bend p^2 + bow p^3, powers of 100 kPa, less what a stop pin hides, and a knot.

    Below about p_pin the pin holds the pointer back, by hidden in the end; above p_knot a table adds knot to the slope.
    """

    family = "pressure_offset"
    form = "random"
    offset: float = 0.0  # Pa
    gain: float = 1.0
    bend: float = 0.0
    bow: float = 0.0
    hidden: float = 0.0  # Pa
    p_pin: float = 2e4  # Pa
    knot: float = 0.0
    p_knot: float = 1e5  # Pa

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        s = p_gauge / 1e5
        smooth = self.offset + 1e5 * s * (self.gain + s * (self.bend + self.bow * s))
        pin = self.hidden * (1 - exp(-max(p_gauge, -1e4) / self.p_pin))
        return smooth - pin + self.knot * max(p_gauge - self.p_knot, 0.0)


GAUGES: dict[str, Place] = {
    "zero and span": lambda rng: OddManometer(some(rng, -4e3, 4e3), some(rng, 0.93, 1.07)),
    "linearity": lambda rng: OddManometer(
        some(rng, -2e3, 2e3), some(rng, 0.96, 1.04), some(rng, -0.04, 0.04), some(rng, -0.01, 0.01)
    ),
    "stop pin": lambda rng: OddManometer(hidden=some(rng, 2e3, 1e4), p_pin=order(rng, 1e4, 4e4)),
    "knot of a table": lambda rng: OddManometer(
        knot=some(rng, -0.15, 0.15), p_knot=some(rng, 4e4, 2e5)
    ),
}
