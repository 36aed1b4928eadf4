"""A term that the catalogue lacks is learned from what the samples feel of it: a formula, on a budget."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.catalogue import effect_classes
from pam_cosim.compiler import compile_model, read_library
from pam_cosim.diagnosis.description.explanation import LearnedModel, described, suspected
from pam_cosim.diagnosis.description.forms import quantities, ramps
from pam_cosim.diagnosis.description.learning import Description
from pam_cosim.diagnosis.description.learning_text import Addend, TermPlace
from pam_cosim.diagnosis.diagnose import fit_base_model
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit
from pam_cosim.ledger import Ledger
from pam_cosim.measurement import DataSet
from pam_cosim.model.domain import Domain
from rig.named import UNLISTED
from rig.short import write_light_data
from tests.reporting.synthetic import make_diagnosis

L0, D0, TURNS = 0.24, 0.02, 2.0
NOISE = 1.0  # N


def learned(data: DataSet, effort: Effort | None = None) -> tuple[Fit, LearnedModel | None]:
    """The base model's fit, and the term that is learned beside it, by a tenth of an effort."""
    subject = subject_of(data, None, (), 1, lambda message: None)
    with subject.simulator() as simulator:
        available_effects = subject.effects(simulator.interface)
        known, base = fit_base_model(simulator, subject.data, lambda message: None)
    search = Search(
        subject.tree,
        subject.name,
        available_effects,
        known,
        subject.sources,
        lambda message: None,
        1,
        effort=effort or Effort(simulations=10**6),
    )
    return base, described(search, None, base, (), base)


