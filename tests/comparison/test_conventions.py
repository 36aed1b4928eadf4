"""Conventions of a logger: each that a recording was made with is found, and none where there is none."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.comparison import RunComparison, likely_convention
from pam_cosim.comparison.conventions import Convention
from pam_cosim.measurement import DataSet, Run, Signal

STEP, SIGMA, TAU = 0.02, 500.0, 0.15
TIME = STEP * np.arange(400)
UNITS = {"u": "A", "v": "A", "p_supply": "Pa"}


def rig(run: Run, gain: float = 3e5, late: float = 0.0) -> np.ndarray:
    """A pressure of first order behind the difference of two currents, at ten steps between samples."""
    fine = np.arange(run.time[0], run.time[-1] + STEP / 20, STEP / 10)
    at = fine - late * STEP
    if run.interpolation == "previous":
        place = np.clip(np.searchsorted(run.time, at + 1e-9, side="right") - 1, 0, None)
        u, v = (run.inputs[n][place] for n in ("u", "v"))
    else:
        u, v = (np.interp(at, run.time, run.inputs[n]) for n in ("u", "v"))
    supply = run.inputs["p_supply"][0]
    p, target = np.zeros(len(fine)), gain * (u - 0.3 * v) * supply / 5e5
    for k in range(1, len(p)):
        p[k] = p[k - 1] + STEP / 10 / TAU * (target[k - 1] - p[k - 1])
    return np.interp(run.time, fine, p)


def recorded(interpolation: str, late: float = 0.0, drift: float = 0.0, seed: int = 1) -> DataSet:
    """Steps and sines of commands; ``drift``: what the model lacks, in its slow parts."""
    u = np.repeat(np.random.default_rng(seed).uniform(0, 1, 20), 20) + 0.2 * np.sin(
        2 * np.pi * 3 * TIME
    )
    u[:20] = 0.0  # at rest
    v = np.where(TIME > 4.0, 0.5, 0.0)
    inputs = {"u": u, "v": v, "p_supply": np.full(400, 5e5)}
    run = Run("a", Path("a.csv"), "fit", interpolation, {}, TIME, inputs, {})  # type: ignore[arg-type]
    noise = np.random.default_rng(seed + 1).normal(0.0, SIGMA, 400)
    read = rig(run, late=late) + noise + drift * np.sin(0.8 * TIME)
    run = replace(run, measurements={"p": read})
    return DataSet(Path("x"), "", "m", {"p": Signal("p", "Pa", SIGMA)}, {}, {}, (run,))


def simulate(data: DataSet) -> Sequence[RunComparison]:
    return [RunComparison(run, {"p": rig(run)}) for run in data.runs]


def found(data: DataSet) -> Convention | None:
    return likely_convention(data, UNITS, simulate)


def read_as(data: DataSet, change: Callable[[Run], Run]) -> DataSet:
    return replace(data, runs=tuple(map(change, data.runs)))


@pytest.mark.parametrize("drift", [0.0, 5e3])
@pytest.mark.parametrize(
    ("own", "other", "name"), [("previous", "linear", "held"), ("linear", "previous", "linear")]
)
def test_between_samples(own: str, other: str, name: str, drift: float) -> None:
    """Also beside an effect that the model lacks; as it was recorded, nothing is named."""
    for seed in range(2):
        data = recorded(own, drift=drift, seed=seed)
        assert found(data) is None
        told = found(read_as(data, lambda run: replace(run, interpolation=other)))  # type: ignore[arg-type]
        assert told is not None and told.name == name and told.chi2 < told.before
        assert f'write interpolation = "{own}"' in told.text
        assert told.data.runs[0].interpolation == own


@pytest.mark.parametrize(
    ("late", "words"), [(0.5, "half a sample"), (1.0, "one sample"), (4.0, "")]
)
def test_commands_that_come_late(late: float, words: str) -> None:
    """A delay of many samples is a lag of the rig, and no convention."""
    told = found(recorded("linear", late=late))
    if not words:
        assert told is None or told.name != "late"
        return
    assert told is not None and told.name == "late" and words in told.text
    assert f'offset = "{-1e3 * late * STEP:g} ms"' in told.text
    assert found(told.data) is None


def scaled(name: str, factor: float, offset: float = 0.0) -> Callable[[Run], Run]:
    return lambda run: replace(run, inputs={**run.inputs, name: factor * run.inputs[name] + offset})


@pytest.mark.parametrize(
    ("change", "name", "words"),
    [
        (lambda run: replace(run, inputs={**run.inputs, "u": run.inputs["v"], "v": run.inputs["u"]}), "swapped",
         "if u and v are exchanged"),
        (scaled("u", 10.0), "factor", "if u is multiplied by 0.1"),
        (scaled("u", 1000.0), "factor", "if u is multiplied by 0.001"),
        (scaled("u", -1.0), "sign", "if the sign of u is turned"),
    ],
)  # fmt: skip
def test_inputs_that_count_otherwise(change: Callable[[Run], Run], name: str, words: str) -> None:
    told = found(read_as(recorded("linear"), change))
    assert told is not None and (told.name, words in told.text) == (name, True)
    assert told.chi2 == pytest.approx(1.0, rel=0.2)


def test_a_model_of_another_size_shows_which_inputs_are_exchanged() -> None:
    """The valves are not calibrated, so that the model explains little of the readings either way."""

    def weak(data: DataSet) -> Sequence[RunComparison]:
        return [RunComparison(run, {"p": rig(run, gain=5e4)}) for run in data.runs]

    assert likely_convention(recorded("linear"), UNITS, weak) is None
    swapped = read_as(
        recorded("linear"),
        lambda run: replace(run, inputs={**run.inputs, "u": run.inputs["v"], "v": run.inputs["u"]}),
    )
    told = likely_convention(swapped, UNITS, weak)
    assert told is not None and told.name == "swapped" and "if u and v are exchanged" in told.text
