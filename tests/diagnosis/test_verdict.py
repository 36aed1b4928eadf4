"""All kinds of verdict from statistics that are written down."""

from __future__ import annotations

from dataclasses import replace

import pytest

from pam_cosim.comparison import ResidualStatistics
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.judgement.verdict import explained
from pam_cosim.diagnosis.judgement.verdict_sentences import meaning, probability_sentence
from pam_cosim.fitting import Fit
from pam_cosim.measurement import Signal
from pam_cosim.model.domain import Domain
from tests.diagnosis.synthetic import candidate, fitted, judged, models_of, statistics

BASE = fitted(10.0, holdout=9.0, score=50.0)
LOUD = fitted(100.0, holdout=100.0, score=50.0)
GOOD = candidate("Leak", fitted(1.0, holdout=1.0), "leak", balance="mass")


def test_none_missing() -> None:
    verdict = judged(fitted(1.0, holdout=1.02, score=1.0), [], [])
    assert (verdict.kind, verdict.families, verdict.effects) == ("none_missing", (), ())


def test_structure_in_the_holdout_runs_alone_is_enough_to_object() -> None:
    odd = fitted(1.0, holdout=2.0)
    odd.residuals["holdout"] = BASE.residuals["holdout"]
    assert judged(odd, [], []).kind == "unknown"


def test_identified() -> None:
    verdict = judged(BASE, [GOOD], [])
    assert (verdict.kind, verdict.families, verdict.effects) == ("identified", ("leak",), ("Leak",))
    assert "100.0 %" in verdict.reason


def test_a_general_member_leaves_the_form_open() -> None:
    verdict = judged(BASE, [replace(GOOD, general=True)], [])
    assert verdict.kind == "identified" and verdict.families == ("leak",)
    assert "Only the family (leak) is identified" in verdict.reason
    assert "Only the family" not in judged(BASE, [GOOD], []).reason


def test_several_effects_in_the_order_in_which_they_were_added() -> None:
    second = candidate("Lag", fitted(1.0, holdout=1.0), "valve", before=("Leak",))
    verdict = judged(
        BASE, [candidate("Leak", fitted(3.0, holdout=3.0, score=30.0), "leak"), second], []
    )
    assert (verdict.families, verdict.effects) == (("leak", "valve"), ("Leak", "Lag"))
    assert verdict.reason.startswith("Leak + Lag removes")


def test_a_signal_that_was_not_fitted_is_judged_too() -> None:
    """Nobody says "nothing else" beside a thermometer that is off."""
    seen = Signal("p", "Pa", 1.0)
    off = candidate("Leak", fitted(1.0, holdout=1.0, shown={"T": 16.0}, measured=seen), "leak")
    verdict = judged(BASE, [off], [], [off], {"Leak": "leak"})
    assert verdict.off == ("T",)
    assert "the residual of p is noise. T, compared but not fitted, is 16 K off" in verdict.reason
    assert "nothing else" not in probability_sentence(replace(verdict, probability=0.7))
    near = candidate("Leak", fitted(1.0, holdout=1.0, shown={"T": 1.5}, measured=seen), "leak")
    sound = judged(BASE, [near], [], [near], {"Leak": "leak"})
    assert sound.off == () and "not fitted" not in sound.reason
    assert "nothing else" in probability_sentence(replace(sound, probability=0.7))


def test_models_that_come_as_near_are_named_with_the_reason() -> None:
    family = {"Leak": "leak", "Gauge": "gauge", "Bends": "spring"}
    best = candidate("Leak", fitted(1.0, holdout=1.0, shown={"T": 16.0}), "leak")
    wrong = candidate("Gauge", fitted(1.0, holdout=1.0, shown={"T": 38.0}), "gauge")
    bends = replace(
        candidate("Bends", fitted(1.0, holdout=1.0, shown={"T": 16.0}), "spring"), general=True
    )
    alone = judged(BASE, [best], [], [best], family)
    assert "No effect of another family comes close." in meaning(alone, Domain())
    verdict = judged(BASE, [best], [], [best, wrong, bends], family)
    assert (verdict.refuted, verdict.bending) == (("Gauge",), ("Bends",))
    said = meaning(verdict, Domain())
    assert (
        "Gauge would fit it as well, but misses T by far more." in said
        and "Bends fits as well" in said
    )
    assert "No effect of another family" not in said


def test_ambiguous_names_all() -> None:
    verdict = judged(BASE, [GOOD], [candidate("Offset", fitted(1.001, holdout=1.001), "offset")])
    assert verdict.kind == "ambiguous"
    assert verdict.families == ("leak", "offset") and verdict.effects == ("Leak", "Offset")
    assert "leak and offset" in verdict.reason


def test_unknown_without_and_with_effects() -> None:
    nothing = judged(BASE, [], [])
    assert (nothing.kind, nothing.families) == ("unknown", ())
    part = candidate("Leak", fitted(3.0, holdout=3.0, score=30.0), "leak")
    some = judged(BASE, [part], [])
    assert (some.kind, some.families) == ("unknown", ("leak",))
    assert "something else is missing" in some.reason


def test_the_one_family_that_takes_away_nearly_all_is_identified_and_its_form_left_open() -> None:
    one = candidate("Leak", fitted(1.3, holdout=1.3, score=30.0), "leak")
    far, near = (
        candidate("Lag", fitted(chi2, holdout=2.0, score=30.0), "valve") for chi2 in (5.0, 1.5)
    )
    verdict = judged(LOUD, [one], [], [one, far])
    assert (verdict.kind, verdict.families) == ("identified", ("leak",))
    assert "not in the catalogue" in verdict.reason and verdict.remainder
    assert not judged(LOUD, [GOOD], [], [GOOD]).remainder
    assert judged(LOUD, [one], [], [one, far, near]).kind == "unknown"


