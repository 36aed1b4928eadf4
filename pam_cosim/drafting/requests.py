"""What the user says beforehand, and what the recordings hold in its light."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from pydantic import ValidationError

from pam_cosim.drafting.clock_columns import even_interval
from pam_cosim.drafting.column_statistics import span
from pam_cosim.drafting.columns import find_columns, with_known_units
from pam_cosim.drafting.direction import with_directions
from pam_cosim.drafting.file_names import quantities
from pam_cosim.drafting.further_clocks import FurtherClock, SeveralClocks, with_one_clock
from pam_cosim.drafting.parts import in_parts
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.sources import RecordingSource, places_of, read_sources
from pam_cosim.drafting.time_column import check_time
from pam_cosim.drafting.vocabulary import AT_REST, Meaning
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.place import Stated
from pam_cosim.units import convert
from pam_cosim.units.grammar import ATMOSPHERES
from pam_cosim.wording import did_you_mean, shown


@dataclass(frozen=True)
class DraftRequests:
    """What the user says beforehand, all optional; see ``study.new``."""

    title: str | None = None
    model: str | None = None
    columns: Mapping[str, str] | None = None
    parameters: Mapping[str, str] | None = None
    recording: Mapping[str, object] | None = None
    muscle: str | None = None
    roles: Mapping[str, str] | None = None


@dataclass(frozen=True)
class ReadRecordings:
    """The recordings as they were read.

    Attributes:
        sources: one for each file, or for each experiment in it.
        columns: of all of them, with what each is.
        time: the one of time; None where an interval is stated.
        recording: as stated.
        asked: names of columns, by the bench's names, as the user says.
        formulas: likewise, of what is no column.
        stated: parameters as texts.
        own: likewise, those that the user states of one recording, by its number.
        points: the recordings are tables of points at rest.
        clocks: further ones in the files, whose samples are here in the rows next to them.
    """

    sources: tuple[RecordingSource, ...]
    columns: tuple[RecordedColumn, ...]
    time: RecordedColumn | None
    recording: RecordingTable
    asked: dict[str, str]
    formulas: dict[str, str]
    stated: dict[str, str]
    own: tuple[dict[str, str], ...] = ()
    points: bool = False
    clocks: tuple[FurtherClock, ...] = ()

    @property
    def ambient_pressure(self) -> RecordedColumn | None:
        """A column that holds it, near that of the standard atmosphere; None: there is none."""
        low, high = ATMOSPHERES
        for column in self.columns:
            if column.of("pressure", "ambient") and column.unit:
                values = convert(column.every, column.unit, "Pa")
                if values.size and bool(((low <= values) & (values <= high)).all()):
                    return column
        return None

    @property
    def files(self) -> list[Path]:
        """Of the user, one for each recording."""
        return [source.file for source in self.sources]


def known(files: Sequence[Path], wishes: DraftRequests) -> ReadRecordings:
    """Reads the recordings and says what their columns are.

    Raises:
        InputError: a file that cannot be read, no time, a wish that cannot be met.
    """
    if not files:
        raise InputError("name the recordings, as data/*.csv")
    _check_different(files)
    recording = recording_table(wishes.recording or {})
    sources = read_sources(files, recording)
    names = {name for source in sources for name in source.table.columns}
    wanted = wishes.columns or {}
    asked = {name: column for name, column in wanted.items() if column in names}
    formulas = {name: text for name, text in wanted.items() if text not in names}
    _check_asked(formulas, names)
    sources, columns, time, clocks = _on_one_clock(sources, asked, formulas, recording)
    parts = sources if time is None or clocks else in_parts(sources, time)
    if len(parts) > len(sources):
        sources = parts
        columns, time = _recognised(sources, asked, formulas, recording)
    # rows of several experiments are not evenly apart
    is_whole = all(source.part is None for source in sources) and not clocks
    interval = None
    if time is not None and is_whole:
        interval = even_interval([convert(v, time.unit, "s") for v in time.values.values()])
    if time is not None and interval is not None:
        columns = [_coarse(c, interval) if c is time else c for c in columns]
        time, recording = None, recording.model_copy(update={"interval": Stated(interval)})
    points = time is None and recording.interval is None
    if points:
        columns = _as_points(columns)
    stated, own = _stated(wishes.parameters or {}, sources)
    recording = _with_missing(recording, sources)
    return ReadRecordings(
        tuple(sources),
        tuple(columns),
        time,
        recording,
        asked,
        formulas,
        stated,
        own,
        points,
        tuple(clocks),
    )


def _on_one_clock(
    sources: Sequence[RecordingSource],
    asked: Mapping[str, str],
    formulas: Mapping[str, str],
    recording: RecordingTable,
) -> tuple[list[RecordingSource], list[RecordedColumn], RecordedColumn | None, list[FurtherClock]]:
    """The recordings with one clock, what their columns are, the one of time, and the further clocks.

    Raises:
        InputError: as ``_recognised``; several clocks that a formula takes columns of.
    """
    clocks: list[FurtherClock] = []
    while True:
        try:
            return list(sources), *_recognised(sources, asked, formulas, recording), clocks
        except SeveralClocks as found:
            if formulas:
                raise
            sources, clock = with_one_clock(sources, found)
            if clock in clocks:
                raise
            clocks.append(clock)


def _recognised(
    sources: Sequence[RecordingSource],
    asked: Mapping[str, str],
    formulas: Mapping[str, str],
    recording: RecordingTable,
) -> tuple[list[RecordedColumn], RecordedColumn | None]:
    """The columns and what each is, and the one of time."""
    columns = find_columns(sources, asked)
    columns = with_known_units(columns, formulas.values(), sources, asked.values())
    rows = [len(next(iter(one.table.columns.values())).values) for one in sources]
    columns += quantities([one.file for one in sources], columns, rows)
    return columns, check_time(columns, sources, recording)


def _coarse(time: RecordedColumn, interval: str) -> RecordedColumn:
    """The clock, which is no time any more."""
    values = next(iter(time.values.values()))
    rows, times = len(values), len(np.unique(values))
    why = f"a clock too coarse, {rows} rows at {times} times: the rows are taken to be {interval} apart"
    return replace(time, meaning=None, why=(why,))


def _check_different(files: Sequence[Path]) -> None:
    """Raises InputError where a file is named twice: its samples would count twice."""
    seen: set[Path] = set()
    for file in files:
        place = file.resolve()
        if place in seen:
            raise InputError("the file is named twice", file)
        seen.add(place)


def _as_points(columns: Sequence[RecordedColumn]) -> list[RecordedColumn]:
    """The columns of tables of points at rest: directions have a sense, a pressure was reached, a mass was hung on."""
    set_, plain = Meaning("pressure", frozenset({"set"})), Meaning("pressure")
    made = [replace(c, points=True) for c in with_directions(columns)]
    made = _with_rest(made)
    made = _instead(made, set_, plain, "a set point, taken as reached")
    return _instead(made, Meaning("mass"), Meaning("force"), "the load of each row")


def _with_rest(columns: list[RecordedColumn]) -> list[RecordedColumn]:
    """The columns, of which a length that does not change beside a contraction is that of the muscle at rest."""
    varying = [
        c for c in columns if c.meaning is not None and c.meaning.kind in ("contraction", "ratio")
    ]
    if not varying:
        return columns
    still = [
        c
        for c in columns
        if c.of("length") and all(span(values) == 0.0 for values in c.values.values())
    ]
    why = f"it does not change, and '{varying[0].name}' does"
    return [replace(c, meaning=AT_REST, why=(*c.why, why)) if c in still else c for c in columns]


def _instead(
    columns: list[RecordedColumn], other: Meaning, wanted: Meaning, why: str
) -> list[RecordedColumn]:
    """The columns, of which one that means another thing serves where none means what is wanted."""
    if any(c.meaning == wanted for c in columns):
        return columns
    return [
        replace(c, meaning=wanted, why=(*c.why, why)) if c.meaning == other and c.unit else c
        for c in columns
    ]


def _stated(
    parameters: Mapping[str, str], sources: Sequence[RecordingSource]
) -> tuple[dict[str, str], tuple[dict[str, str], ...]]:
    """Parameters of all recordings, and those of one, ``NAME@RECORDING``."""
    shared: dict[str, str] = {}
    own: tuple[dict[str, str], ...] = tuple({} for _ in sources)
    for key, value in parameters.items():
        name, at, run = key.partition("@")
        if not at:
            shared[name] = value
            continue
        for i in places_of(run, sources, f"--parameter {key}: "):
            own[i][name] = value
    return shared, own


def _with_missing(recording: RecordingTable, sources: Sequence[RecordingSource]) -> RecordingTable:
    """What is stated of the files, with the words for missing samples that they have."""
    words = list(dict.fromkeys(word for source in sources for word in source.table.missing))
    return recording.model_copy(update={"missing": words}) if words else recording


def recording_table(settings: Mapping[str, object]) -> RecordingTable:
    """What the user says of ``[recording]``.

    Raises:
        InputError: there is no such key, or its value cannot be used.
    """
    known = [name for name in RecordingTable.model_fields if name != "resample"]
    for name in settings:
        if name not in known:
            raise InputError(
                f"there is no key {shown(name)} of [recording]; {did_you_mean(name, known)}"
            )
    made = {
        name: int(str(value))
        if name.endswith("_line") and str(value).isdecimal()
        else _listed(name, value)
        for name, value in settings.items()
    }
    try:
        return RecordingTable.model_validate(made)
    except ValidationError as error:
        one = error.errors(include_url=False)[0]
        raise InputError(
            f"[recording] {one['loc'][0]}: {shown(one['input'])} cannot be used: {one['msg']}"
        ) from None


def _listed(name: str, value: object) -> object:
    """A list as it is written with commas, or as ``experiment.toml`` has it."""
    if name not in ("names", "ignore", "missing") or not isinstance(value, str):
        return value
    if value.strip().startswith("["):
        with suppress(tomllib.TOMLDecodeError):
            return tomllib.loads(f"list = {value}")["list"]
    return [one.strip() for one in value.split(",")]


def _check_asked(formulas: Mapping[str, str], names: set[str]) -> None:
    """A text that is no column must hold one, or an operator: else it is a misspelt name."""
    for name, text in formulas.items():
        if name == "time" or not re.search(r"[-+*/^('\"]", text):
            raise InputError(
                f"--column {name}: no file has a column {shown(text)}; {did_you_mean(text, names)}"
            )