def hidden_force(p: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A lobe over contraction that grows with pressure [N]: no law of a muscle."""
    return np.asarray(60 * (p / 300e3) * np.exp(-(((x - 0.028) / 0.008) ** 2)))


def write_map(folder: Path, model: str) -> Path:
    """Points at rest of a cylinder with the hidden force, by its own formula, with noise; two pressures held out."""
    noise, b = np.random.default_rng(5), np.hypot(L0, TURNS * np.pi * D0)
    p, x = (
        a.ravel()
        for a in np.meshgrid(np.arange(1, 6.1) * 8e4, np.linspace(0, 0.05, 14), indexing="ij")
    )
    pull = p * (3 * (L0 - x) ** 2 - b**2) / (4 * np.pi * TURNS**2) - hidden_force(p, x)
    rows = zip(p / 1e3, 1e3 * x, pull + noise.normal(0, NOISE, p.size), strict=True)
    table = "\n".join(f"{a:.6g},{c:.6g},{d:.6g}" for a, c, d in rows)
    (folder / "map.csv").write_text(f"p [kPa],x [mm],F [N]\n{table}\n")
    (folder / "experiment.toml").write_text(
        f"""title = "a lobe"
model = "{model}"
kind = "static"
[signals.F]
sigma = "{NOISE} N"
[parameters]
"muscle.L0" = "{L0} m"
"muscle.D0" = "{D0} m"
"muscle.mu_fb" = 0
[fit]
"muscle.turns" = {{ min = 1.0, max = 4.0 }}
[[runs]]
file = "map.csv"
hold_out = {{ p = ["240 kPa", "400 kPa"] }}
"""
    )
    return folder


@pytest.fixture(scope="module")
def points(tmp_path_factory: pytest.TempPathFactory) -> tuple[DataSet, Fit, LearnedModel]:
    """Points at rest for a model of one's own; the base model's fit; the term that they teach."""
    folder = tmp_path_factory.mktemp("map")
    own = "within;\nmodel Own\n  extends PneumaticMuscle.Benches.QuasiStaticIsometric;\nend Own;\n"
    (folder / "Own.mo").write_text(own)
    data = pam.read(write_map(folder, "Own.mo"))
    base, found = learned(data)
    assert found is not None
    return data, base, found


@pytest.mark.full
def test_points_at_rest_teach_a_spline_that_holds_at_other_pressures(
    points: tuple[DataSet, Fit, LearnedModel],
) -> None:
    _, base, found = points
    assert found.term.balance == "force"
    before, after = (f.comparison.scores["holdout"]["F"].rmse for f in (base, found.model.fit))
    assert before > 15 * NOISE and after < 0.35 * before, (before, after, found.term.formula)
    assert "max(0, eps" in found.term.formula


@pytest.mark.full
def test_recordings_teach_a_term_that_holds_in_another_run(tmp_path: Path) -> None:
    data = pam.read(write_light_data(tmp_path / "d", [UNLISTED["coupled"]], 1))
    base, found = learned(data)
    assert found is not None and found.term.balance == "force"
    before, after = (f.comparison.chi2_reduced("holdout") for f in (base, found.model.fit))
    assert before > 5 and after < 0.25 * before, (before, after, found.term.formula)


@pytest.mark.full
def test_the_model_with_the_term_is_one_file_that_stands_by_itself(
    tmp_path: Path, points: tuple[DataSet, Fit, LearnedModel]
) -> None:
    data, _, found = points
    diagnosis = replace(make_diagnosis("unknown"), model=data.model, data=data, learned=found)
    better = tmp_path / "Better.mo"
    text = pam.add(diagnosis, output=better, learned=True)
    assert (
        better.read_text() == text
        and f"model {found.term.name} " in text
        and "model Better " in text
    )
    after = pam.compare(data, str(better)).scores["holdout"]["F"].rmse
    assert after == pytest.approx(found.model.fit.comparison.scores["holdout"]["F"].rmse, rel=1e-3)
    with pytest.raises(InputError, match="has no learned term"):
        pam.add(replace(diagnosis, learned=None), output=better, learned=True)
    assert better.read_text() == text


_FORCE = TermPlace("force", "PneumaticMuscle.Unknowns.ForceTerm", "N", "Force against contraction")


def test_class_is_an_effect_like_any_other(tmp_path: Path) -> None:
    x = np.linspace(0.0, 0.06, 50)
    library = ramps(quantities({"x": x}, {"x": "m"}), {"x": x})
    addends = tuple(Addend(c, f, abs(c)) for c, f in zip((5.1, -2.0), library[1:], strict=False))
    description = Description(_FORCE, addends, 0.97, 0.98, 1.1)
    term = description.term(read_library())
    assert term.formula.startswith("missing force = 5.1 N x - 2 N max(0, x - ")
    assert term.formula.endswith("where x stands for x/(60 mm)")
    file = tmp_path / f"{term.name}.mo"
    file.write_text(term.modelica_source)
    (effect,) = [e for e in effect_classes(read_library(files=[file])) if e.family == "learned"]
    assert effect.parameters == ("c_1", "c_2") and effect.balance == "force"
    assert "explains 97 % of" in " ".join(effect.documentation.split())
    text = pam.add([term.name], "Isotonic", tmp_path / "With.mo", files=[file])
    known = compile_model("With", files=[file, tmp_path / "With.mo"]).interface.parameters
    own = [v for n, v in known.items() if n.startswith(f"{effect.component_name}.c_")]
    assert text and [v.start for v in own] == [5.1, -2.0] and {v.unit for v in own} == {"N"}
    assert [(v.min, v.max) for v in own] == [(-50.0, 50.0), (-20.0, 20.0)]
    weaker = description.with_part(0.1).term(read_library()).modelica_source
    assert "max=50, nominal=5) = 0.51 " in weaker


@pytest.mark.parametrize(
    ("failing", "notes", "asked"),
    [
        (("mass",), (), ("mass",)),
        (("mass",), ("either",), ("mass", "energy")),
    ],
)
def test_a_term_is_looked_for_where_the_ledger_fails(
    failing: tuple[str, ...], notes: tuple[str, ...], asked: tuple[str, ...]
) -> None:
    domain = Domain(confused=(("mass", "energy", "either"),))
    ledger = Ledger("M", (), failing, True, 9.0, 1.0, {}, notes, domain)
    assert suspected(ledger) == asked
