"""The benches that the rig has: how each is simulated, what is told to it and read of it, what may be hidden on it.

Parameters and inputs have the names of the library's benches, in SI units; the simulators behind have their own.
An effect can be hidden where each of its hooks (the methods of `Effect` that it overrides, and what it reads of the
state of the rig) is one that the bench has: this is asked of the effect's code, not listed form by form.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from math import tan

import numpy as np

from rig.effect import Effect, LineEffect, Now
from rig.flow import P_ATM
from rig.held import simulate_held, switched
from rig.instruments import Fault, disturbed
from rig.integrate import Array
from rig.muscle import MuscleParameters, simulate_muscle
from rig.pair import PulleyParameters, simulate_pair
from rig.schedule import Schedule
from rig.states import REST, now_at
from rig.tank import Vessel, orifice_port, simulate_vessel, valve_ports
from rig.trial import Trial
from rig.vertical import EmpiricalParameters, simulate_vertical

Signals = dict[str, Array]
Values = Mapping[str, float]
Simulation = Callable[[Values, Trial, Array, Sequence[Effect], float], Signals]

FINE = 1000.0  # Hz, at least, where an instrument's fault takes signals as straight between samples
LONGER = 0.5  # s, beyond the end of a run, for a recorder whose clock is early


@dataclass(frozen=True)
class RigBench:
    """One bench.

    Attributes:
        name: of the library's bench. model: class that experiment.toml names: the bench, or the one that is there
            before an effect is found.
        outputs: signals in order. inputs: with the names of the columns; currents of a pair of valves first.
        course: the input that moves along `Trial.course`, if there is one.
        has: hooks of `Effect`, and fields of `Now`, that act on this bench, each with the signals of which at least
            one has to be measured for it to be seen.
        simulation: (values, trial, times, effects, rtol) -> signals.
        itself: forms (family:form) that its model has, with parameters that are free; hiding them hides nothing.
    """

    name: str
    model: str
    outputs: tuple[str, ...]
    inputs: tuple[str, ...]
    course: str | None
    has: Mapping[str, frozenset[str]]
    simulation: Simulation
    itself: frozenset[str] = frozenset()

    def simulate(
        self,
        values: Values,
        trial: Trial,
        hidden: Sequence[Effect | Fault] = (),
        rtol: float = 1e-6,
    ) -> Signals:
        """Noise-free signals of one run at its samples, through instruments with their faults.

        values: all parameters, as stated. Raises RuntimeError when the run cannot be simulated.
        """
        faults = [fault for fault in hidden if isinstance(fault, Fault)]
        time, clean = self.before_faults(values, trial, hidden, rtol)
        shown = disturbed(faults, time, clean)
        return {name: np.interp(trial.times, time, y) if faults else y for name, y in shown.items()}

    def before_faults(
        self,
        values: Values,
        trial: Trial,
        hidden: Sequence[Effect | Fault] = (),
        rtol: float = 1e-6,
    ) -> tuple[Array, Signals]:
        """Times [s] and signals as right instruments would show them; finer and longer where some are not right."""
        effects = [effect for effect in hidden if isinstance(effect, Effect)]
        times = trial.times
        if len(effects) < len(hidden):
            rate = trial.rate * np.ceil(FINE / trial.rate)
            times = np.arange(round((times[-1] + LONGER) * rate) + 1) / rate
        true = {**values, **trial.values}
        for effect in effects:
            true = {name: effect.in_truth(name, value) for name, value in true.items()}
        signals = self.simulation(true, trial, times, effects, rtol)
        if not all(np.isfinite(y).all() for y in signals.values()):
            raise RuntimeError("the simulation left the numbers")
        return times, signals

    def takes(self, hidden: Effect | Fault, measured: Sequence[str]) -> bool:
        """Whether this can be hidden here, and be seen in the signals that are measured."""
        if isinstance(hidden, Fault):
            return getattr(hidden, "signal", measured[0]) in measured
        needed = hooks(hidden)
        if f"{hidden.family}:{hidden.form}" in self.itself:
            return False
        return all(hook in self.has and self.has[hook] & set(measured) for hook in needed)


class _Watched:
    """The state of a rig that notes what is read of it."""

    def __init__(self, now: Now) -> None:
        self._now = now
        self.read: set[str] = set()

    def __getattr__(self, name: str) -> object:
        self.read.add(name)
        return getattr(self._now, name)


@cache
def hooks(effect: Effect) -> frozenset[str]:
    """The methods of `Effect` that an effect overrides, and ``now.NAME`` for each field of `Now` that it reads."""
    own = {
        name for name in vars(Effect)
        if not name.startswith("_") and callable(getattr(Effect, name)) and name not in ("initial", "rates")
        and getattr(type(effect), name) is not getattr(Effect, name)
    }  # fmt: skip
    if isinstance(effect, LineEffect):
        return frozenset({*own, "node"})
    watched = _Watched(
        now_at(x=0.01, v=0.01, p_gauge=1e5, temperature=300.0, u=0.3, flow=1e-5, heat=0.1)
    )
    effect.rates(effect.initial(REST), watched)  # type: ignore[arg-type]
    return frozenset(own | {f"now.{name}" for name in watched.read})


def _seen(hooks_of: Mapping[str, str]) -> dict[str, frozenset[str]]:
    """``{"p x": "leak delay"}`` -> for each hook the signals that show it."""
    return {hook: frozenset(s.split()) for s, names in hooks_of.items() for hook in names.split()}


_VALVES = "current areas valve_factor delay drive now.command"
_OPENINGS = "opening now.areas"
_GAS = "leak exchange extra_volume now.p_gauge now.temperature now.net_mass_flow now.heat_to_gas now.x now.v"
_HEAT = "film temperature wall_temperature friction_heat heat reading"
_FORCE = "force shape_factor pull_factor"
_MASSES = "hanging_mass resting_mass balanced_mass"


def _muscle(values: Values, muscle: str = "muscle", valve: str = "valve") -> MuscleParameters:
    return MuscleParameters(
        calibration=values.get(f"{valve}.C_A", 0.699),
        length=values[f"{muscle}.L0"],
        diameter=values[f"{muscle}.D0"],
        turns=values[f"{muscle}.turns"],
        fibres=values[f"{muscle}.fibres"],
        mu_fb=values.get(f"{muscle}.mu_fb", 0.015),
        mu_d=values.get(f"{muscle}.mu_d", 0.8),
        t_wall=values[f"{muscle}.t_wall"],
        h_film=values.get(f"{muscle}.h_film", 20.0),
        n_g=values.get(f"{muscle}.n_g", 1.2),
        load=values.get("load.m", 2.27),
    )


def _isotonic(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    (schedule,) = trial.schedules
    t = simulate_muscle(_muscle(values), values["p_supply"], schedule, times, effects, rtol, "BDF")
    return {"p": t.p, "x": t.x, "T": t.temperature}


def _isometric(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    assert trial.course is not None
    (schedule,) = trial.schedules
    t = simulate_held(
        _muscle(values), values["p_supply"], schedule, trial.course, times, effects, 5e-3, rtol
    )
    return {"p": t.p, "F": t.pull, "T": t.temperature}


def _switched(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    assert trial.course is not None
    schedule = switched(trial.schedules[0])
    t = simulate_held(
        _muscle(values), values["p_supply"], schedule, trial.course, times, effects, 1e-3, rtol
    )
    return {"p": t.p, "T": t.temperature}


def _antagonistic(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    muscles = [_muscle(values, f"muscle_{k}", f"valve_{k}") for k in (1, 2)]
    wheel = {"radius": "r", "inertia": "J", "friction": "d", "contraction": "x_0"}
    given = {
        own: values[f"pulley.{name}"] for own, name in wheel.items() if f"pulley.{name}" in values
    }
    t = simulate_pair(
        muscles, PulleyParameters(**given), values["p_supply"], trial.schedules, times, effects, rtol
    )  # fmt: skip
    return {"p_1": t.p_1, "p_2": t.p_2, "x": t.x}


def _vertical(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    assert trial.course is not None
    parameters = EmpiricalParameters(
        length=values["muscle.L0"],
        diameter=values["muscle.D0"],
        angle=values["muscle.alpha_0"],
        coulomb=values["muscle.friction.c_c"],
        viscous=values["muscle.friction.c_v"],
        load=values["load.m"],
        frequency=values["frequency"],
    )
    return {"x": simulate_vertical(parameters, trial.course, times, effects, rtol).x}


def _filling(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    vessel = Vessel(values["tank.V"], values["tank.n"])
    ports = valve_ports(values["p_supply"], values["valve.C_A"], effects)
    t = simulate_vessel(vessel, ports, times, 0.0, trial.schedules[0], effects, min(rtol, 1e-7))
    return {"p": t.p, "T": t.temperature}


def _orifice(
    values: Values, trial: Trial, times: Array, effects: Sequence[Effect], rtol: float
) -> Signals:
    vessel = Vessel(
        values["tank.V"], values["tank.n"], values["tank.p_start"] + P_ATM, values["tank.T_start"]
    )
    port = orifice_port(values["orifice.d"], values["orifice.C_d"], values["p_outside"])
    t = simulate_vessel(
        vessel, port, times, values["tank.p_start"], Schedule((), ()), effects, min(rtol, 1e-7)
    )
    return {"p": t.p, "T": t.temperature}


_PACKAGE = "PneumaticMuscle."
BENCHES: dict[str, RigBench] = {
    bench.name: bench
    for bench in (
        RigBench(
            "Isotonic", f"{_PACKAGE}Benches.Isotonic", ("p", "x", "T"), ("u_in", "u_out", "p_supply"), None,
            _seen({
                "p": f"{_VALVES} {_OPENINGS} {_GAS} supply node pressure_shown in_truth", "T": _HEAT,
                "x": f"{_FORCE} {_MASSES} position_shown",
            }),
            _isotonic,
        ),
        RigBench(
            "Isometric", f"{_PACKAGE}Benches.Isometric", ("p", "F", "T"), ("u_in", "u_out", "p_supply", "s"), "s",
            _seen({"p": f"{_VALVES} {_OPENINGS} {_GAS} supply node pressure_shown in_truth", "T": _HEAT, "F": _FORCE}),
            _isometric,
        ),
        RigBench(
            "SwitchedMuscle", f"{_PACKAGE}Benches.SwitchedMuscle", ("p", "T"), ("u_in", "u_out", "p_supply", "s"), "s",
            _seen({"p": f"{_VALVES} {_OPENINGS} {_GAS} supply node pressure_shown in_truth", "T": _HEAT}),
            _switched,
        ),
        RigBench(
            "Antagonistic", f"{_PACKAGE}Benches.Antagonistic", ("p_1", "p_2", "x"),
            ("u_in_1", "u_out_1", "u_in_2", "u_out_2", "p_supply"), None,
            _seen({
                "p_1": f"{_VALVES} {_OPENINGS} {_GAS} supply pressure_shown in_truth",
                "x": f"{_FORCE} {_MASSES} position_shown",
            }),
            _antagonistic,
        ),
        RigBench(
            "VerticalLoad", f"{_PACKAGE}Examples.ConstantFrictionLoad", ("x",), ("p",), "p",
            _seen({"x": f"force {_MASSES} position_shown in_run in_truth now.x now.v now.p_gauge now.temperature"}),
            _vertical, frozenset({"rate_friction:viscous", "dry_friction:coulomb"}),
        ),
        RigBench(
            "TankFilling", f"{_PACKAGE}Benches.TankFilling", ("p", "T"), ("u_in", "u_out", "p_supply"), None,
            _seen({
                "p": f"{_VALVES} leak node pressure_shown film temperature in_truth now.p_gauge now.temperature "
                     "now.net_mass_flow now.heat_to_gas",
                "T": "reading",
            }),
            _filling,
        ),
        RigBench(
            "VesselOrifice", f"{_PACKAGE}Benches.VesselOrifice", ("p", "T"), (), None,
            _seen({
                "p": "leak pressure_shown film temperature in_truth now.p_gauge now.temperature now.net_mass_flow "
                     "now.heat_to_gas",
                "T": "reading",
            }),
            _orifice,
        ),
    )
}  # fmt: skip
"""By name."""


def turns_of(length: float, diameter: float, angle: float) -> float:
    """Turns of a fibre [-] round a sleeve of this length and diameter [m] at this braid angle [rad] at rest."""
    return tan(angle) * length / (np.pi * diameter)
