"""The tables and keys of experiment.toml."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, PlainValidator

from pam_cosim.measurement.start import StartMode


def _value(value: object) -> str | float:
    if isinstance(value, dict):
        raise ValueError('names with a dot need quotes: "component.parameter" = ...')
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise ValueError(
            'write a text with a unit such as "2.27 kg", or a number where there is no unit'
        )
    try:
        return value if isinstance(value, str) else float(value)
    except OverflowError:
        raise ValueError("the number is too large") from None


Value = Annotated[str | float, PlainValidator(_value)]


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
    interpolation: Literal["linear", "previous"] = "linear"
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


class EffectsTable(CheckedTable):
    """``[effects]``: families or names of effects."""

    exclude: list[Name] = Field(default_factory=list)
    expect: list[Name] = Field(default_factory=list)


class Experiment(CheckedTable):
    """The whole file."""

    runs: list[RunTable]
    title: Prose = ""
    model: Name | None = None
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
