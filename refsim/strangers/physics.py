"""Gas, sleeve, load and sensors of a rig from textbook equations, and the solution of a run."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

Array = NDArray[np.float64]
Load = Literal["hang", "spring", "held", "tank"]
# From the time [s], the readings {"p": Pa gauge, "x": m} and a generator of random numbers: how long [s] what follows
# holds, and the commands of the inlet and the outlet valve, constant or as functions of time, 0 (shut) to 1 (open).
Command = float | Callable[[float], float]
Drive = Callable[[float, dict[str, float], np.random.Generator], tuple[float, Command, Command]]

R, GAMMA, G = 287.05, 1.4, 9.80665
CRITICAL = (2 / (GAMMA + 1)) ** (GAMMA / (GAMMA - 1))
CHOKED = math.sqrt(GAMMA / R * (2 / (GAMMA + 1)) ** ((GAMMA + 1) / (GAMMA - 1)))
_SUBSONIC = 2 / (GAMMA - 1) * ((GAMMA + 1) / 2) ** ((GAMMA + 1) / (GAMMA - 1))
_LINEAR = 0.999  # above this ratio of pressures the flow is laminar
_STOP_K, _STOP_D = 2e5, 500.0  # the braid at full extension [N/m], [N s/m]


@dataclass(frozen=True)
class Truth:
    """What a rig is, in SI units; the defaults of the second part are the base model, without any departure."""

    load: Load
    # What the notes tell.
    L0: float = 0.3
    D0: float = 0.02
    angle: float = math.radians(23)  # between fibres and axis, at rest
    t_wall: float = 1e-3
    M: float = 5.0  # mass that hangs, or slides with the spring
    k_spring: float = 0.0
    F_spring: float = 0.0
    d_guide: float = 0.0
    V_tank: float = 0.0
    A_in: float = 1e-6  # fully open, by the data sheet
    A_out: float = 1e-6
    C_d: float = 0.72
    p_supply: float = 6e5  # gauge
    T_amb: float = 293.15
    p_amb: float = 101325.0
    n: float = 1.2
    h_film: float = 20.0  # on both sides of the bladder, of the base model's wall
    k_wall: float = 0.14
    # Departures.
    film: float = 0.0  # energy balance with this coefficient to a wall at ambience; 0: polytropic
    leak: float = 0.0  # area [m2]
    leak_from: float = -1.0  # contraction ratio at which the leak begins to open
    V_dead: float = 0.0
    V_hose: float = 0.0
    A_hose: float = 0.0
    valve_lag: float = 0.0
    valve_delay: float = 0.0
    valve_offset: float = 0.0  # of the command; positive: the valves open late
    outlet_ratio: float = 1.0  # outlet area over that of the data sheet
    b: float = -1.0  # critical ratio by ISO 6358; negative: isentropic
    droop: float = 0.0  # [Pa s/kg]
    V_supply: float = 5e-4
    k_bladder: float = 0.0
    C10: float = 0.0
    C01: float = 0.0
    k_creep: float = 0.0
    tau_creep: float = 10.0
    dahl: float = 0.0  # [N]
    dahl_p: float = 0.0  # [N/Pa]
    dahl_travel: float = 3e-4  # [m]
    viscous: float = 0.0
    tondu: float = 1.0  # k of (1 - k eps)^2
    end_length: float = 0.0  # of L0, does not contract
    m_extra: float = 0.0  # moves along and weighs nothing
    x_zero: float = 0.0
    x_lag: float = 0.0
    p_zero: float = 0.0
    p_gain: float = 1.0
    p_lag: float = 0.0
    F_zero: float = 0.0
    F_gain: float = 1.0
    T_lag: float = 0.0
    clock: float = 0.0  # a second logger's clock runs this much ahead [s]

    def without(self, *names: str) -> Truth:
        """This rig with some fields at the base model's values."""
        base = {f.name: f.default for f in fields(self) if f.name in names}
        return Truth(**{**{f.name: getattr(self, f.name) for f in fields(self)}, **base})


@dataclass(frozen=True)
class Start:
    """How a run begins: at rest with shut valves, under this gauge pressure."""

    p: float = 0.0
    empty: bool = False  # p is zero and the load rests on the braid


