"""Rigs and test plans: geometry, loads, supplies, what the valves are told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi, sin, tan

import numpy as np

from rig.flow import G
from rig.muscle import MuscleParameters
from rig.schedule import Currents, Phase, SampledSchedule, Schedule

RATE = 100  # Hz
Random = np.random.Generator
STYLES = ("steps", "staircase", "partial", "ramps", "chirp")
"""Ways of driving the valves; `ramps` and `chirp` are joined by lines between samples, the others are held."""


@dataclass(frozen=True)
class TestRun:
    """One run of a plan."""

    __test__ = False  # not a test of pytest's

    style: str
    role: str  # fit or holdout
    load: float  # kg
    p_supply: float  # Pa gauge
    samples: int
    schedule: Schedule

    @property
    def interpolation(self) -> str:
        """As experiment.toml says it."""
        return "linear" if isinstance(self.schedule, SampledSchedule) else "previous"

    @property
    def times(self) -> np.ndarray:
        """Instants of the samples [s]."""
        return np.arange(self.samples) / RATE


def draw_muscle(rng: Random) -> MuscleParameters:
    """A muscle with a braid angle of 23 to 30 degrees at rest, bare to the same share as the paper's."""
    length = round(float(rng.uniform(0.18, 0.32)), 3)
    diameter = round(float(rng.uniform(0.015, 0.025)), 4)
    angle = np.deg2rad(rng.uniform(23.0, 30.0))
    turns = round(tan(angle) * length / (pi * diameter), 2)
    fibres = float(round(216 * diameter / 0.02))
    wall = round(float(rng.uniform(0.2e-3, 0.8e-3)), 6)
    return MuscleParameters(
        length=length, diameter=diameter, turns=turns, fibres=fibres, t_wall=wall
    )


def draw_plan(rng: Random, muscle: MuscleParameters, one_load: bool) -> tuple[TestRun, ...]:
    """Runs to fit and to judge: six of 6 to 8 s mostly, else four longer or eight shorter ones.

    one_load: all runs lift the same weight.
    """
    fits, holdouts, low, high = [
        (4, 2, 6.0, 8.0),
        (4, 2, 6.0, 8.0),
        (3, 1, 8.0, 10.0),
        (6, 2, 5.0, 6.0),
    ][int(rng.integers(0, 4))]
    lead = STYLES[int(rng.integers(0, len(STYLES)))]
    pull = muscle.volume_slope(0.0)
    common = round(float(rng.uniform(0.1, 0.8)) * 0.4 * pull * 1.2e5 / G, 2)
    runs = []
    for k in range(fits + holdouts):
        # every second run in the style of the plan, the first a step, so that every plan fills and vents as a whole
        style = "steps" if k == 0 else lead if k % 2 else STYLES[int(rng.integers(0, len(STYLES)))]
        p_supply = float(rng.integers(12, 31)) * 1e4
        heaviest = 0.4 * pull * p_supply / G
        load = common if one_load else round(float(rng.uniform(0.12, 0.9)) * heaviest, 2)
        samples = round(float(rng.uniform(low, high)) * RATE) + 1
        schedule = _DRIVES[style](rng, samples, muscle)
        runs.append(
            TestRun(style, "fit" if k < fits else "holdout", load, p_supply, samples, schedule)
        )
    return tuple(runs)


def _current(rng: Random, muscle: MuscleParameters) -> float:
    """A current that fills this muscle about as fast as the paper's is filled by 0.22 to 0.36 A."""
    size = muscle.volume(0.0) / 7.5e-5
    area = rng.uniform(0.5, 1.25) * min(max(size, 0.6), 2.0)
    return round(0.145 + 0.205 * float(min(area, 2.2)), 3)


def _seconds(rng: Random, low: float, high: float) -> float:
    return round(float(rng.uniform(low, high)), 2)


def _steps(rng: Random, samples: int, muscle: MuscleParameters) -> Schedule:
    fill, vent = _current(rng, muscle), _current(rng, muscle)
    total = samples / RATE
    return Schedule.of([
        Phase(round(total * rng.uniform(0.3, 0.45), 2), u_in=fill),
        Phase(round(total * rng.uniform(0.1, 0.2), 2)),
        Phase(total, u_out=vent),
    ])  # fmt: skip


def _staircase(rng: Random, samples: int, muscle: MuscleParameters) -> Schedule:
    total, up, down = samples / RATE, _current(rng, muscle), _current(rng, muscle)
    treads = int(rng.integers(3, 6))
    move = _seconds(rng, 0.15, 0.35)
    rest = round((total - 0.6) / (2 * treads) - move, 2)
    rising = [phase for _ in range(treads) for phase in (Phase(move, u_in=up), Phase(rest))]
    falling = [phase for _ in range(treads) for phase in (Phase(move, u_out=down), Phase(rest))]
    return Schedule.of([*rising, *falling, Phase(total, u_out=down)])


def _partial(rng: Random, samples: int, muscle: MuscleParameters) -> Schedule:
    phases, left = [Phase(_seconds(rng, 0.5, 1.5), u_in=_current(rng, muscle))], samples / RATE
    while left > 0:
        kind = len(phases) % 4
        if kind in (1, 3):
            phase = Phase(_seconds(rng, 0.4, 1.5))
        elif kind == 2 and rng.random() < 0.7:
            phase = Phase(_seconds(rng, 0.2, 1.2), u_out=_current(rng, muscle))
        else:
            phase = Phase(_seconds(rng, 0.3, 1.5), u_in=_current(rng, muscle))
        phases.append(phase)
        left -= phase.duration
    return Schedule.of(phases)


def _sampled(function: Callable[[float], float], samples: int) -> SampledSchedule:
    """Positive values open the inlet valve, negative ones the exhaust; the first 50 ms stay shut."""
    rows: list[Currents] = []
    for k in range(samples):
        value = function(k / RATE) if k >= 5 else 0.0
        u = round(0.145 + abs(value), 5) if value else 0.0
        rows.append((u, 0.0) if value > 0 else (0.0, u))
    return SampledSchedule.joined(rows, 1 / RATE)


def _ramps(rng: Random, samples: int, muscle: MuscleParameters) -> Schedule:
    total = samples / RATE
    top, low = _current(rng, muscle) - 0.145, _current(rng, muscle) - 0.145
    rise, hold, vent = (
        total * rng.uniform(0.35, 0.45),
        total * rng.uniform(0.1, 0.2),
        total * rng.uniform(0.15, 0.25),
    )

    def function(t: float) -> float:
        if t < rise:
            return top * t / rise
        if t < rise + hold:
            return 0.0
        return -low * min((t - rise - hold) / vent, 1.0)

    return _sampled(function, samples)


def _chirp(rng: Random, samples: int, muscle: MuscleParameters) -> Schedule:
    total = samples / RATE
    first, last = rng.uniform(0.15, 0.3), rng.uniform(1.0, 2.5)
    size, up = _current(rng, muscle) - 0.145, rng.uniform(0.0, 0.2)

    def function(t: float) -> float:
        phase = 2 * pi * (first * t + (last - first) * t * t / (2 * total))
        return size * (sin(phase) + up)

    return _sampled(function, samples)


_DRIVES: dict[str, Callable[[Random, int, MuscleParameters], Schedule]] = {
    "steps": _steps, "staircase": _staircase, "partial": _partial, "ramps": _ramps, "chirp": _chirp,
}  # fmt: skip
