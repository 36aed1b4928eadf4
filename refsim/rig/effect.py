"""What an effect may change in the simulated rig."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple, TypeVar, dataclass_transform

from rig.schedule import Currents, Schedule

State = Sequence[float]
"""An effect's own states."""


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
    areas: tuple[float, float] = (
        0.0,
        0.0,
    )  # m2, of both valves by their currents, before dynamics of the openings


@dataclass(frozen=True)
class Effect:
    """Nothing is missing. Subclasses override what their physics changes; `q` are their own states."""

    family: ClassVar[str] = "none"
    form: ClassVar[str] = "none"
    atol: ClassVar[tuple[float, ...]] = ()  # one absolute tolerance per own state
    stiff: ClassVar[bool] = False  # LSODA now and then misses that it must switch to stiff steps
    energy_balance: ClassVar[bool] = (
        False  # a vessel takes its pressure from the energy, not from p V^n
    )

    def initial(self, rest: Rest) -> tuple[float, ...]:
        """Own states at the start, as many as `atol` has."""
        return ()

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        """Time derivatives of the own states."""
        return ()

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        """Force [N] on the load; positive opposes contraction."""
        return 0.0

    def hanging_mass(self) -> float:
        """Mass [kg] that hangs on the muscle besides the load."""
        return 0.0

    def resting_mass(self) -> float:
        """Mass [kg] besides the load that the stop carries before the test."""
        return self.hanging_mass()

    def balanced_mass(self, x: float) -> float:
        """Inertia without weight [kg] that moves with the load."""
        return 0.0

    def shape_factor(self, x: float, p_gauge: float) -> float:
        """By what the contraction x [m] counts in the law of the muscle's force."""
        return 1.0

    def pull_factor(self, x: float, p_gauge: float) -> float:
        """Factor on the muscle's pull."""
        return 1.0

    def extra_volume(self) -> float:
        """Gas volume [m3] that does not take part in contraction."""
        return 0.0

    def valve_factor(self, p_up: float, p_down: float) -> float:
        """Factor on the area of a valve between these absolute pressures [Pa]."""
        return 1.0

    def friction_heat(self, fibre: float, bladder: float) -> float:
        """Heat [W] to the gas, from the powers [W] of fibre on fibre and of fibres on the bladder."""
        return 0.0

    def heat(self, q: State) -> float:
        """Further heat [W] to the gas."""
        return 0.0

    def wall_temperature(self, q: State, outside: float) -> float:
        """Temperature [K] that the gas exchanges heat with."""
        return outside

    def leak(self, p: float, temperature: float) -> float:
        """Gas lost to ambient [kg/s] at absolute pressure p [Pa]."""
        return 0.0

    def exchange(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        """Gas [kg/s] and its enthalpy [W] that leave the muscle for a side chamber whose states are q."""
        return 0.0, 0.0

    def enthalpy_beyond(self, p: float) -> float:
        """What gas at absolute pressure p [Pa] holds beyond c_p T [J/kg]."""
        return 0.0

    def drive(self, schedule: Schedule) -> Schedule:
        """The currents that reach the valves when these are commanded."""
        return schedule

    def current(self, q: State, command: Currents) -> Currents:
        """Currents [A] that set the valve areas."""
        return command

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        """Effective areas [m2] of inlet and exhaust valve from the calibrated ones."""
        return areas

    def opening(self, q: State, areas: tuple[float, float]) -> tuple[float, float]:
        """Effective areas [m2] at this moment, of the valves that will be open by `areas` in the end."""
        return areas

    def supply(self, q: State, p: float) -> float:
        """Absolute pressure [Pa] in front of the inlet valve."""
        return p

    def delay(self) -> float:
        """Time [s] by which the currents come late."""
        return 0.0

    def film(self, q: State, h: float, p: float, temperature: float) -> float:
        """Heat transfer coefficient [W/(m2 K)] between gas and surroundings, h without the effect.

        Effects on the wall are asked before those on the gas, whose laws know the flow at it.
        """
        return h

    def temperature(self, q: State, pressure_volume: float, polytropic: float) -> float:
        """Gas temperature [K] from p V [J] or from the polytropic law."""
        return polytropic

    def reading(self, q: State, temperature: float) -> float:
        """What the temperature sensor shows [K]."""
        return temperature

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        """What the pressure sensor shows [Pa gauge]."""
        return p_gauge

    def position_shown(self, q: State, x: float) -> float:
        """What the displacement sensor shows [m]."""
        return x

    def in_run(self, weight: float, frequency: float) -> Effect:
        """The effect in a run with this weight on the muscle [N] and this frequency of excitation [Hz]."""
        return self

    def in_truth(self, name: str, stated: float) -> float:
        """What a bench's parameter is in truth, where the description of the experiment states this value [SI]."""
        return stated


Kind = TypeVar("Kind", bound=type[Effect])


@dataclass_transform(frozen_default=True)
def law(kind: Kind) -> Kind:
    """Makes a frozen dataclass of a class of effects; its family is its module where none is stated."""
    if kind.family == Effect.family:
        kind.family = kind.__module__.rpartition(".")[2]
    return dataclass(frozen=True)(kind)  # type: ignore[return-value]


@dataclass(frozen=True)
class LineEffect(Effect):
    """A line between valves and muscle; `q` is the gas in it. The muscle then meets the valves through it alone."""

    def node(self, q: State) -> tuple[float, float]:
        """Absolute pressure [Pa] and temperature [K] at the valves."""
        raise NotImplementedError

    def into_muscle(self, q: State, p: float, temperature: float) -> tuple[float, float]:
        """Gas [kg/s] and enthalpy [W] that flow into the muscle at p [Pa] and temperature [K]."""
        raise NotImplementedError

    def line_rates(
        self, q: State, from_valves: tuple[float, float], p: float, temperature: float
    ) -> tuple[float, ...]:
        """Time derivatives of q, with gas [kg/s] and enthalpy [W] that come from the valves."""
        raise NotImplementedError
