"""Strangers' rigs: the base model is the library's, a rig comes the same twice, and its score follows the protocol."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from benchmarks.strangers.report import calibration, held_out, recall_and_precision, report
from strangers.__main__ import make
from strangers.loggers import record, write
from strangers.notes import SPRING_RIG, draft
from strangers.physics import Array, Start, Truth, solve
from strangers.rigs import RIGS, Rig, rig

MUSCLE: dict[str, float] = {"L0": 0.2, "D0": 0.015, "angle": math.radians(23), "n": 1.15}
BASES = {
    "Isotonic": Truth("hang", M=10.0, **MUSCLE),
    "Isometric": Truth("held", **MUSCLE),
    "TankFilling": Truth("tank", V_tank=1e-3, A_in=2e-6, A_out=2e-6),
}
NOISE = {"p": 400.0, "x": 3e-5, "F": 1.0, "T": 0.1}  # the least that a rig has
LENGTH = 0.02
FILES = ("plain", "german", "tabs", "two", "one file")


def pulses(t: float, seen: dict[str, float], draw: np.random.Generator) -> Any:
    """Inlet and outlet by turns, shut between."""
    turn = round(t / 0.5) % 4
    return 0.5, 0.3 * (turn == 0), 0.2 * (turn == 2)


def stated(one: Truth) -> dict[str, Any]:
    """The parameters of the library's bench for a rig without friction."""
    values: dict[str, Any] = {"p_supply": one.p_supply, "valve.C_A": one.C_d}
    if one.load == "tank":
        return values | {"tank.V": one.V_tank, "tank.n": one.n}
    values |= {"muscle.L0": one.L0, "muscle.D0": one.D0, "muscle.t_wall": one.t_wall}
    values |= {"muscle.turns": one.L0 * math.tan(one.angle) / (math.pi * one.D0)}
    values |= {"muscle.n_g": one.n, "muscle.mu_fb": 0.0, "muscle.mu_d": 0.0}
    values |= {"muscle.fibres": 1.0, "muscle.w": 1e-5}
    if one.load == "held":
        return values | {"s": LENGTH, "drive.s_start": LENGTH}
    return values | {"load.m": one.M}


def commanded(opening: Array, area: float) -> Array:
    """Of the library's valve [A], with both values of each step."""
    return 0.145 + area * np.repeat(opening, 2)[:-1] / 1.8e-6


@pytest.mark.parametrize("bench", BASES)
def test_without_departures_a_rig_is_the_base_model(bench: str) -> None:
    one = BASES[bench]
    t = np.linspace(0, 6, 1201)
    run = solve(one, Start(), t, pulses, imposed=lambda _: LENGTH)
    time = np.sort(np.concatenate([t, t[1:] - 1e-7]))
    inputs = {
        "time": time,
        "u_in": commanded(run.u_in, one.A_in),
        "u_out": commanded(run.u_out, one.A_out),
    }
    base = pam.simulate(bench, stated(one), inputs, stop_time=6.0, interval=0.005)
    assert set(base.values) == {"p", "T", *{"hang": "x", "held": "F"}.get(one.load, "")}
    for signal in base.values:
        ours = np.interp(base.time, t, run.readings[signal])
        assert np.ptp(ours) > 100 * NOISE[signal]
        assert np.sqrt(np.mean((ours - base[signal]) ** 2)) < NOISE[signal]


def test_a_departure_alone_does_what_it_says() -> None:
    """Laws that hold whatever the solver: gas that a leak loses, heat that a tank gives, a reading's zero."""
    t = np.linspace(0, 60, 301)
    tank = replace(BASES["TankFilling"], film=20.0)

    def shut(at: float, seen: dict[str, float], draw: np.random.Generator) -> Any:
        return 0.2, 0.5 * (at == 0), 0.0

    def last(one: Truth) -> dict[str, float]:
        return {s: float(v[-1]) for s, v in solve(one, Start(), t, shut).readings.items()}

    cooled, leaking = last(tank), last(replace(tank, leak=1e-8))
    assert cooled["T"] == pytest.approx(tank.T_amb, abs=1.0)
    assert leaking["p"] < 0.9 * cooled["p"]
    assert last(replace(tank, p_zero=2e3))["p"] == pytest.approx(cooled["p"] + 2e3)
    hung = BASES["Isotonic"]
    free = solve(hung, Start(2e5), t[:5], shut).readings["x"][0]
    rubber = solve(replace(hung, C10=1e5), Start(2e5), t[:5], shut).readings["x"][0]
    assert 0 < rubber < free


