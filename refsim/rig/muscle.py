"""The isotonic Doumit-Pardoel chain: valves, gas, braid, load.

States are internal energy U = p V/(gamma - 1) [J], contraction x [m], speed v [m/s], then those of the
effects. With U the energy balance (43) needs neither p_dot nor V_dot.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import pi, sqrt, tanh

import numpy as np

from rig.effect import Effect, LineEffect, Now, Rest
from rig.flow import GAMMA, P_ATM, T_ATM, G, R, mass_flow, valve_area
from rig.integrate import Array, integrate
from rig.schedule import Currents, Schedule


@dataclass(frozen=True)
class MuscleParameters:
    """Doumit and Pardoel (2017), table 1 (latex); what they leave open as in the base model's description."""

    calibration: float = 0.699  # C_A, both valves
    length: float = 0.24  # L0, m
    diameter: float = 0.02  # D0, m
    turns: float = 2.0  # n
    fibres: float = 216.0  # N
    fibre_width: float = 0.254e-3  # w, m
    crossing_length: float = 0.254e-3  # z, m
    mu_fb: float = 0.015
    mu_d: float = 0.8
    k_f: float = 1.0  # s/m
    k_wall: float = 0.14  # W/(m K)
    t_wall: float = 0.254e-3  # m
    h_film: float = 20.0  # W/(m2 K), inside and outside
    n_g: float = 1.2
    load: float = 2.27  # kg
    stop_stiffness: float = 2e5  # N/m
    stop_damping: float = 500.0  # N s/m

    @cached_property
    def fibre_squared(self) -> float:
        """b^2 [m2], the geometry closed at rest."""
        return self.length**2 + (self.turns * pi * self.diameter) ** 2

    @cached_property
    def crossings(self) -> float:
        """q (47)."""
        return 2 * self.turns * (self.fibres / 2) ** 2 - self.fibres / 2

    @cached_property
    def fibre_area(self) -> float:
        """Area [m2] of the bladder that the fibres cover (48)."""
        free_length = (
            sqrt(self.fibre_squared) * self.fibres - self.crossing_length * self.crossings / 2
        )
        return self.fibre_width * free_length

    @cached_property
    def crossing_area(self) -> float:
        """A_ff [m2], all crossings together (72)."""
        return self.crossings * self.fibre_width * self.crossing_length

    @cached_property
    def heat_coefficient(self) -> float:
        """h_c [W/(m2 K)] of film, wall and film in series."""
        return 1 / (2 / self.h_film + self.t_wall / self.k_wall)

    def volume(self, x: float) -> float:
        """Gas volume [m3] of the cylinder at contraction x [m]."""
        length = self.length - x
        return length * (self.fibre_squared - length * length) / (4 * pi * self.turns**2)

    def volume_slope(self, x: float) -> float:
        """dV/dx [m2]; gauge pressure times this is the muscle force (virtual work)."""
        length = self.length - x
        return (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)

    def bare_area(self, x: float) -> float:
        """A_q [m2], bladder area that the fibres leave bare (46)."""
        length = self.length - x
        girth = sqrt(self.fibre_squared - length * length) / self.turns
        return max(0.0, girth * length - self.fibre_area)


@dataclass(frozen=True)
class Trajectory:
    """What ideal instruments read, and the speed; arrays of one shape (times,)."""

    time: Array  # s
    p: Array  # Pa gauge
    x: Array  # m
    temperature: Array  # K
    v: Array  # m/s


ATOL = (1e-8, 1e-10, 1e-9)
"""Of internal energy [J] and the two states of motion."""

_CP = GAMMA * R / (GAMMA - 1)  # J/(kg K)


