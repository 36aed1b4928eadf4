"""What a verdict leaves to do, as files: the next experiment and the learned term."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.measurement import read_recording
from pam_cosim.study.input_sources import read_inputs
from tests.cli.conftest import Outcome, everything
from tests.reporting.synthetic import make_data, make_diagnosis
from tests.reporting.test_ledger_learned_next import PLAN, make_learned

Command = Callable[..., Outcome]
TABLE = {
    "time": [0.0, 0.5, 10.0],
    "u_in": [0.35, 0.0, 0.0],
    "u_out": [0.0, 0.0, 0.2],
    "p_supply": [2e5, 2e5, 2e5],
}
FULL = replace(
    PLAN, table=TABLE, units={"u_in": "A", "u_out": "A", "p_supply": "Pa", "load.m": "kg"}
)


@pytest.fixture
def study_gives(monkeypatch: pytest.MonkeyPatch) -> Callable[[Diagnosis], None]:
    """Makes the study find this."""

    def arrange(diagnosis: Diagnosis) -> None:
        monkeypatch.setattr(study, "diagnose", lambda *_, **__: diagnosis)

    return arrange


def test_next_experiment_is_a_file_that_reads_as_inputs(
    command: Command, place: Path, data: Path, study_gives: Callable[[Diagnosis], None]
) -> None:
    study_gives(make_diagnosis("ambiguous", next_experiment=FULL))
    outcome = command("diagnose data --next next.csv")
    assert outcome.status == 0, outcome.err
    assert "Next experiment: run run-2, load.m times 1.5; with load.m = 3.000 kg" in outcome.out
    interface = study.describe("Isotonic")
    recording = read_recording(place / "next.csv", interface)
    assert recording.inputs["p_supply"] == pytest.approx(2e5)
    inputs = read_inputs(place / "next.csv", interface)
    assert inputs.interpolation == "linear"
    # held until the step, by straight lines too: a current of zero at 0.5 s must not lower the one before
    for name, at, value in (("u_in", 0.499, 0.35), ("u_in", 0.501, 0.0), ("u_out", 9.99, 0.0)):
        assert np.interp(at, inputs.time, inputs.values[name]) == value
    run = command("simulate Isotonic --input next.csv --set 'load.m=3 kg' -o t.csv")
    assert run.status == 0, run.err


def test_the_learned_term_is_a_modelica_file(
    command: Command, place: Path, data: Path, study_gives: Callable[[Diagnosis], None]
) -> None:
    measured = make_data()
    study_gives(make_diagnosis("unknown", measured, learned=make_learned(measured)))
    outcome = command("diagnose data --learned LearnedForce.mo")
    assert outcome.status == 0, outcome.err
    assert (place / "LearnedForce.mo").read_text() == "model LearnedForce\nend LearnedForce;\n"


def test_nothing_to_write_is_said_and_nothing_is_written(
    command: Command, place: Path, data: Path
) -> None:
    before = everything(place)
    outcome = command("diagnose data --next next.csv --learned term.mo --workers 1")
    assert outcome.status == 0, outcome.err
    assert "no next experiment: no input and no parameter differs in the recordings" in outcome.out
    assert "; next.csv is not written" in outcome.out
    assert "no term was learned: the verdict is none_missing; term.mo is not written" in outcome.out
    assert everything(place) == before
