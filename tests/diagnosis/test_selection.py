"""When general members of families are tried, and what becomes of them; the fits are written down."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from pam_cosim.catalogue import effect_classes
from pam_cosim.compiler import read_library
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.search import Search
from pam_cosim.diagnosis.selection import select_effects
from pam_cosim.diagnosis.trial import Trial
from pam_cosim.fitting import Fit
from tests.diagnosis.synthetic import fitted

TREE = read_library()
MODEL = "PneumaticMuscle.Benches.Isotonic"
BASE = fitted(100.0, holdout=100.0, score=50.0)
USELESS = fitted(99.0, holdout=99.0, score=50.0)
NEAR = fitted(2.5, holdout=2.5, score=30.0, parameters=4)
NOISE = fitted(1.0, holdout=1.0, parameters=6)


@dataclass(frozen=True)
class Told(Search):
    """A search whose fits are known: by the effects in the model, else of no use."""

    fits: Mapping[tuple[str, ...], Fit] = field(default_factory=dict)
    tried: list[tuple[str, ...]] = field(default_factory=list)

    def _run(self, how: str, trials: Sequence[Trial]) -> list[Candidate]:
        self.tried.extend(t.effects for t in trials)
        return [replace(t.candidate(fit=self.fits.get(t.effects, USELESS)), own_parameters=()) for t in trials]


def search(fits: Mapping[str, Fit]) -> Told:
    named = {tuple(names.split(" + ")): fit for names, fit in fits.items()}
    return Told(TREE, MODEL, effect_classes(TREE), None, fits=named)  # type: ignore[arg-type]


def selected_effects(searched: Told, base: Fit = BASE) -> list[str]:
    path, _ = select_effects(searched, base)
    return list(path[-1].effects) if path else []


def generals(searched: Told) -> set[str]:
    return {names[-1] for names in searched.tried if names[-1].startswith("General")}


def test_general_members_wait_where_a_simple_one_leaves_noise() -> None:
    simple = search({"OrificeLeak": NOISE, "GeneralLeak": NOISE})
    assert selected_effects(simple) == ["OrificeLeak"]
    assert not generals(simple)


def test_nothing_is_tried_with_them_where_nothing_is_missing() -> None:
    nothing = search({})
    assert selected_effects(nothing, fitted(1.0, holdout=1.0)) == []
    assert not generals(nothing)


def test_the_general_member_of_the_leading_family_comes_before_a_second_effect() -> None:
    led = search({"OrificeLeak": NEAR, "FlexibleLeak": NEAR, "GeneralLeak": NOISE})
    assert selected_effects(led) == ["GeneralLeak"]
    assert "GeneralLeak" in generals(led) and len(generals(led)) <= 3


def test_the_general_members_of_all_families_are_the_last_resort() -> None:
    lost = search({"GeneralCreep": NOISE})
    assert selected_effects(lost) == ["GeneralCreep"]
    assert generals(lost) == {e.name for e in effect_classes(TREE) if e.general}


def test_two_effects_where_no_general_member_leaves_noise() -> None:
    two = search({"OrificeLeak": NEAR, "GeneralLeak": NEAR, "OrificeLeak + LinearBladder": NOISE})
    assert selected_effects(two) == ["OrificeLeak", "LinearBladder"]


def test_a_general_member_outdoes_what_leaves_a_remainder_that_does_not_come_again() -> None:
    drifting = fitted(1.3, holdout=1.3, parameters=3)  # above the noise, but not correlated
    outdone = search({"OrificeLeak": drifting, "GeneralLeak": NOISE})
    assert selected_effects(outdone) == ["GeneralLeak"]


PARTLY = fitted(2.0, holdout=2.0, score=30.0, parameters=6)
MOSTLY = fitted(1.25, holdout=1.25, score=30.0, parameters=6)


def test_one_effect_that_takes_away_nearly_all_stays_alone_where_no_second_one_does_the_rest() -> None:
    assert selected_effects(search({"OrificeLeak": NEAR})) == ["OrificeLeak"]
    assert selected_effects(search({"OrificeLeak": NEAR, "OrificeLeak + LinearBladder": PARTLY})) == ["OrificeLeak"]


def test_a_second_effect_stays_that_takes_away_most_of_what_is_left() -> None:
    two = search({"OrificeLeak": NEAR, "OrificeLeak + LinearBladder": MOSTLY})
    assert selected_effects(two) == ["OrificeLeak", "LinearBladder"]


def test_no_effect_is_beyond_doubt_where_another_family_comes_near() -> None:
    near = fitted(4.0, holdout=4.0, score=30.0, parameters=4)
    two = search({"OrificeLeak": NEAR, "LaminarLine": near, "OrificeLeak + LinearBladder": PARTLY})
    assert selected_effects(two) == ["OrificeLeak", "LinearBladder"]


def test_an_effect_of_a_pair_gives_way_to_another_form_of_its_family_a_listed_one_first() -> None:
    half = fitted(50.0, holdout=50.0, score=50.0, parameters=3)
    fits = {"MaxwellSlipFriction": half, "MaxwellSlipFriction + ValveDelay": fitted(7.0, holdout=7.0, score=30.0)}
    listed = search({**fits, "ValveDelay + CoulombFriction": NOISE})
    assert selected_effects(listed) == ["ValveDelay", "CoulombFriction"]
    assert ("ValveDelay", "GeneralDryFriction") not in listed.tried
    assert selected_effects(search({**fits, "ValveDelay + GeneralDryFriction": NOISE})) == [
        "ValveDelay",
        "GeneralDryFriction",
    ]


def test_a_second_effect_is_added_to_the_law_unless_the_general_member_does_much_better() -> None:
    little, much = (fitted(c, holdout=c, score=30.0, parameters=8) for c in (2.4, 1.25))
    law = search({"OrificeLeak": NEAR, "GeneralLeak": little, "OrificeLeak + LinearBladder": NOISE})
    assert selected_effects(law) == ["OrificeLeak", "LinearBladder"]
    general = search({"OrificeLeak": NEAR, "GeneralLeak": much, "GeneralLeak + LinearBladder": NOISE})
    assert selected_effects(general) == ["GeneralLeak", "LinearBladder"]
