"""Commands with a model of the user's own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import EXPERIMENT, Outcome

# The exponent held where it is wrong: something is missing, so that the ledger is asked for.
WRONG = EXPERIMENT.replace('"tank.n" = { min = 1.0, max = 1.4 }\n', "").replace(
    '"orifice.d" = "2.71 mm"', '"orifice.d" = "2.71 mm"\n"tank.n" = 1.4'
)


# What some candidates break: those that let the gas take heat up from the wall.
MODEL = """\
model My "A vessel that says where it is valid"
  extends PneumaticMuscle.Benches.VesselOrifice;
equation
  assert(tank.port.T < 255 or time < 30, "the gas is warmer than it can be, T = " + String(tank.port.T) + " K");
end My;
"""


@pytest.mark.full
def test_a_diagnosis_keeps_its_ledger(data: Path, place: Path, process: Callable[..., Outcome]) -> None:
    """The file is the model and, given again, a further file too: it is read once. A candidate that breaks an
    assertion is one that could not be fitted; the others are judged."""
    (data / "experiment.toml").write_text(WRONG)
    (place / "My.mo").write_text(MODEL)
    outcome = process("diagnose", "data", "--model", "My.mo", "--file", "./My.mo", "--workers", "1")
    assert outcome.status == 0, outcome.err
    said = outcome.out + outcome.err
    assert "Ledger of the base model" in said and "no ledger" not in said
    assert "could not be fitted: no start value within the bounds can be simulated" in said
    assert "the gas is warmer than it can be, T = 2" in said
    assert "Verdict:" in said
