"""A planned course on the reference simulator of a case: hidden effects, noise and faulty instruments included."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from blind_cases.cases import Made
from blind_cases.noise import disturb
from pam_cosim.measurement import Run, Start
from rig.played import PlayedSchedule
from rig.schedule import Course, Schedule
from rig.trial import Trial

NOISE = 77
"""Stream of random numbers for the noise of further runs."""


def played(made: Made, run: Run) -> Run:
    """The run with what is recorded when its inputs are played.

    Args:
        made: the case.
        run: inputs [SI] over time, of which a step is two rows at one time, and parameters.

    Raises:
        RuntimeError: the rig cannot play it.
    """
    bench = made.case.design.rig
    last = np.append(np.diff(run.time) > 0, True)  # of the rows at one time
    sampled = run.time[last]
    rate = 1 / float(np.median(np.diff(sampled)))
    valves = [name for name in bench.inputs if name not in (bench.course, "p_supply")]
    schedules: list[Schedule] = [
        PlayedSchedule.of_table(run.time, list(zip(run.inputs[a], run.inputs[b], strict=True)))
        for a, b in zip(valves[::2], valves[1::2], strict=True)
    ]
    course = None
    if bench.course is not None:
        course = Course(tuple(run.inputs[bench.course][last].tolist()), step=1 / rate)
    stated = set(made.setup.plan[0].values)
    values = {name: value for name, value in run.parameters.items() if name in stated}
    if "p_supply" in run.inputs:
        values["p_supply"] = float(run.inputs["p_supply"][0])
    trial = Trial("planned", "fit", len(sampled), rate, tuple(schedules), course, values)
    setup = replace(made.setup, plan=(trial,), loops={}, done={})
    noise = made.case.rng(NOISE)
    (recorded,) = setup.recorded(made.hidden, lambda clean: disturb(noise, made.sensors, clean))
    measurements = {}
    for name, values_read in recorded.items():
        column = np.full(len(run.time), np.nan)
        column[last] = values_read
        measurements[name] = column
    return replace(run, measurements=measurements, start=Start(mode="rest"))
