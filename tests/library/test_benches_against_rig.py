"""The benches of the library against the independent rig's programs of the same physics, without noise."""

from __future__ import annotations

from math import radians

import numpy as np
import pytest

from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Inputs, Simulator
from rig.benches import BENCHES, Signals, turns_of
from rig.catalogue.creep import Creep
from rig.catalogue.elasticity import LinearSpring
from rig.catalogue.gas_energy import GasEnergy
from rig.catalogue.leak import LaminarLeak
from rig.catalogue.rate_friction import LoadFrequency
from rig.catalogue.supply_line import LongTube
from rig.catalogue.thermocouple_lag import ThermocoupleLag
from rig.catalogue.valve_dynamics import ValveLag
from rig.effect import Effect
from rig.schedule import Course, Phase, SampledSchedule, Schedule
from rig.trial import Trial
from tests.library.catalogue import effects, on_bench, values
from tests.tiers import quick_but

TOLERANCE = {"p": 5.0, "p_1": 5.0, "p_2": 5.0, "x": 1e-7, "F": 0.01, "T": 2e-3}
"""Pa, m, N, K: a hundredth of what instruments show. Nearly equal pressures are regularised differently."""
SURFACES = 2.5 / (1.5 * 4 ** (1 / 3))
"""The library's tank is twice as long as wide, the rig's as long as wide: one inner surface over the other."""

MUSCLE = {
    "L0": 0.3,
    "D0": 0.022,
    "turns": turns_of(0.3, 0.022, radians(26)),
    "fibres": 200.0,
    "t_wall": 4e-4,
}
OWN = {"n_g": 1.25, "mu_fb": 0.012, "mu_d": 0.7, "h_film": 25.0}
WAVE = Course(tuple(0.025 * (1 - np.cos(2 * np.pi * 0.4 * k / 100)) for k in range(701)))
STEPS = Schedule.of(
    [Phase(1.2, u_in=0.35), Phase(0.8), Phase(0.7, u_out=0.3), Phase(0.8, u_in=0.28), Phase(9)]
)
OTHER = Schedule.of(
    [Phase(0.6, u_in=0.3), Phase(1.4), Phase(1.2, u_in=0.33), Phase(0.9, u_out=0.35), Phase(9)]
)
RAMPS = SampledSchedule.joined([(0.145 + 0.001 * min(k, 200), 0.0) for k in range(601)], 0.01)


def named(prefix: str, own: dict[str, float]) -> dict[str, float]:
    return {f"{prefix}.{name}": value for name, value in own.items()}


CASES: dict[str, tuple[str, dict[str, float], Trial]] = {
    "isometric": (
        "Isometric", {**named("muscle", MUSCLE | OWN), "valve.C_A": 0.7, "p_supply": 2.2e5},
        Trial("steps", "fit", 601, 100.0, (STEPS,), WAVE),
    ),
    "isometric_ramps": (
        "Isometric", {**named("muscle", MUSCLE | OWN), "valve.C_A": 0.8, "p_supply": 1.5e5},
        Trial("ramps", "fit", 601, 100.0, (RAMPS,), Course((0.02,))),
    ),
    "switched": (
        "SwitchedMuscle", {**named("muscle", MUSCLE | OWN), "valve.C_A": 0.22, "p_supply": 4.2e5},
        Trial("steps", "fit", 601, 500.0,
              (Schedule.of([Phase(0.1, 1.0), Phase(0.3), Phase(0.2, 0.0, 1.0), Phase(0.1, 1.0), Phase(9)]),),
              Course(tuple(0.03 * min(k, 300) / 300 for k in range(701)), 2e-3)),
    ),
    "antagonistic": (
        "Antagonistic",
        {**named("muscle_1", MUSCLE | {"mu_fb": 0.012}), **named("muscle_2", MUSCLE | {"mu_fb": 0.02, "L0": 0.31}),
         "valve_1.C_A": 0.7, "valve_2.C_A": 0.75, "pulley.r": 0.035, "pulley.x_0": 0.04, "pulley.d": 0.03,
         "p_supply": 2e5},
        Trial("steps", "fit", 601, 100.0, (STEPS, OTHER)),
    ),
    "vertical": (
        "VerticalLoad",
        {"muscle.L0": 0.34, "muscle.D0": 0.021, "muscle.alpha_0": radians(24), "muscle.friction.c_c": 6.0,
         "muscle.friction.c_v": 30.0},
        Trial("waves", "fit", 401, 50.0, (),
              Course(tuple(1.5e5 * (1 - np.cos(2 * np.pi * k / 50)) for k in range(401)), 0.02),
              {"load.m": 18.0, "frequency": 1.7}),
    ),
    "filling": (
        "TankFilling", {"tank.V": 4e-4, "tank.n": 1.15, "valve.C_A": 0.7, "p_supply": 2.5e5},
        Trial("steps", "fit", 401, 50.0, (STEPS,)),
    ),
    "discharge": (
        "VesselOrifice",
        {"tank.V": 2e-3, "tank.n": 1.25, "tank.T_start": 293.15, "orifice.d": 1.5e-3, "orifice.C_d": 0.8,
         "p_outside": 0.0},
        Trial("discharge", "fit", 401, 50.0, values={"tank.p_start": 6e5}),
    ),
}  # fmt: skip
HIDDEN: dict[str, tuple[str, Effect, str, dict[str, float]]] = {
    "held spring": ("isometric", LinearSpring(300.0), "LinearBladder", {"k": 300}),
    "held leak": ("isometric", LaminarLeak(3e-11), "LaminarLeak", {"G": 3e-11}),
    "line before switched muscle": (
        "switched",
        LongTube(5e-6, 1e-6),
        "LongLine",
        {"A": 1e-6, "V": 5e-6},
    ),
    "creep of two": ("antagonistic", Creep(300.0, 0.8), "MaxwellCreep", {"k": 300, "tau": 0.8}),
    "valves of two": ("antagonistic", ValveLag(0.05), "ValveLag", {"tau": 0.05}),
    "load and frequency": (
        "vertical",
        LoadFrequency(0.15, 0.34),
        "LoadFrequencyFriction",
        {"ab": 0.15},
    ),
    "line to tank": ("filling", LongTube(1e-5, 4e-7), "LongLine", {"A": 4e-7, "V": 1e-5}),
    "thermometer in vessel": ("discharge", ThermocoupleLag(0.3), "ThermocoupleLag", {"tau": 0.3}),
    "gas and wall": ("discharge", GasEnergy(10.0 * SURFACES), "EnergyGas", {"h": 10}),
}


