"""The rows of a diagnosis, and the signal that is spoken of, from numbers that are written down."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from pam_cosim.measurement import Signal
from pam_cosim.reporting.account import error_sentence
from pam_cosim.reporting.account.diagnosis_rows import candidate_row, summary_rows
from tests.diagnosis.synthetic import candidate, fitted
from tests.reporting.synthetic import make_diagnosis


def test_a_candidate_is_listed_with_both_chi_squares() -> None:
    compared: Any = SimpleNamespace(chi2_reduced={"fit": 1.25, "holdout": 4.5}.__getitem__)
    leak = candidate("Leak", replace(fitted(1.25, holdout=4.5), comparison=compared))
    row = candidate_row(fitted(10.0), leak, ())
    assert (row["chi2"], row["holdout"], row["added"]) == ("1.25", "4.50", False)


def test_errors_are_printed_with_the_noise_of_their_signals() -> None:
    rows = summary_rows(make_diagnosis("identified"))
    noise = {(row["role"], row["name"]): row["noise"].replace("\u00a0", " ") for row in rows}
    expected = {"p": "0.500 kPa", "x": "0.200 mm", "T": "0.300 K"}
    assert noise == {(r, n): text for r in ("fit", "holdout") for n, text in expected.items()}


def _fit(chi2: dict[str, float]) -> Any:
    """Of signals with these reduced chi-squares, all of a noise of 1 N."""
    scores = {
        n: SimpleNamespace(chi2_reduced=c, rmse=c**0.5, noise_rmse=1.0) for n, c in chi2.items()
    }
    signals = {name: Signal(name, "N", 1.0, fitted=name != "unfitted") for name in chi2}
    data = SimpleNamespace(signals=signals)
    return SimpleNamespace(
        comparison=SimpleNamespace(scores={"fit": scores, "holdout": {}}, data=data)
    )


@pytest.mark.parametrize(
    ("after", "named"),
    [
        (
            {"worst": 80.0, "gains": 1.0, "ratio": 0.1, "unfitted": 1.0},
            "gains falls from 7 N to 1 N",
        ),
        (None, "worst is 10 N"),
    ],
)
def test_the_printed_error_is_of_the_signal_that_gains_most(
    after: dict[str, float] | None, named: str
) -> None:
    """Not of the worst one, unless nothing was added, nor of the largest ratio, nor of one that was not fitted."""
    before = {"worst": 100.0, "gains": 49.0, "ratio": 20.0, "unfitted": 500.0}
    base = _fit(before)
    said = error_sentence(base, base if after is None else _fit(after))
    assert f"the rms error of {named}; the noise is 1 N." in said
