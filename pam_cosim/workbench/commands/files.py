"""Adding effects as Modelica, saving and loading the study, and printing it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pam_cosim.errors import InputError
from pam_cosim.files import write_text
from pam_cosim.model.references import is_file
from pam_cosim.problems import corrections_of
from pam_cosim.study.fitted_model import FittedModel
from pam_cosim.wording import shown
from pam_cosim.workbench.commands.checks import names_of, text_of
from pam_cosim.workbench.commands.models import candidate_of, take_candidate
from pam_cosim.workbench.opened_model import without_ratios
from pam_cosim.workbench.paths import inside
from pam_cosim.workbench.protocol import AddedEvent, SavedEvent
from pam_cosim.workbench.saving import load_state, save_state
from pam_cosim.workbench.script import python_of
from pam_cosim.workbench.shell_script import commands_of
from pam_cosim.workbench.state import State
from pam_cosim.workbench.steps import ADD, CHOOSE, Step

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session


def add(
    session: Session,
    effects: Sequence[str] | None = None,
    file: str | None = None,
    learned: bool = False,
) -> dict[str, Any]:
    """Writes the model with effects and its values as Modelica into the study's folder; default: those that are on.

    Effects of the ranking are taken with the values that were fitted. ``learned``: the formula that the last diagnosis
    found is written instead.
    """
    session.work.make_room()
    if learned:
        return _add_learned(session, file)
    if effects is not None:
        _have(session, names_of(effects, "add"))
    state = session.state
    on = without_ratios(state.effects)
    if not state.effects:
        raise InputError("there is no effect to add: switch one on, or diagnose first")
    if not on:
        raise InputError(
            "what is stated of a parameter is no part of a model: correct it in the data set"
        )
    target = _target(session, file, default=session.catalogue.composed(state.model, on).name)
    corrections = corrections_of(state.data, state.values)
    constants = state.data.constants
    fitted = FittedModel(state.model, on, state.values, constants, corrections=corrections)
    parameters = session.opened.simulator.interface.parameters
    text = session.catalogue.written(fitted, target.stem, parameters)
    _write(target, text)
    step = Step(
        ADD, {"effects": list(on), "values": fitted.stated(parameters), "file": target.name}
    )
    session.back(state.after(step, file=target.name))
    session.remember(state)
    session.windows.tell(AddedEvent(target.name, text, on))
    return {"file": target.name, "text": text}


def _have(session: Session, effects: list[str]) -> None:
    """Makes the model with these effects, beside those that the diagnosed one had, the standing one.

    Raises:
        InputError: neither the standing model nor one of the ranking has them: they would be written with values that
            nobody has fitted or set.
    """
    state = session.state
    if set(effects) == set(state.effects):
        return
    candidate = candidate_of(session, effects)
    if candidate is None:
        raise InputError(
            f"no model with {', '.join(effects) or 'no effect'} stands or was fitted by the last diagnosis: "
            "switch the effects on, or diagnose first"
        )
    if (*state.diagnosed, *effects) != state.effects:
        take_candidate(session, candidate)


def _add_learned(session: Session, file: str | None) -> dict[str, Any]:
    diagnosis = session.state.diagnosis
    if diagnosis is None or diagnosis.learned is None:
        raise InputError("nothing was learned that could be written")
    term = diagnosis.learned.term
    target = _target(session, file, default=term.name)
    _write(target, term.modelica_source)
    session.windows.tell(AddedEvent(target.name, term.modelica_source, ()))
    return {"file": target.name, "text": term.modelica_source}


def _target(session: Session, file: str | None, default: str) -> Path:
    name = f"{default}.mo" if file is None else text_of(file, "add")
    if not name.endswith(".mo"):
        raise InputError(
            f"{shown(name)}: the model is written as Modelica: name a file that ends in .mo"
        )
    return inside(session.folder, name)


def _write(target: Path, text: str) -> None:
    if target.exists() and target.read_text(encoding="utf-8", errors="replace") != text:
        raise InputError(
            f"there is another file {target.name} in the folder already; name a new one"
        )
    write_text(target, text)


def save(session: Session) -> dict[str, Any]:
    """Writes what was done, and its results, into the study's folder."""
    session.work.check_free()
    saved = save_state(session.state, session.folder)
    session.saved = session.state.steps
    session.windows.tell(SavedEvent(saved.file, saved.time))
    session.tell_steps()
    return {"file": saved.file, "time": saved.time}


def load(session: Session) -> None:
    """Makes the saved study the standing one."""
    session.work.make_room()
    first = session.first
    state = _with_base(session, load_state(session.folder, first))
    if state.cuts or state.starts or state.model != first.model:
        known = {run.name: run.role for run in state.data.runs}
        model = first.data.unmapped if state.model == first.model else ""
        data = session.source.read(model or state.model, known, state.cuts, state.starts)
        state = replace(state, data=data)
    before = session.state
    session.back(state)
    session.remember(before)
    session.saved = state.steps
    session.tell_steps()
    session.work.tell_diagnosis()


def _with_base(session: Session, state: State) -> State:
    """A loaded study that can be repeated from the first state, also where it began with another model."""
    chosen = is_file(state.model) or any(step.do == CHOOSE for step in state.steps)
    if chosen or session.is_first(state.model):
        return state
    steps = (Step(CHOOSE, {"model": state.model}), *state.steps)
    return replace(state, steps=steps, loaded=len(steps))


def script(session: Session) -> dict[str, Any]:
    """The study as a Python script and as commands."""
    place = (session.state, session.first.model, session.folder, session.catalogue)
    return {"python": python_of(*place), "commands": commands_of(*place)}
