"""What is written reads back as it was."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.measurement import read_data_set, write_data_set
from tests.measurement.bench import BENCH, describe

UNITS = {
    "time": "ms",
    "p": "kPa",
    "p_supply": "bar",
    "x": "mm",
    "T": "degC",
    "load.m": "g",
    "tank.T_start": "degF",
}


@pytest.mark.parametrize("units", [None, UNITS], ids=["bench units", "chosen units"])
def test_round_trip(make, tmp_path, units):
    data = read_data_set(make(), describe)
    folder = tmp_path / "a" / "copy"
    copy = write_data_set(folder, data, BENCH, units=units)
    assert (copy.title, copy.model, copy.folder) == (data.title, data.model, folder)
    assert list(copy.signals) == list(data.signals)
    for name, signal in data.signals.items():
        assert copy.signals[name].sigma == (signal.sigma and pytest.approx(signal.sigma))
    assert copy.parameters == pytest.approx(data.parameters)
    for name, free in data.fit.items():
        other = copy.fit[name]
        assert [other.min, other.max] == pytest.approx([free.min, free.max])
        assert other.start == (free.start and pytest.approx(free.start))
    for one, two in zip(data.runs, copy.runs, strict=True):
        assert (one.name, one.role, one.interpolation) == (two.name, two.role, two.interpolation)
        assert two.parameters == pytest.approx(one.parameters)
        np.testing.assert_allclose(two.time, one.time, rtol=1e-8)
        assert (list(two.inputs), list(two.measurements)) == (
            list(one.inputs),
            list(one.measurements),
        )
        for name, values in {**one.inputs, **one.measurements}.items():
            np.testing.assert_allclose({**two.inputs, **two.measurements}[name], values, rtol=1e-7)
    header = (folder / "run-01.csv").read_text().splitlines()[0]
    assert ("p [kPa]" if units else "p [Pa]") in header
    assert sorted(item.name for item in (tmp_path / "a").iterdir()) == ["copy"]


@pytest.mark.parametrize("units", [None, UNITS], ids=["bench units", "chosen units"])
@pytest.mark.parametrize(
    "stated",
    ['lead = "0.15 s"', 'before = { p_supply = "200 kPa", for = "5 s" }',
     'start = "steady"\nlead = "100 ms"\nbefore = { u_in = "0.1 A", p_supply = "2 bar", for = "2 s" }',
     'periodic = true\nlead = "0.15 s"'],
)  # fmt: skip
def test_what_is_stated_of_the_start_reads_back(make, tmp_path, stated, units):
    last = 'file = "run-01.csv"'
    data = read_data_set(make(("experiment.toml", last, f"{last}\n{stated}")), describe)
    run, copy = data.runs[0], write_data_set(tmp_path / "copy", data, BENCH, units=units).runs[0]
    one, two = run.start, copy.start
    assert (one.mode, one.periodic) == (two.mode, two.periodic)
    assert (two.lead, two.seconds) == pytest.approx((one.lead, one.seconds))
    assert one.lead or one.seconds
    assert dict(two.before) == pytest.approx(dict(one.before))
    assert list(one.leading) == list(two.leading)
    for name, leading in one.leading.items():
        np.testing.assert_allclose(two.leading[name], leading, rtol=1e-8)
    for name, values in run.measurements.items():
        np.testing.assert_allclose(copy.measurements[name], values, rtol=1e-7)
