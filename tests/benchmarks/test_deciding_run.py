"""The benchmark of one more run: what is played is what was planned, and counts are those of the results."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.deciding_run import muscle, tuning
from benchmarks.deciding_run.play import played
from benchmarks.deciding_run.table import table
from blind_cases import many
from pam_cosim.measurement import further_run, rows_of
from pam_cosim.starts.run_start import inputs_of_run
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from rig.named import EFFECTS
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


def test_lines_between_rows_and_a_delay() -> None:
    ramp = PlayedSchedule.of_table(
        [0.0, 1.0, 1.0, 2.0], [(0.0, 0.0), (0.4, 0.0), (0.1, 0.2), (0.1, 0.0)]
    )
    assert ramp.at(0.5) == pytest.approx((0.2, 0.0)) and ramp.at(1.5) == pytest.approx((0.1, 0.1))
    assert ramp.within(0.0)(1.0) == pytest.approx(
        (0.4, 0.0)
    )  # the end of the line that begins at zero
    late = ramp.delayed(0.25)
    assert late.at(0.75) == pytest.approx((0.2, 0.0)) and late.starts == (1.25,)


def test_a_case_of_the_muscle_is_the_same_twice_and_plays_a_planned_run() -> None:
    one, two = muscle.scene(3), muscle.scene(3)
    assert one.description["families"] == [EFFECTS[4].family]
    first = one.data.runs[0]
    for name, values in first.measurements.items():
        assert np.array_equal(values, two.data.runs[0].measurements[name], equal_nan=True)
        assert np.isfinite(values).sum() == 51
    time = np.array([*np.arange(26) * 0.06, *np.arange(25, 51) * 0.06])
    inputs = {
        "u_in": np.where(np.arange(52) < 26, 0.3, 0.0),
        "u_out": np.zeros(52),
        "p_supply": np.full(52, 2e5),
    }
    run = one.play(further_run(one.data, time, inputs, {"load.m": 3.0}))
    assert np.isfinite(run.measurements["p"]).sum() == 51 and np.isnan(run.measurements["p"][25])
    assert run.measurements["p"][26] > 2e4 > run.measurements["p"][0] - 2e3


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


def test_the_table_counts() -> None:
    verdict = {"verdict": {"kind": "ambiguous", "families": ["leak", "creep"]}}
    further = {
        "designed": {"outcome": "right", "expected_chi2": 40.0},
        "random": {"outcome": "wrong", "expected_chi2": 3.0},
    }
    results = [
        {
            "case": {"families": ["leak"]},
            "first": verdict,
            "further": {**further, "design_seconds": 2.0},
        },
        {
            "case": {"families": ["leak"]},
            "first": {"verdict": {"kind": "identified", "families": ["leak"]}},
        },
        {"error": "..."},
    ]
    text = table(results)
    assert "2 cases were diagnosed" in text and "1 verdicts left rivals" in text
    assert "| ambiguous | yes | designed | 1 | 1 | 0 | 0 | 0 | 0 | 0 |" in text
    assert (
        "- random: right in 0 of 1; expected chi-square of the nearest pair 3 in the median."
        in text
    )
