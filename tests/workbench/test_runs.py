"""Runs are cut, and begin, as is said on the page: seen at once, undone, saved and printed like everything else."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from pam_cosim.workbench import Session
from pam_cosim.workbench.starts import StartsShown
from tests.workbench.conftest import Window
from tests.workbench.test_saving import repeated, same, scores

LATE = 1.1  # s, by when the muscle of run-01 has been filled twice


def started(window: Window, run: str = "run-01") -> dict[str, Any]:
    return next(one for one in window.last("starts")["runs"] if one["run"] == run)


def value(window: Window, state: str, run: str = "run-01") -> float:
    return next(one["value"] for one in started(window, run)["values"] if one["label"] == state)


def chi2(window: Window, role: str = "fit") -> float:
    return window.last("scores")["ladder"][-1][f"chi2_{role}"]


def curve(window: Window, kind: str, run: str = "run-01", what: str = "values") -> Any:
    return [arrays for header, arrays in window.frames if header["kind"] == kind][-1][
        run, "p", what
    ]


def test_each_run_says_where_it_begins(window: Window) -> None:
    told = started(window)
    assert told["mode"] == "rest" and not told["warning"] and "agree" in told["text"]
    assert told["modes"] == ["rest", "steady", "measured", "estimated"]
    assert {one["label"]: one["unit"] for one in told["values"]}["muscle.gas.p"] == "kPa"
    assert value(window, "muscle.gas.p") == pytest.approx(101.325)
    for one in told["values"]:
        assert one["low"] <= one["value"] <= one["high"] and one["low"] < one["high"]


def test_a_cut_run_begins_at_its_new_first_sample(window: Window, recorded: Path) -> None:
    whole = curve(window, "measured")
    window.forget()
    window.do(do="cut", run="run-01", begin=LATE)
    cut = pam.compare(pam.read(recorded, cuts={"run-01": (LATE, None)}))
    assert started(window)["mode"] == "estimated" == cut.data.runs[0].start.mode
    assert "begins at" in started(window)["text"] and value(window, "muscle.gas.p") > 130
    assert chi2(window) == pytest.approx(cut.chi2_reduced("fit"), rel=1e-6)
    run = next(run for run in window.last("study")["runs"] if run["name"] == "run-01")
    assert (run["begins"], run["ends"]) == (LATE, pytest.approx(4.0))
    np.testing.assert_array_equal(
        curve(window, "measured"), whole
    )  # all that was recorded stays in sight
    model = curve(window, "model")
    before = round(LATE * 50)
    assert (
        len(model) == len(whole)
        and np.isnan(model[:before]).all()
        and np.isfinite(model[before:]).all()
    )
    residual = curve(window, "model", what="residual")[before:]
    np.testing.assert_allclose(residual, whole[before:] - model[before:], atol=1e-3)


@pytest.mark.full
def test_cuts_and_starts_are_steps_that_can_be_taken_back(window: Window) -> None:
    before, stood = chi2(window), window.session.state
    window.do(do="cut", run="run-01", begin=LATE, end=3.0)
    window.do(do="begin", run="run-01", mode="rest")
    assert started(window)["mode"] == "rest" and chi2(window) > 10 * before
    window.do(do="begin", run="run-01", mode="measured")
    texts = [step["text"] for step in window.last("steps")["steps"]]
    assert texts == ["cut run-01: 1.1 s to 3 s", "begin run-01: rest", "begin run-01: measured"]
    window.do(do="cut", run="run-01", begin=LATE, end=2.5)  # begins where it did, as it did
    assert started(window)["mode"] == "measured"
    window.do(do="cut", run="run-01", end=2.5)  # begins elsewhere: chosen anew
    assert started(window)["mode"] == "rest"
    for _ in range(5):
        window.do(do="undo")
    assert window.session.state is stood
    assert chi2(window) == before and started(window)["mode"] == "rest"


def test_a_start_value_moves_the_curve_at_once(window: Window, recorded: Path) -> None:
    still = value(window, "load.s")
    window.forget()
    window.do(do="set", values={"muscle.gas.p@run-01": 180.0}, dragged=True)
    assert curve(window, "model")[0] == pytest.approx(180.0 - 101.325, abs=1e-3)
    window.do(do="set", values={"muscle.gas.p@run-01": 170.0}, dragged=True)
    assert curve(window, "model")[0] == pytest.approx(170.0 - 101.325, abs=1e-3)
    assert [step["text"] for step in window.last("steps")["steps"]] == [
        "start muscle.gas.p@run-01 = 1.7e+05"
    ]
    window.session.tell_starts()
    assert started(window)["mode"] == "by hand" and value(window, "load.s") == pytest.approx(still)
    compared = pam.compare(pam.read(recorded), parameters=window.session.state.values)
    assert chi2(window) == pytest.approx(compared.chi2_reduced("fit"), rel=1e-9)
    window.do(do="begin", run="run-01", mode="rest")
    assert (
        value(window, "muscle.gas.p") == pytest.approx(101.325) and not window.session.state.values
    )


def test_what_the_model_cannot_begin_as_is_a_warning(window: Window) -> None:
    session = window.session
    hint = "no start value of a state can be set: free a parameter that moves it"
    reason = f"run-01 begins at 118 kPa: the model begins at p = 0 kPa, and {hint}"
    first, *others = session.state.data.runs
    stuck = replace(first, start=replace(first.start, mode="rest", reason=reason, chosen=True))
    state = replace(session.state, data=replace(session.state.data, runs=(stuck, *others)))
    told = StartsShown().event(state, session.opened, {}, 1)["runs"]
    assert [(one["warning"], one["text"]) for one in told][0] == (True, reason)
    assert not told[1]["warning"]


@pytest.mark.parametrize(
    "command",
    [{"do": "cut", "run": "run-09"}, {"do": "cut", "run": "run-01", "begin": 9.0}, {"do": "cut", "run": None},
     {"do": "cut", "run": "run-01", "begin": "1"}, {"do": "cut", "run": "run-01", "end": float("inf")},
     {"do": "cut", "run": "run-01", "begin": True}, {"do": "begin", "run": "run-01", "mode": "soon"},
     {"do": "begin", "run": "run-09"}, {"do": "begin", "run": "run-01", "mode": 3},
     {"do": "set", "values": {"muscle.gas.p@run-09": 120.0}}, {"do": "set", "values": {"muscle.gas.p@run-01": -5.0}},
     {"do": "set", "values": {"muscle.gas.p@run-01": "high"}}, {"do": "set", "values": {"muscle.gas.p": 120.0}}],
)  # fmt: skip
def test_what_cannot_be_cut_or_begun_is_refused(window: Window, command: dict) -> None:
    state = window.session.state
    with pytest.raises(InputError):
        window.session.do(command).result(60)
    assert window.session.state is state


@pytest.mark.full
def test_a_study_with_cuts_and_starts_is_saved_printed_and_repeated(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with Session(folder) as session:
        window = Window(session)
        window.do(do="cut", run="run-01", begin=LATE)
        window.do(do="set", values={"load.s@run-01": 20.0, "muscle.gas.p@run-01": 210.0})
        window.work(do="fit", free=["valve.C_A"])  # estimates the start that was set by hand
        window.do(do="begin", run="run-02", mode="measured")
        window.do(do="set", values={"muscle.gas.p@run-02": 105.0})
        window.do(do="save")
        stood, held = chi2(window), chi2(window, "holdout")
        signals = scores(session)
        same(signals, repeated(folder, session, tmp_path, monkeypatch))
    with Session(folder) as session:
        window = Window(session)
        assert chi2(window) == pytest.approx(stood, rel=1e-9) and chi2(
            window, "holdout"
        ) == pytest.approx(held)
        assert [started(window, run)["mode"] for run in ("run-01", "run-02")] == [
            "estimated",
            "by hand",
        ]


def test_a_signal_that_is_not_fitted_is_switched_on(window: Window) -> None:
    fitted = {s["name"] for s in window.last("study")["signals"] if s["use"] == "fitted"}
    window.do(
        do="signal",
        name="T",
        fitted="T" not in fitted,
        sigma="0.5 K" if "T" not in fitted else None,
    )
    now = {s["name"]: s for s in window.last("study")["signals"]}
    assert (now["T"]["use"] == "fitted") is ("T" not in fitted)
    window.do(do="signal", name="p", sigma=2)
    now = {s["name"]: s for s in window.last("study")["signals"]}
    assert now["p"]["use"] == "fitted" and now["p"]["noise"] == pytest.approx(2.0)
    for wrong in ({"name": "q"}, {"name": "p", "sigma": "2"}, {"name": "p", "sigma": -1.0}):
        with pytest.raises(InputError):
            window.do(do="signal", **wrong)


def test_a_parameter_is_freed_held_and_stated_with_its_unit(window: Window, recorded: Path) -> None:
    names = [p["name"] for p in window.last("study")["parameters"]]
    window.do(do="set", values={"muscle.L0": "25 cm", "valve.C_A": "0.8"})
    held = {one["name"]: one for one in window.last("study")["held"]}
    assert held["muscle.L0"]["value"] == pytest.approx(250.0)
    assert "stated here" in held["muscle.L0"]["source"]
    window.do(do="free", names=[*names, "muscle.L0"])
    free = {p["name"]: p for p in window.last("study")["parameters"]}
    assert free["muscle.L0"]["value"] == pytest.approx(250.0) and free["muscle.L0"]["low"] < 250
    window.do(do="free", names=["muscle.L0"])
    held = {one["name"]: one["value"] for one in window.last("study")["held"]}
    assert held["valve.C_A"] == pytest.approx(0.8)
    stood = chi2(window)
    data = pam.problem(pam.read(recorded), values={"valve.C_A": 0.8}, free=["muscle.L0"]).data
    again = pam.compare(data, parameters={"muscle.L0": 0.25})
    assert stood == pytest.approx(again.chi2_reduced("fit"), rel=1e-6)
    with pytest.raises(InputError):
        window.do(do="free", names=["no.such"])
    with pytest.raises(InputError):
        window.do(do="set", values={"muscle.L0": "3 kg"})


def test_values_typed_one_after_another_are_taken_back_one_by_one(window: Window) -> None:
    for value in (0.61, 0.62, 0.63):
        window.do(do="set", values={"valve.C_A": value})
    for value in (0.64, 0.65):
        window.do(do="set", values={"valve.C_A": value}, dragged=True)
    window.do(do="undo")
    assert window.last("scores")["values"]["valve.C_A"] == pytest.approx(0.63)
    window.do(do="undo", count=3)
    assert window.last("steps")["steps"] == []
