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


# What the right exponent breaks.
MODEL = """\
model My "A vessel that says where it is valid"
  extends PneumaticMuscle.Benches.VesselOrifice;
equation
  assert(tank.port.T < 185 or time < 30, "the gas is warmer than it can be, T = " + String(tank.port.T) + " K");
end My;
"""


@pytest.mark.full
def test_a_diagnosis_keeps_its_ledger(
    data: Path, place: Path, process: Callable[..., Outcome]
) -> None:
    """The file is the model and, given again, a further file too: it is read once. The exponent that the rig has
    breaks an assertion of the model: no candidate may have it, and the others are judged."""
    (data / "experiment.toml").write_text(WRONG)
    (place / "My.mo").write_text(MODEL)
    outcome = process("diagnose", "data", "--model", "My.mo", "--file", "./My.mo", "--workers", "1")
    assert outcome.status == 0, outcome.err
    said = outcome.out + outcome.err
    assert "Ledger of the base model" in said and "no ledger" not in said
    assert "Verdict:" in said and "tank.n/stated removes" not in said
