"""The benchmark of fits beside estim8: its data, and pam-cosim's part of it; estim8 itself is not a requirement."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from benchmarks.fit_speed.__main__ import FREE, Outcome, _input_table, ours, table, write_data


@pytest.mark.full
def test_six_parameters_come_back(tmp_path: Path) -> None:
    data = pam.read(write_data(tmp_path / "data"))
    fmu = pam.build("Isotonic", tmp_path / "Isotonic.fmu", sensitivities=list(FREE))
    outcome = ours("pam-cosim", data, fmu)
    assert len(FREE) == 6 and outcome.chi2_reduced < 1.05
    for name, (_, true, _) in FREE.items():
        assert outcome.parameters[name] == pytest.approx(true, rel=0.03), name


@pytest.mark.full
def test_inputs_are_those_of_the_run(tmp_path: Path) -> None:
    """Held between the samples: a step is two rows at one time."""
    run = pam.read(write_data(tmp_path / "data")).fit_runs[0]
    rows = _input_table(run)
    assert rows.dtype.names == ("time", *run.inputs) and np.all(np.diff(rows["time"]) >= 0)
    steps = np.flatnonzero(np.diff(run.inputs["u_in"]))
    assert steps.size and len(rows) > len(run.time)
    at = run.time[steps[0] + 1]
    assert (
        rows["u_in"][rows["time"] == at].tolist()
        == run.inputs["u_in"][steps[0] : steps[0] + 2].tolist()
    )


def test_table_says_who_comes_to_the_same_optimum() -> None:
    text = table(
        [Outcome("pam-cosim", 2.0, 40, 1.0, {}), Outcome("other", 50.0, 900, 1.2, {})], 1.0
    )
    assert "yes" in text.splitlines()[1] and "no, 25 times pam-cosim's time" in text.splitlines()[2]
