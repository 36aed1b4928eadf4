"""The map of a ledger: same bytes for the same ledger, and a panel for each balance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pam_cosim.ledger import BalanceEntry, Ledger, TermSeries
from pam_cosim.reporting.figures.ledger import ledger_figure
from pam_cosim.reporting.style import drawing
from tests.field import DOMAIN


def _ledger(places: bool = True) -> Ledger:
    t = np.linspace(0, 10, 101)
    x = 0.03 + 0.02 * np.sin(t)
    against = {"x": x, "v": 0.02 * np.cos(t), "p_gauge": 1e5 + 1e4 * np.cos(t)}
    course = TermSeries("run-01", "fit", t, 200 * x, np.full_like(t, 0.3), against)
    force = BalanceEntry(
        "force", 100.0, 0.9, 0.75, "N", "Missing force", (course,), {"x": "m", "v": "m/s", "p_gauge": "Pa"}
    )  # fmt: skip
    entries = (
        force if places else BalanceEntry("force", 100.0, 0.9, 0.75),
        BalanceEntry("mass", 10.0, 0.1, 0.25),
    )
    return Ledger("Isotonic", entries, ("force", "mass"), True, 9.0, 1.0, {}, domain=DOMAIN)


def test_shares_and_panels() -> None:
    with drawing():
        figure = ledger_figure(_ledger())
        labels = [a.get_ylabel() for a in figure.axes]
        texts = [t.get_text() for t in figure.axes[0].texts]
        bars = [patch.get_width() for patch in figure.axes[0].patches]
    assert texts == ["force 75 %", "mass 25 %"] and np.allclose(bars, [0.75, 0.25])
    assert "missing force [N]" in labels and "p_gauge [kPa]" in labels


def test_the_domain_determines_the_axes_of_a_term() -> None:
    with drawing():
        axes = ledger_figure(_ledger()).axes
        plain = ledger_figure(
            replace(_ledger(), domain=replace(DOMAIN, axes=("v",), planes=()))
        ).axes
    assert [a.get_xlabel() for a in axes[1:4]] == ["time [s]", "x [mm]", "p_gauge [kPa]"]
    assert [a.get_xlabel() for a in plain[1:4]] == ["time [s]", "v [m/s]", "x [mm]"]
    assert "one variable only: no plane" in [t.get_text() for a in plain for t in a.texts]
