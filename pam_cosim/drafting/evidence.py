"""The recordings in the light of what the user states: what their columns are, their time, their values."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.drafting.columns import RecordedColumn, as_points, find_columns, names_in
from pam_cosim.drafting.headings import UNKNOWN, Headings, Remark, remarks_in
from pam_cosim.drafting.recordings import Source, in_parts, places_of, read_sources, recording_table
from pam_cosim.drafting.time_axis import (
    SeveralClocks,
    check_time,
    even_interval,
    with_one_clock,
    with_time,
)
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.place import Stated
from pam_cosim.units import convert
from pam_cosim.units.grammar import ATMOSPHERES
from pam_cosim.wording import did_you_mean, shown


@dataclass(frozen=True)
class DraftRequests:
    """What the user states, all optional; see ``study.new``."""

    title: str | None = None
    model: str | None = None
    columns: Mapping[str, str] | None = None
    parameters: Mapping[str, str] | None = None
    recording: Mapping[str, object] | None = None
    muscle: str | None = None
    roles: Mapping[str, str] | None = None
    valve: str | None = None


@dataclass(frozen=True)
class Evidence:
    """The recordings as they were read.

    Attributes:
        sources: one for each file, or for each experiment in it.
        columns: of all of them, with what each is.
        time: the one of time; None where an interval is stated.
        recording: as stated.
        requested: names of columns by the bench's names: those that the user states, and those named as in the model.
        formulas: texts by the bench's names, of what is no column.
        stated: parameters as texts.
        run_parameters: by recording, parameters that the user states for it alone, as texts.
        remarks: by recording, quantities that lines above its rows state.
        points: the recordings are tables of points at rest.
    """

    sources: tuple[Source, ...]
    columns: tuple[RecordedColumn, ...]
    time: RecordedColumn | None
    recording: RecordingTable
    requested: dict[str, str]
    formulas: dict[str, str]
    stated: dict[str, str]
    run_parameters: tuple[dict[str, str], ...]
    remarks: tuple[tuple[Remark, ...], ...]
    points: bool
    headings: Headings

    @property
    def ambient_pressure(self) -> RecordedColumn | None:
        """A column that holds it, near that of the standard atmosphere; None: there is none."""
        low, high = ATMOSPHERES
        for column in self.columns:
            if column.of("pressure", "ambient") and column.unit and column.values:
                values = convert(column.samples, column.unit, "Pa")
                if bool(((low <= values) & (values <= high)).all()):
                    return column
        return None

    @property
    def stated_names(self) -> list[str]:
        """The parameters and inputs that the user states, of all recordings or of one."""
        of_runs = (name for values in self.run_parameters for name in values)
        return list(dict.fromkeys([*self.stated, *of_runs]))

    @property
    def files(self) -> list[Path]:
        """Of the user, one for each recording."""
        return [source.file for source in self.sources]

    @property
    def signals(self) -> list[RecordedColumn]:
        """Columns of which it is known what they are, but for time and what stands around a muscle."""
        around = ("ambient", "rest")
        recognised = [c for c in self.columns if c.meaning and not c.of("time")]
        return [c for c in recognised if c.meaning.roles.isdisjoint(around)]


def gather(
    files: Sequence[Path], requests: DraftRequests, headings: Headings, names: Collection[str]
) -> Evidence:
    """Reads the recordings and recognises their columns.

    Args:
        files: recordings.
        requests: what the user states.
        headings: by which headings are read.
        names: of inputs and outputs of the model that the user states: a column that is called so is that.

    Raises:
        InputError: a file that cannot be read, no time, a wish that cannot be met.
    """
    recording = recording_table(requests.recording or {})
    sources = read_sources(files, recording, headings)
    requested, formulas = _stated_columns(requests.columns or {}, sources, names)
    sources, columns, time = _recognised(sources, requested, formulas, headings)
    check_time(time, columns, sources, recording, headings)
    interval = None
    # rows of several experiments are not evenly apart
    if time is not None and not any(source.part for source in sources):
        interval = even_interval(list(time.converted("s").values()))
    if time is not None and recording.interval is None and interval is not None:
        columns = [_coarse(c, interval) if c.name == time.name else c for c in columns]
        recording = recording.model_copy(update={"interval": Stated(interval)})
    if recording.interval is not None:
        time = None
    points = time is None and recording.interval is None
    stated, of_run = _stated(requests.parameters or {}, sources)
    words = list(dict.fromkeys(word for source in sources for word in source.table.missing))
    if any(source.is_merged for source in sources):
        words, recording = [], RecordingTable()
    return Evidence(
        sources=tuple(sources),
        columns=tuple(as_points(columns) if points else columns),
        time=time,
        recording=recording.model_copy(update={"missing": words}) if words else recording,
        requested=requested,
        formulas=formulas,
        stated=stated,
        run_parameters=of_run,
        remarks=tuple(tuple(remarks_in(source.remarks, headings)) for source in sources),
        points=points,
        headings=headings,
    )


def _stated_columns(
    wanted: Mapping[str, str], sources: Sequence[Source], names: Collection[str]
) -> tuple[dict[str, str], dict[str, str]]:
    """Columns and formulas by the bench's names, as the user states them or the files call them.

    Raises:
        InputError: a text is neither a column nor a formula.
    """
    recorded = {n: c for source in sources for n, c in source.table.columns.items()}
    called = {column.heading.strip(): name for name, column in recorded.items()}
    stated = {n: called.get(text.strip(" '"), text) for n, text in wanted.items()}
    formulas = {name: text for name, text in stated.items() if text not in recorded}
    for name, text in formulas.items():
        if name == "time" or not re.search(r"[-+*/^('\"]", text):
            hint = did_you_mean(text, recorded)
            raise InputError(f"--column {name}: no file has a column {shown(text)}; {hint}")
    alike = {name: name for name in names if name in recorded and name not in stated}
    return alike | {n: text for n, text in stated.items() if n not in formulas}, formulas


def _recognised(
    sources: list[Source],
    requested: Mapping[str, str],
    formulas: Mapping[str, str],
    headings: Headings,
) -> tuple[list[Source], list[RecordedColumn], RecordedColumn | None]:
    """The recordings, one for each experiment and of one clock each, with their columns and the time."""
    columns = find_columns(sources, requested.values(), formulas.values(), headings)
    try:
        columns, time = with_time(columns, requested.get("time"), headings)
    except SeveralClocks as found:
        merged = with_one_clock(sources, columns, found, headings)
        return _recognised(merged, requested, formulas, headings)
    parts = sources if time is None else in_parts(sources, time.name, time.unit)
    if len(parts) > len(sources):
        return _recognised(parts, requested, formulas, headings)
    return sources, columns, time


def used_in(evidence: Evidence) -> set[str]:
    """The columns that formulas of the user read."""
    return {name for text in evidence.formulas.values() for name in names_in(text)}


def _coarse(time: RecordedColumn, interval: str) -> RecordedColumn:
    """The clock, which is no time any more."""
    values = next(iter(time.values.values()))
    rows, times = len(values), len(np.unique(values))
    why = f"a clock too coarse, {rows} rows at {times} times: the rows are taken to be {interval} apart"
    return replace(time, meaning=UNKNOWN, why=(why,))


def _stated(
    parameters: Mapping[str, str], sources: Sequence[Source]
) -> tuple[dict[str, str], tuple[dict[str, str], ...]]:
    """Parameters of all recordings, and those of one, ``NAME@RECORDING``."""
    shared: dict[str, str] = {}
    of_run: tuple[dict[str, str], ...] = tuple({} for _ in sources)
    for key, value in parameters.items():
        name, at, run = key.partition("@")
        if not at:
            shared[name] = value
            continue
        for i in places_of(run, sources, f"--parameter {key}: "):
            of_run[i][name] = value
    return shared, of_run
