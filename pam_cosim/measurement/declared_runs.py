"""The runs that ``experiment.toml`` declares: from a table of ``[[runs]]`` and its recording to runs."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement.cuts import Cut, Overrides, cut_run
from pam_cosim.measurement.data_set import Along, Run
from pam_cosim.measurement.experiment_tables import Experiment, LoggerTable, RunTable
from pam_cosim.measurement.formats import may_hold_tables
from pam_cosim.measurement.free_parameter import FreeParameter
from pam_cosim.measurement.parameters import free_parameter, known_values
from pam_cosim.measurement.pieces import pieces_of
from pam_cosim.measurement.place import Stated
from pam_cosim.measurement.points import Points
from pam_cosim.measurement.read_run import read_points, read_run
from pam_cosim.measurement.read_start import with_start
from pam_cosim.measurement.recording import Recording
from pam_cosim.measurement.resampling import resampled
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH
from pam_cosim.wording import shown

_OVER_TIME = ("start", "before", "lead", "periodic", "gaps")  # of all runs
_NOT_STATIC = 'is for recordings over time; points of kind = "static" have none: leave it out'


def check_runs(runs: Sequence[RunTable], experiment: Experiment) -> None:
    """Every file is there, what is used of it is used once, names differ, and something is left to fit."""
    if not any(run.role == "fit" for run in runs):
        raise experiment.error('no run has role = "fit"; one at least is needed', "runs")
    if all(run.is_static for run in runs):
        for key in filter(experiment.states, _OVER_TIME):
            raise experiment.error(f"{key} {_NOT_STATIC}", key)
    files = [run.at("file").file_inside(run.file).resolve() for run in runs]
    listed = defaultdict[Path, list[RunTable]](list)
    for file, run in zip(files, runs, strict=True):
        for other in listed[file]:
            _check_apart(other, run)
        listed[file].append(run)
    may_choose = any(may_hold_tables(Path(run.file)) for run in runs)
    names = set[str]()
    for run in runs:
        _check_keys(run, experiment, may_choose)
        if run.name in names:
            message = f"two runs would be called {shown(run.name)}; rename one of the files"
            raise run.error(message, "file")
        names.add(run.name)


def _check_apart(part_a: RunTable, part_b: RunTable) -> None:
    """Raises InputError where two runs of a file use the same samples."""
    file = shown(part_b.file)
    if part_a.is_static or part_b.is_static:
        message = f"the file {file} is listed twice; hold_out keeps points of a file from the fit"
        raise part_b.error(message, "file")
    ends = [_stated_ends(table) for table in (part_a, part_b)]
    begin = max(interval.get("from", -inf) for interval in ends)
    end = min(interval.get("to", inf) for interval in ends)
    if begin < end:
        message = f"the file {file} is listed twice, and its runs share samples; select their parts with from and to"
        raise part_b.error(message, "file")


def _check_keys(run: RunTable, experiment: Experiment, may_choose: bool) -> None:
    """Rejects keys without an effect; what is stated for all runs may be meant for others."""
    keys: Mapping[str, object]
    if run.is_static:
        own_gaps = run.gaps if run.states("gaps") else None
        stated = {"gaps": own_gaps, "interpolation": run.interpolation}
        keys, why = {"from": run.begin, "to": run.end, **stated}, _NOT_STATIC
    else:
        keys = {"branch": run.branch, "hold_out": run.hold_out}
        why = 'is for points at rest: state kind = "static", or leave it out'
    for key in filter(keys.get, keys):
        raise run.error(f"{key} {why}", key)
    files: list[RunTable | LoggerTable] = [run, *run.loggers]
    for file, table in ((Path(file_table.file), file_table.recording) for file_table in files):
        counts = table.states("table") or not may_choose
        if table.table is not None and counts and not may_hold_tables(file):
            message = f"table selects one of several in a file, and {file.name} has only one"
            raise table.error(f"{message}: leave it out", "table")
    for name, value in run.parameters.items():
        if name in experiment.fit and name not in run.fit:
            message = f"{name} is free under [fit] and cannot have a value of its own in a run"
            raise value.place.error(message)


def check_branches(
    interface: Interface, tables: Sequence[RunTable], read: Sequence[Sequence[Run]]
) -> None:
    """Where one file states the direction of its branches, the others must too."""
    if BRANCH not in interface.inputs:
        return
    static = [(table, runs[0]) for table, runs in zip(tables, read, strict=True) if table.is_static]
    with_branch = [run for _, run in static if BRANCH in run.inputs]
    for table, run in static:
        if with_branch and BRANCH not in run.inputs and BRANCH not in run.parameters:
            directed = shown(with_branch[0].file.name)
            message = (
                f"{shown(run.file.name)} has no column 'branch', and {directed} has a direction"
            )
            hint = 'state branch = "up" or "down", "order" where the rows were taken in their order, or "none"'
            raise table.error(f"{message}; {hint}")


def parameters_of_run(
    interface: Interface, table: RunTable, stated: Mapping[str, Stated]
) -> list[FreeParameter]:
    """What is fitted to one run alone."""
    for name, free in table.fit.items():
        if table.role == "holdout":
            message = f"{name} is free in a run that is never fitted; state its value under [runs.parameters]"
            raise free.error(message)
        if name in table.parameters:
            message = f"{name} is free under [runs.fit] and has a value under [runs.parameters]; keep one of them"
            raise free.error(message)
        if "@" in table.name:
            message = (
                f"the run {shown(table.name)} has parameters of its own; its name must have no '@'"
            )
            raise table.error(message, "fit")
    return [
        free_parameter(interface, name, free, stated, table.name)
        for name, free in table.fit.items()
    ]


def runs_of_table(
    interface: Interface,
    table: RunTable,
    stated: Mapping[str, Stated],
    shared: Mapping[str, float],
    instead: Overrides,
) -> list[Run]:
    """The runs of one table of ``[[runs]]``: of a recording or its pieces, or of the curves of points at rest.

    Args:
        interface: of the bench.
        table: with what is stated for all runs.
        stated: parameters of all runs.
        shared: values of those that are not free [SI].
        instead: what counts instead of what is stated of single runs.

    Raises:
        InputError: whatever is wrong in the table or in the recording.
    """
    run_values = known_values(interface, table.parameters)
    values = {
        name: part_made
        for name, part_made in {**shared, **run_values}.items()
        if name not in table.fit
    }
    points: list[Points] = []
    if table.is_static:
        constants = {
            part_made: value for part_made, value in values.items() if part_made in interface.inputs
        }
        points, files = read_points(table, interface, constants)
        recording = points[0].recording
    else:
        recording, files = read_run(table, interface)
    for name in recording.inputs:
        if name in values:
            message = (
                f"{name} is constant here and a column of {shown(table.file)}; keep one of them"
            )
            raise {**stated, **table.parameters}[name].place.error(message)
    run = _whole_run(table, interface, recording, files, values)
    if points:
        made_runs = [_curve(run, part_made, i == 0) for i, part_made in enumerate(points)]
        parts = f"holds {len(made_runs)} curves"
    else:
        ends = _stated_ends(table)
        try:
            part = cut_run(run, Cut(ends.get("from"), ends.get("to")))
        except InputError as error:
            raise table.error(error.message, next(iter(ends), "file")) from None
        made_runs = pieces_of(part, table.gaps)
        if table.is_part:
            run = part  # what others cut it to lies within: the rest is of another run
        parts = f"falls into {len(made_runs)} pieces"
    if table.fit and len(made_runs) > 1:
        message = f"{shown(table.file)} {parts}, which have no parameter of their own; free it under [fit]"
        raise table.error(message, "fit")
    return [_begun(interface, table, run, part_made, instead) for part_made in made_runs]


def _whole_run(
    table: RunTable,
    interface: Interface,
    recording: Recording,
    files: Sequence[Path],
    values: dict[str, float],
) -> Run:
    """The run with all rows of its recording, and no start yet."""
    stated = {*recording.inputs, *values}
    return Run(
        name=table.name,
        file=files[0],
        more_files=tuple(files[1:]),
        role=table.role,
        interpolation=table.between_samples,
        interpolation_stated=table.interpolation is not None,
        parameters=values,
        time=recording.time,
        inputs=recording.inputs,
        measurements=recording.measurements,
        notes=recording.notes,
        averaged=recording.averaged,
        default_inputs=tuple(name for name in interface.inputs if name not in stated),
    )


def _stated_ends(table: RunTable) -> dict[str, float]:
    """``from`` and ``to`` of a run [s], as far as they are stated."""
    ends = (("from", table.begin), ("to", table.end))
    return {key: value.quantity("s") for key, value in ends if value is not None}


def _begun(interface: Interface, table: RunTable, uncut: Run, run: Run, instead: Overrides) -> Run:
    """A run, or a piece of one, with its start; cut to other ends than are stated, where that is requested.

    What is stated of its start does not count where it then begins elsewhere, or is no longer the period that it was.
    """
    mode, cut, resample = instead.start(run), instead.cut(run), table.recording.resample
    interval = None if resample is None else resample.above_zero("s")
    if mode is not None and run.is_static:
        raise InputError(f"{run.name} holds points at rest, which have no start", run.file)
    shortened_run = run if cut is None else cut_run(uncut if run.name == uncut.name else run, cut)
    ends = [
        (piece.time[0], piece.time[-1] if table.periodic else 0.0) for piece in (run, shortened_run)
    ]
    if interval is not None:
        shortened_run = resampled(shortened_run, interval, shortened_run.interpolation)
    return with_start(table, interface, shortened_run, mode, anew=ends[0] != ends[1])


def _curve(run: Run, points: Points, is_first: bool) -> Run:
    """One curve of a file; the first has the notes on the file."""
    recording = points.recording
    unknown = BRANCH in run.default_inputs
    notes = (
        *run.notes,
        *(["no direction of a branch is stated: dry friction is left out"] if unknown else []),
    )
    return replace(
        run,
        name=f"{run.name} {points.label}".rstrip(),
        role="holdout" if points.holdout else run.role,
        along=Along(points.along, points.unit),
        time=recording.time,
        inputs=recording.inputs,
        measurements=recording.measurements,
        notes=notes if is_first else (),
        default_inputs=tuple(name for name in run.default_inputs if name != BRANCH),
    )
