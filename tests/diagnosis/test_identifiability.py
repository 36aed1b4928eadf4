"""What data can tell: by hand in a linear world, and of a vessel whose fits are made too."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.planning.hypothetical_measurements import AS_MEASURED, Option
from pam_cosim.diagnosis.planning.identifiability import Rows
from pam_cosim.diagnosis.search.probing import StatedEffect, Strengths
from pam_cosim.errors import InputError
from pam_cosim.fitting import Free, Linear
from tests.cli.conftest import EXPERIMENT, table

COUNT = 200
PRICE = math.log(COUNT)
MORE = Option("signal", "another")
WIDE = np.array([1e6])


def unit(row: int) -> np.ndarray:
    return np.eye(2 * COUNT)[:, row]


BASE = Linear(("a",), np.array([0.0]), -WIDE, WIDE, np.zeros(2 * COUNT), 5 * unit(0)[:, None])


def stated(
    effect: str, family: str, does: np.ndarray, weaker: float = CRITERIA.search.weaker
) -> StatedEffect:
    """An effect of one parameter, which does this at its stated value, and so much of it when weaker."""
    name = f"{effect}.k"
    own = Free(name, -1e6, 1e6, 1.0, "N")
    slopes = np.column_stack([BASE.slopes, does])
    limits = np.append(WIDE, 1e6)
    linear = Linear(
        ("a", name), np.array([0.0, 1.0]), -limits, limits, BASE.residual - does, slopes
    )
    return StatedEffect(
        effect, family, Strengths((own,), {name: 0.0}), linear, (BASE.residual - weaker * does,)
    )


def rows(*effects: StatedEffect) -> Rows:
    option = [AS_MEASURED] * COUNT + [MORE] * COUNT
    return Rows(BASE, {"a": "m"}, effects, option, {AS_MEASURED: COUNT, MORE: COUNT})


def test_a_parameter_is_known_as_well_as_the_samples_move_with_it() -> None:
    (known,) = rows().identifiability().parameters
    assert known.deviation == pytest.approx(1 / 5)
    assert known.determined


def test_a_parameter_that_moves_nothing_is_known_as_well_as_its_bounds() -> None:
    still = replace(BASE, slopes=0 * BASE.slopes)
    (known,) = (
        Rows(still, {"a": "m"}, [], [AS_MEASURED] * 2 * COUNT, {AS_MEASURED: 2 * COUNT})
        .identifiability()
        .parameters
    )
    assert known.deviation == pytest.approx(2e6 / math.sqrt(12))  # of an even distribution
    assert not known.determined


def test_an_effect_shows_by_what_no_free_parameter_does() -> None:
    (shown,) = (
        rows(stated("Spring", "elasticity", 30 * unit(0) + 20 * unit(1))).identifiability().effects
    )
    assert shown.size == pytest.approx(20.0, rel=1e-6)
    needed = math.sqrt(CRITERIA.evidence.very_strong + PRICE)
    assert shown.least == pytest.approx(needed / 20, rel=1e-6)
    assert shown.values == {"Spring.k": pytest.approx(needed / 20, rel=1e-6)}


def test_what_does_nothing_is_hidden_and_a_faint_effect_is_not_visible() -> None:
    told = rows(
        stated("None", "leak", 0 * unit(1)), stated("Faint", "creep", 2 * unit(1))
    ).identifiability()
    assert told.hidden == ("leak",)
    assert told.visible == frozenset()
    assert told.families["creep"].least > 1


def test_what_begins_at_a_threshold_shows_where_it_was_seen_or_not_at_all() -> None:
    strong = stated("Ceiling", "saturation", 50 * unit(1), weaker=0.0)
    weak = stated("High", "saturation", 1 * unit(1), weaker=0.0)
    assert [s.least for s in rows(strong).identifiability().effects] == [1.0]
    assert [s.least for s in rows(weak).identifiability().effects] == [math.inf]


def test_families_that_do_the_same_are_told_apart_by_a_signal_in_which_they_differ() -> None:
    same, apart = 40 * unit(1), unit(COUNT + 1)
    told = rows(
        stated("Spring", "elasticity", same), stated("Hole", "leak", 0.5 * same + 60 * apart)
    )
    now, then = told.identifiability(), told.identifiability(MORE)
    assert [{a.family, a.other_family} for a in now.alike] == [{"elasticity", "leak"}]
    assert not now.pairs
    assert then.pairs == {frozenset(("elasticity", "leak"))}
    assert told.further == [MORE]


def vessel(folder: Path, text: str = EXPERIMENT) -> pam.Check:
    folder.mkdir()
    (folder / "experiment.toml").write_text(text)
    (folder / "one.csv").write_text(table())
    return pam.check(pam.read(folder), workers=0)


def test_a_parameter_that_data_do_not_determine_is_named(tmp_path: Path) -> None:
    """The volume and the area of the hole act as their ratio alone."""
    text = EXPERIMENT.replace(
        '"tank.n" =', '"tank.V" = { min = "16.2 l", max = "16.3 l" }\n"tank.n" ='
    ).replace('"tank.V" = "16.2 l"\n', "")
    known = {k.name: k for k in vessel(tmp_path / "rig", text).identifiability.parameters}
    assert not known["tank.V"].determined
    assert known["tank.n"].determined


def test_an_fmu_has_no_place_for_effects(tmp_path: Path) -> None:
    vessel(tmp_path / "rig")
    fmu = str(pam.build("VesselOrifice", tmp_path / "Some.fmu"))
    with pytest.raises(InputError, match="Modelica model only"):
        pam.diagnose(pam.read(tmp_path / "rig"), fmu)
