"""Gas that is stirred or lags at the wall, walls that their surroundings cool, and contacts that share their heat."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import T_ATM
from rig.seen.heat import EnergyGas

State = Sequence[float]


@dataclass(frozen=True)
class DecayingTurbulence(EnergyGas):
    """Flow in or out makes turbulence, which decays by itself: u' = b |m_net| - u^2/l; film h + h_1 (u/1 m/s)^0.8.

    Second state: u. Left alone, it falls as l/t. Source: H. Tennekes, J. L. Lumley, A First Course in Turbulence
    (1972), section 3.2, on the decay; the exponent is that of turbulent flow over walls.
    """

    form = "turbulence"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-7)
    h_1: float = 15.0  # W/(m2 K)
    eddy: float = 0.02  # m, l
    b: float = 2e6  # m/(s kg)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, self.b * abs(now.net_mass_flow) - q[1] * abs(q[1]) / self.eddy

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h + self.h_1 * (q[1] ** 2 + 1e-8) ** 0.4)


@dataclass(frozen=True)
class GasSpring(EnergyGas):
    """Heat leads the temperature: K (T_w - T) + c K (T_b - T), where gas near the wall follows, T_b' = (T - T_b)/tau.

    Second state: T_b. Compressed gas gives off more heat than its mean temperature says while that still rises.
    Source: A. A. Kornhauser, J. L. Smith, The effects of heat transfer on gas spring performance, J. Energy Resour.
    Technol. 115 (1993) 70, whose complex Nusselt number is this for one time constant.
    """

    form = "gas_spring"
    atol: ClassVar[tuple[float, ...]] = (1e-14, 1e-6)
    c: float = 1.0
    tau: float = 0.3  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass, rest.temperature)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return now.net_mass_flow, (now.temperature - q[1]) / self.tau

    def film_now(self, q: State, h: float, p: float, temperature: float) -> float:
        return self._through(self.h) * (1 + self.c)

    def wall_temperature(self, q: State, outside: float) -> float:
        return (outside + self.c * q[1]) / (1 + self.c)


@dataclass(frozen=True)
class FannedWall(Effect):
    """A warm wall that cools itself by moving through the air: loss g_out dT (1 + (|v|/v_0)^(1/2)).

    Source: L. V. King, On the convection of heat from small cylinders, Phil. Trans. R. Soc. A 214 (1914) 373.
    """

    family = "wall_heat"
    form = "fanned"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    capacity: float = 0.4  # J/K
    g_out: float = 0.02  # W/K, at rest
    v_0: float = 0.02  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        fanned = 1 + ((now.v * now.v + 1e-10) ** 0.5 / self.v_0) ** 0.5
        return ((-now.heat_to_gas - self.g_out * fanned * (q[0] - T_ATM)) / self.capacity,)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class MetalEnds(Effect):
    """A bladder that loses heat to the air and to the metal fittings, which keep it: conductances g_out and g_end.

    States: temperatures of bladder and fittings. Source: heat balance of two lumps.
    """

    family = "wall_heat"
    form = "metal_ends"
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-6)
    capacity: float = 0.4  # J/K, of the bladder
    ratio: float = 8.0  # capacity of the fittings by that of the bladder
    g_out: float = 0.02  # W/K
    g_end: float = 0.04  # W/K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (T_ATM, T_ATM)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        passed = self.g_end * (q[0] - q[1])
        kept = -now.heat_to_gas - self.g_out * (q[0] - T_ATM) - passed
        return kept / self.capacity, passed / (self.ratio * self.capacity)

    def wall_temperature(self, q: State, outside: float) -> float:
        return q[0]


@dataclass(frozen=True)
class MovingContact(Effect):
    """The faster a contact moves, the less of its heat goes to the bladder: power times share/(1 + (|v|/v_0)^(1/2)).

    State: the heat behind the lag of 20 ms that it takes through a film of rubber; friction heats in both directions.
    Source: J. C. Jaeger, Moving sources of heat and the temperature at sliding contacts, Proc. R. Soc. NSW 76 (1942)
    203: the partition goes with the root of the Peclet number.
    """

    family = "friction_heat"
    form = "moving_contact"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    share: float = 1.0
    v_0: float = 0.05  # m/s
    crossing: float = 2.4e-3  # m s, force of fibre on fibre per pressure and speed
    covered: float = 2e-4  # m2, force of fibres on the bladder per pressure
    tau: float = 0.02  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        rubbed = max(now.p_gauge, 0.0) * (self.crossing * now.v**2 + self.covered * abs(now.v))
        return ((self.share * rubbed / (1 + sqrt(abs(now.v) / self.v_0)) - q[0]) / self.tau,)

    def heat(self, q: State) -> float:
        return q[0]
