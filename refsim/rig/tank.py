"""Vessels of constant volume: the tank with valves (63)-(66) and a vessel with an orifice.

The polytropic law is kept as p = p_ref (m/m_ref)^n with the gas mass m as the state; that is (66) integrated
once. Energy is carried along for effects that take the pressure from it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi, pow

import numpy as np

from rig.effect import Effect, LineEffect, Now, Rest
from rig.flow import CP, GAMMA, P_ATM, T_ATM, R, mass_flow, valve_area
from rig.integrate import Array, integrate
from rig.schedule import Currents, Schedule

OF_A_MUSCLE = (
    "elasticity", "dry_friction", "rate_friction", "creep", "end_shape", "moving_mass", "dead_volume", "friction_heat",
    "wall_heat", "position_sensor", "force_sensor",
)  # fmt: skip
"""Families of effects that a vessel cannot have."""

Ports = Callable[[float, float, Currents], Iterable[tuple[float, float]]]
"""Absolute pressure [Pa], temperature [K], currents [A] -> flows into the vessel [kg/s], outer temperatures."""


@dataclass(frozen=True)
class Vessel:
    """A volume of gas with p V^n constant per mass, through the point (p_ref, t_ref)."""

    volume: float = 2.1e-3  # m3
    n: float = 1.2
    p_ref: float = P_ATM  # Pa absolute
    t_ref: float = T_ATM  # K
    h: float = 0.0  # W/(m2 K), used by effects with an energy balance

    @cached_property
    def mass_ref(self) -> float:
        """Gas mass [kg] at the reference point."""
        return self.p_ref * self.volume / (R * self.t_ref)

    @cached_property
    def wall_area(self) -> float:
        """Inner surface [m2] of a cylinder as high as wide."""
        return 1.5 * pi * pow(4 * self.volume / pi, 2 / 3)

    def pressure(self, mass: float) -> float:
        """Absolute pressure [Pa] with this gas mass [kg]."""
        return self.p_ref * pow(mass / self.mass_ref, self.n)

    def temperature(self, p: float) -> float:
        """Temperature [K] at absolute pressure p [Pa] (60)."""
        return self.t_ref * pow(p / self.p_ref, (self.n - 1) / self.n)

    def mass(self, p: float) -> float:
        """Gas mass [kg] at absolute pressure p [Pa]."""
        return self.mass_ref * pow(p / self.p_ref, 1 / self.n)


@dataclass(frozen=True)
class VesselTrajectory:
    """What ideal instruments read; arrays of one shape (times,)."""

    time: Array  # s
    p: Array  # Pa gauge
    temperature: Array  # K


def valve_ports(p_supply: float, calibration: float, effects: Sequence[Effect] = ()) -> Ports:
    """Valves from a supply at p_supply [Pa gauge] and to ambient, with what effects do to their areas."""
    source = p_supply + P_ATM

    def flows(p: float, temperature: float, currents: Currents) -> Iterable[tuple[float, float]]:
        areas = (valve_area(currents[0], calibration), valve_area(currents[1], calibration))
        for effect in effects:
            areas = effect.areas(areas, currents)
        area_in, area_out = areas
        for effect in effects:
            area_in *= effect.valve_factor(max(p, source), min(p, source))
            area_out *= effect.valve_factor(max(p, P_ATM), min(p, P_ATM))
        yield mass_flow(area_in, source, T_ATM, p, temperature), T_ATM
        yield mass_flow(area_out, P_ATM, T_ATM, p, temperature), T_ATM

    return flows


def orifice_port(diameter: float, c_d: float, p_outside: float) -> Ports:
    """An orifice [m] to surroundings at p_outside [Pa gauge] and T_atm."""
    area = c_d * pi / 4 * diameter**2

    def flows(p: float, temperature: float, currents: Currents) -> Iterable[tuple[float, float]]:
        yield mass_flow(area, p_outside + P_ATM, T_ATM, p, temperature), T_ATM

    return flows


def simulate_vessel(
    vessel: Vessel,
    ports: Ports,
    times: Array,
    p_start: float = 0.0,
    schedule: Schedule | None = None,
    effects: Sequence[Effect] = (),
    rtol: float = 1e-9,
) -> VesselTrajectory:
    """Pressure and temperature from p_start [Pa gauge], at the vessel's polytropic temperature there.

    times: increasing, shape (n,) [s]. Raises ValueError for an effect that is among OF_A_MUSCLE, RuntimeError when
    integration fails. Effects on the areas of valves have to be among those of `ports` as well.
    """
    for effect in effects:
        if effect.family in OF_A_MUSCLE:
            raise ValueError(f"a vessel cannot have an effect of the family {effect.family}")
    schedule = schedule or Schedule((), ())
    late = schedule.delayed(sum(effect.delay() for effect in effects))
    for effect in effects:
        late = effect.drive(late)
    line = next((k for k, effect in enumerate(effects) if isinstance(effect, LineEffect)), None)
    slices, at = [], 2
    for effect in effects:
        slices.append(slice(at, at + len(effect.atol)))
        at += len(effect.atol)
    with_energy = any(effect.energy_balance for effect in effects)
    at_the_wall = sorted(zip(effects, slices, strict=True), key=lambda pair: pair[0].energy_balance)

    def gas(y: Sequence[float]) -> tuple[float, float]:
        p = (GAMMA - 1) * y[1] / vessel.volume if with_energy else vessel.pressure(y[0])
        temperature = vessel.temperature(p)
        for effect, own in zip(effects, slices, strict=True):
            temperature = effect.temperature(y[own], p * vessel.volume, temperature)
        return p, temperature

    def through(p: float, temperature: float, currents: Currents) -> tuple[float, float]:
        """Gas [kg/s] and enthalpy [W] through the ports into gas at p [Pa]."""
        mass, enthalpy = 0.0, 0.0
        for flow, outer in ports(p, temperature, currents):
            mass += flow
            enthalpy += flow * (outer if flow > 0 else temperature)
        return mass, CP * enthalpy

    def inflow(
        y: Sequence[float], p: float, temperature: float, currents: Currents
    ) -> tuple[tuple[float, float], tuple[float, ...]]:
        """Gas and enthalpy into the vessel, and the rates of the line if there is one."""
        if line is None:
            return through(p, temperature, currents), ()
        tube, q = effects[line], y[slices[line]]
        assert isinstance(tube, LineEffect)
        arriving = through(*tube.node(q), currents)
        return tube.into_muscle(q, p, temperature), tube.line_rates(q, arriving, p, temperature)

    def rates(y: Sequence[float], command: Currents) -> list[float]:
        p, temperature = gas(y)
        currents, net, enthalpy = command, 0.0, 0.0
        for effect, own in zip(effects, slices, strict=True):
            currents = effect.current(y[own], currents)
            net -= effect.leak(p, temperature)
        enthalpy = CP * net * (temperature if net < 0 else T_ATM)
        entering, line_rates = inflow(y, p, temperature, currents)
        net, enthalpy = net + entering[0], enthalpy + entering[1]
        film = vessel.h
        for effect, own in at_the_wall:
            film = effect.film(y[own], film, p, temperature)
        heat = film * vessel.wall_area * (T_ATM - temperature)
        now = Now(0.0, 0.0, p - P_ATM, temperature, command, net, heat)
        result = [net, enthalpy + heat]
        for k, (effect, own) in enumerate(zip(effects, slices, strict=True)):
            result.extend(line_rates if k == line else effect.rates(y[own], now))
        return result

    def reading(y: Sequence[float]) -> tuple[float, float]:
        p, temperature = gas(y)
        gauge = p - P_ATM
        for effect, own in zip(effects, slices, strict=True):
            temperature = effect.reading(y[own], temperature)
            gauge = effect.pressure_shown(y[own], gauge)
        return gauge, temperature

    p_absolute = p_start + P_ATM
    rest = Rest(0.0, vessel.mass(p_absolute), vessel.temperature(p_absolute), (0.0, 0.0))
    start = [rest.gas_mass, p_absolute * vessel.volume / (GAMMA - 1)]
    start += [value for effect in effects for value in effect.initial(rest)]
    atol = (
        1e-6 * rest.gas_mass * rtol,
        1e-6 * start[1] * rtol,
        *(a for e in effects for a in e.atol),
    )
    states = integrate(rates, start, late, times, atol, rtol)
    readings = np.array([reading(column) for column in states.T.tolist()])
    return VesselTrajectory(times, readings[:, 0], readings[:, 1])
