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
from pam_cosim.diagnosis.search.probing import StatedEffect, Strengths, detectable_strength
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


def test_a_strength_is_extrapolated_from_the_weakest_look_that_shows() -> None:
    assert detectable_strength([100.0, 10.0, 1.0], 5.0) == pytest.approx(0.05)  # in proportion
    assert detectable_strength([100.0, 40.0, 4.0], 5.0) == pytest.approx(
        0.1 * 5 / 40
    )  # saturated where it is strong
    assert detectable_strength([100.0, 10.0, 0.0], 5.0) == pytest.approx(
        0.1
    )  # a threshold lies between the last two
    assert detectable_strength([1.0], 5.0) == pytest.approx(5.0)
    assert detectable_strength([0.0], 5.0) == math.inf


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


def test_a_form_that_pays_for_many_parameters_is_not_taken_for_a_plain_one() -> None:
    """That the price of four more parameters tells them apart needs no strength at all."""
    plain, rich = stated("Spring", "elasticity", 40 * unit(1)), stated("Hole", "leak", 40 * unit(1))
    names = [f"Hole.{i}" for i in range(4)]
    further = tuple(Free(name, -1e6, 1e6, 1.0, "N") for name in names)
    slopes = np.column_stack([rich.linear.slopes, *(5 * unit(2 + i) for i in range(4))])
    limits = np.append(rich.linear.high, np.full(4, 1e6))
    linear = replace(
        rich.linear, names=(*rich.linear.names, *names), slopes=slopes, low=-limits, high=limits,
        values=np.append(rich.linear.values, np.zeros(4)),
    )  # fmt: skip
    absent = {**rich.strengths.absent, **dict.fromkeys(names, 0.0)}
    strengths = Strengths((*rich.strengths.own, *further), absent)
    told = rows(plain, replace(rich, linear=linear, strengths=strengths)).identifiability()
    assert not any(a.effect == "Spring" for a in told.alike)


def vessel(folder: Path, text: str = EXPERIMENT) -> pam.Check:
    folder.mkdir()
    (folder / "experiment.toml").write_text(text)
    (folder / "one.csv").write_text(table())
    return pam.check(pam.read(folder), workers=0)


@pytest.mark.full
def test_the_deviations_of_a_vessel_are_those_of_its_fit(tmp_path: Path) -> None:
    """The fit is asked at the optimum and the check at the start values, so that they are alike, not equal."""
    told = vessel(tmp_path / "rig").identifiability
    fit = pam.fit(pam.read(tmp_path / "rig"))
    for known in told.parameters:
        estimate = fit.parameters[known.name]
        deviation = (estimate.high - estimate.low) / 2 / 1.96
        assert known.determined
        assert 0.5 < known.deviation / deviation < 2.0


@pytest.mark.full
def test_measuring_the_temperature_of_a_vessel_helps(tmp_path: Path) -> None:
    """Pressure alone says little of heat, and nothing of what reads a temperature."""
    check = vessel(tmp_path / "rig")
    assert {"temperature_sensor", "thermocouple_lag"} <= set(check.identifiability.hidden) | set(
        check.no_place
    )
    (temperature,) = [h for h in check.helps if h.option.text.startswith("T in every run")]
    assert "temperature_sensor" in temperature.shows
    assert temperature.sharper < 0.5
    assert "elasticity" in check.no_place
    assert "what would help most:" in str(check)


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
