"""What is wrong with a key of experiment.toml, in words."""

from __future__ import annotations

from typing import Any

from pydantic_core import ErrorDetails

from pam_cosim.measurement.experiment_tables import (
    CheckedTable,
    ColumnTable,
    EffectsTable,
    Experiment,
    FreeTable,
    IntervalTable,
    LoggerTable,
    PriorTable,
    RecordingTable,
    RunTable,
    SignalTable,
)
from pam_cosim.wording import did_you_mean, shown

KeyPath = tuple[str | int, ...]


def complaint_of(error: ErrorDetails) -> tuple[KeyPath, str]:
    """Where the error is, and what is wrong there."""
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


def _table_of(path: KeyPath) -> type[CheckedTable]:
    """The table that a key stands in."""
    within: dict[str | int, type[CheckedTable]] = {
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
