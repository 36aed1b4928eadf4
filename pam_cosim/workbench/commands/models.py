"""The model: which one, with which effects."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.diagnosis import Candidate
from pam_cosim.errors import InputError
from pam_cosim.workbench.checks import is_number, names_of, text_of
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.source import OF_RUNS
from pam_cosim.workbench.state import label_of
from pam_cosim.workbench.steps import Step


def switch(study: StudyWithJobs, effects: Sequence[str]) -> None:
    """Gives the model just these effects."""
    study.make_room()
    chosen, state = tuple(names_of(effects, "switch")), study.state
    if chosen == state.effects:
        return
    values = _kept(study, chosen)
    study.enter(
        state.after(
            Step("switch", {"effects": list(chosen), "values": values}),
            effects=chosen,
            values=values,
            milestone="",
            fit=None,
            file=None,
            before=study.comparison if chosen else None,
        )
    )


def _kept(study: StudyWithJobs, effects: Sequence[str]) -> dict[str, float]:
    """The values that a model with these effects keeps: those of its base, and of effects that it had before."""
    values, origin = study.state.values, study.opened.origin
    starts = study.opened.start_values_in(values)  # another model may have other states
    return {
        name: value
        for name, value in values.items()
        if name not in starts and origin.get(name) in (None, *effects)
    }


def choose(study: StudyWithJobs, model: str) -> None:
    """Takes another base model, without effects; the data set is read for it."""
    study.make_room()
    name = text_of(model, "choose")
    if "/" in name or "\\" in name or name.startswith("."):
        raise InputError("choose wants the name of a bench or of a Modelica class")
    state = study.state
    chosen = {key: value for key, value in state.chosen.items() if key in OF_RUNS}
    data, known = study.source.read(name, chosen)
    same = data.signals.keys() == state.data.signals.keys()
    study.enter(
        state.after(
            Step("choose", {"model": name}),
            data=data,
            known=known,
            chosen=chosen,
            model=name,
            effects=(),
            values={},
            fit=None,
            file=None,
            before=None,
            diagnosis=None,
            diagnosed=(),
            milestone=f"{name}, as stated",
            rungs=state.rungs if same else (),
        )
    )
    study.tell_diagnosis()


def candidate_of(study: StudyWithJobs, effects: Sequence[str]) -> Candidate | None:
    """The model of the last ranking with just these effects."""
    diagnosis = study.state.diagnosis
    candidates = diagnosis.candidates if diagnosis else ()
    return next((c for c in candidates if c.effects == tuple(effects)), None)


def take(study: StudyWithJobs, candidate: Sequence[str] | int) -> None:
    """Makes a model of the ranking the standing one, at the values that were fitted: its effects, or its number."""
    study.make_room()
    diagnosis = study.state.diagnosis
    if diagnosis is None:
        raise InputError("there is no ranking to take a model from: diagnose first")
    if isinstance(candidate, int) and not isinstance(candidate, bool):
        chosen = dict(enumerate(diagnosis.candidates)).get(candidate)
    else:
        chosen = candidate_of(study, names_of(candidate, "take"))
    if chosen is None:
        raise InputError("the ranking has no such model")
    take_candidate(study, chosen)


def take_candidate(study: StudyWithJobs, chosen: Candidate) -> None:
    """Makes a model of the ranking the standing one."""
    state = study.state
    effects = (*state.diagnosed, *chosen.effects)
    kept, fitted = _kept(study, ()), chosen.fit.values
    study.enter(
        state.after(
            Step("take", {"effects": list(chosen.effects), "values": fitted, "kept": kept}),
            effects=effects,
            values={**kept, **fitted},
            fit=chosen.fit,
            file=None,
            milestone=f"{label_of(effects)}, fitted",
            before=study.comparison,
        )
    )
    study.draw_beside("found", None)


def undo(study: StudyWithJobs, count: int = 1) -> None:
    """Takes the last steps back."""
    study.make_room()
    if not is_number(count) or not 0 < count <= len(study.past):
        raise InputError("there is no step to take back")
    study.back(study.past[-int(count)])
    del study.past[-int(count) :]
    study.tell_diagnosis()
