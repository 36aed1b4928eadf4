"""The same rig driven by sines, of which the last period alone is kept."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np

from benchmarks.starts.cutting import Keep, cut_files
from blind_cases.drives import SHUT
from blind_cases.setups import Setup
from rig.schedule import Course, Phase, SampledSchedule, Schedule
from rig.trial import Trial

PERIODS = 4
KNOTS = 60  # corners in a period, about
UP = 0.1  # of the amplitude, by which the inlet opens more than the exhaust


def in_sines(setup: Setup) -> Setup:
    """The same tests, each driven by four periods of a sine; valves that switch do so in turns."""
    return replace(setup, plan=tuple(_driven(trial) for trial in setup.plan), loops={})


def _driven(trial: Trial) -> Trial:
    knot = max(
        1, (trial.samples - 1) // (PERIODS * KNOTS)
    )  # samples: corners fall on them, so that they are recorded
    count = (trial.samples - 1) // (PERIODS * knot)
    schedules = tuple(
        _periodic(schedule, count, knot / trial.rate, trial.held) for schedule in trial.schedules
    )
    course = trial.course and _sine(trial.course, count, knot / trial.rate)
    return replace(trial, samples=PERIODS * count * knot + 1, schedules=schedules, course=course)


def _periodic(schedule: Schedule, count: int, knot: float, switched: bool) -> Schedule:
    """Count corners in a period, a knot [s] apart."""
    rows = schedule.samples if isinstance(schedule, SampledSchedule) else schedule.currents
    largest = float(np.max(rows, initial=0.0))
    if not largest:
        return schedule
    if switched:
        move, rest = round(0.35 * count), round(0.15 * count)
        left = count - 2 * move - rest
        filled = [Phase(move * knot, u_in=largest), Phase(rest * knot)]
        return Schedule.of(
            [*filled, Phase(move * knot, u_out=largest), Phase(left * knot)] * PERIODS
        )
    values = (largest - SHUT) * (np.sin(2 * pi * _turns(count)) + UP)
    currents = [(SHUT + v, 0.0) if v > 0 else (0.0, SHUT - v) for v in values.tolist()]
    return SampledSchedule.joined(currents, knot)


def _sine(course: Course, count: int, knot: float) -> Course:
    low, high = min(course.values), max(course.values)
    return Course(
        tuple((low + (high - low) * (1 - np.cos(2 * pi * _turns(count))) / 2).tolist()), knot
    )


def _turns(count: int) -> np.ndarray:
    return np.arange(count * PERIODS + 1) / count


def last_period(source: Path, folder: Path, seed: int) -> Path:
    """Of each recording the last period alone."""

    def keep(random: np.random.Generator) -> Keep:
        return lambda time, begin, end: time >= end - (end - begin) / PERIODS - 1e-9

    return cut_files(source, folder, keep, seed)


__all__ = ["in_sines", "last_period"]
