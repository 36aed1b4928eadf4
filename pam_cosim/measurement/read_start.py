"""What ``experiment.toml`` states of how a run begins."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.experiment_tables import RunTable
from pam_cosim.measurement.parameters import known_values
from pam_cosim.measurement.place import Stated
from pam_cosim.measurement.start import Start, StartMode
from pam_cosim.model.interface import Interface
from pam_cosim.wording import listed, shown

_FOR = "for"
_KEYS = ("start", "before", "lead", "periodic")


def with_start(
    table: RunTable,
    interface: Interface,
    run: Run,
    mode: StartMode | None = None,
    *,
    anew: bool = False,
) -> Run:
    """The run with what is stated of its start, by itself or for all.

    Args:
        table: what is stated.
        interface: of the bench.
        run: the run.
        mode: how it begins, instead of what is stated of that and of the time before; a lead stays.
        anew: it begins elsewhere than what is stated is about, which then counts no more.

    Raises:
        InputError: what contradicts itself, an unknown input, a duration that is none.
    """
    if run.is_static:
        for key in filter(table.states, _KEYS):
            raise table.error(
                f"{key} is for recordings over time; points at rest have no start", key
            )
        return run
    if mode is not None or anew:
        start = Start(mode=mode)
        return replace(run, start=start) if anew else _with_lead(table, run, start)
    start = Start(mode=table.start, periodic=bool(table.periodic))
    if start.periodic:
        _check_periodic(table)
    elif table.before is not None:
        start = _with_before(table, interface, start, table.before)
    return _with_lead(table, run, start)


def _check_periodic(table: RunTable) -> None:
    """A periodic run begins where its period ends; what is stated of all runs gives way to what is stated of one."""
    for key in ("start", "before"):
        shared_counts = getattr(table, key) is not None and not table.states("periodic")
        if table.states(key) or shared_counts:
            message = f"both {key} and periodic = true state where the run begins; keep one of them"
            raise table.error(message, key)


def _with_before(
    table: RunTable, interface: Interface, start: Start, before: Mapping[str, Stated]
) -> Start:
    if start.mode in ("measured", "estimated"):
        message = (
            f"{shown(start.mode)} begins at the first samples, but before describes earlier times"
        )
        raise table.error(f'{message}; state "rest" or "steady", as it was then', "before")
    if _FOR not in before:
        raise table.error('for is missing: state how long, before = { ..., for = "5 s" }', "before")
    inputs = {name: value for name, value in before.items() if name != _FOR}
    for name in inputs:
        if name not in interface.inputs:
            raise table.error(
                f"{shown(name)} is no input of {interface.model}; its inputs: {listed(interface.inputs)}",
                "before",
            )
    seconds = before[_FOR].above_zero("s")
    held = known_values(interface, inputs)
    return replace(start, mode=start.mode or "rest", before=held, seconds=seconds)


def _with_lead(table: RunTable, run: Run, start: Start) -> Run:
    """The run with its start, whose first samples are set aside where a lead is stated."""
    if table.lead is None:
        return replace(run, start=start)
    seconds = table.lead.above_zero("s")
    early = run.time < run.time[0] + seconds
    if early.all():
        raise table.error(
            f"{run.name} is not longer than its lead: no sample would be scored", "lead"
        )
    leading = {name: (run.time[early], values[early]) for name, values in run.measurements.items()}
    scored = {name: np.where(early, np.nan, values) for name, values in run.measurements.items()}
    start = replace(start, lead=seconds, leading=leading)
    return replace(run, measurements=scored, start=start)
