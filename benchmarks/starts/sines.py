"""The same rig driven by sines, of which the last period alone is kept."""

from __future__ import annotations

from dataclasses import replace
from math import pi
from pathlib import Path

import numpy as np

from benchmarks.hidden_effects.drives import SHUT
from benchmarks.hidden_effects.setups import Setup
from benchmarks.starts.cutting import Keep, cut_files
from rig.schedule import Course, Phase, SampledSchedule, Schedule
from rig.trial import Trial

PERIODS = 4
KNOTS = 60  # corners in a period
UP = 0.1  # of the amplitude, by which the inlet opens more than the exhaust


def in_sines(setup: Setup) -> Setup:
    """The same tests, each driven by four periods of a sine; valves that switch do so in turns."""
    return replace(setup, plan=tuple(_driven(trial) for trial in setup.plan), loops={})


def _driven(trial: Trial) -> Trial:
    period = (trial.samples - 1) / trial.rate / PERIODS
    schedules = tuple(_periodic(schedule, period, trial.held) for schedule in trial.schedules)
    return replace(trial, schedules=schedules, course=trial.course and _sine(trial.course, period))


def _periodic(schedule: Schedule, period: float, switched: bool) -> Schedule:
    rows = schedule.samples if isinstance(schedule, SampledSchedule) else schedule.currents
    largest = float(np.max(rows, initial=0.0))
    if not largest:
        return schedule
    if switched:
        filled = [Phase(0.35 * period, u_in=largest), Phase(0.15 * period)]
        return Schedule.of([*filled, Phase(0.35 * period, u_out=largest), Phase(0.15 * period)] * PERIODS)
    turns = np.arange(KNOTS * PERIODS + 1) / KNOTS
    values = (largest - SHUT) * (np.sin(2 * pi * turns) + UP)
    currents = [(SHUT + v, 0.0) if v > 0 else (0.0, SHUT - v) for v in values.tolist()]
    return SampledSchedule.joined(currents, period / KNOTS)


def _sine(course: Course, period: float) -> Course:
    low, high = min(course.values), max(course.values)
    turns = np.arange(KNOTS * PERIODS + 1) / KNOTS
    return Course(tuple((low + (high - low) * (1 - np.cos(2 * pi * turns)) / 2).tolist()), period / KNOTS)


def last_period(source: Path, folder: Path, seed: int) -> Path:
    """Of each recording the last period alone."""

    def keep(random: np.random.Generator) -> Keep:
        return lambda time, begin, end: time >= end - (end - begin) / PERIODS

    return cut_files(source, folder, keep, seed)


__all__ = ["in_sines", "last_period"]
