"""What takes long: fit, diagnose, check."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from pam_cosim.diagnosis import Check, Diagnosis
from pam_cosim.errors import InputError
from pam_cosim.fitting import METHODS, Fit
from pam_cosim.units import UnitError, seconds
from pam_cosim.wording import shown
from pam_cosim.workbench.checks import names_of, one_of
from pam_cosim.workbench.commands.choices import release_estimated
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.protocol import event
from pam_cosim.workbench.saved import lean
from pam_cosim.workbench.state import label_of
from pam_cosim.workbench.state_events import value_of
from pam_cosim.workbench.steps import Step


def fit(
    study: StudyWithJobs, method: str = "least-squares", free: Sequence[str] | None = None
) -> None:
    """Fits parameters, all or those named, from where the sliders stand."""
    one_of(method, METHODS, "method", " to fit with")
    parameters = study.opened.parameters
    chosen = list(parameters) if free is None else names_of(free, "fit")
    for name in chosen:
        one_of(name, parameters, "parameter", " to fit")
    if not chosen:
        raise InputError("nothing to fit: choose at least one parameter")
    start = _prepared(study)
    options: dict[str, Any] = {"method": method, "free": chosen, "start": start}
    begun = dict(study.state.values)

    def finish(result: Fit) -> None:
        state = study.state
        # what was moved while it was stopped is no part of what it fitted
        moved_values = {} if state.values == begun else {"kept": begun}
        study.enter(
            state.after(
                Step("fit", options | moved_values),
                values={**begun, **start, **result.values},
                fit=result,
                milestone=f"{label_of(state.effects)}, fitted",
            )
        )

    study.begin_job("fit", f"fitting {', '.join(chosen)}", options, finish)


def diagnose(
    study: StudyWithJobs,
    time_limit: float | str | None = None,
    exclude: Sequence[str] = (),
    expect: Sequence[str] = (),
) -> None:
    """Looks for the effect that the standing model lacks."""
    try:
        if time_limit is not None and (isinstance(time_limit, bool) or not seconds(time_limit) > 0):
            raise InputError(f"{shown(time_limit)} is no time limit: the limit must be above 0 s")
    except UnitError as problem:
        raise InputError(f"the time limit: {problem}") from None
    options: dict[str, Any] = {
        "time_limit": time_limit,
        "exclude": names_of(exclude, "exclude"),
        "expect": names_of(expect, "expect"),
    }
    if study.state.effects:
        options["free"] = list(study.opened.parameters)
    start = _prepared(study)
    if start:
        options["start"] = start

    def finish(result: Diagnosis) -> None:
        state = study.state
        step = Step("diagnose", options)
        study.back(state.after(step, diagnosis=lean(result), diagnosed=state.effects))
        study.remember(state)
        study.tell_diagnosis()

    study.clear_diagnosis()
    study.begin_job("diagnose", "refitting the base model", options, finish)


def check(study: StudyWithJobs) -> None:
    """Computes what the data can determine about the standing model before any fit."""

    def finish(result: Check) -> None:
        study.windows.tell(event("checked", text=str(result)))

    study.begin_job("check", "checking what the data can determine", {}, finish)


def _prepared(study: StudyWithJobs) -> dict[str, float]:
    """The start of a fit: values [SI] of the parameters that do not stand where they begin, and start values that were
    set by hand; a job before it is given up."""
    study.make_room()
    release_estimated(study)
    state = study.state
    values = {
        free.name: value_of(free, state)
        for free in study.opened.parameters.values()
        if value_of(free, state) != free.start
    }
    return values | study.opened.start_values_in(state.values)
