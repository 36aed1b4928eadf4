"""The tables and keys of experiment.toml."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    PlainSerializer,
    PlainValidator,
    PrivateAttr,
)

from pam_cosim.errors import InputError
from pam_cosim.measurement.place import Place, Stated
from pam_cosim.measurement.start import StartMode
from pam_cosim.measurement.table import Layout


def _value(value: object) -> Stated:
    if isinstance(value, dict):
        raise ValueError('names with a dot need quotes: "component.parameter" = ...')
    if isinstance(value, bool):
        return Stated("true" if value else "false")
    if not isinstance(value, str | int | float):
        raise ValueError(
            'write a text with a unit such as "2.27 kg", or a number where there is no unit'
        )
    try:
        return Stated(value if isinstance(value, str) else float(value))
    except OverflowError:
        raise ValueError("the number is too large") from None


Value = Annotated[Stated, PlainValidator(_value), PlainSerializer(lambda stated: stated.value)]


def _visible(value: str) -> str:
    """Text that is printed as it is, so that it must not steer a terminal."""
    hidden = next((c for c in value if not c.isprintable()), None)
    if hidden is not None:
        raise ValueError(f"the character {ascii(hidden)} is not visible; leave it out")
    return value


def _lines(value: str) -> str:
    _visible(value.replace("\n", "").replace("\t", ""))
    return value


Name = Annotated[str, AfterValidator(_visible)]
Prose = Annotated[str, AfterValidator(_lines)]


class CheckedTable(BaseModel):
    """A table of known keys, of values that are taken as they are; another key is an error."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)
    _place: Place = PrivateAttr(default=Place())
    _shared: dict[str, Place] = PrivateAttr(default_factory=dict)

    def at(self, key: str = "") -> Place:
        """The place of a key, in this table or where it is stated for all; of the table itself without one."""
        return self._shared.get(key, self._place / key if key else self._place)

    def error(self, message: str, key: str = "") -> InputError:
        """An error about a key, or about the table."""
        return self.at(key).error(message)

    def states(self, key: str) -> bool:
        """Whether the table itself has a value of the key."""
        return getattr(self, key) is not None and key not in self._shared

    def completed(self, shared: CheckedTable) -> Self:
        """The table with the values of ``shared``, at their places, for keys that it leaves out."""
        keys = [k for k in type(self).model_fields if getattr(self, k) is None]
        values = {k: v for k in keys if (v := getattr(shared, k, None)) is not None}
        table = self.model_copy(update=values)
        table._shared = {key: shared.at(key) for key in values}
        return table


def located(value: Any, place: Place) -> Any:
    """A value with the place of every table and quantity within."""
    match value:
        case Stated():
            return Stated(value.value, place)
        case CheckedTable():
            keys = {n: f.alias or n for n, f in type(value).model_fields.items()}
            within = {n: located(getattr(value, n), place / key) for n, key in keys.items()}
            copied = value.model_copy(update=within)
            copied._place = place
            return copied
        case dict():
            return {key: located(entry, place / key) for key, entry in value.items()}
        case [CheckedTable(), *_]:
            return [located(entry, place / i) for i, entry in enumerate(value)]
        case list():
            return [located(entry, place) for entry in value]
    return value


class SignalTable(CheckedTable):
    """``[signals.NAME]``."""

    sigma: Value | None = None
    sigma_of_reading: Value | None = None
    repeatability: Value | None = None


class PriorTable(CheckedTable):
    """``prior = { mean = ..., sd = ... }`` of a free parameter."""

    mean: Value
    sd: Value


class FreeTable(CheckedTable):
    """``"NAME" = { min = ..., max = ... }`` under ``[fit]`` or ``[runs.fit]``."""

    min: Value
    max: Value
    start: Value | None = None
    transform: Literal["log", "linear"] | None = None
    prior: PriorTable | None = None


class RecordingTable(CheckedTable):
    """``[recording]`` or ``[runs.recording]``: how files are written, as far as they do not show it."""

    encoding: Name | None = None
    separator: Literal[",", ";", "tab", "blank"] | None = None
    decimal: Literal[".", ","] | None = None
    names: list[Name] | None = None
    header_line: int | None = Field(default=None, ge=1)
    units_line: int | None = Field(default=None, ge=1)
    table: Name | None = None
    interval: Value | None = None
    ignore: list[Name] | None = None
    missing: list[Name] | None = None
    resample: Value | None = None

    def layout(self, **more: Any) -> Layout:
        """How files are written, as far as that is stated; ``more``: what else is known of their columns."""
        alike = ("encoding", "separator", "decimal", "header_line", "units_line", "table")
        return Layout(
            **{key: getattr(self, key) for key in alike},
            names=None if self.names is None else tuple(self.names),
            ignore=tuple(self.ignore or ()),
            missing=frozenset(map(str.casefold, self.missing or ())),
            **more,
        )


