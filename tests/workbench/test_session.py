"""A study without a browser: what is set is drawn and scored as the public calls do, and told to every window."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.diagnosis.judgement.model_space import effects_named
from pam_cosim.errors import InputError
from pam_cosim.workbench import Session
from pam_cosim.workbench.state_events import short_name
from tests.workbench.conftest import Window


def rms(scores: dict, role: str) -> dict[str, float]:
    return {name: level["rms"] for name, level in scores[role].items()}


def compared(comparison: pam.Diagnosis | object, role: str) -> dict[str, float]:
    """Scores of the public call, in the shown units."""
    factor = {"p": 1e-3, "x": 1e3, "T": 1.0}
    return {name: s.rmse * factor[name] for name, s in comparison.scores[role].items()}  # type: ignore[attr-defined]


def test_a_slider_moves_curves_and_errors_as_the_public_call_says(
    window: Window, recorded: Path
) -> None:
    measured = next(arrays for header, arrays in window.frames if header["kind"] == "measured")
    before = next(arrays for header, arrays in window.frames if header["kind"] == "model")
    window.do(do="set", values={"valve.C_A": 0.71})
    header, after = [frame for frame in window.frames if frame[0]["kind"] == "model"][-1]
    comparison = pam.compare(pam.read(recorded), parameters={"valve.C_A": 0.71})
    for role in ("fit", "holdout"):
        assert rms(window.last("scores")["scores"], role) == pytest.approx(
            compared(comparison, role), rel=1e-12
        )
    for run in comparison.runs:
        x = run.model["x"] * 1e3
        np.testing.assert_allclose(after[run.run.name, "x", "values"], x, rtol=1e-6, atol=1e-6)
        residual = measured[run.run.name, "x", "values"] - after[run.run.name, "x", "values"]
        np.testing.assert_allclose(after[run.run.name, "x", "residual"], residual, atol=1e-4)
        assert (
            np.abs(after[run.run.name, "p", "values"] - before[run.run.name, "p", "values"]).max()
            > 0.1
        )
    assert header["version"] == window.last("scores")["version"]
    assert window.last("scores")["values"]["valve.C_A"] == 0.71


def test_a_warning_of_the_model_stands_with_the_scores(folder: Path, window: Window) -> None:
    assert window.last("scores")["warnings"] == []
    file = folder / "experiment.toml"
    file.write_text(file.read_text() + '[parameters]\n"muscle.fibres" = 300\n')
    with Session(folder) as session:
        (warning,) = Window(session).last("scores")["warnings"]
    assert warning.startswith("every run: ") and "muscle.fibres = 300" in warning


def test_the_curves_come_before_the_scores_of_them(window: Window) -> None:
    window.forget()
    window.do(do="set", values={"valve.C_A": 0.65})
    kinds = ["frame" if isinstance(m, bytes) else "other" for m in window._told]
    assert kinds[0] == "frame"


def test_dragging_never_makes_a_queue(window: Window) -> None:
    """While one is drawn, of all that come only the last is drawn."""
    session, gate = window.session, threading.Event()
    window.forget()
    session.submit(gate.wait)
    values = ({"valve.C_A": 0.6 + 0.001 * i} for i in range(50))
    moves = [session.do({"do": "set", "values": one, "dragged": True}) for one in values]
    gate.set()
    for move in moves:
        move.result(60)
    assert len([h for h, _ in window.frames if h["kind"] == "model"]) == 1
    assert window.last("scores")["values"]["valve.C_A"] == pytest.approx(0.649)
    assert window.last("steps")["steps"] == [{"text": "set valve.C_A = 0.649"}]


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"valve.C_B": 0.7}, "did you mean 'valve.C_A'"),
        ({"valve.C_A": "0.7 kg"}, "valve.C_A"),
        ({"valve.C_A": float("nan")}, "finite"),
        ({"valve.C_A": 1e308}, "must be between"),
        ({"valve.C_A": 2.5}, "lowest to its highest"),
        ({"valve.C_A": True}, "must be a number"),
        ({"valve.C_A": None}, "must be a number"),
        ([1, 2], "by name"),
    ],
)
def test_what_cannot_be_set_is_refused_in_words(window: Window, values: object, said: str) -> None:
    state = window.session.state
    with pytest.raises(InputError, match=said):
        window.do(do="set", values=values)
    assert window.session.state is state


@pytest.mark.parametrize(
    "command",
    [{"do": "explode"}, {"do": None}, {}, {"do": "__init__"}, {"do": "fit", "speed": 3}, {"do": "switch"},
     {"do": "switch", "effects": "LinearBladder"}, {"do": "switch", "effects": ["NoSuchEffect"]},
     {"do": "choose", "model": "/etc/passwd.mo"}, {"do": "choose", "model": "NoSuchBench"},
     {"do": "choose", "model": "Isometric"}, {"do": "choose", "model": "LumpedLinear"},
     {"do": "fit", "method": "magic"}, {"do": "fit", "free": ["valve.nothing"]}, {"do": "fit", "free": []},
     {"do": "take", "candidate": 0}, {"do": "take", "candidate": ["LinearBladder"]}, {"do": "add"},
     {"do": "undo"}, {"do": "stop"}, {"do": "resume"},
     {"do": "roles", "roles": {"run-01": "judge"}}, {"do": "roles", "roles": {"run-01": "holdout"}},
     {"do": "load"}, {"do": "diagnose", "time_limit": "soon"}, {"do": "diagnose", "exclude": "leak"}],
)  # fmt: skip
def test_what_cannot_be_done_is_refused_and_changes_nothing(window: Window, command: dict) -> None:
    state = window.session.state
    with pytest.raises(InputError):
        window.session.do(command).result(60)
    assert window.session.state is state


def test_an_effect_is_a_switch_with_sliders_of_its_own(window: Window, recorded: Path) -> None:
    shown = {e["name"]: e for e in window.last("study")["effects"]}
    bladder = shown["LinearBladder"]
    assert (
        not bladder["on"]
        and bladder["fits"]
        and "=" in bladder["equation"]
        and bladder["fingerprint"]
    )
    window.do(do="set", values={"valve.C_A": 0.71})
    window.do(do="switch", effects=["LinearBladder"])
    study = window.last("study")
    own = [p for p in study["parameters"] if p["effect"] == "LinearBladder"]
    assert own and {e["name"] for e in study["effects"] if e["on"]} == {"LinearBladder"}
    assert any(header["kind"] == "reference" for header, _ in window.frames)
    low, high = own[0]["low"], own[0]["high"]
    window.do(do="set", values={own[0]["name"]: low + 0.3 * (high - low)})
    window.do(do="undo")
    window.do(do="undo")
    assert window.last("study")["with_effects"] == "base model"
    comparison = pam.compare(pam.read(recorded), parameters={"valve.C_A": 0.71})
    assert rms(window.last("scores")["scores"], "fit") == pytest.approx(
        compared(comparison, "fit"), rel=1e-12
    )


def test_a_second_window_shows_the_same(window: Window) -> None:
    window.do(do="set", values={"valve.C_A": 0.66})
    other = Window(window.session)
    assert other.last("scores") == window.last("scores") and other.last("steps") == window.last(
        "steps"
    )
    value = {p["name"]: p["value"] for p in other.last("study")["parameters"]}["valve.C_A"]
    assert value == pytest.approx(0.66)
    assert {header["kind"] for header, _ in other.frames} == {"measured", "model"}
    other.end()
    seen = len(other.events)
    window.do(do="set", values={"valve.C_A": 0.67})
    assert len(other.events) == seen


def test_the_ladder_keeps_where_it_came_from(window: Window) -> None:
    start = window.last("scores")["ladder"]
    assert [rung["label"] for rung in start] == ["as stated"]
    window.do(do="set", values={"valve.C_A": 0.66})
    ladder = window.last("scores")["ladder"]
    assert [rung["label"] for rung in ladder] == ["as stated", "base model, by hand"]
    assert ladder[0] == start[0] and ladder[1]["fit"] != start[0]["fit"]


def test_rules_say_where_the_error_is(window: Window) -> None:
    rules = window.until("where")["rules"]
    runs = {run["name"]: run["ends"] for run in window.last("study")["runs"]}
    assert rules and all(rule["ranges"] for rule in rules)
    for rule in rules:
        for run, ranges in rule["ranges"].items():
            assert all(0 <= first <= last <= runs[run] for first, last in ranges)


def test_roles_are_changed_for_the_study(window: Window, recorded: Path) -> None:
    window.do(do="roles", roles={"run-02": "fit"})
    assert {r["name"]: r["role"] for r in window.last("study")["runs"]} == {
        "run-01": "fit",
        "run-02": "fit",
    }
    assert window.last("scores")["scores"]["holdout"] == {}
    comparison = pam.compare(pam.read(recorded, roles={"run-02": "fit"}))
    assert rms(window.last("scores")["scores"], "fit") == pytest.approx(
        compared(comparison, "fit"), rel=1e-12
    )


def test_a_study_of_which_a_run_cannot_be_simulated_opens_and_names_the_run(folder: Path) -> None:
    file = folder / "run-02.csv"
    header, *rows = (line.split(",") for line in file.read_text().splitlines())
    column = next(i for i, name in enumerate(header) if name.startswith("x "))
    for row in rows:
        row[column] = str(float(row[column] or "nan") - 313)
    file.write_text("\n".join(",".join(row) for row in (header, *rows)))
    with Session(folder) as session:
        window = Window(session)
        scores = window.last("scores")
        assert [run["run"] for run in scores["failed"]] == ["run-02"]
        assert scores["warnings"][0].startswith("run-02 cannot be simulated: the solver's step")
        assert rms(scores["scores"], "fit")["x"] > 0 and not scores["scores"]["holdout"]
        window.do(do="set", values={"valve.C_A": 0.71})
        assert window.last("scores")["values"]["valve.C_A"] == 0.71


def test_two_studies_do_not_mix(window: Window, recorded: Path) -> None:
    with Session(recorded) as other:
        second = Window(other)
        window.do(do="set", values={"valve.C_A": 0.6})
        second.do(do="set", values={"valve.C_A": 0.8})
        assert window.last("scores")["values"]["valve.C_A"] == 0.6
        assert second.last("scores")["values"]["valve.C_A"] == 0.8
        assert window.session.state.steps != other.state.steps


def test_every_family_that_can_be_ticked_is_one_that_a_diagnosis_knows(window: Window) -> None:
    study = window.last("study")
    families, available = study["families"], pam.effects()
    assert set(families) == {e.family for e in available} and any("_" in one for one in families)
    for family in families:
        assert effects_named(available, family), family


def test_a_model_from_before_that_is_gone_is_told_to_be_gone(window: Window) -> None:
    window.do(do="switch", effects=["LinearBladder"])
    window.do(do="undo")
    gone = [header for header, _ in window.frames if header["kind"] == "reference"][-1]
    assert gone["runs"] == []
    other = Window(window.session)
    assert "reference" not in {header["kind"] for header, _ in other.frames}
    other.end()


@pytest.mark.parametrize(
    ("model", "short"),
    [("PneumaticMuscle.Benches.Isotonic", "Isotonic"), ("Isotonic", "Isotonic"), ("rigs/Better.mo", "Better"),
     ("C:\\rigs\\my.rig.MO", "my.rig"), ("/tmp/Muscle.fmu", "Muscle"), ("Mine.'a.b'", "'a.b'")],
)  # fmt: skip
def test_a_model_is_called_by_the_last_of_its_name(model: str, short: str) -> None:
    assert short_name(model) == short
