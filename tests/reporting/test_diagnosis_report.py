from __future__ import annotations

import base64
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from functools import cache

import pytest

from pam_cosim.diagnosis.judgement.posterior import Explanation, Posterior
from pam_cosim.reporting import diagnosis_report, diagnosis_text
from pam_cosim.reporting.account import percent
from tests.reporting.html_checks import checked
from tests.reporting.synthetic import EQUATIONS, make_data, make_diagnosis
from tests.tiers import quick

KINDS = ("none_missing", "identified", "ambiguous", "unknown")


@cache
def report(kind):
    return diagnosis_report(make_diagnosis(kind))


@pytest.mark.parametrize("kind", quick(KINDS, "identified"))
def test_every_verdict_makes_a_sound_page_that_names_what_was_tried(kind):
    diagnosis = make_diagnosis(kind)
    page = checked(report(kind))
    for candidate in diagnosis.candidates:
        assert candidate.effect in page.text
    assert diagnosis.verdict.reason in page.text
    assert "no start value <can> be simulated" in page.text
    assert "pam-cosim" in page.text and "1800 " in f"{page.text} "


@pytest.mark.full
def test_each_verdict_is_said_and_explained_in_its_own_words():
    texts = {kind: checked(report(kind)).text for kind in KINDS}
    assert "These data show no missing effect" in texts["none_missing"]
    assert "The model lacks elasticity (StiffWall)." in texts["identified"]
    assert "these data cannot separate elasticity and end shape" in texts["ambiguous"]
    assert "no effect of the catalogue explains it" in texts["unknown"]
    assert "That does not prove that the model is complete" in texts["none_missing"]
    assert "Do not choose one by its small lead" in texts["ambiguous"]
    assert "do not trust them as physical values" in texts["unknown"]


def test_the_error_before_and_after_stands_first_in_readable_units():
    diagnosis = make_diagnosis("identified")
    text = checked(report("identified")).text
    before, after = (
        f.comparison.scores["holdout"]["p"].rmse for f in (diagnosis.base, diagnosis.final)
    )
    assert before == pytest.approx(3.6e3, rel=0.1) and after == pytest.approx(500, rel=0.1)
    assert f"{before / 1e3:.2f} kPa" in text and f"{after / 1e3:.3f} kPa" in text
    assert "On runs that were never fitted the rms error of" in text
    assert (
        text.index("The model lacks")
        < text.index("The error ladder")
        < text.index("Measured against model")
    )
    assert (
        text.index("Where the error")
        < text.index("Which effects")
        < text.index("What this verdict means")
    )


@pytest.mark.full
def test_what_may_be_missing_is_a_bar_with_its_numbers():
    diagnosis = make_diagnosis("identified")
    assert "Probability of what may be missing" not in report(
        "identified"
    )  # one that was saved before there was any
    sets = (
        Explanation(("elasticity",), 0.0, 0.6),
        Explanation((), 9.0, 0.2),
        Explanation(("leak",), 30.0, 0.004),
    )
    known = Posterior(sets, 0.196, ("unchecked",))
    stated = replace(
        diagnosis, verdict=replace(diagnosis.verdict, posterior=known, probability=0.6)
    )
    html = diagnosis_report(stated)
    checked(html)
    bar = (
        (0.6, "elasticity"),
        (0.2, "nothing is missing"),
        (0.196, "something no effect describes"),
    )
    assert f"missing: {'; '.join(f'{percent(share)}  {what}' for share, what in bar)}" in html
    assert "Otherwise: nothing 20 %, something else 20 %" in diagnosis_text(stated)
    assert diagnosis_report(stated) == html


def test_parameters_have_intervals_units_and_plain_remarks():
    text = checked(report("identified")).text
    assert "bladder.k StiffWall – 812 804 to 820 N/m" in text
    assert "valve.C_A base model 0.712 0.699 0.695 to 0.703" in text
    assert "bladder.L_free StiffWall – 200 – mm not determined by these data, at its bound" in text
    assert "film.h StiffWall – 7.6 7.1 to 8.1 W/(m²·K)" in text
    assert "mm at its bound" in text


def test_ranking_gives_the_evidence_and_marks_what_was_added():
    html = report("identified")
    text = checked(html).text
    assert "−5200" in text
    assert (
        "98 %" not in text
    )  # a candidate's weight by that criterion is not the verdict's probability
    assert html.count('<tr class="added">') == 1
    assert "Could not be fitted" in text


@pytest.mark.full
def test_titles_and_names_cannot_carry_markup():
    title = "<script>alert('x')</script> & \"friends\""
    data = make_data(title=title)
    html = diagnosis_report(make_diagnosis("identified", data))
    assert "<script" not in html
    assert title in checked(html).text


@pytest.mark.full
def test_the_final_model_can_be_read():
    html = report("identified")
    page = checked(html)
    assert EQUATIONS in "".join(page.texts)
    assert "details" in page.tags
    assert "Modelica text" not in checked(report("none_missing")).text


def test_pictures_are_complete_vector_pictures_without_outside_resources():
    page = checked(report("identified"))
    sources = [value for tag, name, value in page.attributes if (tag, name) == ("img", "src")]
    assert len(sources) == 7
    for source in sources:
        assert source.startswith("data:image/svg+xml;base64,")
        root = ElementTree.fromstring(base64.b64decode(source.split(",", 1)[1]))
        links = [v for e in root.iter() for n, v in e.attrib.items() if n.endswith("href")]
        assert all(link.startswith(("#", "data:")) for link in links)
