"""Effects in the balances of mass and energy, and in the reading of the thermocouple."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi
from typing import ClassVar

from tests.reference.effects.base import Effect, Now, Rest
from tests.reference.flow import P_ATM, T_ATM, R, mass_flow
from tests.reference.schedule import Currents


@dataclass(frozen=True)
class OrificeLeak(Effect):
    """A hole to ambient, compressible flow through C_d pi d^2/4."""

    family = "leak"
    form = "orifice"
    diameter: float = 0.1e-3  # m
    c_d: float = 0.7

    def leak(self, p: float, temperature: float) -> float:
        area = self.c_d * pi / 4 * self.diameter**2
        return mass_flow(area, p, temperature, P_ATM, T_ATM)


@dataclass(frozen=True)
class LaminarLeak(Effect):
    """A laminar leak, mass flow = conductance times gauge pressure."""

    family = "leak"
    form = "laminar"
    conductance: float = 2.0e-11  # kg/(s Pa)

    def leak(self, p: float, temperature: float) -> float:
        return self.conductance * (p - P_ATM)


@dataclass(frozen=True)
class ValveLag(Effect):
    """Both currents act through a first-order lag."""

    family = "valve_dynamics"
    form = "lag"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.08  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return (now.command[0] - q[0]) / self.tau, (now.command[1] - q[1]) / self.tau

    def current(self, q: Sequence[float], command: Currents) -> Currents:
        return q[0], q[1]


@dataclass(frozen=True)
class ValveDeadTime(Effect):
    """Both currents act after a dead time."""

    family = "valve_dynamics"
    form = "dead_time"
    dead_time: float = 0.05  # s

    def delay(self) -> float:
        return self.dead_time


@dataclass(frozen=True)
class ValveSecondOrder(Effect):
    """Both currents act through a damped oscillator: u'' = omega^2 (command - u) - 2 zeta omega u'."""

    family = "valve_dynamics"
    form = "second_order"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-7, 1e-9, 1e-7)
    omega: float = 25.0  # rad/s
    zeta: float = 0.7

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0, 0.0, 0.0)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        square, damping = self.omega**2, 2 * self.zeta * self.omega
        return (
            q[1], square * (now.command[0] - q[0]) - damping * q[1],
            q[3], square * (now.command[1] - q[2]) - damping * q[3],
        )  # fmt: skip

    def current(self, q: Sequence[float], command: Currents) -> Currents:
        return q[0], q[2]


@dataclass(frozen=True)
class GasEnergy(Effect):
    """Gas temperature from mass and energy, T = p V/(m R), with heat exchange through the wall area."""

    family = "gas_energy"
    form = "film"
    energy_balance = True
    atol: ClassVar[tuple[float, ...]] = (1e-14,)
    h: float = 20.0  # W/(m2 K)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.gas_mass,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return (now.net_mass_flow,)

    def film(self, h: float) -> float:
        return self.h

    def temperature(self, q: Sequence[float], pressure_volume: float, polytropic: float) -> float:
        return pressure_volume / (q[0] * R)


@dataclass(frozen=True)
class ThermocoupleLag(Effect):
    """The temperature reading follows the gas through a first-order lag."""

    family = "thermocouple_lag"
    form = "first_order"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    tau: float = 0.15  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.temperature,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return ((now.temperature - q[0]) / self.tau,)

    def reading(self, q: Sequence[float], temperature: float) -> float:
        return q[0]
