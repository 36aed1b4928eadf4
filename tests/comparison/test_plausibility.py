"""What speaks against the data: mistakes as people make them, and data without any."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.comparison.plausibility import Doubt, doubts
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.measurement import Run, Signal

TIME = np.linspace(0.0, 10.0, 401)
PRESSURE = 1e5 * (2 + np.sin(2 * np.pi * TIME / 5))
SIGMA = 500.0


def compared(
    measured: np.ndarray,
    modelled: np.ndarray,
    parameters: dict[str, float] | None = None,
    name: str = "run-01",
) -> RunComparison:
    """One run of a pressure by a current."""
    inputs = {"u": np.interp(TIME % 5, [0, 2.5, 5], [0.0, 1.0, 0.0])}
    run = Run(name, Path("x.csv"), "fit", "linear", parameters or {}, TIME, inputs, {"p": measured})
    return RunComparison(run, {"p": modelled})


def asked(*runs: RunComparison, unit: str = "Pa", sigma: float = SIGMA) -> list[Doubt]:
    return list(doubts(runs, {"p": Signal("p", unit, sigma)}, {"load.m": "kg"}))


def noisy(values: np.ndarray) -> np.ndarray:
    return values + SIGMA * np.random.default_rng(4).standard_normal(len(values))


def test_a_model_with_an_ordinary_error_is_not_doubted() -> None:
    assert asked(compared(noisy(PRESSURE), 1.1 * PRESSURE + 5e3)) == []


@pytest.mark.parametrize(("count", "verb"), [(1, "is"), (3, "are")])
def test_a_number_that_is_no_reading_is_named(count: int, verb: str) -> None:
    """As loggers write it where there is no reading; a spike that is as high as the rest spans is one."""
    measured = noisy(PRESSURE)
    measured[10 : 10 + count] = -999e3
    doubt = asked(compared(measured, PRESSURE))[0]
    assert doubt.kind == "marker"
    assert f"{count} of 401 samples {verb} -999 kPa, first at 0.25 s of run-01" in doubt.text
    measured[10 : 10 + count] = 1.5 * PRESSURE.max()
    assert "marker" not in {d.kind for d in asked(compared(measured, PRESSURE))}


@pytest.mark.parametrize(("held", "told"), [(1, True), (4, False)])
def test_a_number_that_is_no_reading_of_an_input_is_named(held: int, told: bool) -> None:
    """A command of few steps, each of which it holds, has none."""
    run = compared(noisy(PRESSURE), PRESSURE)
    command = np.repeat(np.sin(TIME[: len(TIME) // held + 1]), held)[: len(TIME)]
    command[40:48] = 9999.0
    made = replace(run, run=replace(run.run, inputs={"u": command}))
    kinds = [(doubt.kind, doubt.signal) for doubt in asked(made)]
    assert (("marker", "u") in kinds) is told


@pytest.mark.parametrize(
    ("measured", "words"),
    [
        (PRESSURE * 6.895, "written in kPa were read as psi"),
        (PRESSURE / 100, "written in bar were read as kPa"),
        (PRESSURE + 101325.0, "absolute and gauge pressure mixed up"),
        (PRESSURE - 2e5, "its zero is wrong"),
        (-PRESSURE, "sign turned"),
        (PRESSURE * 3.3, "3.3 times as large: a size of the muscle"),
        (np.random.default_rng(1).permutation(PRESSURE), "Before you look for a missing effect"),
    ],
)
def test_a_usual_mistake_is_named(measured: np.ndarray, words: str) -> None:
    (doubt,) = [d for d in asked(compared(noisy(measured), PRESSURE)) if d.kind == "far_off"]
    assert words in doubt.text
    assert "explains little" in doubt.text


def test_an_absolute_pressure_is_reported_if_the_model_begins_at_it() -> None:
    """The start is estimated from the same wrong reading, so that no constant is what the two differ by."""
    rest = 1e5 * np.clip(TIME - 2.0, 0.0, 2.0)
    modelled = np.maximum(rest, 101325.0 * np.exp(-TIME))
    (doubt,) = [d for d in asked(compared(rest + 101325.0, modelled)) if d.kind == "far_off"]
    assert "absolute and gauge pressure mixed up" in doubt.text


def test_a_disconnected_sensor_is_reported() -> None:
    (doubt,) = asked(compared(np.full_like(TIME, 3.0), PRESSURE))
    assert doubt.kind == "still" and "the sensor is not connected" in doubt.text
    assert asked(compared(np.full_like(TIME, 3.0), np.full_like(TIME, 4.0))) == []


def test_warnings_of_the_model_come_first_and_each_once() -> None:
    """With its runs; where its numbers differ, those of the first of them."""
    measured = np.full_like(TIME, 3.0)
    names = ("run-01", "run-02", "run-03")
    times = ((1.5, 2.5), (), (2e-3,))
    runs = [
        replace(
            compared(measured + k, PRESSURE, name=name),
            warnings=tuple(f"fails at time {t:g} s: p = {t} Pa" for t in own) + ("always",),
        )
        for k, (name, own) in enumerate(zip(names, times, strict=True))
    ]
    first, second, *others = asked(*runs)
    assert first.text == "run-01, run-03: fails at time 1.5 s: p = 1.5 Pa (in run-01)"
    assert second == Doubt("warning", "", "every run: always")
    assert others and "warning" not in {doubt.kind for doubt in others}


def test_a_copy_under_another_name_is_reported() -> None:
    measured = noisy(PRESSURE)
    one, other = compared(measured, PRESSURE), compared(measured, PRESSURE, name="run-02")
    (doubt,) = asked(one, other)
    assert doubt.kind == "copy" and "run-01 and run-02 have the same samples of p" in doubt.text
    repeated = compared(noisy(measured), PRESSURE, name="run-02")
    assert asked(one, repeated) == []


def test_a_large_error_without_a_simple_cause_waits_for_the_fit() -> None:
    run = compared(noisy(np.random.default_rng(1).permutation(PRESSURE)), PRESSURE)
    signals = {"p": Signal("p", "Pa", SIGMA)}
    assert doubts([run], signals, {}, fitted=False) == ()
    assert len(doubts([run], signals, {}, fitted=True)) == 1
    (mended,) = doubts([compared(noisy(6.895 * PRESSURE), PRESSURE)], signals, {}, fitted=False)
    assert "psi" in mended.text


def test_a_measurement_that_never_passes_zero_is_reported() -> None:
    """A muscle that cannot push, in a model that can."""
    force = 100 * np.sin(2 * np.pi * TIME / 5)
    every = asked(compared(np.maximum(force, 0.0), force), unit="N", sigma=0.1)
    (doubt,) = [d for d in every if d.kind == "one_sided"]
    assert "never falls below zero" in doubt.text
    assert "down to -100 N" in doubt.text or "down to −100 N" in doubt.text


def pair(heavier: float) -> list[RunComparison]:
    """Two runs by load; in the model the pressure of the heavier one is 20 kPa higher, in the data by so much."""
    level = 1e5 * np.interp(TIME % 5, [0, 2.5, 5], [0.0, 1.0, 0.0])
    light = compared(noisy(level), level, {"load.m": 2.0})
    return [light, compared(noisy(level + heavier), level + 2e4, {"load.m": 5.0}, "run-02")]


def test_runs_that_differ_the_other_way_than_in_the_model_contradict() -> None:
    (doubt,) = [d for d in asked(*pair(-1.5e4)) if d.kind == "contradiction"]
    assert "run-01 and run-02 differ in load.m alone (2 kg and 5 kg)" in doubt.text
    assert "exchanged" in doubt.text


def test_runs_that_differ_as_in_the_model_do_not() -> None:
    assert not [d for d in asked(*pair(1.5e4)) if d.kind == "contradiction"]


def test_runs_are_not_compared_where_inputs_do_not_say_what_the_model_does() -> None:
    """A pressure that a valve's current drives is what the current has been, not what it is."""
    rise = np.cumsum(np.ones_like(TIME)) * 500.0
    light = compared(rise, rise, {"load.m": 2.0})
    heavy = compared(rise - 2e4, rise + 2e4, {"load.m": 5.0}, "run-02")
    assert not [d for d in asked(light, heavy) if d.kind == "contradiction"]