class IntervalTable(CheckedTable):
    """``zero = { from = ..., to = ... }`` of a column."""

    start: Value = Field(alias="from")
    to: Value


class ColumnTable(CheckedTable):
    """``NAME = { column = ..., ... }`` under ``[columns]`` or ``[runs.columns]``."""

    column: Name | int | None = None
    unit: Name | None = None
    formula: Name | None = Field(default=None, max_length=300)
    zero: IntervalTable | None = None
    gain: Value | None = None
    offset: Value | None = None
    fit: Literal[True, False, "gain", "offset"] = False
    words: dict[str, Literal["up", "down", "none"]] | None = None


class LoggerTable(CheckedTable):
    """``[[runs.loggers]]``: another file of the same run, by a clock of its own."""

    file: Name
    offset: Value | None = None
    match: Name | None = None
    recording: RecordingTable = RecordingTable()
    columns: dict[str, ColumnTable] = Field(default_factory=dict)


class RunTable(CheckedTable):
    """``[[runs]]``."""

    file: Name
    recording: RecordingTable = RecordingTable()
    columns: dict[str, ColumnTable] = Field(default_factory=dict)
    loggers: list[LoggerTable] = Field(default_factory=list)
    role: Literal["fit", "holdout"] = "fit"
    interpolation: Literal["linear", "previous"] | None = None
    parameters: dict[str, Value] = Field(default_factory=dict)
    fit: dict[str, FreeTable] = Field(default_factory=dict)
    kind: Literal["dynamic", "static"] | None = None
    branch: Literal["up", "down", "none", "order"] | None = None
    hold_out: dict[str, list[Value]] = Field(default_factory=dict)
    start: StartMode | None = None
    before: dict[str, Value] | None = None
    lead: Value | None = None
    periodic: bool | None = None
    gaps: Literal["split", "through"] | None = None
    begin: Value | None = Field(default=None, alias="from")
    end: Value | None = Field(default=None, alias="to")
    _part: int = PrivateAttr(default=0)

    @property
    def name(self) -> str:
        """The path of the file without the suffix, and which part of the file the run is."""
        part = f" part {self._part}" if self._part else ""
        return f"{Path(self.file).with_suffix('').as_posix()}{part}"

    @property
    def between_samples(self) -> Literal["linear", "previous"]:
        """The interpolation of inputs, stated or the default."""
        return self.interpolation or "linear"

    @property
    def is_part(self) -> bool:
        """Whether it is one of several runs of its file."""
        return self._part > 0

    @property
    def is_static(self) -> bool:
        """Whether it holds points at rest, without time."""
        return self.kind == "static"


class EffectsTable(CheckedTable):
    """``[effects]``: families or names of effects."""

    exclude: list[Name] = Field(default_factory=list)
    expect: list[Name] = Field(default_factory=list)


class Experiment(CheckedTable):
    """The whole file."""

    runs: list[RunTable]
    title: Prose = ""
    model: Name | None = None
    pressures: Literal["absolute", "gauge"] | None = None
    kind: Literal["dynamic", "static"] = "dynamic"
    start: StartMode | None = None
    before: dict[str, Value] | None = None
    lead: Value | None = None
    periodic: bool | None = None
    gaps: Literal["split", "through"] | None = None
    recording: RecordingTable = RecordingTable()
    columns: dict[str, ColumnTable] = Field(default_factory=dict)
    signals: dict[str, SignalTable] = Field(default_factory=dict)
    parameters: dict[str, Value] = Field(default_factory=dict)
    fit: dict[str, FreeTable] = Field(default_factory=dict)
    effects: EffectsTable = Field(default_factory=EffectsTable)

    def full_runs(self) -> list[RunTable]:
        """The runs, each with what is stated for all of them."""
        files = Counter(Path(run.file) for run in self.runs)
        runs, parts = [], Counter[Path]()
        for run, file in ((run, Path(run.file)) for run in self.runs):
            recording = run.recording.completed(self.recording)
            update = {"recording": recording, "columns": {**self.columns, **run.columns}}
            full = run.completed(self).model_copy(update=update)
            parts[file] += 1
            full._part = parts[file] if files[file] > 1 else 0
            runs.append(full)
        return runs
