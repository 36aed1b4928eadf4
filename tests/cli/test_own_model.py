"""Commands with a model of the user's own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tests.cli.conftest import EXPERIMENT, Outcome

# The exponent held where it is wrong: something is missing, so that the ledger is asked for.
WRONG = EXPERIMENT.replace('"tank.n" = { min = 1.0, max = 1.4 }\n', "").replace(
    '"orifice.d" = "2.71 mm"', '"orifice.d" = "2.71 mm"\n"tank.n" = 1.4'
)


def test_a_diagnosis_keeps_its_ledger(data: Path, place: Path, process: Callable[..., Outcome]) -> None:
    """The file is the model and, given again, a further file too: it is read once."""
    (data / "experiment.toml").write_text(WRONG)
    (place / "My.mo").write_text("model My\n  extends PneumaticMuscle.Benches.VesselOrifice;\nend My;\n")
    found = process("diagnose", "data", "--model", "My.mo", "--file", "./My.mo", "--workers", "1")
    assert found.status == 0, found.err
    assert "Ledger of the base model" in found.out
    assert "no ledger" not in found.out + found.err
