"""How much of a law that the independent rig obeys an effect of the library leaves in the readings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.simulation import Inputs, Simulator
from rig.effect import Effect
from rig.measurement import TRUTH, Noise
from rig.muscle import simulate_muscle
from rig.plan import Run, default_plan
from tests.library.shelf import BENCH, built, on_bench
from tests.library.spans import coefficients, misses

Array = np.ndarray
TIMES = np.linspace(0, 10, 501)
RUNS = (default_plan()[0], default_plan()[2])  # filled, held, vented; in parts under a small load
SIGMA = Noise().as_dict()


def left_of(
    law: Effect, effect: str, start: Mapping[str, float] | None = None
) -> tuple[float, float]:
    """What a model with ``effect`` leaves of a law, and what the base model does, in noise standard deviations.

    Root mean square over pressure, contraction and temperature of two runs without noise. The base parameters are
    the true ones; the effect's own coefficients are free within their bounds, from ``start`` where it
    names one.
    """
    target = _measured([law])
    size = float(np.sqrt(np.mean((target - _measured([])) ** 2)))
    names = on_bench(effect, BENCH).parameters[effect]
    with Simulator(built(BENCH, effect)) as simulator:

        def readings(values: dict[str, float]) -> Array:
            full = {name: values[name.rpartition(".")[2]] for name in names}
            return np.concatenate([_simulated(simulator, run, full) for run in RUNS])

        own = coefficients(simulator.interface, names)
        for name, value in (start or {}).items():
            low, high, _, scale = own[name]
            own[name] = (low, high, value, scale)
        return misses(readings, target, own, np.ones(len(target))), size


def _measured(effects: Sequence[Effect]) -> Array:
    runs = [
        simulate_muscle(replace(TRUTH, load=run.load), run.p_supply, run.schedule, TIMES, effects)
        for run in RUNS
    ]
    return np.concatenate(
        [
            y / s
            for f in runs
            for y, s in zip((f.p, f.x, f.temperature), SIGMA.values(), strict=True)
        ]
    )


def _simulated(simulator: Simulator, run: Run, own: dict[str, float]) -> Array:
    true = {"valve.C_A": TRUTH.calibration, "muscle.mu_fb": TRUTH.mu_fb, "load.m": run.load}
    starts, currents = np.array(run.schedule.starts), np.array(run.schedule.currents)
    courses = {
        "u_in": currents[:, 0],
        "u_out": currents[:, 1],
        "p_supply": np.full(len(starts), run.p_supply),
    }
    simulated = simulator.run(
        TIMES, parameters=true | own, inputs=Inputs(starts, courses, "previous"), tolerance=1e-7
    )
    return np.concatenate([simulated.values[name] / sigma for name, sigma in SIGMA.items()])
