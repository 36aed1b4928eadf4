"""Runs: whether they are fitted, from when to when they go, and how they begin."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.run_names import stated_of
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.commands.checks import text_of
from pam_cosim.workbench.state import Ends
from pam_cosim.workbench.steps import BEGIN, CUT, ROLES_STEP, Step

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session


def roles(session: Session, roles: Mapping[str, str]) -> None:
    """Says of runs whether they are fitted or held out."""
    session.work.make_room()
    if not isinstance(roles, Mapping):
        raise InputError("roles wants fit or holdout by run")
    data = session.state.data.with_roles(roles)
    stated = {run.name: run.role for run in data.runs if stated_of(run.name, roles) is not None}
    step = Step(ROLES_STEP, {"roles": stated})
    session.enter(session.state.after(step, data=data, rungs=(), before=None))


def cut(session: Session, run: str, begin: float | None = None, end: float | None = None) -> None:
    """Keeps of a run what lies between two times [s]; None: its beginning, or its end, as it was recorded.

    Where it begins elsewhere than before, its start is chosen anew.
    """
    session.work.make_room()
    state, old = session.state, _run(session.state.data, run)
    ends: Ends = (_time(begin, "begin"), _time(end, "end"))
    cuts = {**state.cuts, old.name: ends}
    starts = dict(state.starts)
    data = _read(session, cuts, starts)
    if _run(data, run).time[0] != old.time[0] and starts.pop(old.name, None) is not None:
        data = _read(session, cuts, starts)
    moved = _run(data, run).time[0] != old.time[0]
    values = without_start(session, old.name) if moved else dict(state.values)
    plain = {name: list(both) for name, both in cuts.items()}
    step = Step(CUT, {"run": old.name, "cuts": plain, "starts": starts, "values": values})
    changes: dict[str, Any] = {"data": data, "cuts": cuts, "starts": starts, "values": values}
    session.enter(state.after(step, **changes, rungs=(), before=None))


def begin(session: Session, run: str, mode: str | None = None) -> None:
    """Says how a run begins; None: as the data set says, or its first samples. What was set by hand counts no more."""
    session.work.make_room()
    state, chosen = session.state, _run(session.state.data, run)
    if chosen.is_static:
        raise InputError(f"{chosen.name} holds points at rest, which have no start")
    starts = {name: one for name, one in state.starts.items() if name != chosen.name}
    if mode is not None:
        starts[chosen.name] = text_of(mode, "begin")
    data, values = _read(session, state.cuts, starts), without_start(session, chosen.name)
    step = Step(BEGIN, {"run": chosen.name, "starts": starts, "values": values})
    changes: dict[str, Any] = {"data": data, "starts": starts, "values": values}
    session.enter(state.after(step, **changes, rungs=(), before=None))


def release_estimated(session: Session) -> None:
    """Gives up start values that were set by hand where a fit estimates them, a step for each run."""
    by_hand = {
        name.rpartition("@")[2] for name in session.opened.start_values_in(session.state.values)
    }
    for run in session.state.data.runs:
        if run.name in by_hand and run.start.mode == "estimated":
            begin(session, run.name, "estimated")


def without_start(session: Session, run: str) -> dict[str, float]:
    """The values of the study [SI] but for where a run begins."""
    gone = {
        name
        for name in session.opened.start_values_in(session.state.values)
        if name.endswith(f"@{run}")
    }
    return {name: value for name, value in session.state.values.items() if name not in gone}


def _read(session: Session, cuts: Mapping[str, Ends], starts: Mapping[str, str]) -> DataSet:
    """The measurement with these cuts and starts."""
    data = session.state.data
    return session.source.read(
        data.unmapped or data.model, {run.name: run.role for run in data.runs}, cuts, starts
    )


def _run(data: DataSet, name: Any) -> Run:
    known = {run.name: run for run in data.runs}
    if not isinstance(name, str) or name not in known:
        raise InputError(f"there is no run {shown(name)}; {did_you_mean(str(name), known)}")
    return known[name]


def _time(value: Any, which: str) -> float | None:
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not np.isfinite(value):
        raise InputError(f"{which} wants a time in seconds, not {shown(value)}")
    return float(value)
