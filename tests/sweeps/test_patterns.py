"""Inputs over time, varied from run to run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pandas
import pytest
import xarray

import pam_cosim as pam
from pam_cosim.errors import InputError

MODEL = "TankFilling"
STEP = "time [s],u_in [A]\n0,0\n1,0\n1,0.3\n4,0.3\n"
SCALARS = {"last": "final(p)", "highest": "max(p)"}


@pytest.fixture
def step(tmp_path: Path) -> Path:
    file = tmp_path / "step.csv"
    file.write_text(STEP)
    return file


def rising(t: float) -> float:
    return 0.2 + 0.05 * t


def test_each_run_is_what_simulate_makes_of_its_inputs(step: Path) -> None:
    """A file, a function and arrays, each at two supplies."""
    arrays = {"time": [0, 2, 2, 4], "u_in": [0.35, 0.35, 0, 0], "u_out": [0, 0, 0.3, 0.3]}
    sources: list[Any] = [step, {"u_in": rising}, arrays]
    supplies = [138e3, 207e3]
    swept = pam.sweep(
        MODEL,
        {"inputs": sources, "p_supply": supplies},
        scalars=SCALARS,
        stop_time=4,
        trajectories=True,
        workers=1,
    )
    assert len(swept) == 6 and not swept.failed
    for k, point in enumerate(swept):
        alone = pam.simulate(MODEL, {"p_supply": supplies[k % 2]}, sources[k // 2], stop_time=4)
        assert point.trajectory is not None and np.array_equal(point.trajectory["p"], alone["p"])
    lasts = swept.column("last").reshape(3, 2)
    assert len({round(v) for v in lasts.ravel().tolist()}) == 6
    assert (
        swept.column("highest").reshape(3, 2)[2] > 1.1 * lasts[2]
    ).all()  # what was let out again
    assert "inputs of 3 patterns" in str(swept)


def test_formulas_are_inputs_over_time() -> None:
    """As text, on the command line too; without times they are evaluated at those of the output."""
    text = "u_in = 0.25 + 0.1*sin(6.28*time); u_out = 0"
    told = pam.simulate(MODEL, inputs=text, stop_time=2)
    alone = pam.simulate(
        MODEL, inputs={"u_in": lambda t: 0.25 + 0.1 * np.sin(6.28 * t), "u_out": 0.0}, stop_time=2
    )
    assert np.array_equal(told["p"], alone["p"])
    swept = pam.sweep(
        MODEL, {"inputs": [text, "u_in=0.3"]}, scalars=SCALARS, stop_time=2, workers=1
    )
    assert swept.column("last")[0] == told["p"][-1]
    assert list(swept.to_frame()["inputs"]) == [text, "u_in=0.3"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("u_in = log(-time)", "the formula of the input 'u_in' is no number at 0 s"),
        ("u_in = __import__(1)", "only arithmetic and elementary functions"),
        ("u_in = 1/0 + 2^99999", "cannot be evaluated"),
        ("u_in = (-1)^0.5", "cannot be evaluated"),
        ("u_in = 1; u_in = 2", "the input 'u_in' has two formulas"),
        ("v = 1", "TankFilling has no input 'v'"),
    ],
)
def test_a_wrong_formula_is_one_error(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        pam.simulate(MODEL, inputs=text, stop_time=1)


@pytest.mark.parametrize("kind", ["csv", "nc", "parquet"])
def test_results_have_the_names_of_the_patterns(step: Path, tmp_path: Path, kind: str) -> None:
    vary = {"inputs": {"a step": step, "a ramp": {"u_in": rising}}, "p_supply": [138e3, 207e3]}
    file = tmp_path / f"result.{kind}"
    swept = pam.sweep(MODEL, vary, scalars=SCALARS, stop_time=4, output=file, workers=1)
    names = ["a step", "a step", "a ramp", "a ramp"]
    assert list(swept.to_frame()["inputs"]) == names
    if kind == "nc":
        with xarray.open_dataset(file) as data:
            assert (
                float(data["last"].sel(inputs="a ramp", p_supply=207e3)) == swept.column("last")[3]
            )
    else:
        read = pandas.read_csv(file) if kind == "csv" else pandas.read_parquet(file)
        assert list(read["inputs [1]"]) == names


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"inputs": {"u_in": rising}}, "both given and varied"),
        ({"parameters": {"u_in": 0.3}}, "the input 'u_in' is in"),
        ({"design": "random", "runs": 3}, "draws between two values"),
        ({"vary": {"inputs": []}}, "no value at all"),
        ({"vary": {"inputs": "step.csv"}}, "give a list of inputs"),
        ({"vary": {"inputs": [{"u_on": rising}]}}, "did you mean 'u_in'"),
        ({"vary": {"inputs": [{"u_in": rising}], "u_in": [0.2, 0.3]}}, "given otherwise"),
    ],
)
def test_what_cannot_be_varied(step: Path, change: dict[str, Any], message: str) -> None:
    asked: dict[str, Any] = {
        "vary": {"inputs": [step, {"u_in": rising}]},
        "scalars": SCALARS,
        "workers": 1,
    } | change
    with pytest.raises(InputError, match=message):
        pam.sweep(MODEL, **asked)
