"""The benchmark of fits beside estim8: its data, and pam-cosim's part of it; estim8 itself is not a requirement."""

from __future__ import annotations

from pathlib import Path

import pytest

import pam_cosim as pam
from benchmarks.fit_speed.__main__ import FREE, Outcome, ours, table, write_data


@pytest.mark.full
def test_six_parameters_come_back(tmp_path: Path) -> None:
    data = pam.read(write_data(tmp_path / "data"))
    fmu = pam.build("Isotonic", tmp_path / "Isotonic.fmu", sensitivities=list(FREE))
    outcome = ours("pam-cosim", data, fmu)
    assert len(FREE) == 6 and outcome.chi2_reduced < 1.05
    for name, (_, true, _) in FREE.items():
        assert outcome.parameters[name] == pytest.approx(true, rel=0.03), name


def test_table_says_who_comes_to_the_same_optimum() -> None:
    text = table(
        [Outcome("pam-cosim", 2.0, 40, 1.0, {}), Outcome("other", 50.0, 900, 1.2, {})], 1.0
    )
    assert "yes" in text.splitlines()[1] and "no, 25 times pam-cosim's time" in text.splitlines()[2]
