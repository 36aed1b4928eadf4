"""A rig that cannot be simulated is drawn again, so that every number of a set gives a data set."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from blind_cases import many
from rig.integrate import integrate
from rig.schedule import Phase, Schedule


def _root(y: Sequence[float], told: Any) -> list[float]:
    return [-sqrt(y[0]) - 1.0]


def _quotient(y: Sequence[float], told: Any) -> list[float]:
    return [1.0 / (y[0] - y[0])]


def _too_large(y: Sequence[float], told: Any) -> list[float]:
    return [10.0 ** (400.0 + y[0])]


@pytest.mark.parametrize("method", ["LSODA", "BDF"])
@pytest.mark.parametrize("rates", [_root, _quotient, _too_large])
def test_what_an_equation_cannot_compute_is_a_simulation_that_failed(
    rates: Any, method: str
) -> None:
    schedule, times = Schedule.of([Phase(1.0)]), np.linspace(0.0, 1.0, 11)
    with pytest.raises(RuntimeError, match="integration"):
        integrate(rates, [0.1], schedule, times, [1e-9], 1e-6, method)


@pytest.mark.full
def test_a_case_whose_rig_fails_is_drawn_again_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    case = next(c for c in (many.case_of("tuning2", n) for n in range(80)) if c.group == "null")
    drawn: list[int] = []
    simulated = many._made

    def failing(case: many.Case, changed: Any) -> many.Made:
        drawn.append(case.draw)
        if len(drawn) < 3:
            raise RuntimeError("no rig of this draw runs")
        return simulated(case, changed)

    first = many.make(case)
    monkeypatch.setattr(many, "_made", failing)
    again = many.make(case)
    assert drawn == [0, 1, 2]
    assert "draw" not in first.description and again.description["draw"] == 2
    assert again.description["rig"] != first.description["rig"]
    same = ("group", "bench", "signals", "rate", "runs", "hidden")
    assert all(again.description[name] == first.description[name] for name in same)
    drawn.clear()
    monkeypatch.setattr(many, "_made", lambda case, changed: _failing_always(case, drawn))
    with pytest.raises(RuntimeError):
        many.make(case)
    assert drawn == list(range(many.DRAWS + 1))


def _failing_always(case: many.Case, drawn: list[int]) -> many.Made:
    drawn.append(case.draw)
    raise RuntimeError("no rig of any draw runs")


@pytest.mark.full
def test_a_number_that_had_no_data_set_has_one(tmp_path: Path) -> None:
    """Its tank emptied below nothing in a trial step of the integrator."""
    made = many.make(many.case_of("score2", 237))
    many.write(made, tmp_path / "data")
    assert made.description["draw"] >= 1
    assert (tmp_path / "data" / "experiment.toml").exists()
