"""A study that somebody else saved is data: no name, value or key in it becomes code in what is printed from it."""

from __future__ import annotations

import ast
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pam_cosim.errors import InputError
from pam_cosim.workbench import Session
from pam_cosim.workbench.protocol import text_of_message
from pam_cosim.workbench.saved import FILE, load_state, save_state
from pam_cosim.workbench.script import python_of
from pam_cosim.workbench.state import State
from pam_cosim.workbench.state_events import steps_event
from pam_cosim.workbench.steps import Step
from rig.named import effect_of
from rig.short import write_light_data

CORPUS = json.loads((Path(__file__).parent / "corpora" / "saved_studies.json").read_text())
CALLED = {"read", "compare", "fit", "diagnose", "add", "problem"}  # of pam_cosim


@pytest.fixture(scope="module")
def study(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Session]:
    folder = write_light_data(
        tmp_path_factory.mktemp("rig") / "my-rig", [effect_of("elasticity:linear")], 1
    )
    with Session(folder) as session:
        yield session


def written(study: Session, folder: Path, **changes: Any) -> Path:
    """A saved study in a folder of its own, with something in it changed."""
    folder.mkdir(exist_ok=True)
    save_state(study.first, folder)
    content = json.loads((folder / FILE).read_text())
    (folder / FILE).write_text(json.dumps(content | changes))
    return folder


@pytest.mark.parametrize("step", CORPUS["refused"], ids=lambda step: json.dumps(step)[:60])
def test_a_step_that_no_study_has_is_refused_with_its_place(
    study: Session, tmp_path: Path, step: Any
) -> None:
    good = {"do": "set", "values": {"valve.C_A": 0.7}}
    with pytest.raises(InputError, match=r"damaged: steps\.2") as caught:
        load_state(written(study, tmp_path / "s", steps=[good, step]), study.first)
    assert caught.value.message.isprintable() and len(caught.value.message) < 600


@pytest.mark.parametrize("table", CORPUS["tables"])
def test_what_stands_beside_the_steps_is_checked(
    study: Session, tmp_path: Path, table: str
) -> None:
    for value in CORPUS["tables"][table]:
        with pytest.raises(InputError) as caught:
            load_state(written(study, tmp_path / "s", **{table: value}), study.first)
        assert caught.value.file is not None, value
    content = json.loads((written(study, tmp_path / "s") / FILE).read_text())
    content.pop(table, None)
    (tmp_path / "s" / FILE).write_text(json.dumps(content))
    if table != "unknown":
        with pytest.raises(InputError):
            load_state(tmp_path / "s", study.first)


def only_calls_of_the_library(script: str) -> None:
    """A script that does what a study can do, whatever its texts are."""
    for node in ast.walk(ast.parse(script)):
        assert not isinstance(node, (ast.Lambda, ast.FunctionDef, ast.ImportFrom, ast.JoinedStr)), (
            ast.unparse(node)
        )
        if isinstance(node, ast.Import):
            assert ast.unparse(node) == "import pam_cosim as pam"
        if isinstance(node, ast.Call):
            called = ast.unparse(node.func)
            of_library = {f"pam.{name}" for name in CALLED}
            assert called in {"print", "next", "data.with_signals", *of_library}, called
        if isinstance(node, ast.Attribute) and not is_data_of_problem(node):
            assert ast.unparse(node) in {
                *(f"pam.{name}" for name in CALLED), "fit.values", "candidate.fit", "candidate.fit.values",
                "diagnosis.candidates", "c.effects", "data.with_signals",
            }  # fmt: skip


def is_data_of_problem(node: ast.Attribute) -> bool:
    call = node.value
    return (
        node.attr == "data"
        and isinstance(call, ast.Call)
        and ast.unparse(call.func) == "pam.problem"
    )


def test_a_run_that_the_data_set_lacks_is_refused_when_it_is_read(study: Session) -> None:
    for chosen in ({"roles": {"another": "fit"}}, {"cuts": {"another": (1.0, None)}}):
        with pytest.raises(InputError, match="another"):
            study.source.read(None, chosen)


def printed(study: Session, state: State) -> None:
    folder = Path("/data/a b; touch MADE'")
    only_calls_of_the_library(python_of(state, study.first.model, folder, study.catalogue))


@pytest.mark.parametrize("step", CORPUS["taken"], ids=lambda step: json.dumps(step)[:60])
def test_what_loads_is_printed_as_text(
    study: Session, tmp_path: Path, step: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    composed = type("Composition", (), {"name": "'x; touch MADE'"})()
    monkeypatch.setattr(
        study.catalogue, "composed", lambda *_: composed
    )  # there are no effects of these names
    state = load_state(written(study, tmp_path / "s", steps=[step]), study.first)
    printed(study, state)
    message = json.loads(text_of_message(steps_event(state, True)))
    assert all(line["text"].isprintable() for line in message["steps"])


def test_what_was_never_checked_is_printed_as_text_too(
    study: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The printer trusts nothing: the steps that are refused are given to it past the check."""
    composed = type("Composition", (), {"name": "'x; touch MADE'"})()
    monkeypatch.setattr(study.catalogue, "composed", lambda *_: composed)
    tried = 0
    for step in CORPUS["refused"]:
        if not isinstance(step, dict) or not isinstance(step.get("do"), str):
            continue
        state = replace(
            study.first, steps=(Step(step["do"], {k: v for k, v in step.items() if k != "do"}),)
        )
        try:
            printed(study, state)
        except (KeyError, TypeError, ValueError, AttributeError):
            continue  # what has no form is not printed at all
        tried += 1
    assert tried > 15