def flow(p_a: float, p_b: float, T_a: float, T_b: float, area: float, b: float = -1.0) -> float:
    """Mass flow [kg/s] from a to b through an orifice: choked, or isentropic, or elliptic with a critical ratio b."""
    if area <= 0:
        return 0.0
    if p_a < p_b:
        return -flow(p_b, p_a, T_b, T_a, area, b)
    r = p_b / p_a
    return CHOKED * p_a * area / math.sqrt(T_a) * _shape(r, b)


def _shape(r: float, b: float) -> float:
    if r > _LINEAR:
        return _shape(_LINEAR, b) * (1 - r) / (1 - _LINEAR)
    if b >= 0:
        return 1.0 if r <= b else math.sqrt(1 - ((r - b) / (1 - b)) ** 2)
    if r <= CRITICAL:
        return 1.0
    return math.sqrt(_SUBSONIC * (r ** (2 / GAMMA) - r ** ((GAMMA + 1) / GAMMA)))


@dataclass
class Sleeve:
    """Volume, force and rubber of a muscle at a contraction."""

    rig: Truth
    active: float = field(init=False)
    b2: float = field(init=False)
    c: float = field(init=False)

    def __post_init__(self) -> None:
        r = self.rig
        self.active = r.L0 - r.end_length
        b = self.active / math.cos(r.angle)
        turns = self.active * math.tan(r.angle) / (math.pi * r.D0)
        self.b2, self.c = b * b, 4 * math.pi * turns * turns

    def volume(self, x: float) -> tuple[float, float]:
        """Volume of the gas in the sleeve [m3] and its derivative by contraction [m2]."""
        length = self.active - x
        ends = math.pi / 4 * self.rig.D0**2 * self.rig.end_length
        return (
            length * (self.b2 - length**2) / self.c + ends,
            (3 * length**2 - self.b2) / self.c,
        )

    def area(self, x: float) -> float:
        """Surface of the cylinder [m2]."""
        length = self.active - x
        return math.pi * length * math.sqrt(max(self.b2 - length**2, 0.0) * 4 / (self.c * math.pi))

    def braid(self, p: float, x: float) -> float:
        """Pull [N] at a gauge pressure: McKibben's, with Tondu's k."""
        r = self.rig
        if r.tondu == 1.0:
            return p * self.volume(x)[1]
        eps = r.tondu * x / r.L0
        a0 = math.pi / 4 * r.D0**2
        return p * a0 * (3 * (1 - eps) ** 2 / math.tan(r.angle) ** 2 - 1 / math.sin(r.angle) ** 2)

    def rubber(self, x: float) -> float:
        """Force [N] of the bladder against contraction: a spring, and a Mooney-Rivlin tube by virtual work."""
        r = self.rig
        force = r.k_bladder * x
        if r.C10 or r.C01:
            solid = math.pi * r.D0 * r.t_wall * r.L0
            b2 = (r.L0 / math.cos(r.angle)) ** 2
            around2 = b2 - r.L0**2

            def invariants(stretch: float) -> tuple[float, float]:
                axial = stretch**2
                hoop = (b2 - r.L0**2 * axial) / around2
                radial = 1 / (axial * hoop)
                return axial + hoop + radial, 1 / axial + 1 / hoop + 1 / radial

            d = 1e-6
            (i1, i2), (j1, j2) = invariants(1 - x / r.L0 - d), invariants(1 - x / r.L0 + d)
            slope = -(r.C10 * (j1 - i1) + r.C01 * (j2 - i2)) / (2 * d * r.L0)
            force += solid * slope
        return force


_STATES = (
    "p",
    "m",
    "x",
    "v",
    "z",
    "creep",
    "inlet",
    "outlet",
    "supply",
    "hose",
    "p_r",
    "x_r",
    "T_r",
)
_I = {name: i for i, name in enumerate(_STATES)}
_TINY = np.array([1e-1, 1e-11, 1e-10, 1e-8, 1e-7, 1e-10, 1e-8, 1e-8, 1.0, 1.0, 1e-1, 1e-10, 1e-5])


