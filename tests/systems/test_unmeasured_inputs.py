"""A command known as volts behind an amplifier nobody measured, a supply nobody recorded: what is missing?"""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim import study
from rig.named import effect_of
from tests.measurement.test_input_maps import GAIN, recorded_in_volts

COLUMNS = '[columns]\nu_in = { column = "u", gain = "0.06 A/V", offset = "20 mA", fit = "gain" }'
STATED = '[columns]\nu_in = { column = "u", gain = "45 mA/V", offset = "20 mA" }'
SUPPLY = {"p_supply": '[runs.fit]\np_supply = { min = "150 kPa", max = "4 bar" }\n'}
UNKNOWN: dict[str, tuple[str, dict[str, str]]] = {
    "gain": (COLUMNS, {}),
    "supply": (STATED, SUPPLY),
    "gain and supply": (COLUMNS, SUPPLY),
}
CASES = [
    ("gain", []),
    ("gain", ["elasticity:linear"]),
    ("supply", ["elasticity:linear"]),
    ("gain and supply", []),
]
"""One fitted run tells hardly more than gain times supply, so that an effect beside both is not found."""


@pytest.mark.full
@pytest.mark.parametrize(("unknown", "hidden"), CASES)
def test_an_effect_is_found_behind_inputs_that_are_fitted(
    tmp_path: Path, unknown: str, hidden: list[str], workers: int | None
) -> None:
    columns, without = UNKNOWN[unknown]
    effects = [effect_of(name) for name in hidden]
    data = study.read(recorded_in_volts(tmp_path / "data", columns, effects, **without))
    diagnosis = study.diagnose(data, explain=False, workers=workers)
    assert list(diagnosis.verdict.families) == [name.split(":")[0] for name in hidden]
    assert diagnosis.verdict.kind == ("identified" if hidden else "none_missing")
    if unknown == "gain":
        gain = diagnosis.final.parameters["u_in_gain"]
        assert gain.low <= GAIN <= gain.high
