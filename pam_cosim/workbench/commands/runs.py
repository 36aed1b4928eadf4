"""Runs: whether they are fitted, from when to when they go, and how they begin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.run_names import stated_of
from pam_cosim.wording import shown
from pam_cosim.workbench.checks import is_number, one_of, text_of
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.state import Ends
from pam_cosim.workbench.steps import Step


def roles(study: StudyWithJobs, roles: Mapping[str, str]) -> None:
    """Sets whether runs are fitted or held out."""
    study.make_room()
    if not isinstance(roles, Mapping):
        raise InputError("roles wants fit or holdout by run")
    data = study.state.data.with_roles(roles)
    stated = {run.name: run.role for run in data.runs if stated_of(run.name, roles) is not None}
    step = Step("roles", {"roles": stated})
    study.enter(study.state.after(step, data=data, rungs=(), before=None))


def cut(
    study: StudyWithJobs, run: str, begin: float | None = None, end: float | None = None
) -> None:
    """Keeps of a run what lies between two times [s]; None: its beginning, or its end, as it was recorded.

    Where it begins elsewhere than before, its start is chosen anew.
    """
    study.make_room()
    state, old = study.state, _run(study.state.data, run)
    cuts = {**state.cuts, old.name: (_time(begin, "begin"), _time(end, "end"))}
    starts = dict(state.starts)
    data = study.source.read_again(state.data, cuts, starts)
    moved = _run(data, run).time[0] != old.time[0]
    if moved and starts.pop(old.name, None) is not None:
        data = study.source.read_again(state.data, cuts, starts)
        moved = _run(data, run).time[0] != old.time[0]
    values = _without_start(study, old.name) if moved else dict(state.values)
    plain = {name: list(both) for name, both in cuts.items()}
    step = Step("cut", {"run": old.name, "cuts": plain, "starts": starts, "values": values})
    _enter(study, step, data, cuts)


def begin(study: StudyWithJobs, run: str, mode: str | None = None) -> None:
    """Sets how a run begins; None: as the data set says, or its first samples. Start values that were set by hand are
    given up."""
    study.make_room()
    state, chosen = study.state, _run(study.state.data, run)
    if chosen.is_static:
        raise InputError(f"{chosen.name} holds points at rest, which have no start")
    starts = {name: one for name, one in state.starts.items() if name != chosen.name}
    if mode is not None:
        starts[chosen.name] = text_of(mode, "begin")
    data, values = (
        study.source.read_again(state.data, state.cuts, starts),
        _without_start(study, chosen.name),
    )
    step = Step("begin", {"run": chosen.name, "starts": starts, "values": values})
    _enter(study, step, data, state.cuts)


def _enter(study: StudyWithJobs, step: Step, data: DataSet, cuts: Mapping[str, Ends]) -> None:
    changes: dict[str, Any] = {name: step.arguments[name] for name in ("starts", "values")}
    study.enter(study.state.after(step, data=data, cuts=cuts, rungs=(), before=None, **changes))


def release_estimated(study: StudyWithJobs) -> None:
    """Gives up start values that were set by hand where a fit estimates them, a step for each run."""
    for run in study.state.data.runs:
        if run.start.mode == "estimated" and len(_without_start(study, run.name)) < len(
            study.state.values
        ):
            begin(study, run.name, "estimated")


def _without_start(study: StudyWithJobs, run: str) -> dict[str, float]:
    """The values of the study [SI] but for where a run begins."""
    starts = study.opened.start_values_in(study.state.values)
    return {
        name: value
        for name, value in study.state.values.items()
        if name not in starts or not name.endswith(f"@{run}")
    }


def _run(data: DataSet, name: Any) -> Run:
    runs = {run.name: run for run in data.runs}
    return runs[one_of(name, runs, "run")]


def _time(value: Any, which: str) -> float | None:
    if value is None:
        return None
    if not is_number(value) or not np.isfinite(value):
        raise InputError(f"{which} wants a time in seconds, not {shown(value)}")
    return float(value)
