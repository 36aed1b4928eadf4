"""An instrument of the independent rig is at fault: the fault is measured, and the diagnosis names the instrument."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.catalogue import compose
from pam_cosim.compiler import read_library
from pam_cosim.measurement import DataSet, FreeParameter
from pam_cosim.reporting import diagnosis_text
from rig.instruments import (
    ClockOffset,
    Fault,
    Gain,
    Lag,
    Offset,
    OffsetAndGain,
    Saturation,
    TransducerSaturation,
)
from rig.short import write_light_data

# fault of the rig: the effect of the same law, its parameter, bounds and true value
FAULTS: dict[Fault, tuple[str, str, tuple[float, float], float]] = {
    ClockOffset(-0.04): ("ClockOffset", "recorder.shift", (-2.0, 2.0), -0.04),
    Offset("x", 1.5e-3): ("PositionOffset", "channel_x.offset", (-0.02, 0.02), 1.5e-3),
    Gain("x", 1.05): ("PositionGain", "channel_x.gain", (0.5, 2.0), 1.05),
    Lag("p", 0.04): ("PressureLag", "channel_p.tau", (1e-4, 5.0), 0.04),
    Gain("T", 1.15, zero=293.15): ("TemperatureGain", "channel_T.gain", (0.5, 2.0), 1.15),
    TransducerSaturation("p", high=70e3): (
        "PressureCeiling",
        "channel_p.high",
        (-1.01e5, 1e7),
        70e3,
    ),
}
"""The first at every change."""
FIRST, *OTHERS = FAULTS
EACH = [FIRST, *(pytest.param(fault, marks=pytest.mark.full, id=str(fault)) for fault in OTHERS)]


def faulty(folder: Path, *faults: Fault) -> DataSet:
    """Two short runs of the rig through these instruments."""
    return study.read(write_light_data(folder / "data", seed=1, faults=faults))


@pytest.mark.full
@pytest.mark.parametrize("fault", EACH)
def test_a_fault_is_measured(tmp_path: Path, fault: Fault) -> None:
    effect, name, (low, high), true = FAULTS[fault]
    composed = compose(read_library(), "PneumaticMuscle.Benches.Isotonic", [effect])
    assert composed.parameters[effect] == (name,)
    model = tmp_path / f"{composed.name}.mo"
    model.write_text(composed.text)
    data = faulty(tmp_path, fault)
    data = replace(data, fit={**data.fit, name: FreeParameter(name, low, high)})
    fit = study.fit(data, str(model))
    estimate = fit.parameters[name]
    assert estimate.low <= true <= estimate.high, str(estimate)
    assert 0.85 < fit.comparison.chi2_reduced("holdout") < 1.2


NAMED: dict[tuple[Fault, ...], str] = {
    (OffsetAndGain("x", 1e-3, 1.04),): "position_sensor",
    (Saturation("p", high=60e3),): "saturation",
    (Offset("p", 101_325.0),): "pressure_offset",  # an absolute pressure, recorded as gauge
}


@pytest.mark.full
@pytest.mark.parametrize("faults", NAMED, ids=str)
def test_a_fault_is_named_as_that_of_an_instrument(
    tmp_path: Path, workers: int | None, faults: tuple[Fault, ...]
) -> None:
    diagnosis = study.diagnose(faulty(tmp_path, *faults), explain=False, workers=workers)
    assert (diagnosis.verdict.kind, diagnosis.verdict.families) == ("identified", (NAMED[faults],))
    assert "An instrument, not physics:" in diagnosis_text(diagnosis)
