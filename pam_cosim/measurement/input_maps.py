"""What ``experiment.toml`` says of inputs that were not measured themselves: fitted maps and free constants."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from pam_cosim.measurement.experiment import ExperimentFile
from pam_cosim.measurement.experiment_tables import (
    ColumnTable,
    Experiment,
    FreeTable,
    RunTable,
    Value,
)
from pam_cosim.model.input_map import InputMap, constant_of, gain_of, offset_of, raw_of
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, parse_quantity, quotient

_RECORDED_IN = ("V", "A", "1", "Pa", "m", "N", "Hz", "rad")
"""Units of what may be recorded in the place of an input, besides its own."""


def input_maps(document: ExperimentFile, interface: Interface) -> list[InputMap]:
    """The maps and constants that the model itself does not have yet.

    Raises:
        InputError: a gain or an offset whose unit does not fit, or that is stated where it cannot be fitted.
    """
    maps = []
    for name, table in document.content.columns.items():
        if table.fit and name in interface.inputs:
            maps.append(_map(document, interface.inputs[name], table))
        elif table.fit and raw_of(name) not in interface.inputs:
            message = f"only the map of an input can be fitted, and {interface.model} has no input '{name}'"
            raise document.error(message, "columns", name, "fit")
    for index, run in enumerate(document.content.runs):
        for name, table in run.columns.items():
            if table.fit:
                message = "a map that is fitted is one for all runs: state it under [columns]"
                raise document.error(message, "runs", index, "columns", name, "fit")
    return maps + [
        _constant(document, interface.inputs[name]) for name in _free_inputs(document, interface)
    ]


def with_names_of_maps(document: ExperimentFile, interface: Interface) -> ExperimentFile:
    """The document by the names of the model that has the maps: raw inputs, gains, offsets, constants.

    Args:
        document: by the names of the inputs.
        interface: of the model with the maps.
    """
    content = document.content
    mapped = {name: table for name, table in content.columns.items() if table.fit}
    raw = {name: raw_of(name) for name in mapped}
    constants = _constants(content, interface)
    free: dict[str, Any] = {}
    for name, table in mapped.items():
        free |= _free(document, name, table, interface)
    runs = [_run(run, raw, constants) for run in content.runs]
    return replace(
        document,
        content=content.model_copy(
            update={
                "columns": _columns(content.columns, raw),
                "parameters": _renamed(content.parameters, constants),
                "fit": {**free, **_renamed(content.fit, constants)},
                "runs": runs,
            }
        ),
    )


def _constants(content: Experiment, interface: Interface) -> dict[str, str]:
    """What the maps call a parameter that the document states or leaves free."""
    of_runs = [name for run in content.runs for name in run.fit]
    stated = dict.fromkeys([*content.parameters, *content.fit, *of_runs])
    names = {name: constant_of(name) for name in stated if name not in interface.inputs}
    return {name: constant for name, constant in names.items() if constant in interface.parameters}


def _run(run: RunTable, raw: Mapping[str, str], constants: Mapping[str, str]) -> RunTable:
    return run.model_copy(
        update={
            "columns": _columns(run.columns, raw),
            "parameters": _renamed(run.parameters, constants),
            "fit": _renamed(run.fit, constants),
            "loggers": [
                logger.model_copy(update={"columns": _columns(logger.columns, raw)})
                for logger in run.loggers
            ],
        }
    )


def _columns(columns: Mapping[str, ColumnTable], raw: Mapping[str, str]) -> dict[str, ColumnTable]:
    """Columns of inputs with a map are read as they were recorded."""
    renamed: dict[str, ColumnTable] = {}
    for name, table in columns.items():
        renamed[raw.get(name, name)] = _as_recorded(name, table) if name in raw else table
    return renamed


def _as_recorded(name: str, table: ColumnTable) -> ColumnTable:
    update: dict[str, Any] = {"gain": None, "offset": None, "fit": False}
    if not table.formula:
        update["column"] = name if table.column is None else table.column
    return table.model_copy(update=update)


def _renamed(table: Mapping[str, Any], names: Mapping[str, str]) -> dict[str, Any]:
    return {names.get(name, name): value for name, value in table.items()}


def _free_inputs(document: ExperimentFile, interface: Interface) -> list[str]:
    content = document.content
    asked = [*content.fit, *(name for run in content.runs for name in run.fit)]
    return [name for name in dict.fromkeys(asked) if name in interface.inputs]


def _constant(document: ExperimentFile, known: Variable) -> InputMap:
    stated = document.content.parameters.get(known.name)
    value = known.start or 0.0
    if stated is not None:
        value = _quantity(document, stated, known.unit, "parameters", known.name)
    return InputMap(known.name, known.unit, None, 0.0, value)


def _map(document: ExperimentFile, known: Variable, table: ColumnTable) -> InputMap:
    path = ("columns", known.name)
    gain, offset = 1.0 if table.gain is None else table.gain, table.offset
    for raw in dict.fromkeys((known.unit, *_RECORDED_IN)):
        try:
            factor = parse_quantity(gain, quotient(known.unit, raw))
        except UnitError:
            continue
        if factor == 0.0:
            raise document.error(f"the gain of {known.name} must not be zero", *path, "gain")
        same = raw == known.unit  # a temperature is shifted by a difference
        shift = 0.0
        if offset is not None:
            shift = _quantity(document, offset, known.unit, *path, "offset", difference=same)
        return InputMap(known.name, known.unit, raw, factor, shift)
    message = f'gain of {known.name}: {gain} does not fit; write for example "0.05 {quotient(known.unit, "V")}"'
    raise document.error(message, *path, "gain")


def _free(
    document: ExperimentFile, name: str, table: ColumnTable, interface: Interface
) -> dict[str, FreeTable]:
    """Gain and offset as free parameters: within a factor of two, and half of what such an input usually is."""
    gain, offset = (
        interface.parameters.get(gain_of(name)),
        interface.parameters.get(offset_of(name)),
    )
    if gain is None or offset is None:
        raise document.error(
            f"{interface.model} has no map of {name} that could be fitted", "columns", name, "fit"
        )
    one = _map(document, Variable(name, offset.unit), table)
    low, high = sorted((one.gain / 2, one.gain * 2))
    span = _usual(interface, offset.unit) / 2 or abs(one.gain)
    ends = {
        gain_of(name): (low, high, one.gain, gain.unit),
        offset_of(name): (one.offset - span, one.offset + span, one.offset, offset.unit),
    }
    chosen = {"gain": [gain_of(name)], "offset": [offset_of(name)]}.get(str(table.fit), list(ends))
    return {
        key: FreeTable(min=_text(low, unit), max=_text(high, unit), start=_text(start, unit))
        for key, (low, high, start, unit) in ends.items()
        if key in chosen
    }


def _usual(interface: Interface, unit: str) -> float:
    """The largest default of an input of this unit, through its map where it has one."""
    sizes = [abs(v.start or 0.0) for v in interface.inputs.values() if v.unit == unit]
    for name, v in interface.parameters.items():
        gain = interface.parameters.get(gain_of(name.removesuffix(offset_of(""))))
        raw = interface.inputs.get(raw_of(name.removesuffix(offset_of(""))))
        if v.unit == unit and gain is not None and raw is not None:
            sizes.append(abs((gain.start or 0.0) * (raw.start or 0.0) + (v.start or 0.0)))
    return max(sizes, default=0.0)


def _text(value: float, unit: str) -> Value:
    return value if unit in ("", "1") else f"{value!r} {unit}"


def _quantity(
    document: ExperimentFile, value: Value, unit: str, *path: str, difference: bool = False
) -> float:
    try:
        number = parse_quantity(value, unit, difference=difference)
    except UnitError as error:
        raise document.error(f"{path[-1]}: {error}", *path) from None
    return number
