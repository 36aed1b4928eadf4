"""Rigs of many benches: which bench, what is measured how fast, geometry, plan, what is free.

`Design` is known before anything is drawn for the rig itself: what can be hidden follows from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from math import pi
from typing import Any

import numpy as np

from blind_cases import drives
from blind_cases.drives import HELD, JOINED, Clock
from blind_cases.sizes import FreeParameter, Signals
from rig.benches import BENCHES, RigBench, turns_of
from rig.control import Loop, closed_loop
from rig.effect import Effect
from rig.flow import G
from rig.instruments import Fault, disturbed
from rig.muscle import MuscleParameters
from rig.schedule import Schedule
from rig.trial import Trial

Random = np.random.Generator
Array = np.ndarray

SHARES: Mapping[str, int] = {
    "Isotonic": 6, "Isometric": 4, "VerticalLoad": 4, "TankFilling": 3, "SwitchedMuscle": 3, "Antagonistic": 3,
    "VesselOrifice": 1,
}  # fmt: skip
"""How many of 24 cases are of each bench."""

SIGNALS: Mapping[str, tuple[tuple[tuple[str, ...], float], ...]] = {
    "Isotonic": ((("p", "x", "T"), 0.5), (("p", "x"), 0.35), (("p",), 0.15)),
    "Isometric": ((("p", "F", "T"), 0.4), (("p", "F"), 0.45), (("p",), 0.15)),
    "SwitchedMuscle": ((("p", "T"), 0.5), (("p",), 0.5)),
    "Antagonistic": ((("p_1", "p_2", "x"), 0.85), (("p_1", "p_2"), 0.15)),
    "VerticalLoad": ((("x",), 1.0),),
    "TankFilling": ((("p", "T"), 0.6), (("p",), 0.4)),
    "VesselOrifice": ((("p", "T"), 0.7), (("p",), 0.3)),
}
"""What is measured, and how often."""

RATES: Mapping[str, tuple[float, ...]] = {
    "SwitchedMuscle": (200.0, 500.0, 500.0, 1000.0),
    "TankFilling": (20.0, 20.0, 50.0, 100.0),
    "VesselOrifice": (20.0, 50.0, 100.0),
    "VerticalLoad": (20.0, 50.0, 50.0, 100.0, 200.0),
}
_RATES = (20.0, 50.0, 50.0, 100.0, 100.0, 100.0, 200.0, 500.0, 1000.0)
"""Samples a second [Hz], drawn evenly."""

RUNS = (1, 2, 3, 4, 4, 6, 6, 6, 8, 8, 12, 20)
_RTOL = 1e-5  # leaves errors of some pascals and some tenths of a micrometre
SAMPLES = 16000  # of all runs together, at most
_SECONDS: Mapping[str, tuple[float, float]] = {
    "SwitchedMuscle": (0.6, 1.5), "TankFilling": (6.0, 11.0), "VesselOrifice": (6.0, 11.0), "VerticalLoad": (5.0, 9.0),
}  # fmt: skip
_USUAL_SECONDS = (4.0, 9.0)


@dataclass(frozen=True)
class Design:
    """What is fixed before the rig is drawn.

    Attributes:
        bench: by name. signals: that are measured. rate: Hz. runs: how many. sixth: the dimension or load that is
            free besides the usual parameters, if there is one.
    """

    bench: str
    signals: tuple[str, ...]
    rate: float
    runs: int
    sixth: str | None = None

    @property
    def rig(self) -> RigBench:
        """The bench of the rig."""
        return BENCHES[self.bench]


@dataclass(frozen=True)
class Setup:
    """The true rig of one case; what `sizes.Ruler` measures with.

    Attributes:
        values: all parameters as stated, free ones at their truth. muscle: geometry for forms that ask for one.
        loops: controllers by number of the run. done: what was simulated, which copies of this share; each with its
            trial, by whose identity it is known.
    """

    design: Design
    values: Mapping[str, float]
    free: tuple[FreeParameter, ...]
    plan: tuple[Trial, ...]
    muscle: MuscleParameters
    loops: Mapping[int, Loop] = field(default_factory=dict)
    done: dict[Any, tuple[Trial, tuple[Array, Signals]]] = field(
        default_factory=dict, repr=False, compare=False
    )

    @property
    def signals(self) -> tuple[str, ...]:
        """Names of what is measured."""
        return self.design.signals

    def simulate(
        self, effects: Sequence[Effect | Fault] = (), changed: Mapping[str, float] | None = None
    ) -> list[Signals]:
        """Noise-free signals of every run. Raises RuntimeError when a run cannot be simulated."""
        values = {**self.values, **(changed or {})}
        recorded = []
        for trial in self.plan:
            time, right = self.before_faults(trial, effects, values)
            shown = disturbed([one for one in effects if isinstance(one, Fault)], time, right)
            recorded.append(
                {name: self._sampled(trial, time, shown[name]) for name in self.signals}
            )
        return recorded

    @staticmethod
    def _sampled(trial: Trial, time: Array, y: Array) -> Array:
        return (
            y[trial.begin :] if len(time) == trial.samples else np.interp(trial.recorded, time, y)
        )

    def recorded(
        self, effects: Sequence[Effect | Fault], noisy: Callable[[Signals], Signals]
    ) -> list[Signals]:
        """What is written of every run: readings of faulty instruments, noise, what the recorder makes of both."""
        faults = [one for one in effects if isinstance(one, Fault)]
        written = []
        for trial in self.plan:
            time, right = self.before_faults(trial, effects, self.values)
            shown = disturbed([fault for fault in faults if not fault.after_noise], time, right)
            read = noisy({name: self._sampled(trial, time, shown[name]) for name in self.signals})
            written.append(
                disturbed([fault for fault in faults if fault.after_noise], trial.recorded, read)
            )
        return written

    def before_faults(
        self, trial: Trial, effects: Sequence[Effect | Fault], values: Mapping[str, float]
    ) -> tuple[Array, Signals]:
        """As `RigBench.before_faults`, without doing the same work twice."""
        key = (id(trial), tuple(effects), tuple(values.items()))
        if key not in self.done:
            self.done[key] = (trial, self.design.rig.before_faults(values, trial, effects, _RTOL))
        return self.done[key][1]

    def roles(self) -> Array:
        """For every sample of every run in order: whether it is of role fit; shape (samples,)."""
        return np.concatenate(
            [np.full(len(trial.recorded), trial.role == "fit") for trial in self.plan]
        )

    def driven(self, effects: Sequence[Effect | Fault] = ()) -> Setup:
        """The same with the currents of its controllers, which meet these effects."""
        if not self.loops:
            return self
        held = {"Isometric": 5e-3, "SwitchedMuscle": 1e-3}.get(self.design.bench)
        physics = [effect for effect in effects if isinstance(effect, Effect)]
        plan = list(self.plan)
        for k, loop in self.loops.items():
            trial = plan[k]
            true = {**self.values, **trial.values}
            for effect in physics:
                true = {name: effect.in_truth(name, value) for name, value in true.items()}
            muscle = muscle_of(true)
            further = None if held is None or trial.course is None else (trial.course, held)
            told = closed_loop(loop, muscle, true["p_supply"], further, physics)
            plan[k] = replace(trial, schedules=(told,))
        return replace(self, plan=tuple(plan))


def muscle_of(
    values: Mapping[str, float], muscle: str = "muscle", valve: str = "valve"
) -> MuscleParameters:
    """The simulator's muscle of a bench's values."""
    names = {
        "length": "L0", "diameter": "D0", "turns": "turns", "fibres": "fibres", "t_wall": "t_wall", "mu_fb": "mu_fb",
        "mu_d": "mu_d", "h_film": "h_film", "n_g": "n_g",
    }  # fmt: skip
    given = {
        own: values[f"{muscle}.{name}"]
        for own, name in names.items()
        if f"{muscle}.{name}" in values
    }
    given |= {
        own: values[name]
        for own, name in (("calibration", f"{valve}.C_A"), ("load", "load.m"))
        if name in values
    }
    return MuscleParameters(**given)


def draw_design(rng: Random, bench: str) -> Design:
    """What is measured, how fast and how often."""
    choice, weights = zip(*SIGNALS[bench], strict=True)
    signals = choice[int(rng.choice(len(choice), p=weights))]
    rates = RATES.get(bench, _RATES)
    rate, runs = rates[int(rng.integers(len(rates)))], RUNS[int(rng.integers(len(RUNS)))]
    shortest = _SECONDS.get(bench, _USUAL_SECONDS)[0]
    runs = max(1, min(runs, int(SAMPLES / (1.2 * shortest * rate))))
    free_dimensions = {
        "Isotonic": ("muscle.D0", "muscle.L0", "load.m"), "Isometric": ("muscle.D0", "muscle.L0"),
    }.get(bench, (None,))  # fmt: skip
    sixth = free_dimensions[int(rng.integers(len(free_dimensions)))]
    if signals == ("p",):
        sixth = None
    return Design(bench, signals, rate, runs, sixth)


def draw(rng: Random, design: Design) -> Setup:
    """Geometry, plan and free parameters, whose truth is not where a fit starts. Controllers are not driven yet."""
    return _DRAWN[design.bench](rng, design)


# --- what all benches share -------------------------------------------------------------------------------


def _round(value: float, digits: int = 4) -> float:
    return float(f"{value:.{digits}g}")


def _log(rng: Random, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(*np.log((low, high)))))


def _roles(count: int) -> list[str]:
    judging = 0 if count == 1 else max(1, round(count / 3))
    return ["fit"] * (count - judging) + ["holdout"] * judging


def _clocks(rng: Random, design: Design) -> list[Clock]:
    """Of each run: shorter ones where there are many or the rate is high."""
    low, high = _SECONDS.get(design.bench, _USUAL_SECONDS)
    high = min(high, max(low * 1.1, SAMPLES / (design.rate * design.runs)))
    return [
        Clock(round(float(rng.uniform(low, high)) * design.rate) + 1, design.rate)
        for _ in range(design.runs)
    ]


def _style(rng: Random, k: int, styles: Sequence[str]) -> str:
    """The first run is a step, so that every plan fills and vents as a whole."""
    return styles[0] if k == 0 else styles[int(rng.integers(len(styles)))]


def _free(
    rng: Random, rows: Sequence[tuple[str, float, float, float]], values: dict[str, float]
) -> tuple[FreeParameter, ...]:
    """(name, low, high, truth) of parameters whose start is the bench's own default; the truth goes into values."""
    free = []
    for name, low, high, true in rows:
        values[name] = _round(true, 5)
        free.append(FreeParameter(name, name, low, high, values[name]))
    return tuple(free)


