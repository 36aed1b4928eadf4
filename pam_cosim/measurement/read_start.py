"""What ``experiment.toml`` says of how a run begins."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.experiment import ExperimentFile
from pam_cosim.measurement.experiment_errors import KeyPath
from pam_cosim.measurement.parameters import known_values
from pam_cosim.measurement.start import Start, StartMode
from pam_cosim.model.interface import Interface
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import listed, shown

_FOR = "for"
_KEYS = ("start", "before", "lead", "periodic")


def with_start(
    document: ExperimentFile,
    interface: Interface,
    index: int,
    run: Run,
    mode: StartMode | None = None,
    *,
    anew: bool = False,
) -> Run:
    """The run with what is stated of its start, by itself or for all.

    Args:
        document: what is stated.
        interface: of the bench.
        index: of the run's table.
        run: the run.
        mode: how it begins, instead of what is stated of that and of the time before; a lead stays.
        anew: it begins elsewhere than what is stated is about, which then counts no more.

    Raises:
        InputError: what contradicts itself, an unknown input, a duration that is none.
    """
    content, table = document.content, document.content.runs[index]
    own: dict[str, KeyPath] = {
        key: ("runs", index, key) for key in _KEYS if getattr(table, key) is not None
    }
    places: dict[str, KeyPath] = {
        key: (key,) for key in _KEYS if getattr(content, key) is not None
    } | own
    stated = {key: getattr(table if key in own else content, key) for key in places}
    if run.is_static:
        if own:
            key = next(iter(own))
            raise document.error(
                f"{key} is for recordings over time; points at rest have no start", *own[key]
            )
        return run
    if anew:
        return replace(run, start=Start(mode=mode))
    start = Start(mode=mode)
    if mode is None:
        start = Start(mode=stated.get("start"), periodic=stated.get("periodic", False))
        if start.periodic:
            _check_periodic(document, own, places)
        elif "before" in places:
            start = _with_before(document, interface, start, stated["before"], places["before"])
    if "lead" in places:
        lead = _seconds(document, stated["lead"], *places["lead"])
        return _without_lead(document, run, replace(start, lead=lead), places["lead"])
    return replace(run, start=start)


def _check_periodic(
    document: ExperimentFile, own: dict[str, KeyPath], places: dict[str, KeyPath]
) -> None:
    """A periodic run begins where its period ends; what is stated of all runs gives way to what is stated of one."""
    for key in ("start", "before"):
        shared_counts = key in places and "periodic" not in own
        if key in own or shared_counts:
            message = (
                f"{key} says where the run begins, and so does periodic = true; keep one of them"
            )
            raise document.error(message, *places[key])


def _with_before(
    document: ExperimentFile,
    interface: Interface,
    start: Start,
    table: dict[str, str | float],
    place: KeyPath,
) -> Start:
    if start.mode in ("measured", "estimated"):
        message = f'{shown(start.mode)} begins with the first samples, and before says what led there; state "rest"'
        raise document.error(f'{message} or "steady", as it was then', *place)
    if _FOR not in table:
        raise document.error(
            'for is missing: state how long, before = { ..., for = "5 s" }', *place
        )
    for name in table:
        if name != _FOR and name not in interface.inputs:
            raise document.error(
                f"{shown(name)} is no input of {interface.model}; its inputs: {listed(interface.inputs)}",
                *place,
            )
    seconds = _seconds(document, table[_FOR], *place, _FOR)
    inputs = {name: value for name, value in table.items() if name != _FOR}
    held = known_values(document, interface, inputs, *place)
    return replace(start, mode=start.mode or "rest", before=held, seconds=seconds)


def _seconds(document: ExperimentFile, value: str | float, *place: str | int) -> float:
    try:
        seconds = parse_quantity(value, "s")
    except UnitError as error:
        raise document.error(f"{place[-1]}: {error}", *place) from None
    if not 0.0 < seconds < float("inf"):
        raise document.error(f"{place[-1]} must be greater than zero", *place)
    return seconds


def _without_lead(document: ExperimentFile, run: Run, start: Start, place: KeyPath) -> Run:
    """The run with a start whose first samples are set aside."""
    early = run.time < run.time[0] + start.lead
    if early.all():
        raise document.error(
            f"{run.name} is not longer than its lead: nothing would be scored", *place
        )
    leading = {name: (run.time[early], values[early]) for name, values in run.measurements.items()}
    scored = {name: np.where(early, np.nan, values) for name, values in run.measurements.items()}
    return replace(run, measurements=scored, start=replace(start, leading=leading))
