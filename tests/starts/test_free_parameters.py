"""Free parameters where a run begins: a start value among them is its start, a load or a length is not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.measurement import DataSet, FreeParameter
from tests.fitting.models import data_set, recording

TIME = np.linspace(0.0, 3.0, 61)
RATE, LEVEL, BEGIN, SIGMA = 2.0, 0.2, 0.7, 0.01
MODEL = """model Lag "Comes to a level"
  parameter Real rate(unit="1/s", min=0, max=100) = 1;
  parameter Real level(unit="1") = {level};
  parameter Real {start}(unit="1") = {first};
  Real s(unit="1", start={start}, fixed=true, nominal=1);
  output Real y(unit="1");
equation
  der(s) = rate*({right} - s);
  y = s;
end Lag;"""
STATELESS = """model Curve "A course in closed form, whose states nobody could set"
  input Real u(unit="1", start=0);
  parameter Real rate(unit="1/s", min=0, max=100) = 1;
  parameter Real y0(unit="1") = 0;
  output Real y(unit="1");
equation
  y = y0*exp(-rate*time) + u;
end Curve;"""


def _data(free: dict[str, tuple[float, float]], begin: float = BEGIN) -> DataSet:
    y = LEVEL + (begin - LEVEL) * np.exp(-RATE * TIME)
    y += SIGMA * np.random.default_rng(0).standard_normal(len(TIME))
    fitted = [FreeParameter(name, low, high, None, "1") for name, (low, high) in free.items()]
    run = recording(TIME, {"y": y}, inputs={})
    return data_set("Lag", [run], {"y": SIGMA}, fitted)


def _fit(tmp_path: Path, data: DataSet, text: str, name: str = "Lag") -> pam.Fit:
    model = tmp_path / f"{name}.mo"
    model.write_text(text)
    return pam.fit(data, str(model))


@pytest.mark.parametrize("start", ["begin", "s_start"])
def test_a_run_begins_at_the_start_value_that_is_fitted(tmp_path: Path, start: str) -> None:
    data = _data({"rate": (0.1, 10.0), start: (-5.0, 5.0)})
    text = MODEL.format(level=LEVEL, start=start, first=0.0, right="level")
    fit = _fit(tmp_path, data, text)
    (run,) = fit.comparison.runs
    assert (run.run.start.mode, run.run.start.reason) == ("rest", "") and not fit.starts
    assert fit.values[start] == pytest.approx(BEGIN, abs=3 * SIGMA)
    assert fit.values["rate"] == pytest.approx(RATE, rel=0.05)


@pytest.mark.parametrize("is_free", [True, False])
def test_a_model_without_states_cannot_begin_elsewhere_unless_its_start_is_fitted(
    tmp_path: Path, is_free: bool
) -> None:
    free = {"rate": (0.1, 10.0), **({"y0": (-5.0, 5.0)} if is_free else {})}
    y = BEGIN * np.exp(-RATE * TIME) + SIGMA * np.random.default_rng(0).standard_normal(len(TIME))
    fitted = [FreeParameter(name, low, high, None, "1") for name, (low, high) in free.items()]
    run = recording(TIME, {"y": y}, inputs={"u": np.zeros(len(TIME))})
    fit = _fit(tmp_path, data_set("Curve", [run], {"y": SIGMA}, fitted), STATELESS, "Curve")
    assert ("no start value of a state can be set" in str(fit)) == (not is_free)
    if is_free:
        assert fit.values["y0"] == pytest.approx(BEGIN, abs=3 * SIGMA)