@dataclass
class Piece:
    """Commands that hold from a time on."""

    begin: float
    inlet: Command
    outlet: Command


def _value(command: Command, t: float) -> float:
    return command(t) if callable(command) else command


class Plant:
    """The differential equations of a rig whose commands are pieces of time."""

    def __init__(self, rig: Truth, imposed: Callable[[float], float] | None = None) -> None:
        self.rig, self.sleeve = rig, Sleeve(rig)
        self.imposed = imposed or (lambda t: 0.0)
        self.pieces: list[Piece] = []
        self.y: Array = np.zeros(len(_STATES))
        self.now = 0.0  # middle of the interval that is being solved

    # -- parts ---------------------------------------------------------------------------------

    def temperature(self, p: float, mass: float, volume: float) -> float:
        """Of the gas [K]: by its mass, or by the polytropic law from ambience."""
        r = self.rig
        if r.film:
            return p * volume / (mass * R)
        return float(r.T_amb * (p / r.p_amb) ** ((r.n - 1) / r.n))

    def volume(self, x: float) -> tuple[float, float]:
        """Of the gas, with its derivative by contraction."""
        if self.rig.load == "tank":
            return self.rig.V_tank + self.rig.V_dead, 0.0
        volume, slope = self.sleeve.volume(x)
        return volume + self.rig.V_dead, slope

    def conductance(self, x: float) -> float:
        """Heat from the wall to the gas by difference of temperature [W/K]."""
        r = self.rig
        if r.load == "tank":
            return r.film * tank_surface(r.V_tank)
        u = r.film or 1 / (2 / r.h_film + r.t_wall / r.k_wall)
        return u * self.sleeve.area(x)

    def back(self, x: float, v: float) -> float:
        """What the load pulls with [N]."""
        r = self.rig
        if r.load == "spring":
            return r.F_spring + r.k_spring * (x + r.F_spring / _STOP_K) + r.d_guide * v
        return r.M * G

    def pull(self, p: float, x: float, v: float, z: float, creep: float) -> float:
        """Of the muscle [N]."""
        r = self.rig
        gauge = p - r.p_amb
        force = self.sleeve.braid(gauge, x) - self.sleeve.rubber(x) - r.k_creep * (x - creep)
        if r.dahl or r.dahl_p:
            force -= (r.dahl + r.dahl_p * max(gauge, 0.0)) * z
        force -= r.viscous * v
        if x < 0 and r.load != "held":
            force += max(0.0, -_STOP_K * x - _STOP_D * v)
        return force

    def at_rest(self, start: Start) -> Array:
        """The state in which a run begins."""
        r = self.rig
        p = r.p_amb + start.p
        x = self.imposed(0.0)
        if r.load in ("hang", "spring"):

            def excess(at: float) -> float:
                return self.pull(p, at, 0.0, 0.0, at) - self.back(at, 0.0)

            x = brentq(excess, -0.02, 0.6 * self.sleeve.active, xtol=1e-12)
        volume, _ = self.volume(x)
        supply = r.p_amb + r.p_supply
        y = np.zeros(len(_STATES))
        y[_I["p"]], y[_I["m"]] = p, p * volume / (R * r.T_amb)
        y[_I["x"]] = y[_I["creep"]] = y[_I["x_r"]] = x
        y[_I["supply"]], y[_I["hose"]], y[_I["p_r"]] = supply, p, p
        y[_I["T_r"]] = self.temperature(p, y[_I["m"]], volume)
        return y

    # -- equations -----------------------------------------------------------------------------

    def commands(self, t: float, piece: int) -> tuple[float, float]:
        """Of the valves, after the dead time; `piece` is the one that holds at the middle of the interval."""
        late = t - self.rig.valve_delay
        while piece > 0 and self.pieces[piece].begin > self.now - self.rig.valve_delay:
            piece -= 1
        if self.pieces[0].begin > self.now - self.rig.valve_delay:
            return 0.0, 0.0
        one = self.pieces[piece]
        return _value(one.inlet, late), _value(one.outlet, late)

    def rates(self, t: float, y: Array, piece: int) -> list[float]:
        """Derivatives of the states."""
        r = self.rig
        p, mass, x, v, z, creep, inlet, outlet, supply, hose, p_r, x_r, T_r = y.tolist()
        p, supply, hose = max(p, 1e3), max(supply, 1e3), max(hose, 1e3)
        if r.load == "held":
            x = self.imposed(t)
            v = (self.imposed(t + 1e-4) - self.imposed(t - 1e-4)) / 2e-4
        volume, slope = self.volume(x)
        T = self.temperature(p, max(mass, 1e-9), volume)
        u_in, u_out = self.commands(t, piece)
        d_in = d_out = 0.0
        if r.valve_lag:
            d_in, d_out = (u_in - inlet) / r.valve_lag, (u_out - outlet) / r.valve_lag
            u_in, u_out = inlet, outlet
        area_in = r.C_d * r.A_in * max(0.0, u_in - r.valve_offset)
        area_out = r.C_d * r.A_out * r.outlet_ratio * max(0.0, u_out - r.valve_offset)
        source = supply if r.droop else r.p_amb + r.p_supply
        node, T_node = (hose, r.T_amb) if r.V_hose else (p, T)
        m_in = flow(source, node, r.T_amb, T_node, area_in, r.b)
        m_out = flow(node, r.p_amb, T_node, r.T_amb, area_out, r.b)
        net, enthalpy, d_hose = m_in - m_out, 0.0, 0.0
        if r.V_hose:
            through = flow(hose, p, r.T_amb, T, r.A_hose, 0.3)
            d_hose = R * r.T_amb / r.V_hose * (net - through)
            net = through
            enthalpy = through * (r.T_amb if through > 0 else T)
        else:
            enthalpy = m_in * (r.T_amb if m_in > 0 else T) - m_out * (T if m_out > 0 else r.T_amb)
        lost = 0.0
        if r.leak:
            opened = 1.0
            if r.leak_from >= 0:
                opened = max(0.0, x / r.L0 - r.leak_from) / 0.1
            lost = flow(p, r.p_amb, T, r.T_amb, r.leak * opened)
            net, enthalpy = net - lost, enthalpy - lost * T
        if r.load == "tank" and not r.film:
            d_p = r.n * R * T / volume * net
        else:
            heat = self.conductance(x) * (r.T_amb - T)
            d_p = (GAMMA * R * enthalpy + (GAMMA - 1) * heat - GAMMA * p * slope * v) / volume
        d_x = d_v = d_z = d_creep = 0.0
        if r.load != "tank":
            if r.dahl or r.dahl_p:
                d_z = (v - abs(v) * z) / r.dahl_travel
            if r.k_creep:
                d_creep = (x - creep) / r.tau_creep
        if r.load in ("hang", "spring"):
            d_x = v
            d_v = (self.pull(p, x, v, z, creep) - self.back(x, v)) / (r.M + r.m_extra)
        d_supply = 0.0
        if r.droop:
            refill = (r.p_amb + r.p_supply - supply) / r.droop
            d_supply = R * r.T_amb / r.V_supply * (refill - m_in)
        return [
            d_p, net, d_x, d_v, d_z, d_creep, d_in, d_out, d_supply, d_hose,
            (p - p_r) / r.p_lag if r.p_lag else 0.0,
            (x - x_r) / r.x_lag if r.x_lag else 0.0,
            (T - T_r) / r.T_lag if r.T_lag else 0.0,
        ]  # fmt: skip

    # -- solution ------------------------------------------------------------------------------

    def advance(self, begin: float, end: float, at: Array) -> Array:
        """Goes on to `end`; the states at the times `at` within, each a column."""
        delay = self.rig.valve_delay
        edges = [p.begin + delay for p in self.pieces if begin < p.begin + delay < end]
        edges += [p.begin for p in self.pieces if begin < p.begin < end]
        times = sorted({begin, *edges, end})
        columns = []
        for a, b in zip(times, times[1:], strict=False):
            inside = at[(at >= a) & (at < b)]
            self.now = 0.5 * (a + b)
            piece = max(i for i, one in enumerate(self.pieces) if one.begin <= self.now)
            solution = solve_ivp(
                self.rates,
                (a, b),
                self.y,
                method="LSODA",
                t_eval=np.append(inside, b),
                args=(piece,),
                rtol=1e-7,
                atol=_TINY,
                max_step=0.1,
            )
            if not solution.success:
                raise RuntimeError(f"no solution from {a:.3f} s on: {solution.message}")
            columns.append(solution.y[:, :-1])
            self.y = solution.y[:, -1]
        return np.hstack(columns)

    def readings(self, t: Array, states: Array) -> dict[str, Array]:
        """What the instruments read without noise: p [Pa gauge], x [m], F [N], T [K]."""
        r = self.rig
        rows: dict[str, list[float]] = {"p": [], "x": [], "F": [], "T": []}
        for at, y in zip(t.tolist(), states.T.tolist(), strict=True):
            s: dict[str, Any] = dict(zip(_STATES, y, strict=True))
            if r.load == "held":
                s["x"] = self.imposed(at)
                s["v"] = (self.imposed(at + 1e-4) - self.imposed(at - 1e-4)) / 2e-4
            T = self.temperature(s["p"], max(s["m"], 1e-9), self.volume(s["x"])[0])
            gauge = (s["p_r"] if r.p_lag else s["p"]) - r.p_amb
            rows["p"].append(r.p_gain * gauge + r.p_zero)
            rows["x"].append((s["x_r"] if r.x_lag else s["x"]) + r.x_zero)
            rows["T"].append(s["T_r"] if r.T_lag else T)
            force = self.pull(s["p"], s["x"], s["v"], s["z"], s["creep"])
            rows["F"].append(r.F_gain * force + r.F_zero)
        return {name: np.array(values) for name, values in rows.items()}


