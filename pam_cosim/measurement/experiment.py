"""The structure of ``experiment.toml``: which tables and keys there are; checked by pydantic.

Units, names and bounds are checked afterwards, against the bench (see ``read``).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, PlainValidator, ValidationError
from pydantic_core import ErrorDetails

from pam_cosim.errors import InputError
from pam_cosim.measurement.start import StartMode
from pam_cosim.measurement.text_file import read_text
from pam_cosim.measurement.toml_text import line_of, parse_toml
from pam_cosim.wording import did_you_mean, shown

FILE_NAME = "experiment.toml"
KeyPath = tuple[str | int, ...]


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


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True, frozen=True)


class SignalTable(_Table):
    """``[signals.NAME]``."""

    sigma: Value | None = None
    sigma_of_reading: Value | None = None
    repeatability: Value | None = None


class PriorTable(_Table):
    """``prior = { mean = ..., sd = ... }`` of a free parameter."""

    mean: Value
    sd: Value


class FreeTable(_Table):
    """``"NAME" = { min = ..., max = ... }`` under ``[fit]`` or ``[runs.fit]``."""

    min: Value
    max: Value
    start: Value | None = None
    transform: Literal["log", "linear"] | None = None
    prior: PriorTable | None = None


class RecordingTable(_Table):
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


class IntervalTable(_Table):
    """``zero = { from = ..., to = ... }`` of a column."""

    start: Value = Field(alias="from")
    to: Value


class ColumnTable(_Table):
    """``NAME = { column = ..., ... }`` under ``[columns]`` or ``[runs.columns]``."""

    column: Name | int | None = None
    unit: Name | None = None
    formula: Name | None = Field(default=None, max_length=300)
    zero: IntervalTable | None = None
    gain: Value | None = None
    offset: Value | None = None
    fit: Literal[True, False, "gain", "offset"] = False
    words: dict[str, Literal["up", "down", "none"]] | None = None


class LoggerTable(_Table):
    """``[[runs.loggers]]``: another file of the same run, by a clock of its own."""

    file: Name
    offset: Value | None = None
    match: Name | None = None
    recording: RecordingTable = RecordingTable()
    columns: dict[str, ColumnTable] = Field(default_factory=dict)


class RunTable(_Table):
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


class EffectsTable(_Table):
    """``[effects]``: families or names of effects."""

    exclude: list[Name] = Field(default_factory=list)
    expect: list[Name] = Field(default_factory=list)


class Experiment(_Table):
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


@dataclass(frozen=True)
class ExperimentFile:
    """``experiment.toml`` as read, with its text, so that a later complaint can name the line."""

    file: Path
    text: str
    content: Experiment

    def error(self, message: str, *path: str | int) -> InputError:
        """An error about the key at ``path``, with its line."""
        return InputError(message, self.file, line_of(self.text, path))


def error_in(folder: Path, message: str, *path: str | int) -> InputError:
    """An error about a key of the data set in a folder, with its line where the file is still there."""
    file = folder / FILE_NAME
    return (
        InputError(message, file, line_of(read_text(file), path))
        if file.is_file()
        else InputError(message, file)
    )


def read_experiment(file: Path) -> ExperimentFile:
    """Reads the file and checks its structure.

    Raises:
        InputError: not readable, not TOML, an unknown or missing key, a value of the wrong kind.
    """
    text = read_text(file)
    data = parse_toml(text, file)
    try:
        return ExperimentFile(file, text, Experiment.model_validate(data))
    except ValidationError as error:
        # An unknown key first: a misspelt key is also a missing one.
        worst = min(
            error.errors(include_url=False), key=lambda one: one["type"] != "extra_forbidden"
        )
        path, message = _complaint(worst)
        raise InputError(message, file, line_of(text, path)) from None


def _complaint(error: ErrorDetails) -> tuple[KeyPath, str]:
    path, kind = error["loc"], error["type"]
    key = shown(path[-1]) if path else "the file"
    if kind == "extra_forbidden":
        return path, _unknown_key(path, error["input"])
    if kind == "missing":
        return path, f"{key} is missing{_hint_for_missing(path)}"
    if path == ("runs",):
        return path, "runs must be a list of tables: write each as [[runs]], in double brackets"
    return path, f"{key}: {_wrong_kind(error)}"


def _wrong_kind(error: ErrorDetails) -> str:
    value = shown(error["input"])
    match error["type"]:
        case "value_error":
            return str(error["ctx"]["error"])
        case "literal_error":
            return f"{value} is not possible; write {error['ctx']['expected']}"
        case "string_type":
            return f"{value} is not a text; put it in quotes"
        case "model_type" | "dict_type" | "model_attributes_type":
            return f"{value} stands where a table of keys is needed"
    return error["msg"]


def _hint_for_missing(path: KeyPath) -> str:
    match path:
        case ("runs",):
            return ': add a table [[runs]] with file = "run-01.csv" for each recording'
        case ("runs", _, "file"):
            return ': add the name of the CSV file, file = "run-01.csv"'
        case ("fit", _, "prior", _) | ("runs", _, "fit", _, "prior", _):
            return ": write prior = { mean = ..., sd = ... }"
        case ("fit", name, _) | ("runs", _, "fit", name, _):
            return f': write {{ min = ..., max = ... }} for the free parameter "{name}"'
    return ""


def _unknown_key(path: KeyPath, value: Any) -> str:
    inner = path[2:] if path[0] == "runs" else path
    if (
        inner
        and inner[0] in ("fit", "signals", "columns")
        and len(inner) > 2
        and isinstance(value, dict)
    ):
        return f'a name with a dot needs quotes: "{inner[1]}.{inner[2]}"'
    known = [field.alias or name for name, field in _table_of(path).model_fields.items()]
    return f"unknown key {shown(path[-1])}; {did_you_mean(str(path[-1]), known)}"


def _table_of(path: KeyPath) -> type[_Table]:
    """The table that a key stands in."""
    within: dict[str | int, type[_Table]] = {
        "prior": PriorTable,
        "zero": IntervalTable,
        "recording": RecordingTable,
    }
    if len(path) > 1 and path[-2] in within:
        return within[path[-2]]
    match path:
        case (*_, "columns", _, _):
            return ColumnTable
        case ("runs", _, "loggers", _, _):
            return LoggerTable
        case ("runs", _, _):
            return RunTable
        case ("fit", _, _) | ("runs", _, "fit", _, _):
            return FreeTable
        case ("signals", _, _):
            return SignalTable
        case ("effects", _):
            return EffectsTable
    return Experiment