def test_a_run_of_one_sample_is_not_compared() -> None:
    light, heavy = pair(-1.5e4)
    values = {n: v[:1] for n, v in heavy.run.inputs.items()}
    seen = {n: v[:1] for n, v in heavy.run.measurements.items()}
    short = replace(heavy.run, time=heavy.run.time[:1], inputs=values, measurements=seen)
    one = replace(heavy, run=short, model={n: v[:1] for n, v in heavy.model.items()})
    assert not [d for d in asked(light, one) if d.kind == "contradiction"]


def test_runs_that_differ_in_more_than_one_thing_are_not_compared() -> None:
    light, heavy = pair(-1.5e4)
    other = replace(heavy, run=replace(heavy.run, parameters={"load.m": 5.0, "p_supply": 1.0}))
    assert not [d for d in asked(light, other) if d.kind == "contradiction"]


@pytest.mark.parametrize(
    ("lowest", "current", "duration", "words"),
    [
        (0.0, 1.0, 10.0, ""),
        (0.0, 250.0, 10.0, "u: 250 A in run-01, and outside -20 A to 20 A in every run"),
        (0.0, 1.0, 12000.0, "duration: 1.2e+04 s"),
        (-100e3, 1.0, 10.0, "p: -100 kPa"),
    ],
)
def test_values_unusual_in_the_field_are_reported(
    lowest: float, current: float, duration: float, words: str
) -> None:
    """Only where it is so in every run."""
    pressure = PRESSURE - PRESSURE.min() + lowest
    usual = compared(pressure, pressure)
    inputs = {"u": current * usual.run.inputs["u"]}
    odd = replace(usual, run=replace(usual.run, inputs=inputs, time=duration / 10.0 * TIME))
    ranges = (("Pa", "-9e4", "2e7"), ("A", "-20", "20"), ("s", "0.1", "1e4"))
    signals, units = {"p": Signal("p", "Pa", SIGMA)}, {"u": "A"}
    texts = [d.text for d in doubts([odd], signals, units, ranges=ranges) if d.kind == "unusual"]
    assert len(texts) == bool(words) and all(text.startswith(words) for text in texts)
    if words.startswith("u"):
        run = replace(odd.run, name="run-03", inputs={"u": 2.0 * inputs["u"]})
        idle = replace(usual, run=replace(usual.run, name="run-04", inputs={}))
        first = doubts([idle, replace(odd, run=run)], signals, units, ranges=ranges)
        assert any(d.text.startswith("u: 500 A in run-03") for d in first)
    calm = compared(noisy(PRESSURE), PRESSURE, name="run-02")
    both = doubts([odd, calm], signals, units, ranges=ranges)
    assert not [d for d in both if d.kind == "unusual"]
