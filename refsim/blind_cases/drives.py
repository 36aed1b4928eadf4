"""What is told to a bench: steps, staircases, ramps, sines, chirps, random courses, at any rate.

Switches fall on samples, so that what is recorded is what was told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import pi

import numpy as np

from rig.schedule import Course, Currents, Phase, SampledSchedule, Schedule

Random = np.random.Generator
SHUT = 0.145  # A, at which a valve begins to open
_KNOT = 0.02  # s, at least, between corners of what is joined by lines
_SLOW_KNOT = 0.03  # of the run, between corners of an imposed sine: what moves the muscle has to settle after each
_WAVE_KNOT = 0.04  # s, likewise, of waves of pressure


@dataclass(frozen=True)
class Clock:
    """The samples of a run: how many, and how many a second [Hz]."""

    samples: int
    rate: float

    @property
    def seconds(self) -> float:
        """Duration of the run [s]."""
        return (self.samples - 1) / self.rate

    @property
    def knot(self) -> float:
        """Seconds between the corners of what is joined by lines, a whole number of samples."""
        return max(1, round(_KNOT * self.rate)) / self.rate

    def whole(self, seconds: float) -> float:
        """The duration of a phase, a whole number of samples, at least one."""
        return max(1, round(seconds * self.rate)) / self.rate

    def knots(self, apart: float | None = None) -> np.ndarray:
        """Instants of the corners [s], so far `apart` [s], to the end of the run or one beyond."""
        step = apart or self.knot
        return np.arange(int(np.ceil(self.seconds / step)) + 1) * step


Amount = Callable[[], float]
"""Draws a current [A], or the command of an open valve."""


def steps(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """Fill, hold, vent."""
    total = clock.seconds
    return Schedule.of([
        Phase(clock.whole(total * rng.uniform(0.3, 0.45)), u_in=amount()),
        Phase(clock.whole(total * rng.uniform(0.1, 0.2))),
        Phase(total, u_out=amount()),
    ])  # fmt: skip


def staircase(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """Up and down in treads."""
    up, down, treads = amount(), amount(), int(rng.integers(3, 6))
    move = clock.whole(clock.seconds * rng.uniform(0.02, 0.05))
    rest = clock.whole(0.9 * clock.seconds / (2 * treads) - move)
    rising = [phase for _ in range(treads) for phase in (Phase(move, u_in=up), Phase(rest))]
    falling = [phase for _ in range(treads) for phase in (Phase(move, u_out=down), Phase(rest))]
    return Schedule.of([*rising, *falling, Phase(clock.seconds, u_out=down)])


def partial(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """Filled, held and vented in parts."""
    unit = clock.seconds / 7
    phases, left = [Phase(clock.whole(unit * rng.uniform(0.5, 1.5)), u_in=amount())], clock.seconds
    while left > 0:
        kind, long = len(phases) % 4, clock.whole(unit * rng.uniform(0.3, 1.5))
        if kind in (1, 3):
            phase = Phase(long)
        elif kind == 2 and rng.random() < 0.7:
            phase = Phase(long, u_out=amount())
        else:
            phase = Phase(long, u_in=amount())
        phases.append(phase)
        left -= phase.duration
    return Schedule.of(phases)


def telegraph(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """Random: one valve or the other or none, for random times."""
    unit, phases, left = (
        clock.seconds / 16,
        [Phase(clock.whole(clock.seconds / 8), u_in=amount())],
        clock.seconds,
    )
    while left > 0:
        which, long = (
            rng.random(),
            clock.whole(unit * float(np.clip(rng.exponential(1.0), 0.1, 3.0))),
        )
        phase = (
            Phase(long, amount(), 0.0)
            if which < 0.4
            else Phase(long, 0.0, amount())
            if which < 0.7
            else Phase(long)
        )
        phases.append(phase)
        left -= phase.duration
    return Schedule.of(phases)


def _joined(clock: Clock, values: np.ndarray) -> SampledSchedule:
    """Positive values open the inlet valve, negative ones the exhaust."""
    rows: list[Currents] = []
    for value in values.tolist():
        u = round(SHUT + abs(value), 5) if value else 0.0
        rows.append((u, 0.0) if value > 0 else (0.0, u))
    return SampledSchedule.joined(rows, clock.knot)


def ramps(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """The inlet opens slowly, the exhaust opens slowly."""
    total, t = clock.seconds, clock.knots()
    top, low = amount() - SHUT, amount() - SHUT
    rise, hold, vent = (
        total * rng.uniform(0.35, 0.45),
        total * rng.uniform(0.1, 0.2),
        total * rng.uniform(0.15, 0.25),
    )
    falling = -low * np.minimum((t - rise - hold) / vent, 1.0)
    return _joined(
        clock, np.where(t < rise, top * t / rise, np.where(t < rise + hold, 0.0, falling))
    )


def sine(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """Both valves in turns, a sine with a little more filling than venting."""
    periods, size, up = rng.uniform(2.0, 6.0), amount() - SHUT, rng.uniform(0.05, 0.25)
    return _joined(clock, size * (np.sin(2 * pi * periods * clock.knots() / clock.seconds) + up))


def chirp(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """As `sine`, faster and faster."""
    first, last = rng.uniform(1.0, 2.0), rng.uniform(6.0, 14.0)
    size, up, share = amount() - SHUT, rng.uniform(0.0, 0.2), clock.knots() / clock.seconds
    return _joined(
        clock, size * (np.sin(2 * pi * (first * share + (last - first) * share**2 / 2)) + up)
    )


def wander(rng: Random, clock: Clock, amount: Amount) -> Schedule:
    """Random: lines between random currents."""
    t, size = clock.knots(), amount() - SHUT
    places = np.linspace(0.0, t[-1], int(rng.integers(10, 24)))
    return _joined(
        clock, np.round(np.interp(t, places, size * rng.uniform(-0.9, 1.1, len(places))), 5)
    )


HELD: dict[str, Callable[[Random, Clock, Amount], Schedule]] = {
    "steps": steps, "staircase": staircase, "partial": partial, "telegraph": telegraph,
}  # fmt: skip
"""Ways of driving valves that are open or shut."""
JOINED: dict[str, Callable[[Random, Clock, Amount], Schedule]] = {
    "ramps": ramps, "sine": sine, "chirp": chirp, "wander": wander,
}  # fmt: skip
"""Further ones, of valves that open by their current."""


def course(rng: Random, clock: Clock, style: str, low: float, high: float) -> Course:
    """An input between two bounds [SI]: constant, sine, triangles, twelve sines (waves), lines between random places.

    All but the constant begin at `low`; the constant one is reached within a tenth of the run.
    """
    knot = clock.whole(_SLOW_KNOT * clock.seconds) if style == "sine" else clock.knot
    t = clock.knots(knot)
    share = t / clock.seconds
    if style == "constant":
        level = rng.uniform(0.3, 1.0)
        y = level * np.minimum(share / 0.1, 1.0)
    elif style == "sine":
        y = (1 - np.cos(2 * pi * rng.uniform(1.5, 5.0) * share)) / 2
    elif style == "triangles":
        y = np.abs((rng.uniform(1.0, 3.0) * 2 * share + 1) % 2 - 1)
    elif style == "random":
        places = np.linspace(0.0, 1.0, int(rng.integers(8, 16)))
        y = np.interp(share, places, np.append(0.0, rng.uniform(0.0, 1.0, len(places) - 1)))
    else:
        raise ValueError(f"no course '{style}'")
    return Course(tuple(np.round(low + (high - low) * y, 7).tolist()), knot)


def waves(rng: Random, clock: Clock, frequency: float, high: float) -> Course:
    """Twelve sines of random frequency up to the highest [Hz] and random phase, from 0 to `high`, from nothing.

    Dzahir and Yamamoto (2019), section 2: the random wave of pressure [Pa].
    """
    knot = clock.whole(_WAVE_KNOT)
    t = clock.knots(knot)
    parts = frequency * np.append(rng.uniform(0.15, 1.0, 11), 1.0)
    y = sum(
        np.sin(2 * pi * f * t + a) for f, a in zip(parts, rng.uniform(0, 2 * pi, 12), strict=True)
    )
    rising = np.sin(pi / 2 * np.minimum(t, 1.0)) ** 2
    return Course(tuple(np.round(high * rising * (y - np.min(y)) / np.ptp(y), 1).tolist()), knot)


def reference(rng: Random, instants: np.ndarray, low: float, high: float) -> tuple[float, ...]:
    """What a controller is asked for, at its instants [s]: a few levels between bounds, or a sine."""
    if rng.random() < 0.5:
        levels = rng.uniform(low, high, int(rng.integers(3, 6)))
        place = (instants / instants[-1] * len(levels)).astype(int)
        return tuple(float(v) for v in levels[np.minimum(place, len(levels) - 1)])
    periods = rng.uniform(1.0, 3.0)
    return tuple(low + (high - low) * (1 - np.cos(2 * pi * periods * instants / instants[-1])) / 2)
