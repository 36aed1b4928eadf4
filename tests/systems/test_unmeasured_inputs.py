"""A command known as volts behind an amplifier nobody measured, a supply nobody recorded: what is missing?"""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim import study
from rig.named import effect_of
from tests.measurement.test_input_maps import GAIN, recorded_in_volts

COLUMNS = '[columns]\nu_in = { column = "u", gain = "0.06 A/V", offset = "20 mA", fit = "gain" }'
SUPPLY = '[runs.fit]\np_supply = { min = "150 kPa", max = "4 bar" }\n'


@pytest.mark.full
@pytest.mark.parametrize("hidden", [[], ["elasticity:linear"]], ids=["nothing", "elasticity"])
@pytest.mark.parametrize("without", [{}, {"p_supply": SUPPLY}], ids=["supply recorded", "supply free"])
def test_an_effect_is_found_behind_inputs_that_are_fitted(
    tmp_path: Path, hidden: list[str], without: dict[str, str], workers: int | None
) -> None:
    effects = [effect_of(name) for name in hidden]
    data = study.read(recorded_in_volts(tmp_path / "data", COLUMNS, effects, **without))
    diagnosis = study.diagnose(data, explain=False, workers=workers)
    assert list(diagnosis.verdict.families) == [name.split(":")[0] for name in hidden]
    assert diagnosis.verdict.kind == ("identified" if hidden else "none_missing")
    if not without:
        gain = diagnosis.final.parameters["u_in_gain"]
        assert gain.low <= GAIN <= gain.high