def _near(
    rng: Random, name: str, off: float, room: float, values: dict[str, float]
) -> FreeParameter:
    """A dimension that is stated with an error of up to `off` and free within `room`; the truth goes into values."""
    about = values[name]
    values[name] = _round(about * (1 + rng.uniform(-off, off)), 5)
    return FreeParameter(name, name, about * (1 - room), about * (1 + room), values[name], about)


def draw_geometry(rng: Random) -> dict[str, float]:
    """A muscle of 100 to 600 mm, 10 to 30 mm thick and slender, with a braid angle of 21 to 30 degrees at rest."""
    length = round(_log(rng, 0.1, 0.6), 3)
    diameter = round(float(np.clip(_log(rng, 0.01, 0.03), length / 28, length / 7)), 4)
    return {
        "muscle.L0": length,
        "muscle.D0": diameter,
        "muscle.turns": round(turns_of(length, diameter, np.deg2rad(rng.uniform(21.0, 30.0))), 2),
        "muscle.fibres": float(round(216 * diameter / 0.02)),
        "muscle.t_wall": round(float(rng.uniform(0.2e-3, 0.8e-3)), 6),
    }


def _valve_scale(volume: float, seconds: float) -> tuple[float, float]:
    """Factor on valves for large muscles or short runs, and what current-driven ones then open of it at 0.35 A."""
    wanted = volume / 7.5e-5 * 7.0 / seconds
    scale = float(np.clip(wanted / 2.0, 1.0, 3.0))
    return scale, float(np.clip(wanted / scale, 0.05, 2.2))


