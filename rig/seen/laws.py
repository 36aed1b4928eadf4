"""Laws of the independent rig that no class of the catalogue states: what a flexible member is held against."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, exp, sinh, sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import GAMMA, P_ATM, T_ATM, G, R
from rig.schedule import Currents

State = Sequence[float]


@dataclass(frozen=True)
class Lever(Effect):
    """A mass on a lever of the ratio 1 + x/x_0: inertia m (1 + x/x_0)^2, weight in proportion to the ratio."""

    m: float = 3.0  # kg
    x_0: float = 0.08  # m
    share: float = 0.3  # of the weight, the rest is balanced

    def balanced_mass(self, x: float) -> float:
        return self.m * self._ratio(x) ** 2

    def resting_mass(self) -> float:
        return self.share * self.m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        inertial = self.m * self._ratio(x) / self.x_0 * v * v if x > 0 else 0.0
        return inertial + self.share * self.m * G * self._ratio(x)

    def _ratio(self, x: float) -> float:
        return 1 + max(x, 0.0) / self.x_0


@dataclass(frozen=True)
class Spiral(Effect):
    """A balanced wheel on a drum whose radius shrinks: inertia m (1 + x/x_0), without weight."""

    m: float = 3.0  # kg
    x_0: float = 0.04  # m

    def balanced_mass(self, x: float) -> float:
        return self.m * (1 + max(x, 0.0) / self.x_0)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m / self.x_0 * v * v / 2 if x > 0 else 0.0


@dataclass(frozen=True)
class Arm(Effect):
    """A weight on an arm that turns by x/r: constant inertia, weight by the cosine of its angle."""

    m: float = 2.0  # kg
    r: float = 0.1  # m
    angle: float = -0.2  # rad, at the start

    def balanced_mass(self, x: float) -> float:
        return self.m

    def resting_mass(self) -> float:
        return 0.5 * self.m * cos(self.angle)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return 0.5 * self.m * G * cos(self.angle + max(x, 0.0) / self.r)


@dataclass(frozen=True)
class LimitedRate(Effect):
    """The currents that act follow at a limited rate, up or down: rate tanh(gap/u_0), slower or faster down."""

    atol: ClassVar[tuple[float, ...]] = (1e-8, 1e-8)
    rate: float = 3.0  # A/s
    u_0: float = 0.01  # A
    down: float = 1.0  # rate down by that up

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return 0.0, 0.0

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        a, b = (self._toward(u - y) for u, y in zip(now.command, q, strict=True))
        return a, b

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]

    def _toward(self, gap: float) -> float:
        return self.rate * (1.0 if gap > 0 else self.down) * tanh(gap / self.u_0)


@dataclass(frozen=True)
class Bead(Effect):
    """A thermocouple's bead: exchange p^n (1 + (|m|/m_0)^k), less radiation to surroundings that stay cold."""

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.5  # s
    n: float = 0.3
    m_0: float = 5e-5  # kg/s
    k: float = 0.6
    radiation: float = 0.08
    both_ways: bool = True  # whether venting counts as a flow

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow = abs(now.net_mass_flow) if self.both_ways else max(now.net_mass_flow, 0.0)
        exchange = (1 + now.p_gauge / P_ATM) ** self.n * (1 + (flow / self.m_0) ** self.k)
        return ((exchange * (now.temperature - q[0]) - self.radiation * (q[0] - T_ATM)) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class Shares(Effect):
    """A share of the reading follows the gas with one time constant, the rest with another."""

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.2  # s
    slow: float = 2.0  # s
    share: float = 0.6  # of the quick part

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return rest.temperature, rest.temperature

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.temperature - q[0]) / self.tau, (now.temperature - q[1]) / self.slow

    def reading(self, q: State, temperature: float) -> float:
        return self.share * q[0] + (1 - self.share) * q[1]


