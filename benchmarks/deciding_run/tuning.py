"""Cases of the tuning set of many benches, of which the beginning of one run was recorded, with few samples."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from benchmarks.deciding_run.play import played
from benchmarks.deciding_run.scene import Scene
from blind_cases import cases
from pam_cosim import study
from pam_cosim.diagnosis.planning import limits_of
from pam_cosim.measurement import DataSet

SET = "tuning2"
SAMPLES = 30  # of the recording that there is, and of a further run
SHARE = 0.4  # of the first run, that was recorded
BENCHES = ("Isotonic", "Isometric", "TankFilling", "VerticalLoad")
GROUPS = ("catalogue", "new_form", "instrument")
LEAST = 3.0  # standard deviations that a hidden effect shows at least, in all runs of the case


def is_asked(number: int) -> bool:
    """Whether a case is among those of this benchmark: one effect that shows, on a bench with inputs."""
    case = cases.case_of(SET, number)
    return case.group in GROUPS and case.design.bench in BENCHES and min(case.targets) >= LEAST


def scene(number: int) -> Scene:
    """A case; a further run is as long as the recording that there is, within the limits of the case's own plan."""
    made = cases.make(cases.case_of(SET, number))
    with tempfile.TemporaryDirectory() as folder:
        cases.write(made, Path(folder))
        whole = study.read(folder)
    data = _scarce(whole)
    seconds = float(data.runs[0].time[-1] - data.runs[0].time[0])
    limits = replace(limits_of(whole, seconds=seconds), interval=seconds / SAMPLES)
    return Scene(made.description, data, limits, partial(played, made), number)


def _scarce(whole: DataSet) -> DataSet:
    """The beginning of the first run, with few samples."""
    run = whole.runs[0]
    kept = run.time <= run.time[0] + SHARE * (run.time[-1] - run.time[0])
    count = int(kept.sum())
    at = np.zeros(count, dtype=bool)
    at[:: max(1, count // SAMPLES)] = True
    measurements = {
        name: np.where(at, values[kept], np.nan) for name, values in run.measurements.items()
    }
    inputs = {name: values[kept] for name, values in run.inputs.items()}
    part = replace(run, role="fit", time=run.time[kept], inputs=inputs, measurements=measurements)
    return replace(whole, runs=(part,))
