"""The map of a ledger: same bytes for the same ledger, and a panel for each balance."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.ledger import BalanceEntry, Ledger, TermSeries
from pam_cosim.reporting.account.ledger_words import telling_entries
from pam_cosim.reporting.figures.ledger import ledger_figure
from pam_cosim.reporting.style import balance_colours, drawing, image
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
        BalanceEntry("sensor", 10.0, 0.1, 0.25),
    )
    return Ledger("Isotonic", entries, (), ("force", "sensor"), True, 9.0, 1.0, {}, domain=DOMAIN)


@pytest.mark.full
def test_same_ledger_same_picture() -> None:
    with drawing():
        first, second = (image(ledger_figure(_ledger())) for _ in range(2))
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
    assert [e.balance for e in telling_entries(replace(ledger, entries=(force, mass)))] == ["force"]
    failing = replace(ledger, entries=(force, mass), failing=("mass",))
    assert [e.balance for e in telling_entries(failing)] == ["force", "mass"]
    quiet = replace(ledger, entries=(replace(force, share=0.0), mass), failing=())
    assert [e.balance for e in telling_entries(quiet)] == ["force", "mass"]


def test_each_balance_has_its_colour_in_the_order_of_the_field() -> None:
    """Also one that the field does not name; the sensor's is the same everywhere."""
    own = balance_colours(DOMAIN.balances)
    assert list(own) == ["force", "mass", "energy", "sensor"] and len(set(own.values())) == 4
    more = balance_colours(DOMAIN.balances, ["sensor", "charge"])
    assert {name: more[name] for name in own} == own and more["charge"] not in own.values()
    assert balance_colours(["voltage"])["sensor"] == own["sensor"]


def test_the_field_says_what_a_term_is_drawn_against() -> None:
    with drawing():
        axes = ledger_figure(_ledger()).axes
        plain = ledger_figure(
            replace(_ledger(), domain=replace(DOMAIN, axes=("v",), planes=()))
        ).axes
    assert [a.get_xlabel() for a in axes[1:4]] == ["time [s]", "x [mm]", "p_gauge [kPa]"]
    assert [a.get_xlabel() for a in plain[1:4]] == ["time [s]", "v [m/s]", "x [mm]"]
    assert "one variable only: no plane" in [t.get_text() for a in plain for t in a.texts]
