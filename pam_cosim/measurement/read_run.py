"""One file of a data set, read as ``[recording]`` and ``[columns]`` state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from pam_cosim.errors import InputError
from pam_cosim.measurement.clocks import ClockError, Offset, estimate_offset, merged
from pam_cosim.measurement.columns import Columns, clock_of, sources_of, with_columns, with_zeros
from pam_cosim.measurement.experiment_tables import LoggerTable, RecordingTable, RunTable
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.pieces import with_time_going_on
from pam_cosim.measurement.points import WORDS, Points, points_of
from pam_cosim.measurement.recording import (
    Recording,
    recording_of,
    with_held_values,
    words_of,
)
from pam_cosim.measurement.table import TIME, Layout
from pam_cosim.measurement.wrapped_clocks import with_clocks_going_on
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import BRANCH
from pam_cosim.wording import did_you_mean, shown


def read_run(run: RunTable, interface: Interface) -> tuple[Recording, tuple[Path, ...]]:
    """The recording of a run, and its files.

    Raises:
        InputError: see ``read_table``, ``with_columns`` and ``recording_of``; clocks that cannot be brought together.
    """
    files = [run.at("file").file_inside(run.file)]
    recording = _recording(run, run, files[0], interface)
    for logger in run.loggers:
        files.append(logger.at("file").file_inside(logger.file))
        other = _recording(logger, run, files[-1], interface)
        offset = _offset(run, logger, recording, other)
        if offset.sd:
            shift = f"{offset.value:.4g} s, ± {offset.sd:.2g} s, by {logger.match}"
            note = f"the clock of {logger.file} is shifted by {shift}"
            recording = replace(recording, notes=(*recording.notes, note))
        try:
            recording = merged(recording, other, offset.value, run.between_samples)
        except ClockError as error:
            raise logger.error(f"{logger.file}: {error}") from None
    return recording, tuple(files)


def read_points(
    run: RunTable, interface: Interface, held: Mapping[str, float]
) -> tuple[list[Points], tuple[Path, ...]]:
    """The curves of a run of points at rest, and its files; ``held``: inputs that are stated for all of them.

    Raises:
        InputError: see ``read_table``, ``with_columns`` and ``points_of``; what only a recording over time can have.
    """
    stated, columns = run.recording, run.columns
    for key in ("interval", "resample"):
        if getattr(stated, key) is not None:
            raise stated.error(
                f'{key} is for recordings over time; points of kind = "static" have none', key
            )
    if run.loggers:
        message = (
            'other loggers are joined by their clocks, and points of kind = "static" have none'
        )
        raise run.loggers[0].error(message)
    file = run.at("file").file_inside(run.file)
    branch = columns.get(BRANCH)
    source = branch.column if branch is not None and isinstance(branch.column, str) else BRANCH
    words = WORDS
    if branch is not None and branch.words is not None:
        words = {cell.casefold(): WORDS[word] for cell, word in branch.words.items()}
    layout = layout_of(stated, columns, interface)
    layout = replace(layout, words={**layout.words, source: words})
    table = with_columns(read_table(file, layout), columns, interface.inputs)
    return points_of(with_zeros(table, columns), interface, run, held), (file,)


def _recording(
    entry: RunTable | LoggerTable, run: RunTable, file: Path, interface: Interface
) -> Recording:
    """The recording in the file of a run, or of another of its loggers."""
    stated, columns = entry.recording, entry.columns
    table = read_table(file, layout_of(stated, columns, interface))
    table = with_clocks_going_on(table, clock_of(columns))
    if stated.interval is not None:
        interval = stated.interval.above_zero("s")
        if TIME in table.columns:
            message = "an interval is stated, and the file has a column 'time'; keep one of them"
            raise InputError(message, file)
        table = table.with_time(interval)
    table = with_columns(table, columns, [TIME, *interface.inputs])
    table = with_zeros(with_time_going_on(table, run.gaps), columns)
    if run.interpolation == "previous":
        table = with_held_values(table, interface.inputs)
    return recording_of(table, interface)


def _offset(run: RunTable, logger: LoggerTable, reference: Recording, shifted: Recording) -> Offset:
    if (logger.offset is None) == (logger.match is None):
        message = 'state what to add to its times, offset = "0.12 s", or a signal that both files have, match = "p"'
        raise logger.error(f"{logger.file}: {message}", "offset")
    if logger.offset is not None:
        return Offset(logger.offset.quantity("s"))
    name = str(logger.match)
    signals_of_files = [
        {**recording.inputs, **recording.measurements} for recording in (reference, shifted)
    ]
    try:
        for signals, file in zip(signals_of_files, (run.file, logger.file), strict=True):
            if name not in signals:
                raise ClockError(f"{file} has no {shown(name)}; {did_you_mean(name, signals)}")
        return estimate_offset(
            (reference.time, signals_of_files[0][name]), (shifted.time, signals_of_files[1][name])
        )
    except ClockError as error:
        message = (
            f"the offset of {logger.file} cannot be estimated: {error}; state it as offset = ..."
        )
        raise logger.error(message, "match") from None


def layout_of(stated: RecordingTable, columns: Columns, interface: Interface) -> Layout:
    """How the file of a run is read, so that the columns that it needs are kept."""
    required = frozenset((TIME, *interface.inputs, *interface.outputs, *sources_of(columns)))
    headings = {n: choice.column for n, choice in columns.items() if isinstance(choice.column, str)}
    layout = stated.layout(required=required, clock=clock_of(columns))
    return replace(layout, words=words_of(interface, headings))