def test_rigs_are_drawn_as_the_protocol_says() -> None:
    rigs = [rig(n) for n in range(RIGS)]
    assert [r.half for r in rigs] == ["tuning"] * 15 + ["once"] * 15
    for half in ("tuning", "once"):
        inside = [r for r in rigs if r.half == half]
        assert {r.truth.load for r in inside} == {"hang", "spring", "held", "tank"}
        assert {r.layout for r in inside} == set(FILES)
    for one in rigs:
        families = [d.family for d in one.departures]
        assert 3 <= len(families) <= 6 and len(set(families)) == len(families)
        base = one.truth.without(*(f for d in one.departures for f in d.fields))
        assert (base.film, base.leak, base.dahl, base.V_dead, base.T_lag) == (0, 0, 0, 0, 0)
        assert sum(p.held_out for p in one.runs) == 2


def shortened(one: Rig) -> Rig:
    return replace(one, runs=tuple(replace(p, end=p.begin + 3) for p in one.runs[:3]))


@pytest.mark.parametrize("number", [1, 5, 7, 13, 14, 18, 25])  # every load and every layout
def test_a_drafted_data_set_reads_what_was_recorded(number: int, tmp_path: Path) -> None:
    one = shortened(rig(number))
    runs = [record(one, i) for i in range(3)]
    files = write(one, runs, tmp_path)
    (tmp_path / "experiment.toml").write_text(draft(one, files), encoding="utf-8")
    (tmp_path / "SpringRig.mo").write_text(SPRING_RIG)
    data = pam.read(tmp_path)
    for run, read in zip(runs, data.runs, strict=True):
        begin, steps = read.time[0], {**one.steps, "T": 0.1 / 1.8, "F": 0.1}
        for signal, values in run.read.items():
            at = next(t for name, t in run.times.items() if len(t) == len(values))
            kept = ~np.isnan(read.measurements[signal])
            assert kept.sum() == pytest.approx(len(at), abs=2)
            ours = np.interp(read.time[kept] - begin, at, values)
            assert np.median(np.abs(ours - read.measurements[signal][kept])) <= steps[signal]
        if callable(run.plan.imposed):
            assert np.ptp(read.inputs["s"]) > 1e-3
        sheet = 0.145 + one.truth.A_in * run.commands[0] / 1.8e-6
        current = np.interp(run.times[""] + begin, read.time, read.inputs["u_in"])
        step = one.truth.A_in / 1.8e-6 / 400  # of the commands that a rig puts out
        assert np.median(np.abs(current - sheet)) < step


def test_a_rig_comes_the_same_twice(tmp_path: Path) -> None:
    for name in ("a", "b"):
        make(shortened(rig(1)), tmp_path / name)
    files = sorted(p.name for p in (tmp_path / "a").iterdir())
    assert {"notes.md", "truth.json", "experiment.toml"} < set(files)
    for name in files:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
    truth = json.loads((tmp_path / "a" / "truth.json").read_text())
    for signal, error in truth["error_of_truth"]["holdout"].items():
        assert error == pytest.approx(truth["noise"][signal], rel=0.3)  # 61 samples
    for departure in truth["departures"]:
        assert departure["counts"] == (max(departure["rms_over_noise"].values()) > 1)
    assert not {"film", "departure"} & set((tmp_path / "a" / "notes.md").read_text().split())


def result(number: int, families: dict[str, float], **departures: bool) -> dict[str, Any]:
    errors = {"base": {"p": 30.0, "x": 4.0}, "final": {"p": 3.0, "x": 4.0}}
    return errors | {
        "number": number, "kind": "unknown", "families": families, "departures": departures,
        "error_of_truth": {"p": 3.0, "x": 2.0}, "rivals": {"ridge": {"p": 3.0, "x": 2.0}},
        "processor_seconds": 10.0,
    }  # fmt: skip


def test_the_score_counts_as_the_protocol_says() -> None:
    results = [
        result(0, {"leak": 0.9, "creep": 0.6, "elasticity": 0.3}, leak=True, elasticity=True),
        result(1, {"leak": 0.1, "dead_volume": 0.8}, dead_volume=False, gas_energy=True),
        {"number": 2, "error": "time limit", "departures": {"creep": True}},
    ]
    recall, precision = recall_and_precision(results)
    assert (recall, precision) == (1 / 4, 1 / 2)  # a departure too small to count is left out
    rows, brier = calibration(results)
    # gas_energy has no probability in the second verdict: zero
    assert [(n, share) for _, share, n, _ in rows] == [(1, 1), (1, 0), (1, 1), (1, 0), (1, 1)]
    assert brier == pytest.approx((1 + 0.01 + 0.49 + 0.36 + 0.01) / 5)
    assert held_out(results[0])["final"] == pytest.approx(math.sqrt(2.5))
    text = "\n".join(report(results))
    assert (
        "3 rigs, 1 without a verdict" in text and "better than the best regression: 0 of 2" in text
    )