def told(name: str, trial: Trial, stated: dict[str, float]) -> Inputs | None:
    """What is told as the library takes it: a step is two instants at one time."""
    bench = BENCHES[name]
    end = trial.times[-1]
    switches = {t for schedule in trial.schedules for t in schedule.starts if 0 < t < end}
    grid = {k / 100 for k in range(round(end * 100) + 1)} if not trial.held else {0.0, end}
    if trial.course is not None:
        grid |= {k * trial.course.step for k in range(len(trial.course.values))}
    rows = sorted(
        {(t, t) for t in grid if t <= end}
        | {(t, t - 1e-7) for t in switches}
        | {(t, t) for t in switches}
    )
    rows = sorted(rows, key=lambda row: row[1])
    columns: dict[str, list[float]] = {}
    for k, input_name in enumerate(bench.inputs):
        if input_name == bench.course:
            columns[input_name] = [trial.course.at(t)[0] for t, _ in rows]  # type: ignore[union-attr]
        elif input_name == "p_supply":
            columns[input_name] = [stated["p_supply"]] * len(rows)
        else:
            columns[input_name] = [
                trial.schedules[k // 2].at(at - 5e-8 if at < t else t)[k % 2] for t, at in rows
            ]
    if not columns:
        return None
    return Inputs(
        np.array([t for t, _ in rows]), {n: np.array(y) for n, y in columns.items()}, "linear"
    )


def differences(
    case: str, effect: str = "", own: dict[str, float] | None = None, hidden: Effect | None = None
) -> Signals:
    name, stated, trial = CASES[case]
    bench = BENCHES[name]
    expected = bench.simulate(stated, trial, [hidden] if hidden else [], rtol=1e-8)
    parameters = {n: v for n, v in {**stated, **trial.values}.items() if n != "p_supply"}
    if effect:
        composition = on_bench(effect, bench.model)
        member = next(e for e in effects() if e.name == effect)
        parameters |= values(member, composition, own or {})
        fmu = build_source(composition.name, composition.text, brief=True)
    else:
        fmu = build_model(bench.model, brief=True)
    with Simulator(fmu) as simulator:
        run = simulator.run(
            trial.times, parameters=parameters, inputs=told(name, trial, stated), tolerance=1e-8
        )
    assert all(np.ptp(expected[signal]) > 100 * TOLERANCE[signal] for signal in bench.outputs)
    return {signal: np.abs(run.values[signal] - expected[signal]) for signal in bench.outputs}


@pytest.mark.parametrize("case", quick_but(CASES, ("isometric", "vertical")))
def test_bench_is_the_rigs(case: str) -> None:
    away = differences(case)
    assert {n: float(y.max()) for n, y in away.items() if y.max() > TOLERANCE[n]} == {}


@pytest.mark.full
@pytest.mark.parametrize("name", HIDDEN)
def test_effect_on_a_bench_is_the_rigs(name: str) -> None:
    case, hidden, effect, own = HIDDEN[name]
    assert BENCHES[CASES[case][0]].takes(hidden, BENCHES[CASES[case][0]].outputs)
    away = differences(case, effect, own, hidden)
    assert {n: float(y.max()) for n, y in away.items() if y.max() > 4 * TOLERANCE[n]} == {}
