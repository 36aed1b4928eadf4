"""What takes long: fit, diagnose, check; stopped, resumed and given up."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from pam_cosim.diagnosis import Check, Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.fitting import METHODS, Fit
from pam_cosim.units import UnitError, seconds
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.commands.checks import names_of
from pam_cosim.workbench.commands.runs import release_estimated
from pam_cosim.workbench.protocol import CheckEvent
from pam_cosim.workbench.saving import lean
from pam_cosim.workbench.state import State, label_of
from pam_cosim.workbench.state_events import value_of
from pam_cosim.workbench.steps import DIAGNOSE, FIT, Step

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session


def fit(session: Session, method: str = "least-squares", free: Sequence[str] | None = None) -> None:
    """Fits parameters, all or those named, from where the sliders stand."""
    if method not in METHODS:
        raise InputError(
            f"there is no method {shown(method)} to fit with; {did_you_mean(str(method), METHODS)}"
        )
    known = session.opened.parameters
    chosen = list(known) if free is None else names_of(free, "fit")
    stray = next((name for name in chosen if name not in known), None)
    if stray is not None:
        raise InputError(
            f"there is no parameter {shown(stray)} to fit; {did_you_mean(stray, known)}"
        )
    if not chosen:
        raise InputError("nothing to fit: choose at least one parameter")
    session.work.make_room()
    release_estimated(session)
    start, begun = moved(session), dict(session.state.values)
    options = {"method": method, "free": chosen, "start": start}

    def finish(result: Fit) -> None:
        state = session.state
        # what was moved while it was stopped is no part of what it fitted
        kept = {} if state.values == begun else {"kept": begun}
        session.enter(
            state.after(
                Step(FIT, {**options, **kept}),
                values={**begun, **start, **result.values},
                fit=result,
                milestone=f"{label_of(state.effects)}, fitted",
            )
        )

    session.work.begin("fit", f"fitting {', '.join(chosen)}", options, finish)


def diagnose(
    session: Session,
    time_limit: float | str | None = None,
    exclude: Sequence[str] = (),
    expect: Sequence[str] = (),
) -> None:
    """Looks for the effect that the standing model lacks."""
    try:
        if time_limit is not None and (isinstance(time_limit, bool) or not seconds(time_limit) > 0):
            raise InputError(
                f"{shown(time_limit)} is no time limit: it must be longer than nothing"
            )
    except UnitError as problem:
        raise InputError(f"the time limit: {problem}") from None
    options: dict[str, Any] = {
        "time_limit": time_limit,
        "exclude": names_of(exclude, "exclude"),
        "expect": names_of(expect, "expect"),
    }
    if session.state.effects:
        options["free"] = list(session.opened.parameters)
    session.work.make_room()
    release_estimated(session)
    start = moved(session)
    if start:
        options["start"] = start

    def finish(result: Diagnosis) -> None:
        state = session.state
        session.back(
            state.after(Step(DIAGNOSE, options), diagnosis=lean(result), diagnosed=state.effects)
        )
        session.remember(state)
        session.work.tell_diagnosis()

    session.work.clear_diagnosis()
    session.work.begin("diagnose", "refitting the base model", options, finish)


def check(session: Session) -> None:
    """Says what the data can tell about the standing model before any fit."""

    def finish(result: Check) -> None:
        session.windows.tell(CheckEvent(str(result)))

    session.work.begin("check", "looking at what the data can tell", {}, finish)


def stop(session: Session) -> None:
    """Holds what is running where it is."""
    session.work.stop()


def resume(session: Session) -> None:
    """Lets what was stopped go on."""
    session.work.resume()


def discard(session: Session) -> None:
    """Ends what is running, or was stopped, for good."""
    session.work.discard()


def moved(session: Session) -> dict[str, float]:
    """Values [SI] of the parameters that do not stand where they begin, and start values that were set by hand."""
    state: State = session.state
    values = {f.name: (value_of(f, state), f.start) for f in session.opened.parameters.values()}
    moved = {name: value for name, (value, start) in values.items() if value != start}
    return moved | session.opened.start_values_in(state.values)
