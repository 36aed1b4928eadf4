"""A valid data set arrives in SI units, with runs, roles and parameters as stated."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import numpy as np
import pytest

from pam_cosim.measurement import read_data_set, read_recording
from tests.measurement.bench import BENCH, MODEL, RUN_01, describe

TOML, ONE, TWO = "experiment.toml", "run-01.csv", "run-02.csv"


def test_units_are_converted(make):
    data = read_data_set(make(), describe)
    one, two = data.runs
    np.testing.assert_allclose(one.time, [0, 0.1, 0.1, 0.2])
    np.testing.assert_allclose(one.inputs["p_supply"], 207e3)
    np.testing.assert_allclose(one.measurements["p"], [0, 1500, 1600, 20000])
    np.testing.assert_allclose(one.measurements["x"], [0, np.nan, 1e-4, 1.25e-3])
    np.testing.assert_allclose(one.measurements["T"], [293.15, 293.65, np.nan, 294.15])
    np.testing.assert_allclose(two.time, [0, 0.1])
    np.testing.assert_allclose(two.inputs["u_in"], 0.35)
    np.testing.assert_allclose(two.measurements["p"], [0, 1e5])
    np.testing.assert_allclose(two.measurements["eps"], [0, 0.125])


def test_structure(make):
    folder = make()
    data = read_data_set(folder, describe)
    assert (data.folder, data.title, data.model) == (folder, "latex muscle, steps", MODEL)
    assert [run.name for run in data.fit_runs] == ["run-01"]
    assert [run.name for run in data.holdout_runs] == ["run-02"]
    one, two = data.runs
    assert (one.interpolation, two.interpolation) == ("linear", "previous")
    assert one.file == folder / ONE
    assert [one.sample_count(name) for name in ("p", "x", "T", "eps")] == [4, 3, 3, 0]
    assert two.default_inputs == ("p_supply",)
    with pytest.raises(ValueError):
        one.time[0] = 1.0
    with pytest.raises(FrozenInstanceError):
        data.title = "other"


def test_sigma_is_a_difference(make):
    signals = read_data_set(make(), describe).signals
    assert list(signals) == ["p", "x", "T", "eps"]
    assert signals["p"].sigma == pytest.approx(500.0)
    assert signals["x"].sigma == pytest.approx(2e-4)
    assert signals["T"].sigma == pytest.approx(0.5)
    assert signals["eps"].assumed and not signals["p"].estimated


def test_parameters_and_start_values(make):
    data = read_data_set(make(), describe)
    assert data.parameters == pytest.approx({"load.m": 2.27, "tank.T_start": 293.15})
    assert data.runs[0].parameters == pytest.approx(data.parameters)
    assert data.runs[1].parameters == pytest.approx({"load.m": 5.0, "tank.T_start": 293.15})
    free = data.fit["muscle.mu_fb"]
    assert (free.min, free.max, free.start) == pytest.approx((0.0, 0.1, 0.015))
    assert data.fit["valve.C_A"].start is None
    merged = data.parameters_of(data.runs[1])
    assert merged == pytest.approx({"load.m": 5.0, "tank.T_start": 293.15, "muscle.mu_fb": 0.015})
    assert data.parameters_of(data.runs[0], {"muscle.mu_fb": 0.03})["muscle.mu_fb"] == 0.03


def test_a_model_file_beside_the_experiment(make):
    folder = make((TOML, MODEL, "rig.mo"))
    (folder / "rig.mo").write_text("model rig end rig;")
    data = read_data_set(folder, lambda name: BENCH)
    assert data.model == str(folder / "rig.mo")


@pytest.mark.parametrize(
    "rewrite",
    [
        lambda text: "\ufeff" + text,
        lambda text: text.replace("\n", "\r\n"),
        lambda text: text + "\n\n  \n",
        lambda text: "# rig 3\n\n" + text.replace("0.1,0,", "# a remark, with commas\n0.1,0,", 1),
        lambda text: text.replace(",", " , "),
        lambda text: text.replace("u_in [A]", '"u_in [A]"'),
    ],
    ids=["byte order mark", "crlf", "blank lines", "comments", "spaces", "quotes"],
)
def test_harmless_variants(make, rewrite):
    folder = make()
    expected = read_data_set(folder, describe).runs[0]
    (folder / ONE).write_bytes(rewrite(RUN_01).encode())
    run = read_data_set(folder, describe).runs[0]
    np.testing.assert_array_equal(run.time, expected.time)
    for name, values in {**expected.inputs, **expected.measurements}.items():
        np.testing.assert_array_equal({**run.inputs, **run.measurements}[name], values)


@pytest.mark.parametrize("heading", ["eps", "eps [-]", "eps [1]", "eps []"])
def test_dimensionless_headings(make, heading):
    folder = make()
    (folder / TWO).write_text(f"time [s],{heading}\n0,0\n1,0.5\n")
    np.testing.assert_allclose(
        read_data_set(folder, describe).runs[1].measurements["eps"], [0, 0.5]
    )


def test_one_recording_alone(make):
    recording = read_recording(make() / ONE, BENCH)
    assert list(recording.inputs) == ["u_in", "u_out", "p_supply"]
    assert list(recording.measurements) == ["p", "x", "T"]


def test_all_columns_are_fitted_where_no_signal_is_declared(make):
    folder = make()
    file = folder / TOML
    lines = file.read_text().split("\n")
    kept, inside = [], False
    for line in lines:
        if line.startswith("["):
            inside = line.startswith("[signals")
        if not inside:
            kept.append(line)
    file.write_text("\n".join(kept))
    signals = read_data_set(folder, describe).signals
    assert signals and all(s.fitted for s in signals.values())
