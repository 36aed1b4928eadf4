"""The model: which one, with which effects."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from pam_cosim.diagnosis import Candidate
from pam_cosim.errors import InputError
from pam_cosim.workbench.commands.checks import names_of, text_of
from pam_cosim.workbench.state import label_of
from pam_cosim.workbench.steps import CHOOSE, SWITCH, TAKE, Step

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session


def switch(session: Session, effects: Sequence[str]) -> None:
    """Gives the model just these effects."""
    session.work.make_room()
    chosen, state = tuple(names_of(effects, "switch")), session.state
    if chosen == state.effects:
        return
    values = _kept(session, chosen)
    session.enter(
        state.after(
            Step(SWITCH, {"effects": list(chosen), "values": values}),
            effects=chosen,
            values=values,
            milestone="",
            fit=None,
            file=None,
            before=session.comparison if chosen else None,
        )
    )


def _kept(session: Session, effects: Sequence[str]) -> dict[str, float]:
    """The values that a model with these effects keeps: those of its base, and of effects that it had before."""
    origin = session.opened.origin
    starts = session.opened.start_values_in(
        session.state.values
    )  # another model may have other states
    kept = {name: value for name, value in session.state.values.items() if name not in starts}
    return {name: value for name, value in kept.items() if origin.get(name) in (None, *effects)}


def choose(session: Session, model: str) -> None:
    """Takes another base model, without effects; the data set is read for it."""
    session.work.make_room()
    name = text_of(model, "choose")
    if "/" in name or "\\" in name or name.startswith("."):
        raise InputError("choose wants the name of a bench or of a Modelica class")
    state = session.state
    known = {run.name: run.role for run in state.data.runs}
    data = session.source.read(name, known, state.cuts, state.starts)
    same = data.signals.keys() == state.data.signals.keys()
    session.enter(
        state.after(
            Step(CHOOSE, {"model": name}),
            data=data,
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
    session.work.tell_diagnosis()


def candidate_of(session: Session, effects: Sequence[str]) -> Candidate | None:
    """The model of the last ranking with just these effects."""
    diagnosis = session.state.diagnosis
    return (
        next((c for c in diagnosis.candidates if c.effects == tuple(effects)), None)
        if diagnosis
        else None
    )


def take(session: Session, candidate: Sequence[str] | int) -> None:
    """Makes a model of the ranking the standing one, at the values that were fitted: its effects, or its number."""
    session.work.make_room()
    diagnosis = session.state.diagnosis
    if diagnosis is None:
        raise InputError("there is no ranking to take a model from: diagnose first")
    if isinstance(candidate, int) and not isinstance(candidate, bool):
        chosen = (
            diagnosis.candidates[candidate] if 0 <= candidate < len(diagnosis.candidates) else None
        )
    else:
        chosen = candidate_of(session, names_of(candidate, "take"))
    if chosen is None:
        raise InputError("the ranking has no such model")
    take_candidate(session, chosen)


def take_candidate(session: Session, chosen: Candidate) -> None:
    """Makes a model of the ranking the standing one."""
    state = session.state
    effects = (*state.diagnosed, *chosen.effects)
    kept = _kept(session, ())
    step = Step(TAKE, {"effects": list(chosen.effects), "values": chosen.fit.values, "kept": kept})
    session.enter(
        state.after(
            step,
            effects=effects,
            values={**kept, **chosen.fit.values},
            fit=chosen.fit,
            file=None,
            milestone=f"{label_of(effects)}, fitted",
            before=session.comparison,
        )
    )


def undo(session: Session) -> None:
    """Takes the last step back."""
    session.work.make_room()
    if not session.past:
        raise InputError("there is no step to take back")
    session.back(session.past.pop())
    session.work.tell_diagnosis()


def where(session: Session, rule: int) -> dict[str, Any]:
    """Where a rule holds is told with the rules; this says that there is nothing more to ask for."""
    return {"rule": rule}
