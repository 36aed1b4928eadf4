"""Friction by the run's load and frequency, hidden from a model with a constant coefficient: DY Fig. 6a to 6b."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from types import ModuleType

import pytest

from pam_cosim import Diagnosis, study

RUN = Path(__file__).parents[2] / "examples" / "dzahir-yamamoto" / "run.py"


@pytest.fixture(scope="module")
def example() -> ModuleType:
    """The example's own functions, which its main() alone starts."""
    spec = importlib.util.spec_from_file_location("example_dzahir_yamamoto", RUN)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def diagnosis(
    example: ModuleType, workers: int | None, tmp_path_factory: pytest.TempPathFactory
) -> Diagnosis:
    folder = example.rig.write_data_set(tmp_path_factory.mktemp("vertical-load"))
    return study.diagnose(study.read(folder), workers=workers)


@pytest.mark.full
def test_verdict_is_the_effect_of_the_paper(diagnosis: Diagnosis) -> None:
    assert diagnosis.verdict.kind == "identified", diagnosis.verdict
    assert diagnosis.verdict.effects == ("LoadFrequencyFriction",)
    assert max(diagnosis.balance, key=lambda b: diagnosis.balance[b]) == "force"


@pytest.mark.full
def test_error_falls_to_the_noise_on_conditions_that_were_not_fitted(diagnosis: Diagnosis) -> None:
    before, after = (
        f.comparison.scores["holdout"]["x"].rmse for f in (diagnosis.base, diagnosis.final)
    )
    assert before > 5e-4 and after < 1.05e-4
    assert diagnosis.final.residuals["holdout"].chi2_reduced < 1.1


@pytest.mark.full
def test_coefficients_come_back(example: ModuleType, diagnosis: Diagnosis) -> None:
    own = diagnosis.final.values
    muscle = example.rig.Muscle()
    assert [own[f"muscle.braid.c_{i}"] for i in (3, 4, 5)] == pytest.approx(
        muscle.slenderness, rel=0.03
    )
    assert own["damper.ab"] == pytest.approx(0.12, rel=0.02)
    assert own["muscle.friction.c_c"] == pytest.approx(6.0, rel=0.02)
    assert (
        own["muscle.friction.c_v"] < 0.01 * 0.12 * 15 * 9.81
    )  # N.s, of the coefficient at 15 kg and 1 Hz