def _current(rng: Random, share: float) -> float:
    """A current that fills this muscle about as fast as the paper's is filled by 0.22 to 0.36 A."""
    return round(drives.SHUT + 0.205 * float(min(rng.uniform(0.5, 1.25) * share, 2.2)), 4)


_LOOP_STEP = 0.02  # s, at least


def _loop(rng: Random, clock: Clock, signal: str, top: float, switching: bool) -> Loop:
    """A controller of pressure or contraction up to `top` [SI]."""
    step = max(1, round((0.004 if switching else _LOOP_STEP) * clock.rate)) / clock.rate
    instants = np.arange(int(np.ceil(clock.seconds / step)) + 1) * step
    wanted = drives.reference(rng, instants, 0.15 * top, 0.85 * top)
    gain = rng.uniform(0.15, 0.5) / (0.4 * top)
    return Loop(
        signal, wanted, step, 0.004 * top, int(rng.integers(2**31)), gain, gain * rng.uniform(0.2, 1.0),
        switching=0.03 * top if switching else None,
    )  # fmt: skip


_SHUT_VALVES = Schedule.of([])


def _told(rng: Random, clock: Clock, style: str, amount: Callable[[], float]) -> Schedule:
    return (HELD.get(style) or JOINED[style])(rng, clock, amount)


