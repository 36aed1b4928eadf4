"""Gas, wall, heat of friction and sensors by other laws than `heat`."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import asinh, sinh, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import P_ATM, T_ATM
from rig.seen.heat import EnergyGas

State = Sequence[float]


@dataclass(frozen=True)
class ConductiveGas(EnergyGas):
    """The film of still gas is as thick as the muscle: h D0/D (T/T_atm)^0.8. Second state: the contraction.

    Nu = h D/k is a constant without forced flow; air's conductivity grows about as T^0.8.
    Source: F. P. Incropera, D. P. DeWitt, Fundamentals of Heat and Mass Transfer, chapter 8 and table A.4.
    """

    form = "conductive"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, now.v

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        at_rest = self.fibre_squared - self.length**2
        narrower = sqrt(at_rest / (self.fibre_squared - (self.length - q[1]) ** 2))
        return self._through(self.h * narrower * (temperature / T_ATM) ** 0.8)


@dataclass(frozen=True)
class WoschniGas(EnergyGas):
    """The film of an engine's cylinder: h (p/p_atm)^0.8 (T/T_atm)^-0.53 (1 + |w|/w_0)^0.8, w the speed of the end.

    The second state is w: it follows the speed with 20 ms, as the gas that it stirs does.
    Source: G. Woschni, SAE paper 670931 (1967), without the factor of the bore.
    """

    form = "woschni"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-8)
    w_0: float = 0.03  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.v - q[1]) / 0.02

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        stirred = (1 + sqrt(q[1] ** 2 + 1e-8) / self.w_0) ** 0.8
        return self._through(self.h * (p / P_ATM) ** 0.8 * (temperature / T_ATM) ** -0.53 * stirred)


_LAYERS = 5


@dataclass(frozen=True)
class ThickWall(Effect):
    """Heat diffuses into a thick wall, here five equal layers: the longer, the deeper.

    Of the diffusion time tau (thickness squared over diffusivity, 10 s for 1 mm of rubber) and the capacity of all.
    Source: H. S. Carslaw, J. C. Jaeger, Conduction of Heat in Solids (1959), chapter 3, in finite volumes.
    """

    family = "wall_heat"
    form = "diffusion"
    atol: ClassVar[tuple[float, ...]] = (1e-6,) * _LAYERS
    capacity: float = 1.0  # J/K
    tau: float = 8.0  # s
    g_out: float = 0.02  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,) * _LAYERS

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        between = _LAYERS * self.capacity / self.tau
        inner = [between * (a - b) for a, b in zip(q[:-1], q[1:], strict=True)]
        passed = [-now.heat_to_gas, *inner, self.g_out * (q[-1] - T_ATM)]
        layer = self.capacity / _LAYERS
        return tuple((a - b) / layer for a, b in zip(passed[:-1], passed[1:], strict=True))

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class BladderHeat(Effect):
    """A share of what fibres lose by rubbing on the bladder heats the gas; the crossings cool outside.

    Only the bladder lies between the contact and the gas, while air reaches the fibres' crossings. Friction heats in
    both directions.
    """

    family = "friction_heat"
    form = "bladder"
    share: float = 1.0

    def friction_heat_of(self, fibre: float, bladder: float) -> float:
        return self.share * abs(bladder)


@dataclass(frozen=True)
class DenseAirThermocouple(Effect):
    """The lag is shorter in dense gas: tau (p_atm/p)^a, as the film on the wire goes with Re^a.

    Source: V. T. Morgan, The overall convective heat transfer from smooth circular cylinders, Adv. Heat Transf. 11
    (1975) 199, with exponents of about 0.3 to 0.6.
    """

    family = "thermocouple_lag"
    form = "dense_air"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s
    a: float = 0.5

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) * ((now.p_gauge + P_ATM) / P_ATM) ** self.a / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class StemThermocouple(Effect):
    """The stem conducts to the fitting at ambient: tau q' = T - q - c (q - T_atm), so a part of each change is lost.

    A fin with its root at ambient temperature. Source: R. J. Moffat, Gas temperature measurement, in Temperature: Its
    Measurement and Control in Science and Industry 3 (1962), on conduction error.
    """

    family = "thermocouple_lag"
    form = "stem"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s
    c: float = 0.1

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0] - self.c * (q[0] - T_ATM)) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return q[0]


@dataclass(frozen=True)
class StiffeningDiaphragm(Effect):
    """The transducer's diaphragm stiffens: it shows r where p = r + c r^3/p_0^2, so that high pressures read low.

    Source: S. Timoshenko, S. Woinowsky-Krieger, Theory of Plates and Shells (1959), chapter 13: load over deflection
    of a clamped plate has a linear and a cubic term.
    """

    family = "pressure_offset"
    form = "stiffening"
    c: float = 0.05
    p_0: float = 1.5e5  # Pa

    def pressure_reading(self, p_gauge: float) -> float:
        # the real root of the cubic, whose slope is above 0 everywhere
        scale = 2 * self.p_0 / sqrt(3 * self.c)
        return scale * sinh(asinh(3 * p_gauge / (scale)) / 3)
