"""What is chosen in place of what the data set states: of runs, signals and parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isfinite
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.run_names import stated_of
from pam_cosim.units import UnitError, format_quantity, parse_quantity, readable_factor
from pam_cosim.wording import listed, shown
from pam_cosim.workbench.checks import is_number, names_of, one_of, text_of
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.state_events import value_of
from pam_cosim.workbench.steps import Step


def roles(study: StudyWithJobs, roles: Mapping[str, str]) -> None:
    """Sets whether runs are fitted or held out."""
    study.make_room()
    if not isinstance(roles, Mapping):
        raise InputError("roles must map runs to fit or holdout")
    data = study.state.data.with_roles(roles)
    roles_of_runs = {run.name: run.role for run in data.runs}
    text = listed(
        f"{run} {role}" for run, role in roles_of_runs.items() if stated_of(run, roles) is not None
    )
    _choose(study, "roles", f"roles: {text}", {"roles": roles_of_runs})


def cut(
    study: StudyWithJobs,
    run: str,
    begin: str | float | None = None,
    end: str | float | None = None,
) -> None:
    """Keeps of a run what lies between two times, in seconds or with a unit; None: its beginning, or its end, as it was
    recorded.

    Where it begins elsewhere than before, its start is chosen again.
    """
    study.make_room()
    old, chosen = _run(study.state.data, run), study.state.chosen
    recorded = _run(study.source.whole(study.state.data), run).time
    first, last = _time("begin", begin), _time("end", end)
    first = None if first is not None and first <= recorded[0] else first
    last = None if last is not None and last >= recorded[-1] else last
    cuts = {**chosen.get("cuts", {}), old.name: [first, last]}
    starts = dict(chosen.get("starts", {}))
    data, _ = study.source.read(study.bench, chosen | {"cuts": cuts})
    begins_elsewhere = _run(data, run).time[0] != old.time[0]
    if begins_elsewhere:
        starts.pop(old.name, None)
    ends = ["its beginning" if first is None else f"{first:.13g} s"]
    ends.append("its end" if last is None else f"{last:.13g} s")
    text = f"cut {old.name}: {'all of it' if first is last is None else ' to '.join(ends)}"
    values = _without_start(study, old.name) if begins_elsewhere else dict(study.state.values)
    _choose(study, "cut", text, {"cuts": cuts, "starts": starts}, values)


def begin(study: StudyWithJobs, run: str, mode: str | None = None) -> None:
    """Sets how a run begins; None: as the data set states, or its first samples. Start values that were set by hand are
    given up."""
    study.make_room()
    chosen = _run(study.state.data, run)
    if chosen.is_static:
        raise InputError(f"{chosen.name} holds points at rest, which have no start")
    starts = {n: s for n, s in study.state.chosen.get("starts", {}).items() if n != chosen.name}
    if mode is not None:
        starts[chosen.name] = text_of(mode, "begin")
    text = f"begin {chosen.name}: {mode or 'as the data set states'}"
    _choose(study, "begin", text, {"starts": starts}, _without_start(study, chosen.name))


def signal(
    study: StudyWithJobs, name: str, fitted: bool = True, sigma: str | float | None = None
) -> None:
    """Fits a signal, or only compares it; ``sigma``: its noise, with a unit or in the shown one; None: as it is."""
    study.make_room()
    data = study.state.data
    one_of(name, data.signals, "signal")
    signals = dict(study.state.chosen.get("signals") or dict.fromkeys(data.fitted_signals))
    text = f"{name} is compared"
    if not fitted:
        signals.pop(name, None)
    elif sigma is None:
        signals.setdefault(name, None)
        text = f"{name} is fitted"
    else:
        signals[name] = level = in_si(name, sigma, data.signals[name].unit, difference=True)
        if not level > 0:
            raise InputError(f"the noise of {name} must be larger than zero")
        text = f"{name} is fitted, sigma {sigma}"
    _choose(study, "signal", text, {"signals": signals})


def free(study: StudyWithJobs, names: Sequence[str]) -> None:
    """Leaves just these parameters of the base model free for a fit; the others keep the values that they have."""
    study.make_room()
    state, chosen = study.state, study.state.chosen
    free_names = names_of(names, "free")
    before = {n: f for n, f in study.opened.parameters.items() if n not in study.opened.origin}
    stated = dict(chosen.get("values", {}))
    held = {n: value_of(f, state) for n, f in before.items() if n not in free_names}
    released = {n: v for n, v in stated.items() if n in free_names}
    stated = {n: v for n, v in (stated | held).items() if n not in free_names}
    values = {n: v for n, v in state.values.items() if n not in stated} | released
    _choose(
        study, "free", f"free: {listed(free_names)}", {"free": free_names, "values": stated}, values
    )


def state_values(study: StudyWithJobs, values: Mapping[str, float | None]) -> None:
    """States values of parameters that are not free [SI]; None: as the data set states."""
    stated = {**study.state.chosen.get("values", {}), **values}
    settable = study.opened.simulator.interface.settable
    text = ", ".join(
        f"{name} as the data set states"
        if value is None
        else f"{name} = {format_quantity(value, settable[name.partition('@')[0]].unit, 5)}"
        for name, value in values.items()
    )
    values_by_name = {name: value for name, value in stated.items() if value is not None}
    _choose(study, "state", f"state {text}", {"values": values_by_name})


def in_si(name: str, value: Any, unit: str, *, difference: bool = False) -> float:
    """A number in the shown unit, or a text with a unit, in the SI unit.

    Raises:
        InputError: it is neither.
    """
    if isinstance(value, str):
        try:
            return parse_quantity(value, unit, difference=difference)
        except UnitError as problem:
            raise InputError(f"{name}: {problem}") from None
    if not is_number(value):
        raise InputError(f"{shown(f'{name}={value}')}: the value must be a number")
    try:
        return float(value) / readable_factor(unit)
    except OverflowError:
        return float("inf")


def _choose(
    study: StudyWithJobs,
    do: str,
    text: str,
    more: Mapping[str, Any],
    values: Mapping[str, float] | None = None,
) -> None:
    """Reads the data set again with more choices; the ladder restarts where its samples would differ."""
    state = study.state
    chosen, values_after = (
        {**state.chosen, **more},
        dict(state.values if values is None else values),
    )
    if chosen == state.chosen and values_after == state.values:
        return
    data, model_values = study.source.read(study.bench, chosen)
    step = Step(do, {"text": text, "chosen": chosen, "values": values_after})
    rungs = state.rungs if do in ("free", "state") else ()
    changes: dict[str, Any] = {
        "data": data,
        "known": model_values,
        "chosen": chosen,
        "values": values_after,
    }
    study.enter(state.after(step, rungs=rungs, before=None, milestone="", **changes))


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


def _time(name: str, value: Any) -> float | None:
    """A time [s] of seconds, or of a text with a unit; None: none."""
    time = None if value is None else in_si(name, value, "s")
    if time is not None and not isfinite(time):
        raise InputError(f"{name} must be a time in seconds, not {shown(value)}")
    return time
