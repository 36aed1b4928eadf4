"""A term that the catalogue lacks is learned from what the samples feel of it, without a ledger."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.diagnosis.description.explanation import LearnedModel, directly_learned
from pam_cosim.diagnosis.description.learning_library import quantities, ramps
from pam_cosim.diagnosis.diagnose import fit_base_model
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.subject import subject_of
from pam_cosim.errors import InputError
from pam_cosim.fitting import Fit
from pam_cosim.measurement import DataSet
from rig.named import UNLISTED
from rig.short import write_light_data
from tests.reporting.synthetic import make_diagnosis

L0, D0, TURNS = 0.24, 0.02, 2.0
NOISE = 1.0  # N


def learned(data: DataSet) -> tuple[Fit, LearnedModel | None]:
    """The base model's fit, and the term that is learned beside it."""
    subject = subject_of(data, None, (), 1, lambda message: None)
    with subject.simulator() as simulator:
        available_effects = subject.effects(simulator.interface)
        known, base, _ = fit_base_model(simulator, subject.data, lambda message: None)
    search = Search(
        subject.tree,
        subject.name,
        available_effects,
        known,
        subject.sources,
        lambda message: None,
        1,
    )
    return base, directly_learned(search, (), base)


def hidden_force(p: np.ndarray, x: np.ndarray) -> np.ndarray:
    """A lobe over contraction that grows with pressure [N]: no law of a muscle."""
    return np.asarray(60 * (p / 300e3) * np.exp(-(((x - 0.028) / 0.008) ** 2)))


def write_map(folder: Path, model: str = "PneumaticMuscle.Benches.QuasiStaticIsometric") -> Path:
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


@pytest.mark.full
def test_points_at_rest_teach_a_spline_that_holds_at_other_pressures(tmp_path: Path) -> None:
    base, found = learned(pam.read(write_map(tmp_path)))
    assert found is not None and found.term.balance == "force"
    before, after = (f.comparison.scores["holdout"]["F"].rmse for f in (base, found.model.fit))
    assert before > 15 * NOISE and after < 0.35 * before, (before, after, found.term.formula)
    assert "max(0, x" in found.term.formula


@pytest.mark.full
def test_recordings_teach_a_term_that_holds_in_another_run(tmp_path: Path) -> None:
    data = pam.read(write_light_data(tmp_path / "d", [UNLISTED["coupled"]], 1))
    base, found = learned(data)
    assert found is not None and found.term.balance == "force"
    before, after = (f.comparison.chi2_reduced("holdout") for f in (base, found.model.fit))
    assert before > 5 and after < 0.25 * before, (before, after, found.term.formula)


@pytest.mark.full
def test_the_model_with_the_term_is_one_file_that_stands_by_itself(tmp_path: Path) -> None:
    own = "within;\nmodel Own\n  extends PneumaticMuscle.Benches.QuasiStaticIsometric;\nend Own;\n"
    (tmp_path / "Own.mo").write_text(own)
    data = pam.read(write_map(tmp_path, "Own.mo"))
    base, found = learned(data)
    assert found is not None
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
    with pytest.raises(InputError, match="no learned term"):
        pam.add(replace(diagnosis, learned=None), output=better, learned=True)
    assert better.read_text() == text


@pytest.mark.full
def test_nothing_is_learned_where_nothing_is_missing(tmp_path: Path) -> None:
    data = pam.read(write_light_data(tmp_path / "d", [], 1))
    _, found = learned(data)
    assert found is None


def test_ramps_are_lines_and_bends_inside_the_span() -> None:
    z = np.concatenate([np.zeros(40), np.linspace(0, 2, 60)])
    known = quantities({"x": z}, {"x": "m"})
    library = ramps(known, {"x": z})
    assert [f.words for f in library][:2] == ["1", "x"] and len(
        library
    ) == 4  # a bend at the first value says nothing
    bend = library[2]
    values = bend.values({"x": np.array([0.0, 2.0])})
    assert values[0] < 0.02 and values[1] == pytest.approx(
        1 - float(bend.words.split("- ")[1][:-1]), abs=0.02
    )
    assert replace(bend) == bend
