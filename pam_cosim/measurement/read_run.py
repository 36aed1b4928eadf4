"""One file of a data set, read as ``[recording]`` and ``[columns]`` state."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.interface import Interface
from pam_cosim.measurement.columns import Renaming, with_columns
from pam_cosim.measurement.experiment import ExperimentFile, KeyPath, RecordingTable
from pam_cosim.measurement.formats import read_table
from pam_cosim.measurement.recording import Recording, recording_of
from pam_cosim.measurement.resampling import resampled
from pam_cosim.measurement.table import TIME, Column, Layout, Table
from pam_cosim.units import UnitError, parse_quantity


def read_run(document: ExperimentFile, index: int, file: Path, interface: Interface) -> Recording:
    """The recording of a run; what the run states itself overrides what is stated for all.

    Raises:
        InputError: see ``read_table``, ``with_columns`` and ``recording_of``.
    """
    stated, renaming = document.content.recording, _renaming(document, index)
    own = document.content.runs[index].recording
    stated = stated.model_copy(update=own.model_dump(exclude_unset=True))
    table = read_table(file, _layout(stated, renaming, interface))
    if stated.interval is not None:
        place: KeyPath = ("runs", index, "recording") if "interval" in own.model_fields_set else ("recording",)
        table = _with_time(table, _duration(document, stated.interval, *place, "interval"))
    recording = recording_of(with_columns(table, renaming), interface)
    if stated.resample is None:
        return recording
    place = ("runs", index, "recording") if "resample" in own.model_fields_set else ("recording",)
    interval = _duration(document, stated.resample, *place, "resample")
    return resampled(recording, interval, document.content.runs[index].interpolation)


def _renaming(document: ExperimentFile, index: int) -> Renaming:
    shared, own = document.content.columns, document.content.runs[index].columns
    places: dict[str, KeyPath] = {name: ("columns", name) for name in shared}
    places |= {name: ("runs", index, "columns", name) for name in own}
    return Renaming(document, {**shared, **own}, places)


def _layout(stated: RecordingTable, renaming: Renaming, interface: Interface) -> Layout:
    names = None if stated.names is None else tuple(stated.names)
    asked = {TIME, *interface.inputs, *interface.outputs, *renaming.sources, *renaming.names_in_formulas()}
    return Layout(
        encoding=stated.encoding,
        separator=stated.separator,
        decimal=stated.decimal,
        names=names,
        header_line=stated.header_line,
        units_line=stated.units_line,
        table=stated.table,
        ignore=tuple(stated.ignore or ()),
        asked=frozenset(asked),
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
        raise InputError("an interval is stated, and the file has a column 'time'; keep one of them", table.file)
    count = len(next(iter(table.columns.values())).values)
    time = Column(TIME, "s", interval * np.arange(count, dtype=np.float64))
    return replace(table, columns={TIME: time, **table.columns})
