"""Means keep what a recording says: levels, noise, steps of inputs and their times."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement import read_data_set
from pam_cosim.measurement.recording import Recording
from pam_cosim.measurement.resampling import resampled
from tests.measurement.bench import MODEL, describe

STEPS = (3.0005, 7.1235)  # [s], between samples


def recording(rate: float = 1000.0, duration: float = 10.0, noisy: bool = True) -> Recording:
    rng = np.random.default_rng(7)
    time = np.arange(0.0, duration, 1.0 / rate)
    u = np.where((time > STEPS[0]) & (time < STEPS[1]), 0.35, 0.0)
    supply = 2e5 + rng.normal(0, 500 * noisy, len(time))
    x = 5e-3 * np.sin(time) + rng.normal(0, 1e-4 * noisy, len(time))
    sparse = np.where(np.arange(len(time)) % 10 == 0, x, np.nan)
    return Recording(time, {"u": u, "p_supply": supply}, {"x": x, "y": sparse})


@pytest.mark.parametrize("held", ["linear", "previous"])
def test_steps_of_inputs_keep_time_and_value(held):
    before, after = recording(), resampled(recording(), 0.02, held)
    rows = {"linear": 2, "previous": 3}[
        held
    ]  # of means, of the slower signal, of where means begin
    assert len(after.time) < rows * 0.051 * len(before.time)
    assert np.all(np.diff(after.time) >= 0)
    edges = np.flatnonzero(np.diff(after.inputs["u"]))
    assert len(edges) == 2
    for edge, step in zip(edges, STEPS, strict=True):
        assert sorted(set(after.inputs["u"][edge : edge + 2])) == pytest.approx([0, 0.35])
        assert after.time[edge] < step < after.time[edge + 1] + 1e-12
        assert after.time[edge + 1] - step < 1e-3
    assert (after.time[0], after.time[-1]) == (before.time[0], before.time[-1])


def test_the_noise_of_means_is_what_is_said():
    after = resampled(recording(duration=60.0), 0.02, "linear")
    for name, samples in (("x", 20), ("y", 2)):
        values = after.measurements[name]
        there = np.isfinite(values)
        error = values[there] - 5e-3 * np.sin(after.time[there])
        assert after.averaged[name].samples == samples
        assert np.std(error) == pytest.approx(1e-4 / np.sqrt(samples), rel=0.06)
        assert abs(np.mean(error)) < 1e-5


def test_recorded_steps_of_two_rows_stay():
    time = np.repeat(np.arange(0.0, 1.0, 0.001), 1)
    time = np.insert(time, 500, time[500])
    u = np.where(np.arange(len(time)) <= 500, 0.0, 1.0)
    after = resampled(Recording(time, {"u": u}, {"x": u}), 0.05, "linear")
    edge = int(np.flatnonzero(np.diff(after.inputs["u"]))[0])
    assert after.time[edge] == after.time[edge + 1] == 0.5
    assert not np.any((np.diff(after.time)[1:] == 0) & (np.diff(after.time)[:-1] == 0))


def test_in_a_data_set(tmp_path):
    rows = recording()
    body = "\n".join(
        f"{t:.4f};{u:g};{p / 1e3:.4f};{x * 1e3:.5f}".replace(".", ",")
        for t, u, p, x in zip(
            rows.time,
            rows.inputs["u"],
            rows.inputs["p_supply"],
            rows.measurements["x"],
            strict=True,
        )
    )
    (tmp_path / "run.csv").write_text(f"time [s];u_in [A];p_supply [kPa];x [mm]\n{body}\n")
    head = f'model = "{MODEL}"\n[recording]\nresample = "20 ms"\n'
    file = tmp_path / "experiment.toml"
    file.write_text(f'{head}[signals.x]\nsigma = "0.1 mm"\n[[runs]]\nfile = "run.csv"\n')
    data = read_data_set(tmp_path, describe)
    assert data.signals["x"].sigma == pytest.approx(1e-4 / np.sqrt(20))
    assert any(
        "10000 rows are" in note and "2 steps of inputs kept" in note for note in data.notes()
    )
    file.write_text(f'{head}[[runs]]\nfile = "run.csv"\n')
    assert read_data_set(tmp_path, describe).signals["x"].sigma == pytest.approx(
        1e-4 / np.sqrt(20), rel=0.15
    )
    file.write_text(
        f'model = "{MODEL}"\n[[runs]]\nfile = "run.csv"\n[runs.recording]\nresample = "20 mm"\n'
    )
    with pytest.raises(InputError) as caught:
        read_data_set(tmp_path, describe)
    assert (caught.value.line, caught.value.file) == (5, file)


@pytest.mark.parametrize("interval", [0.02, 0.05])
@pytest.mark.parametrize("held", ["linear", "previous"])
def test_a_slower_signal_keeps_its_times(interval: float, held: str) -> None:
    """Its means stood at the middle of all rows, up to half an interval late: 16 standard deviations of its noise."""
    time = np.arange(0.0, 10.0, 1e-3)
    x = np.where(np.arange(len(time)) % 20 == 0, 15e-3 * np.sin(np.pi * time), np.nan)
    p, u = 1e5 * np.sin(time), np.where(time < 4.0, 0.0, 1.0)
    after = resampled(Recording(time, {"u": u}, {"x": x, "p": p}), interval, held)  # type: ignore[arg-type]
    there = np.isfinite(after.measurements["x"])
    assert there.sum() > 9.0 / interval
    error = after.measurements["x"][there] - 15e-3 * np.sin(np.pi * after.time[there])
    assert np.abs(error).max() < (1e-9 if interval == 0.02 else 6e-5)
    there = np.isfinite(after.measurements["p"])
    assert np.abs(after.measurements["p"][there] - 1e5 * np.sin(after.time[there])).max() < 15.0
    assert (np.diff(after.time) >= 0).all() and np.unique(after.inputs["u"]).tolist() == [0, 1]
