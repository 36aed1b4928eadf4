"""A study is saved whole, comes back with the same numbers, and what it prints repeats it exactly."""

from __future__ import annotations

import json
import runpy
import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from pam_cosim.workbench import Session
from pam_cosim.workbench.commands.files import save
from pam_cosim.workbench.saved import FILE, lean, load_state, save_state
from pam_cosim.workbench.script import python_of
from pam_cosim.workbench.steps import Step
from tests.reporting.synthetic import make_data, make_diagnosis, make_fit
from tests.workbench.conftest import Window


@pytest.fixture
def window(folder: Path) -> Iterator[Window]:
    """A study of its own: it writes into its folder."""
    with Session(folder) as session:
        yield Window(session)


def scores(session: Session) -> Any:
    return json.loads(json.dumps(session.comparison.as_dict()["signals"]))


def work_a_little(window: Window) -> None:
    """What needs no other process."""
    window.do(do="set", values={"valve.C_A": 0.71})
    window.do(do="switch", effects=["LinearBladder"])
    name = next(p["name"] for p in window.last("study")["parameters"] if p["effect"])
    low, high = (
        window.session.opened.parameters[name].low,
        window.session.opened.parameters[name].high,
    )
    window.do(do="set", values={name: low + 0.01 * (high - low), "muscle.mu_fb": 0.0213})


@pytest.mark.full
def test_what_was_saved_comes_back_with_the_same_numbers(window: Window, folder: Path) -> None:
    work_a_little(window)
    assert not window.last("steps")["saved"]
    window.do(do="save")
    assert window.last("steps")["saved"]
    before, ladder, steps = (
        scores(window.session),
        window.last("scores")["ladder"],
        window.last("steps"),
    )
    window.do(do="set", values={"valve.C_A": 0.8})
    assert not window.last("steps")["saved"]
    window.do(do="load")
    assert scores(window.session) == before and window.last("scores")["ladder"] == ladder
    window.do(do="undo")
    assert window.last("scores")["values"]["valve.C_A"] == 0.8
    with Session(folder) as again:
        fresh = Window(again)
        assert scores(again) == before
        assert fresh.last("scores")["ladder"] == ladder and fresh.last("steps") == steps
        assert fresh.last("study")["with_effects"] == "with LinearBladder"


@pytest.mark.full
def test_every_step_of_a_session_can_be_saved_and_loaded(window: Window, folder: Path) -> None:
    """What a step holds here is what the check of a saved study knows of it."""
    work_a_little(window)
    window.do(do="add")
    window.do(do="roles", roles={"run-02": "fit"})
    window.do(do="choose", model="Isotonic")
    window.do(do="cut", run="run-01", begin=1.0, end=3.5)
    window.do(do="begin", run="run-02", mode="measured")
    window.do(do="set", values={"muscle.gas.p@run-02": 110.0})
    window.do(do="save")
    steps = window.session.state.steps
    assert {step.do for step in steps} == {
        "set",
        "switch",
        "add",
        "roles",
        "choose",
        "cut",
        "begin",
        "start",
    }
    assert load_state(folder, window.session.first).steps == steps


@pytest.mark.parametrize(
    "damage",
    [
        "{",
        "[]",
        "{}",
        '{"format": "pam-cosim workbench 1"}',
        "steps",
        "effects",
        "values",
        "file",
        "runs",
        "fit",
    ],
)
def test_a_damaged_file_is_refused(folder: Path, shared: Session, damage: str) -> None:
    save_state(shared.state, folder)
    assert load_state(folder, shared.first) == shared.first
    content = json.loads((folder / FILE).read_text())
    changes: dict[str, Any] = {
        "steps": {"steps": [{"do": "rm -rf"}]}, "effects": {"effects": [1]}, "values": {"values": {"valve.C_A": "x"}},
        "file": {"file": "../../etc/passwd"}, "runs": {"runs": ["another"]}, "fit": {"fit": "../fit.npz"},
    }  # fmt: skip
    text = json.dumps(content | changes[damage]) if damage in changes else damage
    (folder / FILE).write_text(text)
    with pytest.raises(InputError):
        load_state(folder, shared.first)


