"""A data set with other free parameters than it declares."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from pam_cosim.errors import InputError
from pam_cosim.fitting.free import Free, base_parameters, model_parameter
from pam_cosim.measurement import DataSet, FreeParameter, Run
from pam_cosim.model.interface import Interface
from pam_cosim.wording import did_you_mean, shown


def with_free(
    data: DataSet,
    interface: Interface,
    free: Sequence[str] | None = None,
    start: Mapping[str, float] | None = None,
) -> DataSet:
    """The data set in which just these parameters are free; what it leaves free besides is held where it starts.

    Args:
        data: the measurement.
        interface: of the model.
        free: names: of parameters that the data set declares free, or that the model itself gives bounds. None: those
            of the data set.
        start: where parameters start, or are held, by name [SI]; and start values of states by "state@run": there the
            run begins, or the estimate of where it does.

    Raises:
        InputError: the model has no such parameter, it has no bounds, or a start is of none of these.
    """
    if isinstance(free, str | Mapping):
        raise InputError(f"free is a list of names, as free=['valve.C_A'], not {shown(free)}")
    data, starts = _beginning(data, interface, start or {})
    declared = {f.name: f for f in base_parameters(data, interface)}
    names = tuple(declared) if free is None else tuple(dict.fromkeys(free))
    started = _started(declared, names, starts, interface)
    held = {name: f for name, f in started.items() if name not in names}
    return replace(
        data,
        fit={name: _fit_entry(data, started[name], name in starts) for name in names},
        runs=tuple(_holding(run, held) for run in data.runs),
    )


def _started(
    declared: Mapping[str, Free],
    names: Sequence[str],
    starts: Mapping[str, float],
    interface: Interface,
) -> dict[str, Free]:
    """All parameters that the data set declares or the user names, each where it starts."""
    further = [name for name in (*names, *starts) if name not in declared]
    every = dict(declared) | {name: model_parameter(name, interface) for name in further}
    for name in starts:
        if name not in names and name not in declared:
            similar = did_you_mean(name, [*names, *declared])
            raise InputError(f"'{name}' has a start and is not free; {similar}")
    return {name: f.starting_at(starts.get(name, f.start)) for name, f in every.items()}


def _fit_entry(data: DataSet, started: Free, has_start: bool) -> FreeParameter:
    """As the data set declares it, unless the user says where it starts."""
    if started.name in data.fit and not has_start:
        return data.fit[started.name]
    return _declared(started)


def _beginning(
    data: DataSet, interface: Interface, start: Mapping[str, float]
) -> tuple[DataSet, dict[str, float]]:
    """The data set whose runs know the start values that are stated of them, and the other starts."""
    others = dict(start)
    runs = []
    for run in data.runs:
        names = {f"{state}@{run.name}": state for state in interface.states}
        of_run = {state: others.pop(name) for name, state in names.items() if name in others}
        runs.append(replace(run, parameters={**run.parameters, **of_run}) if of_run else run)
    return replace(data, runs=tuple(runs)), others


def _declared(f: Free) -> FreeParameter:
    return FreeParameter(f.name, f.low, f.high, f.start, f.unit, f.transform, f.prior, f.run)


def _holding(run: Run, held: Mapping[str, Free]) -> Run:
    """A run in which these are known."""
    shared = {f.parameter: f.start for f in held.values() if not f.run}
    own = {f.parameter: f.start for f in held.values() if f.run == run.name}
    return replace(run, parameters=shared | run.parameters | own) if shared or own else run
