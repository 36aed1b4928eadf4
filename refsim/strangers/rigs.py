"""The thirty rigs: loads, drives and valves by a plan, measures and departures drawn with the rig's number as seed."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from strangers.physics import CHOKED, Command, Drive, G, R, Sleeve, Start, Truth

RIGS = 30
HALVES = {"tuning": range(15), "once": range(15, 30)}
# load, drive and command of the valves; the second half goes through it again with other measures and files.
PLAN = (
    ("hang", "pulses", "A"),
    ("tank", "pulses", "mA"),
    ("held", "pulses", "switch"),
    ("spring", "sines", "V"),
    ("hang", "controller", "mA"),
    ("hang", "staircase", "V"),
    ("held", "staircase", "A"),
    ("hang", "sines", "mA"),
    ("spring", "pulses", "switch"),
    ("tank", "pulses", "switch"),
    ("hang", "pulses", "V"),
    ("spring", "staircase", "mA"),
    ("hang", "controller", "switch"),
    ("held", "sines", "V"),
    ("hang", "staircase", "%"),
)
LAYOUTS = ("plain", "german", "tabs", "plain", "two", "german", "one file", "tabs")


@dataclass(frozen=True)
class Departure:
    """One way in which a rig differs from the base model."""

    name: str
    family: str
    what: str
    size: str
    fields: tuple[str, ...]


@dataclass(frozen=True)
class Valves:
    """The data sheet of the valves: their command shut and fully open."""

    unit: str
    shut: float
    full: float
    step: float


SHEETS = {
    "A": Valves("A", 0.0, 0.2, 0.0005),
    "mA": Valves("mA", 0.0, 400.0, 1.0),
    "V": Valves("V", 2.0, 10.0, 0.02),
    "%": Valves("%", 0.0, 100.0, 0.2),
    "switch": Valves("-", 0.0, 1.0, 1.0),
}


@dataclass(frozen=True)
class RunPlan:
    """A recording: the part [s] of a course that is kept, and what drives it."""

    start: Start
    begin: float
    end: float
    drive: Drive
    seed: int
    held_out: bool
    M: float
    imposed: float | Callable[[float], float] = 0.0


@dataclass(frozen=True)
class Rig:
    """A rig with all that is measured on it."""

    number: int
    truth: Truth
    valves: Valves
    drive: str
    departures: tuple[Departure, ...]
    sigma: dict[str, float]  # SI units
    steps: dict[str, float]  # of the record, in SI units
    rate: float  # [Hz]
    layout: str
    unknown: tuple[str, ...]
    runs: tuple[RunPlan, ...] = field(repr=False)

    @property
    def half(self) -> str:
        """Whether the rig is for tuning or is run once."""
        return next(name for name, numbers in HALVES.items() if self.number in numbers)

    @property
    def loggers(self) -> dict[str, tuple[str, ...]]:
        """The signals of each further logger, by its name."""
        if self.layout != "two":
            return {}
        camera = tuple(s for s in self.sigma if s in ("x", "F"))
        further = {"camera" if "x" in camera else "loadcell": camera} if camera else {}
        return further | ({"thermometer": ("T",)} if "T" in self.sigma else {})


def rig(number: int) -> Rig:
    """The rig of a number, 0 to 29: the same each time."""
    draw = np.random.default_rng([70, number])
    load, drive, sheet = PLAN[number % 15]
    second = number >= 15
    layout = LAYOUTS[(number + 3 * second) % len(LAYOUTS)]
    temperature = load == "tank" or number % 4 == 2 or (layout == "two" and number % 5 == 2)
    base = _base(draw, load, sheet, drive)
    x, force = _middle(base)
    sigma, steps = _instruments(draw, load, temperature, force)
    truth, departures = _departures(draw, base, drive, sheet, layout, temperature, x, force)
    rate = {"pulses": 100.0, "controller": 50.0, "sines": 50.0, "staircase": 40.0}[drive]
    if load == "tank":
        rate = 20.0
    runs = _runs(draw, truth, drive, sheet, rate, 1000 * number)
    unknown = ["valve coefficient", "polytropic exponent"]
    if load != "tank" and draw.random() < 0.5:
        unknown.append("heat transfer")
    return Rig(
        number, truth, SHEETS[sheet], drive, departures, sigma, steps, rate, layout,
        tuple(unknown), runs,
    )  # fmt: skip


def _nice(value: float, digits: int = 2) -> float:
    return float(f"{value:.{digits}g}")


def _base(draw: np.random.Generator, load: Any, sheet: str, drive: str) -> Truth:
    """Measures of a rig without departures."""
    T_amb = 273.15 + float(draw.choice([18.0, 19.5, 21.0, 22.5, 24.0]))
    p_amb = 1e3 * float(draw.choice([101.3, 100.4, 99.1, 96.5]))
    p_supply = 1e5 * float(draw.choice([4.0, 5.0, 6.0, 7.0]))
    C_d = round(float(draw.uniform(0.6, 0.85)), 3)
    n = round(float(draw.uniform(1.05, 1.3)), 2)
    common = {"T_amb": T_amb, "p_amb": p_amb, "p_supply": p_supply, "C_d": C_d, "n": n}
    slow = sheet == "switch"
    if load == "tank":
        V = 1e-3 * _nice(draw.uniform(0.6, 5.0))
        seconds = draw.uniform(6.0, 12.0) * (2.0 if slow else 1.0)
        full = _area(V, p_amb + p_supply, T_amb, C_d, seconds)
        return Truth("tank", V_tank=V, A_in=_mm2(full), A_out=_mm2(full), **common)
    D0 = 1e-3 * round(float(np.exp(draw.uniform(np.log(8), np.log(26 if load == "hang" else 40)))))
    L0 = D0 * float(np.exp(draw.uniform(np.log(8), np.log(22))))
    L0 = round(min(max(L0, 0.09), 0.5), 3)
    angle = math.radians(round(float(draw.uniform(19, 26)), 1))
    t_wall = 1e-3 * _nice(min(draw.uniform(0.6, 2.0), 80 * D0))
    rig = Truth(load, L0=L0, D0=D0, angle=angle, t_wall=t_wall, **common)
    x, _ = _middle(rig)
    volume = Sleeve(rig).volume(x)[0]
    seconds = draw.uniform(1.2, 2.5) if slow else draw.uniform(0.25, 0.6)
    if drive in ("staircase", "sines"):
        seconds *= 0.7
    full = _area(volume, p_amb + p_supply, T_amb, C_d, seconds)
    rig = replace(rig, A_in=_mm2(full), A_out=_mm2(full * float(draw.choice([1.0, 1.0, 1.4]))))
    force = Sleeve(rig).braid(0.38 * p_supply, x)
    if load == "hang":
        return replace(rig, M=_nice(force / G, 3))
    if load == "spring":
        preload = _nice(0.1 * force)
        return replace(
            rig,
            M=_nice(draw.uniform(0.004, 0.01) * force),
            F_spring=preload,
            k_spring=_nice((force - preload) / x, 3),
            d_guide=_nice(0.02 * force / x),
        )
    return rig


def _area(V: float, p: float, T: float, C_d: float, seconds: float) -> float:
    """Area [m2] through which a volume fills from a choked supply in a time."""
    return V * 0.5 * p / (R * T) / (CHOKED * p / math.sqrt(T) * C_d * seconds)


def _mm2(area: float) -> float:
    return _nice(area * 1e6) * 1e-6


def _middle(rig: Truth) -> tuple[float, float]:
    """Contraction [m] and pull [N] in the middle of the range."""
    if rig.load == "tank":
        return 0.0, 0.0
    x = 0.42 * rig.L0 * (1 - 1 / (math.sqrt(3) * math.cos(rig.angle)))
    return x, Sleeve(rig).braid(0.38 * rig.p_supply, x)


def _instruments(
    draw: np.random.Generator, load: str, temperature: bool, force: float
) -> tuple[dict[str, float], dict[str, float]]:
    sigma = {"p": 1e3 * float(draw.choice([0.4, 0.6, 0.9, 1.2]))}
    steps = {"p": 100.0}
    if load == "held":
        sigma["F"], steps["F"] = _nice(float(draw.uniform(0.004, 0.01)) * force), 0.1
    elif load != "tank":
        sigma["x"] = 1e-3 * float(draw.choice([0.03, 0.05, 0.08, 0.12]))
        steps["x"] = 1e-5
    if temperature:
        sigma["T"], steps["T"] = float(draw.choice([0.1, 0.15, 0.2])), 0.1
    return sigma, steps


# -- departures --------------------------------------------------------------------------------


def _departures(
    draw: np.random.Generator,
    rig: Truth,
    drive: str,
    sheet: str,
    layout: str,
    temperature: bool,
    x: float,
    force: float,
) -> tuple[Truth, tuple[Departure, ...]]:
    """Three to six departures, one of a family; a rig with a thermometer always has a gas that keeps its energy."""
    make = _Maker(draw, rig, x, force)
    weights = {"gas_energy": 6.0, "leak": 1.5, "supply_line": 1.5, "valve_area": 1.5}
    weights |= {"pressure_offset": 1.0}
    if temperature:
        weights["thermocouple_lag"] = 2.0
    if sheet == "switch" or drive == "pulses":
        weights["valve_dynamics"] = 1.5 if rig.load != "tank" else 0.5
    if rig.load != "tank":
        weights |= {"elasticity": 3.0, "end_shape": 1.5, "dead_volume": 1.0}
    if rig.load in ("hang", "spring"):
        weights |= {"dry_friction": 2.5, "rate_friction": 2.0, "creep": 1.5}
        weights |= {"position_sensor": 1.0, "moving_mass": 0.7}
    if rig.load == "held":
        weights |= {"force_sensor": 1.0, "creep": 0.0}
        if drive == "sines":
            weights |= {"dry_friction": 2.0, "creep": 1.0}
    if drive in ("pulses", "sines", "controller") and rig.load != "tank":
        weights["pressure_sensor_lag"] = 0.7
    if layout == "two" and rig.load != "tank":
        weights["clock_offset"] = 3.0
    count = int(draw.integers(3, 5 if rig.load == "tank" else 7))
    names = list(weights)
    share = np.array([weights[n] for n in names])
    chosen = [str(n) for n in draw.choice(names, count, replace=False, p=share / share.sum())]
    if rig.load == "hang" and not {"dry_friction", "rate_friction"} & set(chosen):
        chosen[-1] = "dry_friction" if draw.random() < 0.6 else "rate_friction"
    if temperature and "gas_energy" not in chosen:
        chosen[0] = (
            "gas_energy"  # no thermometer reads what the polytropic law says of a gas at rest
        )
    departures = []
    for family in chosen:
        values, name, what, size = getattr(make, family)(sheet)
        rig = replace(rig, **values)
        departures.append(Departure(name, family, what, size, tuple(values)))
    return rig, tuple(departures)


_Made = tuple[dict[str, float], str, str, str]


class _Maker:
    """A departure of each family, of a size as rigs have it."""

    def __init__(self, draw: np.random.Generator, rig: Truth, x: float, force: float) -> None:
        self.draw, self.rig, self.x, self.force = draw, rig, x, force

    def _of(self, low: float, high: float) -> float:
        return _nice(float(np.exp(self.draw.uniform(np.log(low), np.log(high)))))

    def _sign(self) -> float:
        return float(self.draw.choice([-1.0, 1.0]))

    def gas_energy(self, _: str) -> _Made:
        h = self._of(8, 50)
        what = "temperature from mass and energy, heat to a wall at ambience, not polytropic"
        return {"film": h}, "gas energy balance", what, f"film {h:g} W/(m2 K)"

    def leak(self, _: str) -> _Made:
        r = self.rig
        area = self._of(0.002, 0.012) * r.A_in
        if r.load in ("hang", "spring") and self.draw.random() < 0.3:
            begin = round(0.6 * self.x / r.L0, 3)
            what = f"orifice that opens from a contraction of {begin:g} of the length on"
            values = {"leak": 1.5 * area, "leak_from": begin}
            return values, "leak at high contraction", what, f"{1.5e6 * area:.3g} mm2 at 0.1 more"
        return {"leak": area}, "leak", "orifice to ambience", f"{1e6 * area:.3g} mm2"

    def supply_line(self, _: str) -> _Made:
        r = self.rig
        if r.load != "tank" and self.draw.random() < 0.5:
            length, bore = self._of(0.5, 3.0), float(self.draw.choice([2.5e-3, 3e-3, 4e-3]))
            area = self._of(0.5, 1.5) * r.C_d * r.A_in
            what = f"hose of {length:g} m, {1e3 * bore:g} mm bore, ISO 6358 with b = 0.3"
            values = {"V_hose": math.pi / 4 * bore**2 * length, "A_hose": area}
            return values, "hose", what, f"effective area {1e6 * area:.3g} mm2"
        p = r.p_supply + r.p_amb
        greatest = CHOKED * p * r.C_d * r.A_in / math.sqrt(r.T_amb)
        sag = self._of(0.08, 0.25) * p
        vessel = 1e-3 * self._of(0.1, 0.6)
        what = f"regulator loses pressure with the flow, {1e3 * vessel:.2g} l behind it"
        values = {"droop": sag / greatest, "V_supply": vessel}
        size = f"{sag / 1e3:.3g} kPa at {1e3 * greatest:.2g} g/s"
        return values, "supply droop", what, size

    def valve_area(self, sheet: str) -> _Made:
        kind = str(
            self.draw.choice(["b", "ratio"] if sheet == "switch" else ["b", "ratio", "band"])
        )
        if kind == "b":
            b = round(float(self.draw.uniform(0.12, 0.35)), 2)
            what = "ISO 6358 instead of isentropic flow"
            return {"b": b}, "critical ratio", what, f"b = {b:g}"
        if kind == "ratio":
            ratio = round(float(self.draw.choice([0.8, 0.85, 1.15, 1.25])), 2)
            what = "outlet valve's area over that of its data sheet, the inlet's as 1"
            return {"outlet_ratio": ratio}, "unequal valves", what, f"{ratio:g}"
        band = round(float(self.draw.uniform(0.02, 0.07)), 3)
        what = "the valves begin to open above the command of the data sheet"
        return {"valve_offset": band}, "valve dead band", what, f"{100 * band:.2g} % of the range"

    def valve_dynamics(self, sheet: str) -> _Made:
        time = round(float(self.draw.uniform(0.012, 0.05)), 3)
        if sheet == "switch" or self.draw.random() < 0.4:
            return {"valve_delay": time}, "valve dead time", "opens and shuts late", f"{time:g} s"
        return {"valve_lag": time}, "valve lag", "first order", f"{time:g} s"

    def pressure_offset(self, _: str) -> _Made:
        if self.draw.random() < 0.6:
            zero = self._sign() * 1e3 * self._of(2, 8)
            return {"p_zero": zero}, "gauge offset", "of the pressure", f"{zero / 1e3:g} kPa"
        gain = round(1 + self._sign() * self._of(0.01, 0.03), 3)
        return {"p_gain": gain}, "gauge gain", "of the pressure", f"{gain:g}"

    def thermocouple_lag(self, _: str) -> _Made:
        time = self._of(0.5, 3.0)
        return {"T_lag": time}, "thermometer lag", "first order", f"{time:g} s"

    def pressure_sensor_lag(self, _: str) -> _Made:
        time = self._of(0.015, 0.06)
        return {"p_lag": time}, "pressure sensor lag", "first order", f"{time:g} s"

    def elasticity(self, _: str) -> _Made:
        if self.draw.random() < 0.5:
            k = _nice(self.draw.uniform(0.05, 0.15) * self.force / self.x)
            return {"k_bladder": k}, "linear elasticity", "a spring", f"{k / 1e3:g} N/mm"
        unit = Sleeve(replace(self.rig, C10=1e5, C01=2.5e4)).rubber(self.x)
        C10 = _nice(min(max(self.draw.uniform(0.05, 0.15) * self.force / unit * 1e5, 4e4), 3e5))
        what = f"Mooney-Rivlin tube of {1e3 * self.rig.t_wall:g} mm, C01 = C10/4"
        values = {"C10": C10, "C01": C10 / 4}
        return values, "rubber elasticity", what, f"C10 {C10 / 1e6:g} MPa"

    def end_shape(self, _: str) -> _Made:
        if self.draw.random() < 0.5:
            k = round(float(self.draw.uniform(1.02, 1.1)), 3)
            return {"tondu": k}, "end effects", "Tondu's k", f"{k:g}"
        length = round(self.draw.uniform(0.02, 0.07) * self.rig.L0, 4)
        what = "part of the length at rest that does not contract"
        return {"end_length": length}, "dead ends", what, f"{1e3 * length:g} mm"

    def dead_volume(self, _: str) -> _Made:
        volume = self._of(0.06, 0.3) * Sleeve(self.rig).volume(0.0)[0]
        what = "in fittings and gauge line"
        return {"V_dead": volume}, "dead volume", what, f"{1e6 * volume:.3g} cm3"

    def dry_friction(self, _: str) -> _Made:
        share = float(self.draw.uniform(0.015, 0.05))
        f0, f1 = (
            _nice(0.4 * share * self.force),
            0.6 * share * self.force / (0.38 * self.rig.p_supply),
        )
        travel = self.x * self._of(0.005, 0.02)
        what = f"Dahl, {f0:g} N + {1e3 * f1:.2g} N/kPa, travel {1e3 * travel:.2g} mm"
        values = {"dahl": f0, "dahl_p": f1, "dahl_travel": travel}
        return values, "dry friction", what, f"{share * self.force:.3g} N"

    def rate_friction(self, _: str) -> _Made:
        c = _nice(self.draw.uniform(0.03, 0.08) * self.force / (self.x / 0.5))
        return {"viscous": c}, "viscous friction", "damper", f"{c:g} N s/m"

    def creep(self, _: str) -> _Made:
        k = _nice(self.draw.uniform(0.03, 0.09) * self.force / self.x)
        tau = self._of(1.5, 12.0)
        what = f"standard linear solid, relaxation in {tau:g} s"
        return {"k_creep": k, "tau_creep": tau}, "creep", what, f"{k / 1e3:g} N/mm"

    def moving_mass(self, _: str) -> _Made:
        mass = _nice(self.rig.M * self._of(0.2, 0.8) * (1 if self.rig.load == "hang" else 3))
        what = "moves along and weighs nothing (slide, pulley)"
        return {"m_extra": mass}, "moving mass", what, f"{mass:g} kg"

    def position_sensor(self, _: str) -> _Made:
        if self.draw.random() < 0.6:
            zero = self._sign() * 1e-3 * self._of(0.4, 2.0)
            return {"x_zero": zero}, "position zero", "of the ruler", f"{1e3 * zero:g} mm"
        time = self._of(0.015, 0.06)
        return {"x_lag": time}, "position lag", "first order", f"{time:g} s"

    def force_sensor(self, _: str) -> _Made:
        if self.draw.random() < 0.5:
            zero = self._sign() * _nice(self.draw.uniform(0.02, 0.05) * self.force)
            return {"F_zero": zero}, "load cell zero", "tare", f"{zero:g} N"
        gain = round(1 + self._sign() * self._of(0.015, 0.04), 3)
        return {"F_gain": gain}, "load cell gain", "span", f"{gain:g}"

    def clock_offset(self, _: str) -> _Made:
        time = self._sign() * self._of(0.015, 0.08)
        return {"clock": time}, "clock offset", "second logger's clock ahead", f"{time:g} s"


# -- runs --------------------------------------------------------------------------------------


def _runs(
    draw: np.random.Generator, rig: Truth, drive: str, sheet: str, rate: float, seed: int
) -> tuple[RunPlan, ...]:
    """Five or six runs: from rest under pressure, from empty, and cut out of longer ones; two are held out."""
    count = 6 if drive == "pulses" else 5
    length = {"pulses": 20.0, "sines": 24.0, "staircase": 32.0, "controller": 16.0}[drive]
    if rig.load == "tank":
        length = 50.0
    x, _ = _middle(rig)
    step = 1 / rate
    runs = []
    for i in range(count):
        cut = i in (2, count - 1) or (drive != "controller" and i == 3 and count == 6)
        empty = rig.load == "tank" and i < 2
        level = round(draw.uniform(0.28, 0.45) * rig.p_supply, -3)
        M = rig.M
        if rig.load == "hang" and i in (1, count - 2):
            M = _nice(rig.M * 0.75, 3)
        begin = step * round(draw.uniform(3.0, 6.0) / step) if cut else 0.0
        imposed: float | Callable[[float], float] = 0.0
        if rig.load == "held":
            imposed = round(x * (0.3, 1.0, 1.6, 0.7, 1.2, 0.5)[i], 4)
            if drive == "sines" and i in (1, 4):
                imposed = _swing(round(x, 4), round(0.3 * x, 4), 0.05 + 0.03 * i)
        runs.append(
            RunPlan(
                Start(0.0 if empty else level),
                begin,
                begin + length,
                _drive(draw, rig, drive, sheet, x * draw.uniform(0.8, 1.2)),
                seed + i,
                held_out=i in (count - 1, 1),
                M=M,
                imposed=imposed,
            )
        )
    return tuple(runs)


def _swing(middle: float, half: float, frequency: float) -> Callable[[float], float]:
    return lambda t: middle - half * math.cos(2 * math.pi * frequency * max(t, 0.0))


def _drive(draw: np.random.Generator, rig: Truth, drive: str, sheet: str, x: float) -> Drive:
    switch = sheet == "switch"
    tank = rig.load == "tank"
    if drive == "pulses":
        low, high = (0.08, 0.85) if tank else (0.22, 0.62)
        return _pulses(low * rig.p_supply, high * rig.p_supply, switch, 4.0 if tank else 1.0)
    if drive == "controller":
        period = float(draw.uniform(3.0, 7.0))
        return _controller(x, 0.35 * x, period, switch, bool(draw.random() < 0.5))
    ratio = rig.A_out / rig.A_in
    exhaust = float(draw.uniform(0.4, 0.65) if drive == "sines" else draw.uniform(0.25, 0.4))
    # Both valves are open a little: the ratio of their openings sets the pressure.
    middle, half = 0.53 * exhaust * ratio, 0.24 * exhaust * ratio
    if drive == "staircase":
        return _staircase(middle, half, exhaust)
    frequencies = sorted(float(f) for f in draw.uniform(0.06, 0.6, 2))
    return _sines(middle, half, exhaust, frequencies, float(draw.uniform(0, 3)))


def _fraction(value: float) -> float:
    """A command as the output of the rig has it: in steps of 1/400 of the range."""
    return round(min(max(value, 0.0), 1.0) * 400) / 400


def _pulses(low: float, high: float, switch: bool, slow: float) -> Drive:
    waits = [True]

    def drive(t: float, seen: dict[str, float], draw: np.random.Generator) -> Any:
        waits[0] = not waits[0] if t else False
        if not waits[0] and t:
            inlet = seen["p"] < low or (seen["p"] < high and draw.random() < 0.5)
            opening = 1.0 if switch else _fraction(draw.uniform(0.15, 0.7))
            lasts = round(slow * draw.uniform(0.1, 0.5), 1 if slow > 1 else 2)
            return lasts, opening * inlet, opening * (not inlet)
        return round(slow * draw.uniform(0.3, 1.6), 1 if slow > 1 else 2), 0.0, 0.0

    return drive


def _controller(x: float, half: float, period: float, switch: bool, steps: bool) -> Drive:
    """A proportional-integral controller of the position, 25 times a second; with switches it has a dead zone."""
    total = [0.0]

    def drive(t: float, seen: dict[str, float], draw: np.random.Generator) -> Any:
        phase = math.sin(2 * math.pi * t / period)
        wanted = x + half * (math.copysign(1.0, phase) if steps else phase)
        error = (wanted - seen["x"]) / x
        if switch:
            return 0.04, float(error > 0.06), float(error < -0.06)
        total[0] = min(max(total[0] + 0.04 * error, -0.3), 0.3)
        u = 0.9 * error + 0.6 * total[0]
        return 0.04, _fraction(u), _fraction(-u)

    return drive


def _staircase(middle: float, half: float, exhaust: float) -> Drive:
    levels = [0]

    def drive(t: float, seen: dict[str, float], draw: np.random.Generator) -> Any:
        if t == 0:
            return 1.0, 0.0, 0.0
        levels[0] += 1
        place = (levels[0] % 12) / 3 - 1 if levels[0] % 12 <= 6 else 3 - (levels[0] % 12) / 3
        lasts = 0.5 * round(draw.uniform(3.0, 5.5))
        inlet = _fraction(middle + half * (place + draw.uniform(-0.15, 0.15)))
        return lasts, inlet, _fraction(exhaust)

    return drive


def _sines(
    middle: float, half: float, exhaust: float, frequencies: list[float], phase: float
) -> Drive:
    def inlet(t: float) -> float:
        a, b = (math.sin(2 * math.pi * f * t + phase * i) for i, f in enumerate(frequencies))
        return middle + half * (0.6 * a + 0.4 * b)

    def drive(t: float, seen: dict[str, float], draw: np.random.Generator) -> Any:
        return 1e6, inlet, _fraction(exhaust)

    return drive


__all__ = ["HALVES", "PLAN", "RIGS", "Command", "Departure", "Rig", "RunPlan", "Valves", "rig"]
