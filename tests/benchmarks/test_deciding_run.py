"""The benchmark of one more run: what is played is what was planned, and counts are those of the results."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.deciding_run import tuning
from benchmarks.deciding_run.play import played
from blind_cases import many
from pam_cosim.measurement import further_run, rows_of
from pam_cosim.starts.run_start import inputs_of_run
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from rig.played import PlayedSchedule
from rig.schedule import Phase, Schedule

pytestmark = pytest.mark.full  # of the measuring, not of the product


def test_a_table_is_played_as_phases_are() -> None:
    phases = Schedule.of([Phase(0.5, u_in=0.3), Phase(0.3), Phase(0.7, u_out=0.25)])
    rows = [(0, 0.3, 0), (0.5, 0.3, 0), (0.5, 0, 0), (0.8, 0, 0), (0.8, 0, 0.25), (1.5, 0, 0.25)]
    same = PlayedSchedule.of_table([r[0] for r in rows], [(r[1], r[2]) for r in rows])
    for t in (0.0, 0.2, 0.5, 0.6, 0.8, 1.4, 2.0):
        assert same.at(t) == phases.at(t)
    times = np.linspace(0, 1.5, 31)
    one, two = (simulate_muscle(TRUTH, 2e5, s, times) for s in (phases, same))
    assert np.abs(one.p - two.p).max() < 5.0


def test_a_tuning_case_plays_its_own_run_as_it_was_recorded() -> None:
    """The first run of a case, played from its inputs, differs from what was recorded by the noise."""
    cases = (many.case_of("tuning2", n) for n in range(400) if tuning.is_asked(n))
    number = next(
        c.number for c in cases if c.design.bench == "TankFilling" and c.group != "instrument"
    )
    made = many.make(many.case_of("tuning2", number))
    scene = tuning.scene(number)
    run = scene.data.runs[0]
    driven = inputs_of_run(run)
    assert driven is not None
    time, inputs = rows_of(driven, run.time)
    again = played(made, further_run(scene.data, time, inputs, run.parameters)).measurements["p"]
    last = np.append(np.diff(time) > 0, True)
    apart = (again[last] - run.measurements["p"]) / made.sensors.sigma["p"]
    assert np.nanmean(apart**2) < 6.0  # two readings, each with its noise
