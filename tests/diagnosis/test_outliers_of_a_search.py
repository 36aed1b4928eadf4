"""Samples count or not by what the best model shows."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from pam_cosim.diagnosis.search.search import Search
from pam_cosim.measurement import DataSet, Run, Signal
from tests.diagnosis.linear_world import TREE


def data_of(samples: np.ndarray) -> DataSet:
    time = np.arange(len(samples)) / 100
    run = Run("r", Path("r.csv"), "fit", "linear", {}, time, {}, {"x": samples})
    return DataSet("t", Path("."), "Isotonic", {"x": Signal("x", "m", 1.0)}, {}, {}, (run,))


def test_a_sample_that_only_seemed_an_outlier_counts_again() -> None:
    samples = np.random.default_rng(0).standard_normal(200)
    samples[50] += 100.0
    recorded = data_of(samples)
    seemed = samples.copy()
    seemed[120] = np.nan
    search = Search(TREE, "Isotonic", (), data_of(seemed), recorded=recorded)
    assert search.outliers == {"x": 1}
    run = SimpleNamespace(run=recorded.runs[0], residual=lambda name: samples)
    fit: Any = SimpleNamespace(
        comparison=SimpleNamespace(against=lambda data: SimpleNamespace(runs=[run]))
    )
    better = search.without_outliers(fit)
    assert np.flatnonzero(np.isnan(better.data.runs[0].measurements["x"])).tolist() == [50]
    assert better.outliers == {"x": 1}
    assert better.without_outliers(fit) is better
    assert replace(search, recorded=None).outliers == {}
