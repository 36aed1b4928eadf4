"""An effect that held-out runs show far better: the verdict names it, and says how little they check it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.diagnosis.judgement.posterior import something_else
from pam_cosim.measurement import DataSet
from rig.instruments import readings
from rig.measurement import TRUTH, Measurement, Noise, write_data_set
from rig.muscle import simulate_muscle
from rig.plan import Run
from rig.schedule import Phase
from rig.seen.elasticity import SlackCord

_TIMES = np.arange(801) / 100.0  # [s]


def _measured(folder: Path) -> DataSet:
    """A muscle with a cord that is slack until 47 mm: fitted runs stretch it by 5 mm at most, the others by 19."""
    rng, made = np.random.default_rng(3), []
    fill, hold, empty = Phase(2.5, u_in=0.33), Phase(2.5), Phase(3.0, u_out=0.33)
    for load, supply, role in (
        (2.27, 60e3, "fit"),
        (3.0, 70e3, "fit"),
        (2.27, 240e3, "holdout"),
        (4.0, 280e3, "holdout"),
    ):
        run = Run(load, supply, (fill, hold, empty), role)
        hidden = [SlackCord(k=500.0, x_0=0.047)]
        simulated = simulate_muscle(replace(TRUTH, load=load), supply, run.schedule, _TIMES, hidden)
        clean = {"p": simulated.p, "x": simulated.x, "T": simulated.temperature}
        made.append(
            Measurement(run, _TIMES, readings((), _TIMES, clean, _TIMES, Noise().as_dict(), rng))
        )
    write_data_set(folder, made)
    return study.read(folder)


@pytest.mark.full
def test_what_only_held_out_runs_show_is_found_and_not_called_checked(
    tmp_path: Path, workers: int | None
) -> None:
    diagnosis = study.diagnose(_measured(tmp_path / "data"), explain=False, workers=workers)
    verdict = diagnosis.verdict
    assert verdict.kind == "identified" and "elasticity" in verdict.families
    assert 0.9 < verdict.explained <= 1
    assert "so they are a weak check" in verdict.reason
    assert "unchecked" in verdict.posterior.doubts
    assert verdict.probability <= 1 - something_else({"unchecked"})
    # the roles are as they were, and no parameter was fitted to what is shown as held out
    assert [run.role for run in diagnosis.data.runs] == ["fit", "fit", "holdout", "holdout"]
    assert diagnosis.final.comparison.scores["holdout"]
    assert diagnosis.final.comparison.chi2_reduced("fit") < 1.1
    assert {c.effects for c in diagnosis.candidates} >= {(e,) for e in verdict.effects}
