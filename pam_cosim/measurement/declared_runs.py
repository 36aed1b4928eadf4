"""The runs that ``experiment.toml`` declares: from a table of ``[[runs]]`` and its recording to runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import inf
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement.cuts import Cut, Overrides, cut_run
from pam_cosim.measurement.data_set import Along, Run
from pam_cosim.measurement.experiment import ExperimentFile
from pam_cosim.measurement.experiment_errors import KeyPath
from pam_cosim.measurement.experiment_tables import RunTable
from pam_cosim.measurement.free_parameter import FreeParameter
from pam_cosim.measurement.parameters import free_parameter, known_values
from pam_cosim.measurement.paths import file_inside
from pam_cosim.measurement.pieces import pieces_of
from pam_cosim.measurement.points import Points
from pam_cosim.measurement.read_run import read_points, read_run, resampling_interval
from pam_cosim.measurement.read_start import with_start
from pam_cosim.measurement.recording import Recording
from pam_cosim.measurement.resampling import resampled_run
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import shown

_OVER_TIME = ("start", "before", "lead", "periodic", "gaps")  # of all runs
_NOT_STATIC = 'is for recordings over time; points of kind = "static" have none: leave it out'


def check_runs(document: ExperimentFile) -> None:
    """Every file is there, what is used of it is used once, names differ, and something is left to fit."""
    runs = document.content.runs
    if not any(run.role == "fit" for run in runs):
        raise document.error('no run has role = "fit"; one at least is needed', "runs")
    if all(_is_static(document, run) for run in runs):
        for key in _OVER_TIME:
            if getattr(document.content, key, None) is not None:
                raise document.error(f"{key} {_NOT_STATIC}", key)
    files = [
        file_inside(document, run.file, "runs", index, "file").resolve()
        for index, run in enumerate(runs)
    ]
    listed: dict[Path, list[int]] = {}
    for index, file in enumerate(files):
        for other in listed.setdefault(file, []):
            _check_apart(document, index, other)
        listed[file].append(index)
    for index, name in enumerate(document.run_names):
        if name in document.run_names[:index]:
            message = f"two runs would be called {shown(name)}; rename one of the files"
            raise document.error(message, "runs", index, "file")


def _check_apart(document: ExperimentFile, index: int, other: int) -> None:
    """Raises InputError where two runs of a file use the same samples."""
    tables = [document.content.runs[i] for i in (other, index)]
    file, place = shown(tables[1].file), ("runs", index, "file")
    if any(_is_static(document, table) for table in tables):
        message = f"the file {file} is listed twice; hold_out keeps points of a file from the fit"
        raise document.error(message, *place)
    ends = [_stated_ends(document, i) for i in (other, index)]
    begin = max(one.get("from", -inf) for one in ends)
    end = min(one.get("to", inf) for one in ends)
    if begin < end:
        message = f"the file {file} is listed twice, and its runs share samples; from and to say which part each is"
        raise document.error(message, *place)


def check_branches(
    document: ExperimentFile, interface: Interface, read: Sequence[Sequence[Run]]
) -> None:
    """Where one file tells the direction of its branches, the others do so too."""
    if BRANCH not in interface.inputs:
        return
    static = [(i, runs[0]) for i, runs in enumerate(read) if runs[0].along is not None]
    told = [run for _, run in static if BRANCH in run.inputs]
    for index, run in static:
        if told and BRANCH not in run.inputs and BRANCH not in run.parameters:
            message = f"{shown(run.file.name)} has no column 'branch', and {shown(told[0].file.name)} has a direction"
            hint = 'state branch = "up" or "down", "order" where the rows were taken in their order, or "none"'
            raise document.error(f"{message}; {hint}", "runs", index)


def parameters_of_run(
    document: ExperimentFile, interface: Interface, index: int, known: Mapping[str, float]
) -> list[FreeParameter]:
    """What is fitted to one run alone."""
    table = document.content.runs[index]
    path, name = ("runs", index, "fit"), document.run_names[index]
    for one in table.fit:
        if table.role == "holdout":
            message = f"{one} is free in a run that is never fitted; state its value under [runs.parameters]"
            raise document.error(message, *path, one)
        if one in table.parameters:
            message = f"{one} is free under [runs.fit] and has a value under [runs.parameters]; keep one of them"
            raise document.error(message, *path, one)
        if "@" in name:
            raise document.error(
                f"the run {shown(name)} has parameters of its own; its name must have no '@'", *path
            )
    return [
        free_parameter(document, interface, one, free, known, *path, run=name)
        for one, free in table.fit.items()
    ]


def runs_of_table(
    document: ExperimentFile,
    interface: Interface,
    index: int,
    known: Mapping[str, float],
    instead: Overrides,
) -> list[Run]:
    """The runs of one table of ``[[runs]]``: of a recording or its pieces, or of the curves of points at rest.

    Args:
        document: what is stated.
        interface: of the bench.
        index: of the table.
        known: values of parameters that all runs share [SI].
        instead: what counts instead of what is stated of single runs.

    Raises:
        InputError: whatever is wrong in the table or in the recording.
    """
    table = document.content.runs[index]
    own = _own_values(document, interface, index, table)
    values = {name: value for name, value in {**known, **own}.items() if name not in table.fit}
    points: list[Points] = []
    if _is_static(document, table):
        _check_static(document, table, index)
        constants = {one: value for one, value in values.items() if one in interface.inputs}
        points, files = read_points(document, index, interface, constants)
        recording = points[0].recording
    else:
        _check_dynamic(document, table, index)
        recording, files = read_run(document, index, interface)
    _check_constants(document, index, recording, values, own)
    run = _whole_run(document.run_names[index], table, interface, recording, files, values)
    if points:
        every = [_curve(run, one, i == 0) for i, one in enumerate(points)]
        parts = f"holds {len(every)} curves"
    else:
        part = _cut_as_stated(document, index, run)
        every = pieces_of(part, table.gaps or document.content.gaps)
        if document.is_part(index):
            run = part  # what others cut it to lies within: the rest is of another run
        parts = f"falls into {len(every)} pieces"
    if table.fit and len(every) > 1:
        message = f"{shown(table.file)} {parts}, which have no parameter of their own; free it under [fit]"
        raise document.error(message, "runs", index, "fit")
    return [_begun(document, interface, index, run, one, instead) for one in every]


def _check_constants(
    document: ExperimentFile,
    index: int,
    recording: Recording,
    values: Mapping[str, float],
    own: Mapping[str, float],
) -> None:
    """No input is both a column and a constant; ``own`` are the values that are stated for this run alone."""
    file = document.content.runs[index].file
    for name in recording.inputs:
        if name in values:
            place: KeyPath = ("runs", index, "parameters") if name in own else ("parameters",)
            message = f"{name} is constant here and a column of {shown(file)}; keep one of them"
            raise document.error(message, *place, name)


def _whole_run(
    name: str,
    table: RunTable,
    interface: Interface,
    recording: Recording,
    files: Sequence[Path],
    values: dict[str, float],
) -> Run:
    """The run with all rows of its recording, and no start yet."""
    stated = {*recording.inputs, *values}
    return Run(
        name=name,
        file=files[0],
        more_files=tuple(files[1:]),
        role=table.role,
        interpolation=table.interpolation,
        parameters=values,
        time=recording.time,
        inputs=recording.inputs,
        measurements=recording.measurements,
        notes=recording.notes,
        averaged=recording.averaged,
        default_inputs=tuple(name for name in interface.inputs if name not in stated),
    )


def _is_static(document: ExperimentFile, table: RunTable) -> bool:
    return (table.kind or document.content.kind) == "static"


def _check_dynamic(document: ExperimentFile, table: RunTable, index: int) -> None:
    for key in ("branch", "hold_out"):
        if getattr(table, key):
            message = f'{key} is for points at rest: state kind = "static", or leave it out'
            raise document.error(message, "runs", index, key)


def _check_static(document: ExperimentFile, table: RunTable, index: int) -> None:
    """What is stated of one run alone would have no effect; what is stated of all may be meant for the others."""
    fields = {"from": "begin", "to": "end", "gaps": "gaps", "interpolation": "interpolation"}
    for key, field in fields.items():
        if field in table.model_fields_set:
            raise document.error(f"{key} {_NOT_STATIC}", "runs", index, key)


def _own_values(
    document: ExperimentFile, interface: Interface, index: int, table: RunTable
) -> dict[str, float]:
    """What is stated of one run alone [SI]."""
    path = ("runs", index, "parameters")
    for name in table.parameters:
        if name in document.content.fit:
            message = f"{name} is free under [fit] and cannot have a value of its own in a run"
            raise document.error(message, *path, name)
    return known_values(document, interface, table.parameters, *path)


def _cut_as_stated(document: ExperimentFile, index: int, run: Run) -> Run:
    """The rows of a recording that ``from`` and ``to`` leave."""
    ends = _stated_ends(document, index)
    try:
        return cut_run(run, Cut(ends.get("from"), ends.get("to")))
    except InputError as error:
        raise document.error(error.message, "runs", index, next(iter(ends), "file")) from None


def _stated_ends(document: ExperimentFile, index: int) -> dict[str, float]:
    """``from`` and ``to`` of a run [s], as far as they are stated."""
    table, ends = document.content.runs[index], dict[str, float]()
    for key, value in (("from", table.begin), ("to", table.end)):
        if value is not None:
            try:
                ends[key] = parse_quantity(value, "s")
            except UnitError as error:
                raise document.error(f"{key}: {error}", "runs", index, key) from None
    return ends


def _begun(
    document: ExperimentFile,
    interface: Interface,
    index: int,
    whole: Run,
    run: Run,
    instead: Overrides,
) -> Run:
    """A run, or a piece of one, with its start; cut to other ends than are stated, where that is asked for.

    What is stated of its start does not count where it then begins elsewhere, or is no longer the period that it was.
    """
    mode, cut = instead.start(run), instead.cut(run)
    interval = resampling_interval(document, index)

    def means(one: Run) -> Run:
        return one if interval is None else resampled_run(one, interval)

    if mode is not None and run.is_static:
        raise InputError(f"{run.name} holds points at rest, which have no start", run.file)
    if cut is None:
        return with_start(document, interface, index, means(run), mode)
    made = cut_run(whole if run.name == whole.name else run, cut)
    table = document.content.runs[index]
    periodic = document.content.periodic if table.periodic is None else table.periodic
    elsewhere = made.time[0] != run.time[0] or (bool(periodic) and made.time[-1] != run.time[-1])
    return with_start(document, interface, index, means(made), mode, anew=bool(elsewhere))


def _curve(run: Run, points: Points, first: bool) -> Run:
    """One curve of a file; the first says how the file was read."""
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
        notes=notes if first else (),
        default_inputs=tuple(name for name in run.default_inputs if name != BRANCH),
    )
