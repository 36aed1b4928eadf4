"""What an effect may change in the simulated rig."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

from tests.reference.schedule import Currents


class Rest(NamedTuple):
    """The state before the test, from which an effect takes its own initial state."""

    x: float  # m
    gas_mass: float  # kg
    temperature: float  # K
    currents: Currents  # A


class Now(NamedTuple):
    """What is known of the rig when the rates of change of an effect's states are asked for."""

    x: float  # m
    v: float  # m/s
    p_gauge: float  # Pa
    temperature: float  # K
    command: Currents  # A, before valve dynamics
    net_mass_flow: float  # kg/s, into the gas volume
    heat_to_gas: float  # W, through the wall


@dataclass(frozen=True)
class Effect:
    """Nothing is missing. Subclasses override what their physics changes; `q` are their own states."""

    family: ClassVar[str] = "none"
    form: ClassVar[str] = "none"
    atol: ClassVar[tuple[float, ...]] = ()  # one absolute tolerance per own state
    stiff: ClassVar[bool] = False  # LSODA now and then misses that it must switch to stiff steps
    energy_balance: ClassVar[bool] = False  # a vessel takes its pressure from the energy, not from p V^n

    def initial(self, rest: Rest) -> tuple[float, ...]:
        """Own states at the start, as many as `atol` has."""
        return ()

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        """Time derivatives of the own states."""
        return ()

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        """Force [N] on the load; positive opposes contraction."""
        return 0.0

    def hanging_mass(self) -> float:
        """Mass [kg] that hangs on the muscle besides the load."""
        return 0.0

    def contraction_factor(self, p_gauge: float) -> float:
        """By what the contraction counts in the law of the muscle's force."""
        return 1.0

    def extra_volume(self) -> float:
        """Gas volume [m3] that does not take part in contraction."""
        return 0.0

    def valve_factor(self, p_up: float, p_down: float) -> float:
        """Factor on the area of a valve between these absolute pressures [Pa]."""
        return 1.0

    def friction_heat(self, power: float) -> float:
        """Share [W] of the power of friction that heats the gas."""
        return 0.0

    def wall_temperature(self, q: Sequence[float], outside: float) -> float:
        """Temperature [K] that the gas exchanges heat with."""
        return outside

    def leak(self, p: float, temperature: float) -> float:
        """Gas lost to ambient [kg/s] at absolute pressure p [Pa]."""
        return 0.0

    def current(self, q: Sequence[float], command: Currents) -> Currents:
        """Currents [A] that set the valve areas."""
        return command

    def delay(self) -> float:
        """Time [s] by which the currents come late."""
        return 0.0

    def film(self, h: float) -> float:
        """Heat transfer coefficient [W/(m2 K)] between gas and surroundings."""
        return h

    def temperature(self, q: Sequence[float], pressure_volume: float, polytropic: float) -> float:
        """Gas temperature [K] from p V [J] or from the polytropic law."""
        return polytropic

    def reading(self, q: Sequence[float], temperature: float) -> float:
        """What the temperature sensor shows [K]."""
        return temperature

    def pressure_reading(self, p_gauge: float) -> float:
        """What the pressure sensor shows [Pa gauge]."""
        return p_gauge
