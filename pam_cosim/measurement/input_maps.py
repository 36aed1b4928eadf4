"""What ``experiment.toml`` states of inputs that were not measured themselves: fitted maps and free constants."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pam_cosim.measurement.experiment_tables import (
    ColumnTable,
    Experiment,
    FreeTable,
    located,
)
from pam_cosim.model.input_map import InputMap, constant_of, gain_of, offset_of, raw_of
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, parse_quantity, quotient

_RECORDED_IN = ("V", "A", "1", "Pa", "m", "N", "Hz", "rad")
"""Units of what may be recorded in the place of an input, in addition to its own."""


def input_maps(experiment: Experiment, interface: Interface) -> list[InputMap]:
    """The maps and constants that the model itself does not have yet.

    Raises:
        InputError: a gain or an offset whose unit does not fit, or that is stated where it cannot be fitted.
    """
    maps = []
    for name, table in experiment.columns.items():
        if table.fit and name in interface.inputs:
            maps.append(_map(interface.inputs[name], table))
        elif table.fit and raw_of(name) not in interface.inputs:
            message = f"only the map of an input can be fitted, and {interface.model} has no input '{name}'"
            raise table.error(message, "fit")
    for table in (table for run in experiment.runs for table in run.columns.values() if table.fit):
        message = "a map that is fitted is one for all runs: state it under [columns]"
        raise table.error(message, "fit")
    free = dict.fromkeys([*experiment.fit, *(name for run in experiment.runs for name in run.fit)])
    for variable in (interface.inputs[name] for name in free if name in interface.inputs):
        stated = experiment.parameters.get(variable.name)
        value = stated.quantity(variable.unit) if stated else variable.start or 0.0
        maps.append(InputMap(variable.name, variable.unit, None, 0.0, value))
    return maps


def with_names_of_maps(experiment: Experiment, interface: Interface) -> Experiment:
    """The experiment by the names of the model that has the maps: raw inputs, gains, offsets, constants.

    Args:
        experiment: by the names of the inputs.
        interface: of the model with the maps.
    """
    mapped = {name: table for name, table in experiment.columns.items() if table.fit}
    raw = {name: raw_of(name) for name in mapped}
    constants = _constants(experiment, interface)
    free: dict[str, FreeTable] = {}
    for name, table in mapped.items():
        free |= _free(name, table, interface)
    renamed: Experiment = _by_names(experiment, raw, constants)
    return renamed.model_copy(update={"fit": {**free, **renamed.fit}})


def _constants(experiment: Experiment, interface: Interface) -> dict[str, str]:
    """What the maps call a parameter that is stated or free."""
    of_runs = [name for run in experiment.runs for name in run.fit]
    stated = dict.fromkeys([*experiment.parameters, *experiment.fit, *of_runs])
    names = {name: constant_of(name) for name in stated if name not in interface.inputs}
    return {name: constant for name, constant in names.items() if constant in interface.parameters}


def _by_names(table: Any, raw: Mapping[str, str], constants: Mapping[str, str]) -> Any:
    """The experiment, a run or a logger, and those within, by the names of the model that has the maps."""
    update: dict[str, Any] = {"columns": _columns(table.columns, raw)}
    for key in ("runs", "loggers", "parameters", "fit"):
        within = getattr(table, key, None)
        if isinstance(within, dict):
            update[key] = {constants.get(name, name): value for name, value in within.items()}
        elif within is not None:
            update[key] = [_by_names(part, raw, constants) for part in within]
    return table.model_copy(update=update)


def _columns(columns: Mapping[str, ColumnTable], raw: Mapping[str, str]) -> dict[str, ColumnTable]:
    """Columns of inputs with a map are read as they were recorded."""
    renamed = dict[str, ColumnTable]()
    for name, table in columns.items():
        update: dict[str, Any] = {"gain": None, "offset": None, "fit": False}
        if not table.formula:
            update["column"] = name if table.column is None else table.column
        renamed[raw.get(name, name)] = table.model_copy(update=update if name in raw else {})
    return renamed


def _map(variable: Variable, table: ColumnTable) -> InputMap:
    gain = table.gain.value if table.gain else 1.0
    for raw in dict.fromkeys((variable.unit, *_RECORDED_IN)):
        try:
            factor = parse_quantity(gain, quotient(variable.unit, raw))
        except UnitError:
            continue
        if factor == 0.0:
            raise table.error(f"the gain of {variable.name} must not be zero", "gain")
        same_unit = raw == variable.unit  # a temperature is shifted by a difference
        shift = table.offset.quantity(variable.unit, difference=same_unit) if table.offset else 0.0
        return InputMap(variable.name, variable.unit, raw, factor, shift)
    message = f'gain of {variable.name}: {gain} does not fit; write for example "0.05 {quotient(variable.unit, "V")}"'
    raise table.error(message, "gain")


def _free(name: str, table: ColumnTable, interface: Interface) -> dict[str, FreeTable]:
    """Gain and offset as free parameters: within a factor of two, and half of what such an input usually is."""
    place = table.at("fit")
    gain, offset = (
        interface.parameters.get(gain_of(name)),
        interface.parameters.get(offset_of(name)),
    )
    if gain is None or offset is None:
        raise place.error(f"{interface.model} has no map of {name} that could be fitted")
    input_map = _map(Variable(name, offset.unit), table)
    low, high = sorted((input_map.gain / 2, input_map.gain * 2))
    span = _usual(interface, offset.unit) / 2 or abs(input_map.gain)
    ends = {
        gain_of(name): (low, high, input_map.gain, gain.unit),
        offset_of(name): (
            input_map.offset - span,
            input_map.offset + span,
            input_map.offset,
            offset.unit,
        ),
    }
    chosen = {"gain": [gain_of(name)], "offset": [offset_of(name)]}.get(str(table.fit), list(ends))
    free_tables = {}
    for key in chosen:
        *numbers, unit = ends[key]
        values = [number if unit in ("", "1") else f"{number!r} {unit}" for number in numbers]
        keys = dict(zip(("min", "max", "start"), values, strict=True))
        free_tables[key] = located(FreeTable.model_validate(keys), place)
    return free_tables


def _usual(interface: Interface, unit: str) -> float:
    """The largest default of an input of this unit, through its map where it has one."""
    sizes = [abs(v.start or 0.0) for v in interface.inputs.values() if v.unit == unit]
    for name, v in interface.parameters.items():
        gain = interface.parameters.get(gain_of(name.removesuffix(offset_of(""))))
        raw = interface.inputs.get(raw_of(name.removesuffix(offset_of(""))))
        if v.unit == unit and gain is not None and raw is not None:
            sizes.append(abs((gain.start or 0.0) * (raw.start or 0.0) + (v.start or 0.0)))
    return max(sizes, default=0.0)
