"""One muscle, every effect that the simulator knows by name, and a first recording of three seconds."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.deciding_run.scene import Scene
from pam_cosim.arrays import Array
from pam_cosim.diagnosis.planning import Limits
from pam_cosim.measurement import DataSet, FreeParameter, Run, Signal, Start
from rig.effect import Effect
from rig.measurement import BOUNDS, TRUTH, Noise
from rig.muscle import simulate_muscle
from rig.named import EFFECTS
from rig.plan import random_plan
from rig.played import PlayedSchedule
from rig.schedule import Schedule

SECONDS, INTERVAL = 3.0, 0.06  # s
UNITS = {"p": "Pa", "x": "m", "T": "K"}
SIGNALS = (("p", "x"), ("p", "x", "T"))  # every other case has a thermocouple
LIMITS = {"u_in": (0.0, 0.36), "u_out": (0.0, 0.36), "p_supply": (1e5, 3e5)}
LOADS = (1.0, 6.0)  # kg


def is_asked(number: int) -> bool:
    """Every case is."""
    return number >= 0


def scene(number: int) -> Scene:
    """A case: its number says which effect is hidden, and what was recorded first."""
    effect = EFFECTS[1 + number % (len(EFFECTS) - 1)]()
    signals = SIGNALS[number // (len(EFFECTS) - 1) % len(SIGNALS)]
    (run,) = random_plan(number, fits=1, holdouts=0)
    time = np.arange(round(SECONDS / INTERVAL) + 1) * INTERVAL
    times, currents = _stepped(run.schedule, time)
    inputs = {
        "u_in": currents[:, 0],
        "u_out": currents[:, 1],
        "p_supply": np.full(len(times), run.p_supply),
    }
    blank = {name: np.full(len(times), np.nan) for name in signals}
    first = Run(
        "run-01",
        Path("run-01.csv"),
        "fit",
        "linear",
        {"load.m": run.load},
        times,
        inputs,
        blank,
        start=Start("rest"),
    )
    recorded = _played(effect, signals, first, [number, 1])
    sigma = Noise().as_dict()
    data = DataSet(
        Path("rig"),
        f"case {number}",
        "PneumaticMuscle.Benches.Isotonic",
        {name: Signal(name, UNITS[name], sigma[name]) for name in signals},
        {},
        {name: FreeParameter(name, low, high, unit="1") for name, (low, high) in BOUNDS.items()},
        (recorded,),
    )
    infinite, nothing = dict.fromkeys(LIMITS, np.inf), dict.fromkeys(LIMITS, 0.0)
    limits = Limits(
        LIMITS, frozenset({"p_supply"}), infinite, nothing, {"load.m": LOADS}, {}, SECONDS, INTERVAL
    )
    description = {
        "group": "catalogue",
        "families": [effect.family],
        "hidden": [effect.form],
        "bench": "Isotonic",
    }
    return Scene(
        description,
        data,
        limits,
        lambda further, *more: _played(effect, signals, further, [number, 2, *more]),
        number,
    )


def _stepped(schedule: Schedule, time: Array) -> tuple[Array, Array]:
    """Times with two rows at each switch, and (n, 2) currents."""
    switches = np.array([t for t in schedule.starts if 0 < t < time[-1]])
    times = np.sort(np.concatenate([time, switches, switches]))
    first_of_two = np.append(np.diff(times) == 0, False)
    currents = [
        schedule.at(t - 1e-6 if before else t)
        for t, before in zip(times, first_of_two, strict=True)
    ]
    return times, np.array(currents)


def _played(effect: Effect, signals: tuple[str, ...], run: Run, seed: list[int]) -> Run:
    """A run with its samples, at whole intervals, and the noise of the instruments."""
    last = np.append(np.diff(run.time) > 0, True)
    on_grid = np.isclose(run.time / INTERVAL, np.round(run.time / INTERVAL), atol=1e-6) & last
    samples = run.time[on_grid]
    schedule = PlayedSchedule.of_table(
        run.time, list(zip(run.inputs["u_in"], run.inputs["u_out"], strict=True))
    )
    muscle = replace(TRUTH, load=run.parameters["load.m"])
    t = simulate_muscle(muscle, float(run.inputs["p_supply"][0]), schedule, samples, [effect])
    clean, rng, sigma = (
        {"p": t.p, "x": t.x, "T": t.temperature},
        np.random.default_rng(seed),
        Noise().as_dict(),
    )
    measurements = {}
    for name in signals:
        column = np.full(len(run.time), np.nan)
        column[on_grid] = clean[name] + sigma[name] * rng.standard_normal(len(samples))
        measurements[name] = column
    return replace(run, measurements=measurements, start=Start("rest"))