@dataclass(frozen=True)
class FilmGas(Effect):
    """Mass and energy balance; the film is h (p/p_atm)^a + h_1 (|m_jet|/0.1 g/s)^k, the jet dies away in tau.

    With a second virial coefficient b [m3/kg] the temperature is that of p V = m (R T + b p).
    """

    energy_balance: ClassVar[bool] = True
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h: float = 15.0  # W/(m2 K)
    a: float = 0.5
    h_1: float = 30.0  # W/(m2 K)
    k: float = 0.8
    tau: float = 0.05  # s
    b: float = 0.0
    wall: float = 1.8e-3  # m2 K/W, t/k

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return rest.gas_mass / (1 + self.b * P_ATM / (R * T_ATM)), 0.0

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.net_mass_flow - q[1]) / self.tau

    def temperature(self, q: State, pressure_volume: float, polytropic: float) -> float:
        p = P_ATM * (polytropic / T_ATM) ** 6  # the rig's polytropic law backwards, its exponent is 1.2
        return (pressure_volume / q[0] - self.b * p) / R

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        film = self.h * (p / P_ATM) ** self.a + self.h_1 * ((q[1] ** 2 + 1e-16) / 1e-8) ** (self.k / 2)
        return float(1 / (2 / film + self.wall))


@dataclass(frozen=True)
class LayeredWall(Effect):
    """A wall in two layers; the outer one loses its heat by g dT (|dT|/5 K)^n."""

    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.2  # J/K
    ratio: float = 3.0
    between: float = 0.1  # W/K
    g: float = 0.03  # W/K
    n: float = 0.25

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return T_ATM, T_ATM

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        passed, warm = self.between * (q[0] - q[1]), q[1] - T_ATM
        lost = self.g * warm * ((warm * warm + 1e-4) / 25) ** (self.n / 2)
        return (-now.heat_to_gas - passed) / self.capacity, (passed - lost) / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class RisingHeat(Effect):
    """Friction heats the gas while the muscle contracts; extension cools itself from outside."""

    def friction_heat_of(self, fibre: float, bladder: float) -> float:
        return fibre + bladder if bladder > 0 else 0.0


@dataclass(frozen=True)
class DissipatedHeat(Effect):
    """All friction heats the gas, that on the bladder in extension too."""

    def friction_heat_of(self, fibre: float, bladder: float) -> float:
        return fibre + sqrt(bladder * bladder)


@dataclass(frozen=True)
class LateHeat(Effect):
    """The work of fibre on fibre warms the fibres first and reaches the gas through a lag."""

    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.3  # s
    drag: float = 2.4e-3  # m2 s/m, force of fibre on fibre by pressure and speed

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self.drag * max(now.p_gauge, 0.0) * now.v**2 - q[0]) / self.tau,)

    def heat(self, q: State) -> float:
        return q[0]


@dataclass(frozen=True)
class GrowingDamper(Effect):
    """Friction c v (1 + x/x_0), in extension a share of it."""

    c: float = 120.0  # N s/m
    x_0: float = 0.02  # m
    back: float = 1.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1 + max(x, 0.0) / self.x_0) * (1.0 if v > 0 else self.back)


@dataclass(frozen=True)
class ThinningCreep(Effect):
    """A Maxwell element with Eyring's dashpot: q' = (x_0/tau) sinh((x - q)/x_0)."""

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 2.0  # s
    x_0: float = 0.015  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self.x_0 / self.tau * sinh((now.x - q[0]) / self.x_0),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@dataclass(frozen=True)
class FallingFriction(Effect):
    """A Dahl bristle whose force is larger in slow motion, by the share a exp(-(v/v_s)^2)."""

    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    f_c: float = 8.0  # N
    travel: float = 3e-4  # m
    a: float = 0.4
    v_s: float = 0.015  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.v - abs(now.v) * q[0]) / self.travel,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * q[0] * (1 + self.a * exp(-((v / self.v_s) ** 2)))


@dataclass(frozen=True)
class Chamber(Effect):
    """A rigid side volume behind an opening; its gas gives ua (T - T_atm) to its wall (states: mass, energy)."""

    atol: ClassVar[tuple[float, ...]] = (1e-12, 1e-7)
    volume: float = 3e-5  # m3
    conductance: float = 3e-9  # kg/(s Pa)
    ua: float = 0.0  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return P_ATM * self.volume / (R * T_ATM), P_ATM * self.volume / (GAMMA - 1)

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        inside, t = self._inside(q)
        flow = self.conductance * (p - inside)
        return flow, GAMMA * R / (GAMMA - 1) * flow * (temperature if flow > 0 else t)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        flow, enthalpy = self.exchange(q, now.p_gauge + P_ATM, now.temperature)
        return flow, enthalpy - self.ua * (self._inside(q)[1] - T_ATM)

    def _inside(self, q: State) -> tuple[float, float]:
        return (GAMMA - 1) * q[1] / self.volume, (GAMMA - 1) * q[1] / (R * q[0])
