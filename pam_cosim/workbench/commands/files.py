"""Adding effects as Modelica, saving and loading the study, and printing it."""

from __future__ import annotations

from dataclasses import replace

from pam_cosim.catalogue import qualified
from pam_cosim.errors import InputError
from pam_cosim.files import identity, write_text
from pam_cosim.model.references import is_file
from pam_cosim.problems import corrections_of
from pam_cosim.study.fitted_model import FittedModel
from pam_cosim.wording import shown
from pam_cosim.workbench.checks import text_of
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.opened_model import without_ratios
from pam_cosim.workbench.paths import inside
from pam_cosim.workbench.protocol import Json, event
from pam_cosim.workbench.saved import FILE, load_state, save_state
from pam_cosim.workbench.script import python_of
from pam_cosim.workbench.state_events import short_name
from pam_cosim.workbench.steps import Step


def add(
    study: StudyWithJobs,
    file: str | None = None,
    learned: bool = False,
) -> Json:
    """Writes the model with its effects and values as Modelica into the study's folder.

    ``learned``: the formula that the last diagnosis found is written instead.
    """
    study.make_room()
    if learned:
        diagnosis = study.state.diagnosis
        if diagnosis is None or diagnosis.learned is None:
            raise InputError("there is no learned term to write")
        term = diagnosis.learned.term
        return _written(study, _target(study, file, term.name), term.modelica_source)
    state = study.state
    on = without_ratios(state.effects)
    if not state.effects:
        raise InputError("there is no effect to add: switch one on, or diagnose first")
    if not on:
        raise InputError(
            "a correction of a stated value is no part of a model: correct the value in the data set"
        )
    name = _target(study, file, study.catalogue.composed(state.model, on).name)
    corrections = corrections_of(state.data, state.values)
    constants = state.data.constants
    fitted = FittedModel(state.model, on, state.values, constants, corrections=corrections)
    parameters = study.opened.simulator.interface.parameters
    text = study.catalogue.written(fitted, name.removesuffix(".mo"), parameters)
    added = _written(study, name, text)
    step = Step("add", {"effects": list(on), "values": fitted.stated(parameters), "file": name})
    study.back(state.after(step, file=name))
    study.remember(state)
    return added


def _target(study: StudyWithJobs, file: str | None, default: str) -> str:
    """The name of the Modelica file."""
    name = f"{default}.mo" if file is None else text_of(file, "add")
    if not name.endswith(".mo"):
        raise InputError(
            f"{shown(name)}: the model is written as Modelica: name a file that ends in .mo"
        )
    return inside(study.folder, name).name


def _written(study: StudyWithJobs, name: str, text: str) -> Json:
    target = inside(study.folder, name)
    if target.exists() and target.read_text(encoding="utf-8", errors="replace") != text:
        raise InputError(f"there is another file {name} in the folder already; name a new one")
    write_text(target, text)
    added = {"file": name, "text": text}
    study.windows.tell(event("added", **added))
    return added


def save(study: StudyWithJobs) -> Json:
    """Writes what was done, and its results, into the study's folder."""
    study.check_free()
    file = study.folder / FILE
    if identity(file) != study.saved_file:
        raise InputError(
            "another workbench has saved this study since it was opened: load that study by 'Load what was saved' "
            "under Study, or move the file away to save this one",
            file,
        )
    saved = {"file": save_state(study.state, study.folder)}
    study.saved, study.saved_file = study.state.steps, identity(file)
    study.windows.tell(event("saved", **saved))
    study.tell_steps()
    return saved


def load(study: StudyWithJobs) -> None:
    """Makes the saved study the standing one."""
    study.make_room()
    saved_file = identity(study.folder / FILE)
    first, state = study.first, load_state(study.folder, study.first)
    chosen = is_file(state.model) or any(step.do == "choose" for step in state.steps)
    if not chosen and not _is_first(study, state.model):
        # it can be repeated from the first state, though it began with another model
        steps = (Step("choose", {"model": state.model}), *state.steps)
        state = replace(state, steps=steps, loaded=len(steps))
    if state.chosen or state.model != first.model:
        model = first.data.unmapped if state.model == first.model else ""
        data, values = study.source.read(model or state.model, state.chosen)
        state = replace(state, data=data, known=values)
    before = study.state
    study.back(state)
    study.remember(before)
    study.saved, study.saved_file = state.steps, saved_file
    study.tell_steps()
    study.tell_diagnosis()


def load_at_first(study: StudyWithJobs, model_is_stated: bool) -> None:
    """Loads the saved study, if there is one; with ``model_is_stated`` only one of the stated model.

    Raises:
        InputError: the saved study is damaged, or of another model.
        SimulationFailure: it cannot be simulated.
    """
    study.saved_file = identity(study.folder / FILE)
    if not (study.folder / FILE).is_file():
        return
    model = load_state(study.folder, study.first).model if model_is_stated else ""
    if model and not _is_first(study, model):
        raise InputError(
            f"the saved study is of {short_name(model)}, and was not loaded: this one was opened with "
            f"{short_name(study.first.model)}; to continue the saved study, press 'Load what was saved' under Study"
        )
    load(study)


def _is_first(study: StudyWithJobs, model: str) -> bool:
    """Whether it is the model with which the study was opened, however it is written."""
    first = study.first
    tree = study.catalogue.tree(first.model)
    first_model = first.data.unmapped or first.model
    return model == first.model or qualified(tree, model) == qualified(tree, first_model)


def script(study: StudyWithJobs) -> Json:
    """The study as a Python script."""
    return {"python": python_of(study.state, study.first.model, study.folder, study.catalogue)}