def test_a_study_opens_without_what_was_damaged(folder: Path) -> None:
    (folder / FILE).write_text("{")
    with Session(folder) as again:
        fresh = Window(again)
        assert fresh.last("failed")["during"] == "load" and fresh.last("steps")["steps"] == []


def test_nothing_but_files_of_the_folder_is_written(
    window: Window, folder: Path, tmp_path: Path
) -> None:
    window.do(do="switch", effects=["LinearBladder"])
    for name in (
        "../out.mo",
        "/tmp/out.mo",
        "a/b.mo",
        ".mo",
        "..",
        "x.py",
        "x\n.mo",
        "experiment.toml",
        "C:\\x.mo",
    ):
        with pytest.raises(InputError):
            window.do(do="add", file=name)
    outside = tmp_path / "outside.mo"
    (folder / "link.mo").symlink_to(outside)
    with pytest.raises(InputError, match="no regular file"):
        window.do(do="add", file="link.mo")
    (folder / "mine.mo").write_text("mine")
    with pytest.raises(InputError, match="another file"):
        window.do(do="add", file="mine.mo")
    (folder / FILE).symlink_to(outside)
    with pytest.raises(InputError, match="no regular file"):
        window.do(do="save")
    assert not outside.exists() and (folder / "mine.mo").read_text() == "mine"
    added = window.do(do="add", file="Better.mo")
    assert (folder / "Better.mo").read_text() == added["text"] == window.last("added")["text"]
    assert added["text"].startswith("model Better ") and window.last("study")["file"] == "Better.mo"
    again = window.do(do="add", file="Better.mo")  # the same once more is no loss
    assert again["text"] == added["text"]


def test_what_is_added_compares_as_the_page_shows_it(window: Window, folder: Path) -> None:
    """The model is written with its values, not with those that its classes have by default."""
    window.do(do="set", values={"valve.C_A": 0.72})
    window.do(do="switch", effects=["LinearBladder"])
    window.do(do="set", values={"bladder.k": 123.0})
    added = window.do(do="add", file="Better.mo")
    assert "k=123.0" in added["text"] and "C_A=0.72" in added["text"]
    compared = pam.compare(pam.read(folder), str(folder / "Better.mo"))
    same(scores(window.session), json.loads(json.dumps(compared.as_dict()["signals"])))


