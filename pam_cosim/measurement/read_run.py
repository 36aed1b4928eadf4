"""One file of a data set, read as ``[recording]`` and ``[columns]`` state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.measurement.clocks import ClockError, Offset, estimate_offset, merged
from pam_cosim.measurement.columns import ColumnMapping, with_columns, with_zeros
from pam_cosim.measurement.experiment import ExperimentFile
from pam_cosim.measurement.experiment_errors import KeyPath
from pam_cosim.measurement.experiment_tables import LoggerTable, RecordingTable, RunTable
from pam_cosim.measurement.formats import may_hold_tables, read_table
from pam_cosim.measurement.paths import file_inside
from pam_cosim.measurement.pieces import with_time_going_on
from pam_cosim.measurement.points import WORDS, Points, points_of
from pam_cosim.measurement.recording import Recording, recording_of, with_held_values
from pam_cosim.measurement.table import TIME, Column, Layout, Table
from pam_cosim.measurement.wrapped_clocks import with_clocks_going_on
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import did_you_mean, shown


def read_run(
    document: ExperimentFile, index: int, interface: Interface
) -> tuple[Recording, tuple[Path, ...]]:
    """The recording of a run, and its files; what a file states itself overrides what is stated for all.

    Raises:
        InputError: see ``read_table``, ``with_columns`` and ``recording_of``; clocks that cannot be brought together.
    """
    run, place = document.content.runs[index], ("runs", index)
    files = [file_inside(document, run.file, *place, "file")]
    recording = _recording(document, run, files[0], interface, *place)
    for number, logger in enumerate(run.loggers):
        where = (*place, "loggers", number)
        files.append(file_inside(document, logger.file, *where, "file"))
        other = _recording(document, logger, files[-1], interface, *where)
        offset = _offset(document, logger, recording, other, *where)
        if offset.sd:
            said = f"the clock of {logger.file} is put {offset.value:.4g} s on, ± {offset.sd:.2g} s, by {logger.match}"
            recording = replace(recording, notes=(*recording.notes, said))
        try:
            recording = merged(recording, other, offset.value, run.interpolation)
        except ClockError as error:
            raise document.error(f"{logger.file}: {error}", *where) from None
    return recording, tuple(files)


def resampling_interval(document: ExperimentFile, index: int) -> float | None:
    """Over how long the rows of a run become means [s]; None where it is not stated.

    Raises:
        InputError: it is not a time above zero.
    """
    run = document.content.runs[index]
    stated = _stated(document, run).resample
    if stated is None:
        return None
    own = run.recording.resample is not None
    level: KeyPath = ("runs", index, "recording") if own else ("recording",)
    return _duration(document, stated, *level, "resample")


def read_points(
    document: ExperimentFile, index: int, interface: Interface, held: Mapping[str, float]
) -> tuple[list[Points], tuple[Path, ...]]:
    """The curves of a run of points at rest, and its files; ``held``: inputs that are stated for all of them.

    Raises:
        InputError: see ``read_table``, ``with_columns`` and ``points_of``; what only a recording over time can have.
    """
    run, place = document.content.runs[index], ("runs", index)
    stated, renaming = _stated(document, run), _renaming(document, run, *place)
    for key in ("interval", "resample"):
        if getattr(stated, key) is not None:
            level: KeyPath = (
                (*place, "recording") if getattr(run.recording, key) is not None else ("recording",)
            )
            raise document.error(
                f'{key} is for recordings over time; points of kind = "static" have none',
                *level,
                key,
            )
    if run.loggers:
        message = (
            'other loggers are joined by their clocks, and points of kind = "static" have none'
        )
        raise document.error(message, *place, "loggers", 0)
    file = file_inside(document, run.file, *place, "file")
    _check_table(document, run, file, *place)
    branch = renaming.tables.get(BRANCH)
    source = branch.column if branch is not None and isinstance(branch.column, str) else BRANCH
    words = WORDS if branch is None or branch.words is None else _own_words(branch.words)
    layout = replace(_layout(stated, renaming, interface), words={source: words})
    table = with_columns(read_table(file, layout), renaming, interface.inputs)
    table = with_zeros(table, renaming)
    return points_of(table, interface, document, index, held), (file,)


def _own_words(stated: Mapping[str, str]) -> dict[str, float]:
    """Directions by the cells of a file that stand for them."""
    return {cell.casefold(): WORDS[word] for cell, word in stated.items()}


def _recording(
    document: ExperimentFile,
    entry: RunTable | LoggerTable,
    file: Path,
    interface: Interface,
    *place: str | int,
) -> Recording:
    stated, renaming = _stated(document, entry), _renaming(document, entry, *place)
    _check_table(document, entry, file, *place)
    table = read_table(file, _layout(stated, renaming, interface))
    table = with_clocks_going_on(table, renaming.clock)
    if stated.interval is not None:
        where: KeyPath = (
            (*place, "recording") if entry.recording.interval is not None else ("recording",)
        )
        table = _with_time(table, _duration(document, stated.interval, *where, "interval"))
    gaps = document.content.gaps
    if isinstance(entry, RunTable):
        gaps = entry.gaps or gaps
    table = with_columns(table, renaming, [TIME, *interface.inputs])
    table = with_zeros(with_time_going_on(table, gaps), renaming)
    if document.content.runs[int(place[1])].interpolation == "previous":
        table = with_held_values(table, interface.inputs)
    return recording_of(table, interface)


def _check_table(
    document: ExperimentFile, entry: RunTable | LoggerTable, file: Path, *place: str | int
) -> None:
    """Nothing chooses a table of a file that is one; what is stated of all files may be meant for others."""
    if may_hold_tables(file):
        return
    files = [Path(run.file) for run in document.content.runs]
    shared = isinstance(entry, RunTable) and not any(map(may_hold_tables, files))
    message = (
        f"table chooses one of several in a file, and {file.name} is one by itself: leave it out"
    )
    if entry.recording.table is not None:
        raise document.error(message, *place, "recording", "table")
    if shared and document.content.recording.table is not None:
        raise document.error(message, "recording", "table")


def _stated(document: ExperimentFile, entry: RunTable | LoggerTable) -> RecordingTable:
    own = entry.recording.model_dump(exclude_unset=True)
    shared = document.content.recording if isinstance(entry, RunTable) else RecordingTable()
    return shared.model_copy(update=own)


def _renaming(
    document: ExperimentFile, entry: RunTable | LoggerTable, *place: str | int
) -> ColumnMapping:
    """Another logger has columns of its own."""
    shared = document.content.columns if isinstance(entry, RunTable) else {}
    places: dict[str, KeyPath] = {name: ("columns", name) for name in shared}
    places |= {name: (*place, "columns", name) for name in entry.columns}
    return ColumnMapping(document, {**shared, **entry.columns}, places)


def _offset(
    document: ExperimentFile,
    logger: LoggerTable,
    one: Recording,
    other: Recording,
    *place: str | int,
) -> Offset:
    if (logger.offset is None) == (logger.match is None):
        message = 'state what to add to its times, offset = "0.12 s", or a signal that both files have, match = "p"'
        raise document.error(f"{logger.file}: {message}", *place, "offset")
    try:
        if logger.offset is not None:
            return Offset(parse_quantity(logger.offset, "s"))
        name = str(logger.match)
        courses = [{**recording.inputs, **recording.measurements} for recording in (one, other)]
        for course, file in zip(courses, (place[1], logger.file), strict=True):
            if name not in course:
                said = logger.file if file == logger.file else document.content.runs[int(file)].file
                raise ClockError(f"{said} has no {shown(name)}; {did_you_mean(name, course)}")
        return estimate_offset((one.time, courses[0][name]), (other.time, courses[1][name]))
    except UnitError as error:
        raise document.error(f"offset: {error}", *place, "offset") from None
    except ClockError as error:
        message = (
            f"the offset of {logger.file} cannot be estimated: {error}; state it as offset = ..."
        )
        raise document.error(message, *place, "match") from None


def _layout(stated: RecordingTable, renaming: ColumnMapping, interface: Interface) -> Layout:
    names = None if stated.names is None else tuple(stated.names)
    asked = {
        TIME,
        *interface.inputs,
        *interface.outputs,
        *renaming.sources,
        *renaming.names_in_formulas(),
    }
    return Layout(
        encoding=stated.encoding,
        separator=stated.separator,
        decimal=stated.decimal,
        names=names,
        header_line=stated.header_line,
        units_line=stated.units_line,
        table=stated.table,
        ignore=tuple(stated.ignore or ()),
        missing=frozenset(word.casefold() for word in stated.missing or ()),
        asked=frozenset(asked),
        clock=renaming.clock,
    )


def _duration(document: ExperimentFile, value: str | float, *place: str | int) -> float:
    try:
        seconds = parse_quantity(value, "s")
    except UnitError as error:
        raise document.error(f"{place[-1]}: {error}", *place) from None
    if seconds <= 0.0:
        raise document.error(f"{place[-1]} must be greater than zero", *place)
    return seconds


def _with_time(table: Table, interval: float) -> Table:
    """The table with time from zero in equal steps."""
    if TIME in table.columns:
        raise InputError(
            "an interval is stated, and the file has a column 'time'; keep one of them", table.file
        )
    count = len(next(iter(table.columns.values())).values)
    time = Column(TIME, "s", interval * np.arange(count, dtype=np.float64))
    return replace(table, columns={TIME: time, **table.columns})
