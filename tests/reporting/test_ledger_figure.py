"""The map of a ledger: same bytes for the same ledger, and a panel for each balance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pam_cosim.ledger import Course, Entry, Ledger
from pam_cosim.reporting.figures.ledger import ledger_figure, telling
from pam_cosim.reporting.style import drawing, png


def _ledger(places: bool = True) -> Ledger:
    t = np.linspace(0, 10, 101)
    x = 0.03 + 0.02 * np.sin(t)
    against = {"x": x, "v": 0.02 * np.cos(t), "p_gauge": 1e5 + 1e4 * np.cos(t)}
    course = Course("run-01", "fit", t, 200 * x, np.full_like(t, 0.3), against)
    force = Entry(
        "force", 100.0, 0.9, 0.75, "N", "Missing force", "f", (course,), {"x": "m", "v": "m/s", "p_gauge": "Pa"}
    )  # fmt: skip
    entries = (force if places else Entry("force", 100.0, 0.9, 0.75), Entry("sensor", 10.0, 0.1, 0.25))
    return Ledger("Isotonic", entries, (), ("force", "sensor"), True, 9.0, 1.0, {})


def test_same_ledger_same_picture() -> None:
    with drawing():
        first, second = (png(ledger_figure(_ledger())) for _ in range(2))
    assert first == second and first.startswith(b"\x89PNG")


def test_shares_and_panels() -> None:
    with drawing():
        figure = ledger_figure(_ledger())
        labels = [a.get_ylabel() for a in figure.axes]
        texts = [t.get_text() for t in figure.axes[0].texts]
        bars = [patch.get_width() for patch in figure.axes[0].patches]
    assert texts == ["force 75 %", "sensor 25 %"] and np.allclose(bars, [0.75, 0.25])
    assert "missing force [N]" in labels and "p_gauge [kPa]" in labels


def test_model_without_place_for_a_term() -> None:
    with drawing():
        texts = [t.get_text() for a in ledger_figure(_ledger(places=False)).axes for t in a.texts]
    assert "the model has no place for a missing term" in texts


def test_balances_without_a_part_in_the_error_are_not_drawn() -> None:
    ledger = _ledger()
    force = ledger.entries[0]
    mass = replace(force, balance="mass", share=0.0)
    assert [e.balance for e in telling(replace(ledger, entries=(force, mass)))] == ["force"]
    failing = replace(ledger, entries=(force, mass), failing=("mass",))
    assert [e.balance for e in telling(failing)] == ["force", "mass"]
    quiet = replace(ledger, entries=(replace(force, share=0.0), mass), failing=())
    assert [e.balance for e in telling(quiet)] == ["force", "mass"]