# --- each bench -------------------------------------------------------------------------------------------


def _film_and_friction(
    rng: Random, design: Design, forces: bool
) -> list[tuple[str, float, float, float]]:
    """Free parameters of a muscle that the measured signals can say something of."""
    rows = [("muscle.h_film", 2.0, 100.0, _log(rng, 10.0, 45.0))]
    if "T" in design.signals:
        rows.append(("muscle.n_g", 1.0, 1.4, rng.uniform(1.06, 1.34)))
    if forces:
        rows.append(("muscle.mu_fb", 0.002, 0.06, rng.uniform(0.008, 0.03)))
        rows.append(("muscle.mu_d", 0.1, 2.0, rng.uniform(0.5, 1.1)))
    return rows


def _muscle_setup(rng: Random, design: Design) -> Setup:
    """Isotonic, Isometric and SwitchedMuscle: one muscle with valves."""
    values = draw_geometry(rng)
    clocks = _clocks(rng, design)
    rest = muscle_of(values)
    switched, lifts = design.bench == "SwitchedMuscle", design.bench == "Isotonic"
    seconds = float(np.mean([clock.seconds for clock in clocks]))
    if switched:
        scale, share = rest.volume(0.0) / 7.5e-5 * 0.4 / seconds, 1.0
        true = float(np.clip(0.45 * scale, 0.21, 1.7)) * rng.uniform(0.8, 1.25)
        valve = ("valve.C_A", true * 0.6, true * 1.6, true)
    else:
        scale, share = _valve_scale(rest.volume(0.0), seconds)
        valve = ("valve.C_A", 0.5 * scale, 0.9 * scale, rng.uniform(0.58, 0.84) * scale)
    free = list(
        _free(
            rng,
            [valve, *_film_and_friction(rng, design, bool({"x", "F"} & {*design.signals}))],
            values,
        )
    )
    if not lifts:
        values.setdefault("muscle.mu_fb", 0.015)
    if design.sixth and design.sixth != "load.m":
        free.append(
            _near(
                rng,
                design.sixth,
                *((0.02, 0.05) if design.sixth == "muscle.D0" else (0.01, 0.03)),
                values,
            )
        )
    if valve[0] == "valve.C_A" and (switched or scale > 1.0):
        free[0] = replace(free[0], nominal=_round(float(np.sqrt(valve[1] * valve[2]))))
    muscle = muscle_of(values)
    plan, loops = [], {}
    pull = rest.volume_slope(0.0)
    common = round(float(rng.uniform(0.1, 0.8)) * 0.4 * pull * 1.2e5 / G, 3)
    if design.sixth == "load.m":
        values["load.m"] = common
        free.append(_near(rng, "load.m", 0.04, 0.1, values))
    styles = (*HELD, "closed_loop") if switched else (*HELD, *JOINED, "closed_loop", "closed_loop")
    for k, (clock, role) in enumerate(zip(clocks, _roles(design.runs), strict=True)):
        p_supply = float(rng.integers(12, 31)) * 1e4 * (1.5 if switched else 1.0)
        own = {"p_supply": p_supply}
        style = _style(rng, k, styles)
        course = None
        if lifts and design.sixth != "load.m":
            own["load.m"] = round(float(rng.uniform(0.12, 0.9)) * 0.4 * pull * p_supply / G, 3)
        if not lifts:
            bend = ("constant", "sine", "triangles", "random")[int(rng.integers(4))]
            course = drives.course(rng, clock, bend, 0.0, 0.16 * values["muscle.L0"])
        schedule = _SHUT_VALVES
        if style == "closed_loop":
            signal = "x" if lifts and rng.random() < 0.5 else "p"
            load = own.get("load.m", values.get("load.m", 0.0)) if lifts else 0.0
            # with this load the muscle gets about as far as its pull at rest allows
            reach = 0.2 * values["muscle.L0"] * max(0.2, 1 - load * G / (pull * p_supply))
            loops[k] = _loop(
                rng, clock, signal, reach if signal == "x" else 0.9 * p_supply, switched
            )
        else:
            amount = (lambda: 1.0) if switched else partial(_current, rng, share)
            schedule = _told(rng, clock, style, amount)
        plan.append(Trial(style, role, clock.samples, clock.rate, (schedule,), course, own))
    return Setup(design, values, tuple(free), tuple(plan), muscle, loops)


