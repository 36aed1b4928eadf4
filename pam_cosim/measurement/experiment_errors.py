"""What is wrong with a key of experiment.toml, in words."""

from __future__ import annotations

from typing import Any, get_args

from pydantic_core import ErrorDetails

from pam_cosim.measurement.experiment_tables import CheckedTable, Experiment
from pam_cosim.measurement.place import KeyPath
from pam_cosim.wording import did_you_mean, shown

_LISTS_OF_TEXTS = {
    ("recording", "names"): '["time [s]", "p [kPa]"]',
    ("recording", "ignore"): '["remark", "raw_*"]',
    ("recording", "missing"): '["-", "-999"]',
    ("effects", "exclude"): '["FAMILY", "EFFECT"], as pam-cosim effects lists them',
    ("effects", "expect"): '["FAMILY", "EFFECT"], as pam-cosim effects lists them',
}


def complaint_of(error: ErrorDetails) -> tuple[KeyPath, str]:
    """Where the error is, and what is wrong there."""
    path, kind = _of_keys(error["loc"]), error["type"]
    key_name = next((part for part in reversed(path) if isinstance(part, str)), None)
    key = "the file" if key_name is None else shown(key_name)
    if kind == "extra_forbidden":
        return path, _unknown_key(path, error["input"])
    if kind == "missing":
        return path, f"{key} is missing{_hint_for_missing(path)}"
    wrong_list = _wrong_list(path, error)
    return path, wrong_list or f"{key}: {_wrong_kind(error, key_name)}"


def _of_keys(path: KeyPath) -> KeyPath:
    """The path without the kind of value that was tried, which stands behind the key of a column."""
    match path:
        case (*_, "columns", _, "column", _):
            return path[:-1]
    return path


def _wrong_list(path: KeyPath, error: ErrorDetails) -> str:
    """What is wrong where a list of something else is needed; "": it is something else."""
    is_list = error["type"] != "list_type"
    place, message = (path[:-1] if is_list else path), ""
    match place:
        case ("runs",) if not is_list:
            return "runs must be a list of tables: write each as [[runs]], in double brackets"
        case (*_, "loggers") if not is_list:
            return "loggers must be a list of tables: write each as [[runs.loggers]], in double brackets"
        case (*_, "hold_out", str(name)) if not is_list:
            return f'{name} must be a list of values such as ["250 kPa"]'
        case (*_, str(table), str(name)) if (table, name) in _LISTS_OF_TEXTS:
            message = f"{name} must be a list of texts such as {_LISTS_OF_TEXTS[table, name]}"
    if not is_list or not message:
        return message
    wrong = error["type"] == "string_type"
    return f"{message}; {shown(error['input'])} is not in quotes" if wrong else ""


def _wrong_kind(error: ErrorDetails, key_name: str | None) -> str:
    value = shown(error["input"])
    match error["type"]:
        case "value_error":
            return str(error["ctx"]["error"])
        case "literal_error":
            return f"{value} is not possible; write {error['ctx']['expected'].lower()}"
        case "string_type" if key_name == "column":
            return f"{value} is neither the name of a column, in quotes, nor its number, such as 2"
        case "string_type":
            return f"{value} is not a text; put it in quotes"
        case "model_type" | "dict_type" | "model_attributes_type":
            return f"{value} is given, but a table of keys is needed"
        case "int_type":
            return f"{value} is not a whole number, without quotes"
        case "bool_type":
            return f"{value} is not possible; write true or false, without quotes"
        case "greater_than_equal":
            return f"{value} is too small; the least is {error['ctx']['ge']}"
        case "list_type":
            return f"{value} is given, but a list in brackets is needed"
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
    keys = [field.alias or name for name, field in _table_of(path).model_fields.items()]
    return f"unknown key {shown(path[-1])}; {did_you_mean(str(path[-1]), keys)}"


def _table_of(path: KeyPath) -> type[CheckedTable]:
    """The table that a key stands in."""
    table: type[CheckedTable] = Experiment
    for key in path[:-1]:
        fields = {field.alias or name: field for name, field in table.model_fields.items()}
        kinds = _tables_in(fields[key].annotation) if key in fields else []
        table = kinds[0] if kinds else table
    return table


def _tables_in(kind: Any) -> list[type[CheckedTable]]:
    """The tables in the type of a key."""
    if isinstance(kind, type) and issubclass(kind, CheckedTable):
        return [kind]
    return [table for within in get_args(kind) for table in _tables_in(within)]
