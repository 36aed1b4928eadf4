"""Coefficients that a fit does not need are held at zero; the fits are written down."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import pytest

from pam_cosim.diagnosis.search import pruning
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Estimate, Fit, Free
from tests.diagnosis.synthetic import SAMPLES, fitted

OWN = {
    "a": Estimate(0.1, -1.0, 1.0),
    "b": Estimate(-2.5, -2.6, -2.4),
    "c": Estimate(0.2, -0.1, 0.5),
}
COST = {"a": 0.5, "b": 500.0, "c": 50.0}  # of holding them at zero, in chi-square
NONE = dict.fromkeys(COST, 0.0)
FREE = [Free(name, -5.0, 5.0, 1.0) for name in ("base.0", "base.1", *OWN)]


def known(chi2: float, held: Sequence[str] = (), holdout_cost: Mapping[str, float] = NONE) -> Fit:
    more, elsewhere = (
        sum(costs[name] for name in held) / SAMPLES for costs in (COST, holdout_cost)
    )
    own = {n: e for n, e in OWN.items() if n not in held}
    return fitted(chi2 + more, chi2 + elsewhere, own=own)


def prune(
    monkeypatch: pytest.MonkeyPatch,
    chi2: float,
    breaks_down: str = "",
    holdout_cost: Mapping[str, float] = NONE,
) -> tuple[Fit, list[set[str]]]:
    asked: list[set[str]] = []

    def fit(
        simulator: object,
        data: object,
        left: Sequence[Free],
        *,
        fixed: Mapping[str, float],
        **how: object,
    ) -> Fit:
        assert {f.name for f in left} == {f.name for f in FREE} - set(fixed) and set(
            fixed.values()
        ) == {0.0}
        asked.append(set(fixed))
        if breaks_down in fixed:
            raise SimulationFailure("the step has become too small")
        return known(chi2, list(fixed), holdout_cost)

    monkeypatch.setattr(pruning, "fit", fit)
    return pruning.pruned(None, None, FREE, list(OWN), known(chi2), 1e-4), asked  # type: ignore[arg-type]


def test_what_the_evidence_does_not_miss_is_held(monkeypatch: pytest.MonkeyPatch) -> None:
    pruned_fit, asked = prune(monkeypatch, 1.0)
    assert asked == [{"a"}, {"a", "c"}]  # the least certain first; b is certain
    assert (
        pruned_fit.values["a"] == 0
        and pruned_fit.parameters["a"].held
        and not pruned_fit.parameters["a"].determined
    )
    assert "held" in str(pruned_fit.parameters["a"])
    assert {n: pruned_fit.values[n] for n in "bc"} == {"b": -2.5, "c": 0.2}
    assert list(pruned_fit.parameters) == [f.name for f in FREE]


def test_what_held_out_runs_alone_miss_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    pruned_fit, asked = prune(monkeypatch, 1.0, holdout_cost=NONE | {"a": 500.0})
    assert asked == [{"a"}, {"c"}]
    assert pruned_fit.values["a"] == 0.1
    assert not any(e.held for e in pruned_fit.parameters.values())


def test_a_coefficient_without_which_the_model_breaks_down_stays(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pruned_fit, asked = prune(monkeypatch, 1.0, breaks_down="a")
    assert asked == [{"a"}, {"c"}]
    assert not any(e.held for e in pruned_fit.parameters.values())
    assert pruned_fit.values["a"] == 0.1