def _pair_setup(rng: Random, design: Design) -> Setup:
    one = draw_geometry(rng)
    own = {name.partition(".")[2]: value for name, value in one.items()}
    values = {f"muscle_{k}.{name}": value for k in (1, 2) for name, value in own.items()}
    clocks = _clocks(rng, design)
    rest = muscle_of(one)
    scale, share = _valve_scale(
        rest.volume(0.0), float(np.mean([clock.seconds for clock in clocks]))
    )
    length = own["L0"]
    values |= {
        "pulley.r": round(0.1 * length, 4), "pulley.x_0": round(0.11 * length, 4),
        "pulley.J": _round(_log(rng, 0.5, 3.0) * (0.1 * length) ** 2, 3),
    }  # fmt: skip
    rows = [
        (f"valve_{k}.C_A", 0.5 * scale, 0.9 * scale, rng.uniform(0.58, 0.84) * scale)
        for k in (1, 2)
    ]
    if "x" in design.signals:
        rows += [(f"muscle_{k}.mu_fb", 0.002, 0.06, rng.uniform(0.008, 0.03)) for k in (1, 2)]
        turned = values["pulley.r"] ** 2 * rest.volume_slope(0.0) * 1e5 / (0.1 * length)
        damping = turned * rng.uniform(0.02, 0.08)
        rows.append(("pulley.d", 0.0, 6 * damping, damping))
    free = list(_free(rng, rows, values))
    starts = {f"valve_{k}.C_A": 0.7 * scale for k in (1, 2)}
    if "x" in design.signals:
        starts["pulley.d"] = _round(rows[-1][2] / 4)
    free = [replace(p, nominal=_round(starts[p.name])) if p.name in starts else p for p in free]
    plan = []
    for k, (clock, role) in enumerate(zip(clocks, _roles(design.runs), strict=True)):
        style = _style(rng, k, (*HELD, *JOINED))
        kinds = HELD if style in HELD else JOINED
        second = list(kinds)[int(rng.integers(len(kinds)))]
        amount = partial(_current, rng, share)
        schedules = (_told(rng, clock, style, amount), _told(rng, clock, second, amount))
        p_supply = float(rng.integers(12, 31)) * 1e4
        plan.append(
            Trial(style, role, clock.samples, clock.rate, schedules, None, {"p_supply": p_supply})
        )
    return Setup(design, values, tuple(free), tuple(plan), rest)


def _vertical_setup(rng: Random, design: Design) -> Setup:
    """Loads and frequencies of the runs differ, as in DY Table 3; the muscle's pull bounds the load."""
    length = round(_log(rng, 0.15, 0.6), 3)
    diameter = round(float(np.clip(_log(rng, 0.015, 0.03), length / 28, length / 7)), 4)
    angle = round(float(np.deg2rad(rng.uniform(21.0, 26.0))), 5)
    values = {"muscle.L0": length, "muscle.D0": diameter, "muscle.alpha_0": angle}
    pull = pi * diameter**2 / 4 * 1.2 * 4e5 * (3 / np.tan(angle) ** 2 - 1 / np.sin(angle) ** 2)
    dimension = _near(rng, "muscle.D0", 0.02, 0.1, values)
    size = pull / 1500.0
    rows = [
        ("muscle.friction.c_c", 0.0, 100.0, size * rng.uniform(3.0, 10.0)),
        ("muscle.friction.c_v", 0.0, 2000.0, size * rng.uniform(5.0, 60.0)),
    ]
    free = (dimension, *_free(rng, rows, values))
    heaviest, plan = 0.3 * pull / G, []
    for clock, role in zip(_clocks(rng, design), _roles(design.runs), strict=True):
        frequency = (0.5, 1.0, 1.5, 2.0)[int(rng.integers(4))]
        own = {"load.m": round(float(rng.uniform(0.12, 1.0)) * heaviest, 2), "frequency": frequency}
        draw = rng.random()
        if draw < 0.6:
            style, course = "waves", drives.waves(rng, clock, frequency, 4e5)
        else:
            style = "sine" if draw < 0.8 else "random"
            course = drives.course(rng, clock, style, 0.0, float(rng.uniform(2e5, 4e5)))
        plan.append(Trial(style, role, clock.samples, clock.rate, (), course, own))
    turns = turns_of(length, values["muscle.D0"], angle)
    muscle = MuscleParameters(length=length, diameter=values["muscle.D0"], turns=turns, t_wall=1e-3)
    return Setup(design, values, free, tuple(plan), muscle)