def repeated(folder: Path, session: Session, place: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    """The signals' scores at the end of the script."""
    monkeypatch.chdir(place)
    script = place / "study.py"
    script.write_text(python_of(session.state, session.first.model, folder, session.catalogue))
    made = runpy.run_path(str(script))
    return json.loads(json.dumps(made["comparison"].as_dict()["signals"]))


def same(one: Any, other: Any) -> None:
    for signal, values in one.items():
        for key, value in values.items():
            if isinstance(value, float):
                np.testing.assert_allclose(
                    other[signal][key], value, rtol=1e-9, err_msg=f"{signal} {key}"
                )


@pytest.mark.full
def test_a_script_repeats_it(
    window: Window, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    work_a_little(window)
    window.do(do="add")
    window.do(do="switch", effects=[])
    window.do(do="roles", roles={"run-02": "fit"})
    window.do(do="reset", names=["muscle.mu_fb"])
    window.do(do="choose", model="Isotonic")
    window.do(do="set", values={"valve.C_A": 0.77})
    place = tmp_path / "elsewhere"
    place.mkdir()
    same(scores(window.session), repeated(folder, window.session, place, monkeypatch))


def test_a_title_cannot_leave_its_comment(shared: Session) -> None:
    state = shared.state
    evil = replace(state, data=replace(state.data, title='x\nimport os\r\n"""$(rm -rf /)\u2028y'))
    about = (evil, state.model, Path("a b'c"), shared.catalogue)
    text = python_of(*about)
    lines = [line for line in text.splitlines() if "rm -rf" in line or "import os" in line]
    assert len(lines) == 1 and lines[0].startswith("# ")


@pytest.mark.full
def test_a_whole_study_is_saved_and_repeated(
    window: Window, folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Set, fit, diagnose, take, add: the same verdict after loading, the same numbers when it is done again."""
    window.do(do="set", values={"valve.C_A": 0.7})
    window.work(do="fit")
    assert window.work(do="diagnose", exclude=["creep"])["end"] == "done"
    verdict = window.last("verdict")
    window.do(do="take", candidate=verdict["effects"])
    window.do(do="add")
    window.do(do="save")
    with Session(folder) as again:
        fresh = Window(again)
        assert fresh.last("verdict") == verdict and scores(again) == scores(window.session)
        assert fresh.last("study")["parameters"] == window.last("study")["parameters"]
    shutil.rmtree(tmp_path / "elsewhere", ignore_errors=True)
    (tmp_path / "elsewhere").mkdir()
    end = repeated(folder, window.session, tmp_path / "elsewhere", monkeypatch)
    same(scores(window.session), end)


def test_a_diagnosis_is_saved_with_what_its_page_shows(window: Window, folder: Path) -> None:
    """With a ranking that was made by hand: the search is tested elsewhere."""
    session = window.session
    diagnosis = make_diagnosis("ambiguous", session.state.data)
    found = session.state.after(Step("diagnose", {}), diagnosis=lean(diagnosis))
    window.in_its_thread(lambda: session.back(found))
    session.tell_diagnosis()
    save(session)
    with Session(folder) as again:
        fresh = Window(again)
        assert fresh.last("verdict") == window.last("verdict") and fresh.last(
            "ranking"
        ) == window.last("ranking")


def test_an_older_result_is_not_left_behind(folder: Path, shared: Session) -> None:
    for error in (2.0, 3.0):
        fit = make_fit(make_data(), error)
        save_state(replace(shared.state, fit=fit), folder)
        (kept,) = folder.glob("workbench-*.npz")
        assert (
            pam.load(kept).as_dict()
            == fit.as_dict()
            == load_state(folder, shared.first).fit.as_dict()
        )


def test_a_model_that_was_written_is_a_step_of_its_own(window: Window) -> None:
    window.do(do="switch", effects=["LinearBladder"])
    window.do(do="add", file="Better.mo")
    window.do(do="undo")
    assert window.last("study")["with_effects"] == "with LinearBladder"
    assert window.last("study")["file"] is None
    window.do(do="undo")
    assert window.last("steps")["steps"] == []


def test_one_step_back_leaves_a_study_that_was_loaded(window: Window, folder: Path) -> None:
    window.do(do="set", values={"valve.C_A": 0.71})
    window.do(do="save")
    with Session(folder) as again:
        fresh, loaded = Window(again), again.state.steps
        fresh.do(do="set", values={"muscle.mu_fb": 0.02}, dragged=True)
        fresh.do(do="set", values={"muscle.mu_fb": 0.03}, dragged=True)
        assert len(again.state.steps) == 2  # of its own they are one
        fresh.do(do="undo")
        assert again.state.steps == loaded and again.state.values == {"valve.C_A": 0.71}


@pytest.mark.full
def test_a_saved_study_does_not_take_the_place_of_a_model_that_was_named(
    window: Window, folder: Path
) -> None:
    """It is said, and comes when it is asked for, with the data read for its own model."""
    window.do(do="switch", effects=["LinearBladder"])
    written = folder / window.do(do="add", file="Better.mo")["file"]
    window.do(do="switch", effects=[])
    window.do(do="set", values={"valve.C_A": 0.71})
    window.do(do="save")
    saved = window.session.state
    with Session(folder, model=str(written)) as named:
        fresh = Window(named)
        assert fresh.last("study")["short"] == "Better" and fresh.last("steps")["steps"] == []
        (said,) = fresh.of("failed")
        assert said["during"] == "load" and "is of Isotonic" in said["text"]
        assert "opened with Better" in said["text"]
        fresh.do(do="load")
        assert fresh.last("study")["short"] == "Isotonic" and named.state.values == saved.values
        assert named.state.data.model == saved.data.model != named.first.data.model
        same(scores(window.session), scores(named))
        first, *others = named.state.steps  # with it a script comes from the model that was named
        assert first.do == "choose" and tuple(others) == saved.steps
    with Session(folder, model="Isotonic") as likewise:
        assert likewise.state.steps == saved.steps
