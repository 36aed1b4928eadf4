"""What takes long: followed as it goes, stopped and resumed, and never lost because nobody looks."""

from __future__ import annotations

import os
import re
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from pam_cosim.workbench import Session, protocol
from pam_cosim.workbench.documents import document
from pam_cosim.workbench.saved import lean, load_state, save_state
from pam_cosim.workbench.script import python_of
from pam_cosim.workbench.steps import Step
from rig.short import write_light_data
from tests.reporting.synthetic import make_diagnosis
from tests.workbench.conftest import Window


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    """Instead of that of other files, on data that lack nothing: a diagnosis is soon over."""
    folder = write_light_data(tmp_path_factory.mktemp("rig") / "quiet", [], 1)
    with Session(folder, workers=0) as session:
        yield session


def test_a_fit_is_that_of_the_public_call_and_is_seen_coming_down(
    window: Window, shared: Session
) -> None:
    window.do(do="set", values={"valve.C_A": 0.6})
    end = window.work(do="fit")
    assert end["end"] == "done"
    fit = pam.fit(pam.read(shared.folder), start={"valve.C_A": 0.6})
    assert shared.state.values == fit.values
    assert "valve.C_A" in window.of("progress")[-1]["values"]
    first, *_, last = (event["scores"]["fit"]["x"]["rms"] for event in window.of("scores"))
    assert first > last
    shown = {p["name"]: p for p in window.last("study")["parameters"]}["valve.C_A"]
    assert shown["low95"] < shown["value"] < shown["high95"]
    assert [r["label"] for r in window.last("scores")["ladder"]][-1] == "base model, fitted"


def test_a_fit_that_is_asked_for_while_its_process_prepares_comes_after_that(
    window: Window, shared: Session
) -> None:
    """What was prepared is what it needs: it builds nothing."""
    shared.prepare()
    shared.prepare()
    assert window.work(do="fit", free=["valve.C_A"])["end"] == "done"
    assert [event["what"] for event in window.of("idle")] == ["fit"]


def test_some_are_fitted_and_the_others_held(window: Window, shared: Session) -> None:
    window.do(do="set", values={"muscle.mu_fb": 0.02})
    window.work(do="fit", free=["valve.C_A"])
    fit = pam.fit(pam.read(shared.folder), free=["valve.C_A"], start={"muscle.mu_fb": 0.02})
    assert shared.state.values == {"muscle.mu_fb": 0.02, **fit.values} and list(fit.values) == [
        "valve.C_A"
    ]


@pytest.mark.full
def test_stopped_it_stands_still_and_resumed_it_ends_as_if_it_had_not(
    window: Window, shared: Session
) -> None:
    window.forget()
    window.do(do="fit", method="particle-swarm")
    window.until("progress")
    with pytest.raises(InputError, match="a fit is running"):
        window.do(do="set", values={"valve.C_A": 0.7})
    window.do(do="stop")
    assert window.last("busy")["held"]
    seen = heard(window)
    assert shared.job is not None and not window.of("idle")
    window.do(do="resume")
    assert window.until("idle")["end"] == "done" and len(window.of("progress")) > seen
    assert shared.state.values == pam.fit(pam.read(shared.folder), method="particle-swarm").values


def heard(window: Window) -> int:
    """How much progress was told when no more comes: of what goes on, all of it."""
    seen, now = -1, len(window.of("progress"))
    while now != seen:
        time.sleep(1.0)
        seen, now = now, len(window.of("progress"))
    return now


@pytest.mark.full
def test_what_was_stopped_is_given_up_for_something_else(window: Window, shared: Session) -> None:
    window.do(do="fit", method="particle-swarm")
    window.until("progress")
    window.do(do="stop")
    window.do(do="set", values={"valve.C_A": 0.66})  # what stands still does not keep the sliders
    window.forget()
    window.do(do="fit")
    assert [window.until("idle", end=end)["what"] for end in ("stopped", "done")] == ["fit", "fit"]


def test_a_diagnosis_goes_on_when_no_window_is_open(window: Window, shared: Session) -> None:
    window.do(do="diagnose")
    window.end()
    deadline = time.monotonic() + 120
    while shared.job is not None and time.monotonic() < deadline:
        time.sleep(0.05)
    shared.wait()
    later = Window(shared)
    verdict = later.last("verdict")
    assert (
        verdict["kind"] == "none_missing"
        and verdict["complete"]
        and verdict["reason"]
        and verdict["meaning"]
    )
    assert [m["text"] for m in later.of("message")][
        -1
    ] == "what remains is noise: no effect is tried"
    later.end()


def test_what_fails_is_told_in_words_and_the_next_thing_works(
    window: Window, shared: Session
) -> None:
    assert window.work(do="diagnose", exclude=["no_such_family"])["end"] == "failed"
    assert "no_such_family" in window.last("failed")["text"]
    assert window.work(do="fit")["end"] == "done"


@pytest.mark.full
def test_a_process_that_dies_is_told_and_replaced(window: Window, shared: Session) -> None:
    window.do(do="fit", method="particle-swarm")
    window.until("progress")
    window.forget()
    shared.worker.wake().kill()
    assert (
        window.until("idle")["end"] == "failed"
        and "ended without a word" in window.until("failed")["text"]
    )
    assert window.work(do="fit")["end"] == "done"