def test_what_leaves_structure_is_unknown_whatever_its_rivals() -> None:
    dry = candidate("Dry", fitted(50.0, holdout=49.0, score=30.0), "dry_friction")
    rate = candidate("Rate", fitted(50.1, holdout=49.0, score=30.0), "rate_friction")
    verdict = judged(LOUD, [dry], [rate])
    assert (verdict.kind, verdict.families, verdict.effects) == (
        "unknown",
        ("dry_friction",),
        ("Dry",),
    )
    assert (
        "separate dry friction and rate friction" in verdict.reason
        and "something else" in verdict.reason
    )
    second = candidate(
        "Rate", fitted(50.0, holdout=49.0, score=30.0), "rate_friction", before=("Spring",)
    )
    first = candidate("Spring", fitted(60.0, holdout=60.0, score=30.0), "elasticity")
    assert judged(LOUD, [first, second], [dry]).families == ("elasticity", "rate_friction")


@pytest.mark.parametrize(("fit", "holdout"), [(5.0, 1.3), (1.3, 5.0)])
def test_it_takes_away_nearly_all_in_runs_of_both_roles(fit: float, holdout: float) -> None:
    one = candidate("Leak", fitted(fit, holdout=holdout, score=30.0), "leak")
    assert judged(LOUD, [one], [], [one]).kind == "unknown"


def test_share_explained_is_of_the_error_beyond_the_noise_of_the_holdout_runs() -> None:
    assert explained(fitted(3.0, holdout=5.0), fitted(1.0, holdout=2.0)) == pytest.approx(0.75)
    assert explained(fitted(3.0), fitted(2.0)) == pytest.approx(0.5)
    assert explained(fitted(1.0), fitted(0.9)) == 0.0


def _rivals(*others):  # type: ignore[no-untyped-def]  # noqa: ANN002, ANN202
    ranked = rank(BASE, [GOOD, *others])
    assert ranked[0].effect == "Leak"
    return [c.effect for c in models_of(BASE, ranked[:1], ranked, every=len(ranked)).rivals]


def test_rivals_are_close_and_of_other_families() -> None:
    close = candidate("Offset", fitted(1.005, holdout=1.0), "offset")
    far = candidate("Lag", fitted(1.02, holdout=1.0), "lag")
    sister = candidate("SmallLeak", fitted(1.001, holdout=1.0), "leak")
    assert _rivals(close, far, sister) == ["Offset"]


def test_a_general_member_is_no_rival_of_a_law() -> None:
    ranked = rank(
        BASE, [GOOD, replace(candidate("Any", fitted(1.0, holdout=1.0), "line"), general=True)]
    )
    anything, law = sorted(ranked, key=lambda c: not c.general)
    assert models_of(BASE, [law], ranked, every=2).rivals == []
    assert [c.effect for c in models_of(BASE, [anything], ranked, every=2).rivals] == [law.effect]


def test_holdout_runs_refute_a_rival() -> None:
    assert _rivals(candidate("Offset", fitted(1.005, holdout=1.02), "offset")) == []
    assert _rivals(candidate("Offset", fitted(1.005, holdout=1.005), "offset")) == ["Offset"]


def test_signals_that_were_not_fitted_refute_a_rival() -> None:
    best = candidate("Gas", fitted(1.0, shown={"T": 15.0}), "gas")
    for rms, expected in ((80.0, []), (20.0, ["Offset"])):
        other = candidate("Offset", fitted(1.001, shown={"T": rms}), "offset")
        ranked = rank(BASE, [best, other])
        others = models_of(BASE, ranked[:1], ranked, every=len(ranked)).rivals
        assert [c.effect for c in others] == expected


class _Excused(Fit):
    """A fit whose error on held-out runs is within the uncertainty of its parameters."""

    @property
    def residuals_beyond_uncertainty(self) -> dict[str, ResidualStatistics]:
        return {**self.residuals, "holdout": statistics(1.0)}


def test_held_out_runs_that_uncertain_parameters_excuse_check_little() -> None:
    fit = fitted(1.0, holdout=2.0, score=30.0)
    fit = replace(fit, residuals={**fit.residuals, "fit": statistics(1.0)})
    excused = _Excused(fit.model, fit.parameters, fit.comparison, fit.residuals, 1)
    assert judged(LOUD, [candidate("Leak", fit, "leak")], []).kind == "unknown"
    one = candidate("Leak", excused, "leak")
    verdict = judged(LOUD, [one], [])
    assert verdict.kind == "identified" and "they are a weak check" in verdict.reason
    assert "weak check" not in judged(BASE, [GOOD], []).reason
    sure, unsure = (judged(LOUD, [c], [], [c], every=1).probability for c in (GOOD, one))
    assert unsure < sure - 0.1


@pytest.mark.parametrize(
    ("kind", "families", "said"),
    [
        ("none_missing", (), "Probability that nothing is missing: 70 %."),
        ("identified", ("leak",), "Probability that this is missing, and nothing else: 70 %."),
        ("ambiguous", ("leak", "creep"), "Probability that one of these is missing, and nothing else: 70 %."),
        ("unknown", ("leak",), "Probability that this is missing, and nothing else: 70 %."),
        ("unknown", (), "Probability that something is missing that is not listed: 70 %."),
    ],
)  # fmt: skip
def test_the_probability_is_of_what_the_verdict_says(
    kind: str, families: tuple[str, ...], said: str
) -> None:
    """Of a complete model it was said to be that "this, and nothing else, is missing"."""
    verdict = replace(judged(BASE, [GOOD], []), kind=kind, families=families, probability=0.7)  # type: ignore[arg-type]
    assert probability_sentence(verdict) == said
