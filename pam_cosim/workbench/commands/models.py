"""The model: which one, with which effects."""

from __future__ import annotations

from collections.abc import Sequence

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
        raise InputError("choose needs the name of a bench or of a Modelica class")
    state = study.state
    chosen = {key: value for key, value in state.chosen.items() if key in OF_RUNS}
    data, values = study.source.read(name, chosen)
    same_signals = data.signals.keys() == state.data.signals.keys()
    study.enter(
        state.after(
            Step("choose", {"model": name}),
            data=data,
            known=values,
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
            rungs=state.rungs if same_signals else (),
        )
    )
    study.tell_diagnosis()


def take(study: StudyWithJobs, candidate: Sequence[str]) -> None:
    """Makes a model of the ranking, named by its effects, the standing one, at the values that were fitted."""
    study.make_room()
    state, effect_names = study.state, tuple(names_of(candidate, "take"))
    candidates = state.diagnosis.candidates if state.diagnosis else ()
    chosen = next((c for c in candidates if c.effects == effect_names), None)
    if chosen is None:
        raise InputError("the ranking of the last diagnosis has no such model")
    effects = (*state.diagnosed, *chosen.effects)
    values_without_effects, fitted = _kept(study, ()), chosen.fit.values
    study.enter(
        state.after(
            Step(
                "take",
                {"effects": list(chosen.effects), "values": fitted, "kept": values_without_effects},
            ),
            effects=effects,
            values={**values_without_effects, **fitted},
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
        raise InputError("there is no step to undo")
    study.back(study.past[-int(count)])
    del study.past[-int(count) :]
    study.tell_diagnosis()
