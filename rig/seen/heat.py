"""Energy balance of gas and wall, and sensors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import P_ATM, T_ATM, R

State = Sequence[float]


@dataclass(frozen=True)
class EnergyGas(Effect):
    """Gas temperature from mass and energy; state: mass. Films inside and outside the wall grow alike."""

    family = "gas_energy"
    energy_balance = True
    atol: ClassVar[tuple[float, ...]] = (1e-14,)
    h: float = 20.0  # W/(m2 K)
    wall: float = 1.8e-3  # m2 K/W, t/k

    def _through(self, film: float) -> float:
        return 1 / (2 / film + self.wall)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.net_mass_flow,)

    def temperature(self, q: State, pressure_volume: float, polytropic: float) -> float:
        return pressure_volume / (q[0] * R)


@dataclass(frozen=True)
class StirredGas(EnergyGas):
    """The film grows with the flow: h + h_1 (|m_jet|/0.1 g/s)^0.8, where the jet dies away in tau."""

    form = "stirred"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-10)
    h_1: float = 30.0  # W/(m2 K)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.net_mass_flow - q[1]) / self.tau

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h + self.h_1 * ((q[1] ** 2 + 1e-14) / 1e-8) ** 0.4)


@dataclass(frozen=True)
class FreeConvectionGas(EnergyGas):
    """The film grows with the temperature difference: h (0.5 + 0.5 (|T - T_atm|/10 K)^(1/3))."""

    form = "free_convection"

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h * (0.5 + 0.5 * (((temperature - T_ATM) ** 2 + 0.01) / 100) ** (1 / 6)))


@dataclass(frozen=True)
class DenseGas(EnergyGas):
    """The film grows with the density: h (p/p_atm)^a."""

    form = "dense"
    a: float = 0.6

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h * (p / P_ATM) ** self.a)


@dataclass(frozen=True)
class StorageWall(Effect):
    """Heat is stored in the middle of the wall, between a film inside (h_film) and one outside (r h_film)."""

    family = "wall_heat"
    form = "storage"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 1.0  # J/K
    r: float = 1.0
    h_film: float = 20.0  # W/(m2 K)
    half_wall: float = 9e-4  # m2 K/W, t/(2 k)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    fibre_area: float = 0.0133  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def film(self, h: float) -> float:
        return 1 / (1 / self.h_film + self.half_wall)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length = self.length - now.x
        girth = sqrt(self.fibre_squared - length * length) / self.turns
        outside = max(0.0, girth * length - self.fibre_area) / (1 / (self.r * self.h_film) + self.half_wall)
        return ((-now.heat_to_gas - outside * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class TwoLayerWall(Effect):
    """A wall in two layers, the outer one of `ratio` times the capacity, with a conductance between them."""

    family = "wall_heat"
    form = "two_layers"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.5  # J/K
    ratio: float = 2.0
    between: float = 0.1  # W/K
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        passed = self.between * (q[0] - q[1])
        outward = passed - self.g_out * (q[1] - T_ATM)
        return (-now.heat_to_gas - passed) / self.capacity, outward / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class FreeConvectionWall(Effect):
    """A warm wall that air cools by free convection: loss g_out dT (|dT|/5 K)^0.25."""

    family = "wall_heat"
    form = "free_convection"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.5  # J/K
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        warm = q[0] - T_ATM
        loss = self.g_out * warm * ((warm * warm + 1e-4) / 25) ** 0.125
        return ((-now.heat_to_gas - loss) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class FibreHeat(Effect):
    """A share of the power of fibre on fibre heats the gas."""

    family = "friction_heat"
    form = "fibre"
    share: float = 1.0

    def friction_heat_of(self, fibre: float, bladder: float) -> float:
        return self.share * fibre


@dataclass(frozen=True)
class RisingHeat(Effect):
    """A share of the power heats the gas while the muscle contracts; extension cools itself from outside."""

    family = "friction_heat"
    form = "contraction"
    share: float = 1.0

    def friction_heat_of(self, fibre: float, bladder: float) -> float:
        return self.share * (fibre + bladder) if bladder > 0 else 0.0


@dataclass(frozen=True)
class LateHeat(Effect):
    """The power of friction warms the fibres first and reaches the gas through a lag."""

    family = "friction_heat"
    form = "late"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    share: float = 1.0
    tau: float = 0.3  # s
    crossing: float = 2.4e-3  # m2, A_ff mu_d K_f ...: force of fibre on fibre per pressure and speed

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self.share * self.crossing * max(now.p_gauge, 0.0) * now.v**2 - q[0]) / self.tau,)

    def heat(self, q: State) -> float:
        return q[0]


@dataclass(frozen=True)
class Sheath(Effect):
    """The thermometer: a sheath with tau, a junction in it with r tau."""

    family = "thermocouple_lag"
    form = "sheath"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.15  # s
    r: float = 0.3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.temperature - q[0]) / self.tau, (q[0] - q[1]) / (self.r * self.tau)

    def reading(self, q: State, temperature: float) -> float:
        return q[1]


@dataclass(frozen=True)
class BlownThermocouple(Effect):
    """The lag is shorter while gas flows: tau/(1 + (|m|/m_0)^(1/2))."""

    family = "thermocouple_lag"
    form = "blown"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.3  # s
    m_0: float = 3e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        quick = 1 + (abs(now.net_mass_flow) / self.m_0) ** 0.5
        return ((now.temperature - q[0]) * quick / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class TwoPartThermocouple(Effect):
    """A part of the reading follows with tau, the other with 6 tau."""

    family = "thermocouple_lag"
    form = "two_parts"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    tau: float = 0.1  # s
    share: float = 0.6  # of the quick part

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,) * 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.temperature - q[0]) / self.tau, (now.temperature - q[1]) / (6 * self.tau)

    def reading(self, q: State, temperature: float) -> float:
        return self.share * q[0] + (1 - self.share) * q[1]


@dataclass(frozen=True)
class OffsetAndGain(Effect):
    """The pressure reading has an offset and a gain, so that it is right at p_0."""

    family = "pressure_offset"
    form = "offset_and_gain"
    gain: float = 1.05
    p_0: float = 8e4  # Pa

    def pressure_reading(self, p_gauge: float) -> float:
        return p_gauge + (self.gain - 1) * (p_gauge - self.p_0)


@dataclass(frozen=True)
class CurvedPressure(Effect):
    """The pressure reading has an offset and sags in the middle: offset (1 + c (p/p_0)^2)."""

    family = "pressure_offset"
    form = "curved"
    offset: float = 3e3  # Pa
    c: float = 1.0
    p_0: float = 2e5  # Pa

    def pressure_reading(self, p_gauge: float) -> float:
        return p_gauge + self.offset * (1 + self.c * (p_gauge / self.p_0) ** 2)


@dataclass(frozen=True)
class SaturatingPressure(Effect):
    """The pressure reading is off by an offset that fades as the pressure rises: offset exp(-p/p_0)."""

    family = "pressure_offset"
    form = "fading"
    offset: float = 5e3  # Pa
    p_0: float = 2e5  # Pa

    def pressure_reading(self, p_gauge: float) -> float:
        return p_gauge + self.offset * exp(-p_gauge / self.p_0)
