"""Commands that step between two samples: the rig switches its valves when it likes, and the logger is coarse."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.catalogue import compose
from pam_cosim.diagnosis.search.step_times import Retiming, run_retiming, steps_between
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.measurement import DataSet, FreeParameter
from rig.effect import Effect
from rig.instruments import readings
from rig.measurement import TRUTH, Measurement, Noise, write_data_set
from rig.muscle import simulate_muscle
from rig.named import effect_of
from rig.plan import Run
from rig.schedule import Phase

RATE = 100.0  # [Hz]


def _program(rng: np.random.Generator, aligned: bool) -> tuple[Phase, ...]:
    def span(low: float, high: float) -> float:
        length = float(rng.uniform(low, high))
        return round(length * RATE) / RATE if aligned else length

    phases: list[Phase] = []
    for _ in range(8):
        filling, emptying = float(rng.uniform(0.26, 0.36)), float(rng.uniform(0.28, 0.38))
        phases += [Phase(span(0.2, 0.9), u_in=filling), Phase(span(0.3, 0.8))]
        phases += [Phase(span(0.2, 0.9), u_out=emptying), Phase(span(0.2, 0.6))]
    return tuple(phases)


def _measured(
    folder: Path, effects: list[Effect], aligned: bool = False, length: float = 10.0
) -> tuple[DataSet, list[np.ndarray]]:
    """Three runs, and when their commands really stepped."""
    rng, made, switched = np.random.default_rng(5), [], []
    for load, role in ((2.27, "fit"), (4.0, "fit"), (3.0, "holdout")):
        run, times = (
            Run(load, 220e3, _program(rng, aligned), role),
            np.arange(int(length * RATE) + 1) / RATE,
        )
        simulated = simulate_muscle(
            replace(TRUTH, load=load), run.p_supply, run.schedule, times, effects
        )
        clean = {"p": simulated.p, "x": simulated.x, "T": simulated.temperature}
        made.append(
            Measurement(run, times, readings((), times, clean, times, Noise().as_dict(), rng))
        )
        starts = np.array(run.schedule.starts[1:])
        switched.append(starts[starts < length])
    write_data_set(folder, made)
    return study.read(folder), switched


def test_times_of_steps_come_back(tmp_path: Path) -> None:
    data, switched = _measured(tmp_path / "data", [effect_of("elasticity:linear")], length=6.0)
    subject = subject_of(data, None, (), 0, lambda message: None)
    composed = compose(subject.tree, subject.name, ["LinearBladder"])
    model = tmp_path / f"{composed.name}.mo"
    model.write_text(composed.text)
    before = study.fit(replace(subject.data, fit=data.fit | _free(composed.parameters)), str(model))
    assert before.comparison.chi2_reduced("fit") > 1.3
    after = run_retiming(Retiming(("LinearBladder",), composed, subject.data, before))
    assert after is not None
    assert after.steps == steps_between(data) > 30
    assert after.fit.comparison.chi2_reduced("fit") < 1.1
    assert after.fit.comparison.chi2_reduced("holdout") < 1.15
    assert after.fit.values["bladder.k"] == pytest.approx(250.0, abs=6.0)
    errors = [
        np.abs(run.time[np.flatnonzero(np.diff(run.time) == 0)] - true)
        for run, true in zip(after.data.runs, switched, strict=True)
    ]
    assert (
        np.median(np.concatenate(errors)) < 0.1 / RATE
    )  # a quarter of an interval if nothing were known


def _free(parameters: Mapping[str, Sequence[str]]) -> dict[str, FreeParameter]:
    return {name: FreeParameter(name, 0.0, 1e5) for names in parameters.values() for name in names}
