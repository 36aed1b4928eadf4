"""Inputs that were not measured themselves: recorded as volts, through a stated or a fitted map; constant and free."""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.errors import InputError
from pam_cosim.fmu import build_model
from pam_cosim.measurement import read_data_set
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.simulation import Simulator
from rig.effect import Effect
from rig.measurement import TRUTH
from rig.short import write_light_data
from tests.measurement.bench import MODEL, describe

GAIN, OFFSET = 0.045, 0.02
"""[A/V], [A] of the amplifier that the rig's commands pass."""
KNOWN = f'"valve.C_A" = {TRUTH.calibration}\n"muscle.mu_fb" = {TRUTH.mu_fb}\n'


def recorded_in_volts(
    folder: Path, columns: str, effects: Sequence[Effect] = (), **without: str
) -> Path:
    """Data of the rig whose current of the inlet valve was recorded as volts before its amplifier.

    Args:
        folder: where.
        columns: what ``[columns]`` says.
        effects: that the rig has.
        without: heading of a column that was not recorded, and what stands for it under ``[[runs]]``, by its name.
    """
    write_light_data(folder, effects, seed=3)
    for file in sorted(folder.glob("*.csv")):
        with open(file, newline="") as lines:
            rows = list(csv.DictReader(lines))
        for row in rows:
            row["u [V]"] = f"{(float(row.pop('u_in [A]')) - OFFSET) / GAIN:.9g}"
            for name in without:
                row.pop(f"{name} [kPa]")
        with open(file, "w", newline="") as out:
            writer = csv.DictWriter(out, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
    experiment = folder / "experiment.toml"
    before, _, runs = experiment.read_text().partition("[fit]")
    runs = runs[runs.index("[[runs]]") :]
    experiment.write_text(f"{before}[parameters]\n{KNOWN}{columns}\n{_with_runs(runs, without)}")
    return folder


def _with_runs(runs: str, without: Mapping[str, str]) -> str:
    first, second = runs.split("[[runs]]")[1:]
    for free in without.values():
        first += free
        second = second.replace("[runs.parameters]", '[runs.parameters]\np_supply = "240 kPa"')
    return f"[[runs]]{first}\n[[runs]]{second}"


def test_a_stated_map_is_applied_to_the_record(tmp_path: Path) -> None:
    volts = study.read(
        recorded_in_volts(
            tmp_path / "a", '[columns]\nu_in = { column = "u", gain = "45 mA/V", offset = "20 mA" }'
        )
    )
    amperes = study.read(write_light_data(tmp_path / "b", seed=3))
    assert volts.model == amperes.model
    for one, other in zip(volts.runs, amperes.runs, strict=True):
        np.testing.assert_allclose(one.inputs["u_in"], other.inputs["u_in"], atol=1e-8)


def test_a_fitted_map_is_part_of_the_model(tmp_path: Path) -> None:
    columns = (
        '[columns]\nu_in = { column = "u", gain = "0.06 A/V", offset = "20 mA", fit = "gain" }'
    )
    data = study.read(recorded_in_volts(tmp_path / "data", columns))
    assert list(data.fit) == ["u_in_gain"] and "u_in_raw" in data.runs[0].inputs
    with Simulator(build_model(data.model, sensitivities=data.free_names)) as simulator:
        assert {sensitivity_name(s, "u_in_gain") for s in "pxT"} <= set(
            simulator.interface.sensitivities
        )
    fit = study.fit(data)
    gain = fit.parameters["u_in_gain"]
    assert gain.low <= GAIN <= gain.high and gain.high - gain.low < 0.03 * GAIN
    assert fit.comparison.chi2_reduced("holdout") < 1.2
    written = study.add(fit, to=data.model, output=tmp_path / "Written.mo")
    assert "u_in_gain*u_in_raw + u_in_offset" in written
    again = study.compare(study.read(tmp_path / "data", model=str(tmp_path / "Written.mo")))
    assert again.chi2_reduced("holdout") == pytest.approx(
        fit.comparison.chi2_reduced("holdout"), rel=1e-4
    )


def test_a_supply_that_nobody_recorded_is_a_free_constant(tmp_path: Path) -> None:
    columns = '[columns]\nu_in = { column = "u", gain = "45 mA/V", offset = "20 mA" }'
    free = '[runs.fit]\np_supply = { min = "150 kPa", max = "4 bar" }\n'
    data = study.read(recorded_in_volts(tmp_path / "data", columns, p_supply=free))
    (name,) = data.fit
    assert (
        name.startswith("p_supply_constant@")
        and data.runs[1].parameters["p_supply_constant"] == 240e3
    )
    fit = study.fit(data)
    supply = fit.parameters[name]
    assert supply.low <= 207e3 <= supply.high and supply.high - supply.low < 10e3
    assert fit.comparison.chi2_reduced("holdout") < 1.2


TEXT = f'model = "{MODEL}"\n[columns]\n%s\n[[runs]]\nfile = "a.csv"\n%s'


@pytest.mark.parametrize(
    ("columns", "run", "message"),
    [
        ('p = { fit = true }', "", "only the map of an input can be fitted"),
        ('u_in = { gain = "2 m", fit = true }', "", 'gain of u_in: 2 m does not fit; write for example "0.05 A/V"'),
        ('u_in = { gain = "0 A/V", fit = true }', "", "must not be zero"),
        ('u_in = { gain = "2 A/V", offset = "2 V", fit = true }', "", "offset: unit 'V' cannot be converted"),
        ("", "[runs.columns]\nu_in = { fit = true }\n", "state it under .columns."),
        ('u_in = { gain = "2 A/V", fit = true }', "", "an FMU has no parameters for it"),
        ('u_in = { column = "u_in", offset = "2 V" }', "", "column 'u_in': offset"),
        ('u_in = { fit = "slope" }', "", "slope. is not possible; write true, false, 'gain' or 'offset'"),
    ],
)  # fmt: skip
def test_what_is_no_map_is_one_error(tmp_path: Path, columns: str, run: str, message: str) -> None:
    (tmp_path / "a.csv").write_text("time [s],u_in [A],p [kPa]\n0,0,0\n1,1,1\n")
    (tmp_path / "experiment.toml").write_text(TEXT % (columns, run))
    with pytest.raises(InputError, match=message) as caught:
        read_data_set(tmp_path, describe)
    assert caught.value.file is not None and caught.value.line