def tank_surface(volume: float) -> float:
    """Inner surface [m2] of a cylinder twice as long as wide."""
    return float(2.5 * math.pi * (2 * volume / math.pi) ** (2 / 3))


@dataclass(frozen=True)
class Solved:
    """A run: times [s], commands at the times, readings, and the pieces that drove it."""

    t: Array
    u_in: Array
    u_out: Array
    readings: dict[str, Array]
    pieces: list[Piece]


def solve(
    rig: Truth,
    start: Start,
    times: Array,
    drive: Drive | list[Piece],
    seed: int = 0,
    imposed: Callable[[float], float] | None = None,
) -> Solved:
    """The run of a rig from time zero, at increasing times; `drive` decides, or the pieces of a former run hold.

    Raises:
        RuntimeError: the solver does not reach the end.
    """
    plant, generator = Plant(rig, imposed), np.random.default_rng(seed)
    plant.y = plant.at_rest(start)
    end = float(times[-1]) + 1e-9
    parts: list[tuple[Array, dict[str, Array]]] = []
    for begin, until in _intervals(plant, drive, end, generator):
        inside = times[(times >= begin) & (times < until)]
        states = plant.advance(begin, until, inside)
        parts.append((inside, plant.readings(inside, states)))
    t = np.concatenate([a for a, _ in parts])
    readings = {n: np.concatenate([s[n] for _, s in parts]) for n in parts[0][1]}
    u = np.array([_commanded(plant.pieces, at) for at in t.tolist()])
    return Solved(t, u[:, 0], u[:, 1], readings, plant.pieces)


def _commanded(pieces: list[Piece], t: float) -> tuple[float, float]:
    piece = [p for p in pieces if p.begin <= t + 1e-9][-1]
    return _value(piece.inlet, t), _value(piece.outlet, t)


def _intervals(
    plant: Plant,
    drive: Drive | list[Piece],
    end: float,
    generator: np.random.Generator,
) -> Iterator[tuple[float, float]]:
    if isinstance(drive, list):
        plant.pieces = drive
        ends = [p.begin for p in drive[1:] if p.begin < end] + [end]
        yield from zip([p.begin for p in drive], ends, strict=False)
        return
    t = 0.0
    while t < end:
        seen = plant.readings(np.array([t]), plant.y[:, None])
        lasts, inlet, outlet = drive(t, {n: float(v[0]) for n, v in seen.items()}, generator)
        plant.pieces.append(Piece(t, inlet, outlet))
        until = min(round(t + lasts, 6), end)
        yield t, until
        t = until
