"""A force that the catalogue lacks is hidden; its formula is learned, composed, refitted and judged on another run."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.catalogue import effect_classes
from pam_cosim.compiler import compile_model, read_library
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.description.learning import (
    LearnedTerm,
    TermSamples,
    coefficients_of,
    learn,
    refitted,
    try_learned,
)
from pam_cosim.diagnosis.description.learning_library import Form, Quantity, forms, quantities
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit
from pam_cosim.ledger import Ledger, keep_ledger
from pam_cosim.measurement import DataSet
from rig.named import UNLISTED, effect_of
from rig.short import write_light_data
from tests.tiers import quick

HIDDEN = {
    "ripple": UNLISTED["ripple"],
    "coupled": UNLISTED["coupled"],
    "exponential": effect_of("elasticity:exponential"),
}


@cache
def _kept(hidden: str) -> tuple[DataSet, Fit, Ledger]:
    data = study.read(write_light_data(Path(mkdtemp()) / "d", [HIDDEN[hidden]], 1))
    base = study.fit(data)
    return data, base, keep_ledger(data, base.values)


def _learned(hidden: str) -> LearnedTerm:
    return learn(_kept(hidden)[2])


@pytest.mark.parametrize("hidden", quick(HIDDEN, "exponential"))
def test_learned_term_brings_the_error_down_on_a_run_it_has_not_seen(
    hidden: str, tmp_path: Path
) -> None:
    data, base, _ = _kept(hidden)
    term = _learned(hidden)
    assert term.balance == "force" and term.score > 0.9
    model = try_learned(term, data, tmp_path, start=base.values)
    assert isinstance(model, Candidate) and model.family == "learned"
    before = base.comparison.chi2_reduced("holdout")
    after = model.fit.comparison.chi2_reduced("holdout")
    assert before > 5 and after < 1.5, (before, after, term.formula)


@pytest.mark.full
def test_the_written_class_starts_from_the_refitted_values(tmp_path: Path) -> None:
    data, base, ledger = _kept("ripple")
    term, entry = _learned("ripple"), ledger.entry("force")
    assert entry is not None
    model = try_learned(term, data, tmp_path, start=base.values)
    assert isinstance(model, Candidate)
    after = refitted(term, entry, model, read_library())
    fitted = {n.rpartition(".")[2]: e.value for n, e in model.parameters.items()}
    assert after.terms[0].coefficient == fitted["c_1"] != term.terms[0].coefficient
    assert f"= {fitted['c_1']:.6g} " in after.modelica_source and after.formula != term.formula


@pytest.mark.full
def test_ripple_is_found_with_its_size_and_length() -> None:
    term = _learned("ripple")
    (addend,) = term.terms
    assert addend.form.words.startswith("sin(2 pi eps/") and addend.form.shape is not None
    assert addend.coefficient == pytest.approx(6.0, rel=0.1)
    assert addend.form.shape.value * 0.24 == pytest.approx(0.03, rel=0.05)
    assert "N sin(2 pi eps/" in term.formula and term.formula.startswith("missing force = ")


def test_class_is_an_effect_like_any_other(tmp_path: Path) -> None:
    term = _learned("exponential")
    file = tmp_path / f"{term.name}.mo"
    file.write_text(term.modelica_source)
    (effect,) = [e for e in effect_classes(read_library(files=[file])) if e.family == "learned"]
    assert effect.parameters == ("c_1", "s_1") and effect.balance == "force"
    assert (
        "not a cause" in " ".join(effect.documentation.split())
        and "Fingerprint:" in effect.documentation
    )
    text = study.add([term.name], "Isotonic", tmp_path / "With.mo", files=[file])
    known = compile_model("With", files=[file, tmp_path / "With.mo"]).interface.parameters
    own = [
        known[n]
        for n in known
        if n.startswith(effect.component_name + ".") and n.endswith(effect.parameters)
    ]
    assert text and len(own) == 2
    for variable in own:
        assert variable.unit and variable.min is not None and variable.max is not None
        assert variable.start is not None and variable.min < variable.start < variable.max


def test_nothing_is_learned_where_nothing_fails() -> None:
    data = study.read(write_light_data(Path(mkdtemp()) / "d", [], 1))
    ledger = keep_ledger(data, {"valve.C_A": 0.72, "muscle.mu_fb": 0.018})
    with pytest.raises(InputError, match="no missing term to learn"):
        learn(ledger)


def test_forms_are_distinct_and_finite() -> None:
    rng = np.random.default_rng(1)
    variables = {
        "x": rng.uniform(0, 0.07, 200),
        "v": rng.uniform(-0.3, 0.3, 200),
        "twice": np.zeros(200),
    }
    variables["twice"] = 2 * variables["x"]
    known = quantities(variables, {"x": "m", "v": "m/s", "twice": "m"})
    assert [(q.name, q.signed) for q in known] == [("x", False), ("v", True)]
    library = forms(known)
    assert len({(f.text, f.shape) for f in library}) == len(library) > 20
    assert all(np.isfinite(f.values(variables)).all() for f in library)


@pytest.mark.parametrize("alike", [1.0, 30.0], ids=["imitated", "by itself"])
@pytest.mark.parametrize("groups", [(0, 1, 2, 3), (0, 1, 2)], ids=["cross-validated", "held out"])
def test_a_form_that_a_free_parameter_imitates_explains_no_more(
    alike: float, groups: tuple[int, ...]
) -> None:
    """Least squares took the form and the parameter against each other, and the score came to one."""
    rng, count = np.random.default_rng(1), 4000
    imitated, own = 30.0 * rng.standard_normal((count, 1)), rng.standard_normal(count)
    value = own + 2.0 * rng.standard_normal(count)
    value -= imitated[:, 0] * (imitated[:, 0] @ value) / float(imitated[:, 0] @ imitated[:, 0])
    term = TermSamples(
        value, np.ones(count), {"x": imitated[:, 0] + alike * own}, np.repeat(np.arange(4), count // 4),
        groups, imitated, ("k",),
    )  # fmt: skip
    found = coefficients_of(term, [Form("x / x_0", (Quantity("x", "m", 1.0, True),))])
    assert found.score == pytest.approx(0.2, abs=0.05)
    assert found.fit_score == pytest.approx(0.2, abs=0.05)
    assert found.left == pytest.approx(4.0, rel=0.1)