class Chain:
    """Valves, gas, braid and load: the right-hand side for one run of one muscle.

    What moves the load end is `motion` and `moved`; benches that hold it otherwise override those.
    """

    def __init__(
        self, parameters: MuscleParameters, p_supply: float, effects: Sequence[Effect]
    ) -> None:
        self.par, self.effects = parameters, tuple(effects)
        self.p_source = p_supply + P_ATM
        self.slices, at = [], 3
        for effect in self.effects:
            self.slices.append(slice(at, at + len(effect.atol)))
            at += len(effect.atol)
        states = zip(self.effects, self.slices, strict=True)
        self.at_the_wall = sorted(states, key=lambda pair: pair[0].energy_balance)
        self.dead_volume = sum(effect.extra_volume() for effect in self.effects)
        self.mass = parameters.load + sum(effect.hanging_mass() for effect in self.effects)
        self.resting_mass = parameters.load + sum(effect.resting_mass() for effect in self.effects)
        self.line = next(
            (k for k, effect in enumerate(self.effects) if isinstance(effect, LineEffect)), None
        )

    def start(self) -> list[float]:
        """At rest on the stop, filled with ambient air."""
        return self.start_at(-self.resting_mass * G / self.par.stop_stiffness)

    def start_at(self, x: float) -> list[float]:
        """At rest at a contraction [m], filled with ambient air."""
        pv = P_ATM * (self.par.volume(x) + self.dead_volume)
        rest = Rest(x, pv / (R * T_ATM), T_ATM, (0.0, 0.0))
        return [
            pv / (GAMMA - 1),
            *self.at_rest(x),
            *(value for e in self.effects for value in e.initial(rest)),
        ]

    def gas(self, y: Sequence[float]) -> tuple[float, float]:
        """Absolute pressure [Pa] and temperature [K]."""
        pv = max(
            (GAMMA - 1) * y[0], 1e-6
        )  # a step that an integrator tries and rejects may go below nothing
        p = pv / (self.par.volume(y[1]) + self.dead_volume)
        temperature = T_ATM * (p / P_ATM) ** ((self.par.n_g - 1) / self.par.n_g)
        for effect, own in zip(self.effects, self.slices, strict=True):
            temperature = effect.temperature(y[own], pv, temperature)
        return p, temperature

    def rates(self, y: Sequence[float], command: Sequence[float]) -> list[float]:
        """Time derivatives of all states."""
        par = self.par
        x, v = self.motion(y)
        p, temperature = self.gas(y)
        gauge = p - P_ATM
        told = self.currents(command)
        currents, leak, wall, source, inertia = told, 0.0, T_ATM, self.p_source, self.mass
        side_mass, side_enthalpy, other_heat = 0.0, 0.0, 0.0
        for effect, own in zip(self.effects, self.slices, strict=True):
            q = y[own]
            currents = effect.current(q, currents)
            leak += effect.leak(p, temperature)
            inertia += effect.balanced_mass(x)
            wall = effect.wall_temperature(q, wall)
            source = effect.supply(q, source)
            other_heat += effect.heat(q)
            lost = effect.exchange(q, p, temperature)
            side_mass, side_enthalpy = side_mass + lost[0], side_enthalpy + lost[1]

        targets = self._target_areas(currents)
        valves, line_rates = self._inflow(y, (source, p, temperature), targets)
        net = valves[0] - leak - side_mass
        enthalpy_in = valves[1] - side_enthalpy - _CP * leak * (temperature if leak > 0 else T_ATM)
        enthalpy_in += net * sum(effect.enthalpy_beyond(p) for effect in self.effects)
        film = par.heat_coefficient
        for effect, own in self.at_the_wall:
            film = effect.film(y[own], film, p, temperature)
        heat = film * par.bare_area(x) * (wall - temperature)

        pull, fibre, bladder = self.forces(y, x, v, gauge)
        rubbed = sum(effect.friction_heat(fibre * v, bladder * v) for effect in self.effects)
        energy_rate = heat + other_heat + rubbed + enthalpy_in - p * par.volume_slope(x) * v
        now = Now(x, v, gauge, temperature, told, net, heat, targets)
        rates = [energy_rate, *self.moved(y, v, command, self.net_force(x, v, pull), inertia)]
        for k, (effect, own) in enumerate(zip(self.effects, self.slices, strict=True)):
            rates.extend(line_rates if k == self.line else effect.rates(y[own], now))
        return rates

    def currents(self, command: Sequence[float]) -> Currents:
        """Currents of inlet and exhaust valve [A], of all that the rig is told."""
        return command[0], command[1]

    def forces(
        self, y: Sequence[float], x: float, v: float, gauge: float
    ) -> tuple[float, float, float]:
        """What the muscle pulls with after all its frictions, and those of the base model [N].

        Friction of fibre on fibre, then of fibres on the bladder.
        """
        par, extra, factor, pull_factor = self.par, 0.0, 1.0, 1.0
        for effect, own in zip(self.effects, self.slices, strict=True):
            extra += effect.force(y[own], x, v, gauge)
            factor *= effect.shape_factor(x, gauge)
            pull_factor *= effect.pull_factor(x, gauge)
        fibre = gauge * par.crossing_area * par.mu_d * tanh(par.k_f * v)
        bladder = gauge * par.mu_fb * par.fibre_area
        pull = pull_factor * gauge * par.volume_slope(factor * x)
        return pull - fibre - bladder - extra, fibre, bladder

    def motion(self, y: Sequence[float]) -> tuple[float, float]:
        """Contraction [m] and its speed [m/s]."""
        return y[1], y[2]

    def at_rest(self, x: float) -> tuple[float, float]:
        """The two states of motion at rest at a contraction [m]."""
        return x, 0.0

    def net_force(self, x: float, v: float, pull: float) -> float:
        """Force [N] on what moves, from the pull of the muscle: with the stop and the weights."""
        par = self.par
        stop = max(0.0, -par.stop_stiffness * x - par.stop_damping * v) if x < 0 else 0.0
        return pull + stop - self.mass * G

    def moved(
        self, y: Sequence[float], v: float, command: Sequence[float], force: float, inertia: float
    ) -> tuple[float, float]:
        """Time derivatives of the two states of motion."""
        return v, force / inertia

    def _inflow(
        self,
        y: Sequence[float],
        pressures: tuple[float, float, float],
        targets: tuple[float, float],
    ) -> tuple[tuple[float, float], tuple[float, ...]]:
        """Gas [kg/s] and enthalpy [W] into the muscle, and the rates of the line if there is one.

        pressures: of the supply and of the gas [Pa], and the gas's temperature [K]; targets: areas of both valves by
        their currents [m2].
        """
        source, p, temperature = pressures
        areas = targets
        for effect, own in zip(self.effects, self.slices, strict=True):
            areas = effect.opening(y[own], areas)
        if self.line is None:
            return self._valves(source, p, temperature, areas), ()
        line, q = self.effects[self.line], y[self.slices[self.line]]
        assert isinstance(line, LineEffect)
        valves = self._valves(source, *line.node(q), areas)
        return line.into_muscle(q, p, temperature), line.line_rates(q, valves, p, temperature)

    def _target_areas(self, currents: Currents) -> tuple[float, float]:
        """Areas [m2] of both valves by their currents, which dynamics of the openings may reach late."""
        areas = (
            valve_area(currents[0], self.par.calibration),
            valve_area(currents[1], self.par.calibration),
        )
        for effect in self.effects:
            areas = effect.areas(areas, currents)
        return areas

    def _valves(
        self, source: float, p: float, temperature: float, areas: tuple[float, float]
    ) -> tuple[float, float]:
        """Gas [kg/s] and enthalpy [W] that both valves, open by `areas` [m2], let into gas at p [Pa]."""
        area_in, area_out = areas
        for effect in self.effects:
            area_in *= effect.valve_factor(max(p, source), min(p, source))
            area_out *= effect.valve_factor(max(p, P_ATM), min(p, P_ATM))
        m_in = mass_flow(area_in, source, T_ATM, p, temperature)
        m_out = mass_flow(area_out, p, temperature, P_ATM, T_ATM)
        enthalpy = m_in * (T_ATM if m_in > 0 else temperature) - m_out * (
            temperature if m_out > 0 else T_ATM
        )
        return m_in - m_out, _CP * enthalpy

    def reading(self, y: Sequence[float]) -> tuple[float, float, float]:
        """What the sensors show: gauge pressure [Pa], contraction [m] and temperature [K]."""
        p, temperature = self.gas(y)
        gauge, x = p - P_ATM, y[1]
        for effect, own in zip(self.effects, self.slices, strict=True):
            temperature = effect.reading(y[own], temperature)
            gauge = effect.pressure_shown(y[own], gauge)
            x = effect.position_shown(y[own], x)
        return gauge, x, temperature


def simulate_muscle(
    parameters: MuscleParameters,
    p_supply: float,
    schedule: Schedule,
    times: Array,
    effects: Sequence[Effect] = (),
    rtol: float = 1e-8,
    method: str | None = None,
    patience: int | None = None,
) -> Trajectory:
    """Simulate one isotonic run from rest on the stop at times[0].

    p_supply: gauge [Pa]; times: increasing, shape (n,) [s]; method: of solve_ivp, by default BDF with stiff
    effects, else LSODA; patience: as `integrate` has it. Raises RuntimeError when integration fails.
    """
    rig = Chain(parameters, p_supply, effects)
    late = schedule.delayed(sum(effect.delay() for effect in rig.effects))
    for effect in rig.effects:
        late = effect.drive(late)
    atol = (*ATOL, *(value for effect in rig.effects for value in effect.atol))
    method = method or ("BDF" if any(effect.stiff for effect in rig.effects) else "LSODA")
    states = integrate(rig.rates, rig.start(), late, times, atol, rtol, method, patience)
    readings = np.array([rig.reading(column) for column in states.T.tolist()])
    return Trajectory(times, readings[:, 0], readings[:, 1], readings[:, 2], states[2])