def _vessel_muscle(volume: float) -> MuscleParameters:
    """What forms ask of a muscle, for a vessel: its volume, and a wall of 10 mm of steel."""
    diameter = (2 * volume / pi) ** (1 / 3)
    return MuscleParameters(
        length=2 * diameter, diameter=diameter, turns=1.0, t_wall=0.01, k_wall=50.0
    )


def _filling_setup(rng: Random, design: Design) -> Setup:
    values = {"tank.V": _round(_log(rng, 1e-4, 1.5e-3), 3)}
    clocks = _clocks(rng, design)
    seconds = float(np.mean([clock.seconds for clock in clocks]))
    # 2.1 L take 60 s at 0.35 A
    wanted = 60.0 * values["tank.V"] / 2.1e-3 / (0.35 * seconds)
    scale = float(np.clip(wanted / 2.0, 1.0, 3.0))
    share = float(np.clip(wanted / scale, 0.2, 2.2))
    rows = [("valve.C_A", 0.5 * scale, 0.9 * scale, rng.uniform(0.58, 0.84) * scale),
            ("tank.n", 1.0, 1.4, rng.uniform(1.06, 1.34))]  # fmt: skip
    free = list(_free(rng, rows, values))
    if scale > 1.0:
        free[0] = replace(free[0], nominal=_round(0.7 * scale))
    plan = []
    for k, (clock, role) in enumerate(zip(clocks, _roles(design.runs), strict=True)):
        style = _style(rng, k, (*HELD, *JOINED))
        schedule = _told(rng, clock, style, partial(_current, rng, share))
        p_supply = float(rng.integers(12, 51)) * 1e4
        plan.append(
            Trial(style, role, clock.samples, clock.rate, (schedule,), None, {"p_supply": p_supply})
        )
    return Setup(design, values, tuple(free), tuple(plan), _vessel_muscle(values["tank.V"]))


def _orifice_setup(rng: Random, design: Design) -> Setup:
    volume = _round(_log(rng, 2e-4, 1.5e-2), 3)
    clocks = _clocks(rng, design)
    # choked from 6 bar, a vessel empties in about 5 V/(C_d A 200 m/s)
    area = 5 * volume / (0.8 * 200.0 * 0.5 * float(np.mean([clock.seconds for clock in clocks])))
    values = {
        "tank.V": volume,
        "orifice.d": _round(2 * np.sqrt(area / pi), 3),
        "tank.T_start": 293.15,
    }
    rows = [
        ("orifice.C_d", 0.5, 1.0, rng.uniform(0.62, 0.92)),
        ("tank.n", 1.0, 1.4, rng.uniform(1.08, 1.36)),
    ]
    free = _free(rng, rows, values)
    plan = []
    for k, (clock, role) in enumerate(zip(clocks, _roles(design.runs), strict=True)):
        filling = k > 0 and rng.random() < 0.3
        high = float(rng.integers(20, 80)) * 1e4
        own = (
            {"tank.p_start": 0.0, "p_outside": high}
            if filling
            else {"tank.p_start": high, "p_outside": 0.0}
        )
        style = "filling" if filling else "discharge"
        plan.append(Trial(style, role, clock.samples, clock.rate, (), None, own))
    return Setup(design, values, free, tuple(plan), _vessel_muscle(volume))


_DRAWN: dict[str, Callable[[Random, Design], Setup]] = {
    "Isotonic": _muscle_setup, "Isometric": _muscle_setup, "SwitchedMuscle": _muscle_setup,
    "Antagonistic": _pair_setup, "VerticalLoad": _vertical_setup, "TankFilling": _filling_setup,
    "VesselOrifice": _orifice_setup,
}  # fmt: skip