@pytest.mark.full
def test_a_hidden_effect_is_found_added_and_the_error_at_the_noise(
    recorded: Path, tmp_path: Path
) -> None:
    folder = Path(shutil.copytree(recorded, tmp_path / "my-rig"))
    with Session(folder) as session:
        window = Window(session)
        assert window.work(do="diagnose")["end"] == "done"
        rankings = window.of("ranking")
        assert window.of("candidate") and not rankings[0]["final"] and rankings[-1]["final"]
        assert any(c["share"] > 0.9 for c in rankings[-1]["candidates"])
        verdict = window.last("verdict")
        assert verdict["kind"] == "identified" and verdict["families"] == ["elasticity"]
        assert window.last("ledger")["courses"] and window.last("ledger")["sentence"]
        window.do(do="take", candidate=verdict["effects"])
        added = window.do(do="add")
        assert (folder / added["file"]).read_text() == added["text"]
        noise = {signal["name"]: signal["noise"] for signal in window.last("study")["signals"]}
        for name, level in window.last("scores")["scores"]["holdout"].items():
            assert level["rms"] < 1.3 * noise[name]
        report = document(session, "report.html")
        assert verdict["headline"] in report and verdict["reason"].replace("'", "&#39;") in report


@pytest.mark.full
def test_memory_is_flat_over_a_thousand_moves_and_twenty_fits(
    recorded: Path, tmp_path: Path
) -> None:
    def size() -> float:
        with open(f"/proc/{os.getpid()}/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6

    with Session(Path(shutil.copytree(recorded, tmp_path / "my-rig"))) as session:
        window = Window(session)

        def some(moves: int, fits: int) -> None:
            for i in range(moves):
                window.do(do="set", values={"valve.C_A": 0.6 + 0.0002 * (i % 1000)})
                window.forget()
            for _ in range(fits):
                window.work(do="fit")

        some(100, 2)
        before = size()
        some(1000, 20)
        assert size() - before < 30, f"from {before:.0f} MB to {size():.0f} MB"


def diagnosed(session: Session, kind: str = "ambiguous") -> None:
    """As after a diagnosis; its ranking was made by hand."""
    state = session.state
    found = lean(make_diagnosis(kind, state.data))
    session.back(state.after(Step("diagnose", {}), diagnosis=found))
    session.remember(state)
    session.tell_diagnosis()


def test_every_field_of_an_event_is_documented(window: Window, shared: Session) -> None:
    documented = dict(re.findall(r"^(\w+): (.*(?:\n    .*)*)", protocol.__doc__ or "", re.M))
    window.do(do="set", values={"valve.C_A": 0.6})
    window.work(do="fit", free=["valve.C_A"])
    window.in_its_thread(lambda: diagnosed(shared))
    events = [*window.events, *Window(shared).events]
    assert {"study", "scores", "starts", "busy", "idle", "verdict"} < {e["event"] for e in events}
    for event in events:
        fields = event.keys() - {"event"}
        assert fields <= {*re.findall(r"\w+", documented[event["event"]])}, event["event"]


def test_a_window_that_opens_when_all_is_over_is_told_of_nothing_that_goes_on(
    window: Window, shared: Session
) -> None:
    assert window.work(do="fit", free=["valve.C_A"])["end"] == "done"
    later = Window(shared)
    assert later.of("busy") == []
    later.end()


def test_a_diagnosis_that_was_taken_back_is_gone_from_every_window(
    window: Window, shared: Session
) -> None:
    window.in_its_thread(lambda: diagnosed(shared))
    assert window.last("verdict")["complete"] and window.last("ranking")["candidates"]
    window.forget()
    window.do(do="undo")
    assert window.of("no_diagnosis")
    later = Window(shared)
    for one in (window, later):
        assert not one.of("ranking") and not one.of("verdict") and not one.of("ledger")
    later.end()


def test_after_a_diagnosis_that_failed_the_one_before_stands_there_again(
    window: Window, shared: Session
) -> None:
    """What can be taken from the page is what the study has."""
    window.in_its_thread(lambda: diagnosed(shared))
    ranking, verdict = window.last("ranking"), window.last("verdict")
    assert window.work(do="diagnose", exclude=["no_such_family"])["end"] == "failed"
    shared.wait()
    assert window.last("ranking") == ranking and window.last("verdict") == verdict
    kinds = [event["event"] for event in window.events]
    assert kinds.index("no_diagnosis") < kinds.index("busy")  # nothing of it stays meanwhile


def test_what_was_moved_while_a_fit_was_stopped_is_no_part_of_it(
    window: Window, shared: Session, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Its values are those it fitted with, also when it is done again as the script says."""
    window.do(do="set", values={"valve.C_A": 0.6})
    fit = pam.fit(pam.read(shared.folder), free=["valve.C_A"], start={"valve.C_A": 0.6})
    ends: list[Callable[..., None]] = []
    monkeypatch.setattr(shared.worker, "run", lambda *a: ends.append(a[-1]))
    monkeypatch.setattr(shared.worker, "hold", lambda: True)
    monkeypatch.setattr(shared.worker, "go_on", lambda: None)
    window.do(do="fit", free=["valve.C_A"])
    window.do(do="stop")
    window.do(do="set", values={"muscle.mu_fb": 0.02})
    window.do(do="resume")
    ends[0](True, fit)
    shared.wait()
    state = shared.state
    assert state.values == {"valve.C_A": fit.values["valve.C_A"]}
    (line,) = [
        one
        for one in python_of(state, state.model, tmp_path, shared.catalogue).splitlines()
        if one.startswith("values") and "fit.values" in one
    ]
    repeated: dict[str, Any] = {"values": {"muscle.mu_fb": 0.02}, "fit": fit}
    exec(line, repeated)
    assert repeated["values"] == state.values
    save_state(state, tmp_path)
    assert load_state(tmp_path, shared.first).steps == state.steps
