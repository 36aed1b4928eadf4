"""Cross-validation over runs: which effects are needed whichever runs are left out."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from pam_cosim.diagnosis.judgement.folds import Folds
from pam_cosim.diagnosis.judgement.verdict import Verdict
from pam_cosim.diagnosis.search import folds as module
from pam_cosim.diagnosis.search.folds import FoldResult, folds_of
from pam_cosim.measurement import DataSet, Run, Signal


def data_of(count: int) -> DataSet:
    empty = np.zeros(0)
    runs = tuple(
        Run(f"r{i}", Path(f"r{i}.csv"), "fit", "linear", {}, empty, {}, {}) for i in range(count)
    )
    return DataSet("t", Path("."), "Isotonic", {"F": Signal("F", "N", 1.0)}, {}, {}, runs)


class World:
    """What models leave of the force [N, noise 1 N] on runs that are left out; a sum over the effects that lack."""

    def __init__(self, gains: dict[str, list[float]]) -> None:
        self.gains = gains

    def result(self, fold: int, effects: tuple[str, ...]) -> FoldResult:
        chi2 = 4.0 + sum(gain[fold] for name, gain in self.gains.items() if name not in effects)
        without = {name: chi2 - 1.0 + self.gains[name][fold] for name in effects}
        return FoldResult({"F": float(np.sqrt(chi2))}, (f"r{fold}",), chi2 - 1.0, without)

    def folds(
        self, monkeypatch: pytest.MonkeyPatch, runs: int = 10, **values: float
    ) -> Folds | None:
        def results(
            search: Any, data: Any, effects: tuple[str, ...], final: Any
        ) -> list[FoldResult]:
            return [self.result(fold, effects) for fold in range(len(data))]

        def base(subject: Any, search: Any, data: Any) -> list[FoldResult]:
            return [self.result(fold, ()) for fold in range(len(data))]

        monkeypatch.setattr(module, "fold_results", results)
        monkeypatch.setattr(module, "base_results", base)
        search: Any = SimpleNamespace(data=data_of(runs), say=lambda message: None)
        return folds_of(None, search, tuple(self.gains), SimpleNamespace(values=values))  # type: ignore[arg-type]


def test_an_effect_is_needed_in_most_folds_or_not_named(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World({"StiffWall": [9.0] * 5, "Once": [5.0, 0, 0, 0, 0], "Idle": [0.1] * 5})
    folds = world.folds(monkeypatch)
    assert folds is not None and folds.needed == {"StiffWall": 5, "Once": 1, "Idle": 0}
    assert folds.named == ("StiffWall",)
    # of the model with what is named alone
    assert folds.rmse["F"] == pytest.approx(np.sqrt(4.0 + 0.1))
    assert folds.worst["F"] == (pytest.approx(np.sqrt(4.0 + 5.0 + 0.1)), ("r0",))
    reason = Verdict("unknown", folds=folds).reason
    assert "Once (1 of 5 folds)" in reason and "Idle (0 of 5 folds)" in reason


def test_each_run_is_left_out_once(monkeypatch: pytest.MonkeyPatch) -> None:
    for runs, count in ((3, 3), (4, 4), (5, 5), (13, 5)):
        folds = list(module._folds(data_of(runs)))
        assert len(folds) == count
        held = [sum(fold.runs[i].role == "holdout" for fold in folds) for i in range(runs)]
        assert held == [1] * runs
    assert list(module._folds(data_of(2))) == []
    assert World({"A": [1.0] * 5}).folds(monkeypatch, runs=2) is None


def test_what_is_noise_either_way_is_not_needed_and_what_cannot_be_absent_is() -> None:
    result = FoldResult({}, (), 0.0, {"Noise": 0.0, "Little": 0.5})
    assert not result.needs("Noise") and result.needs("Little") and result.needs("Law")


def test_where_no_effect_is_named_the_error_is_that_of_the_base_model(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    folds = World({"Once": [5.0, 0, 0, 0, 0]}).folds(monkeypatch)
    assert folds is not None and folds.named == ()
    assert folds.worst["F"] == (pytest.approx(3.0), ("r0",))
