"""Parameters: what the user states, what the files say of a run, what stays to be stated, what is left free."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.bench_choice import meaning_of
from pam_cosim.drafting.mapped import Mapped, MappedRecording
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.rest import is_constant, noise_of, span
from pam_cosim.drafting.vocabulary import Meaning, fits, read_variable
from pam_cosim.drafting.words import UNITS
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, convert, parse_quantity, readable_factor, readable_unit

_C = CRITERIA.recognition
# What a rule, scales, a thermometer or a gauge tells, or the maker's drawing: it is stated, not fitted.
_MEASURED = ("m", "m2", "m3", "kg", "kg.m2", "K", "Pa", "N")
_OPEN = (
    "calibration",
    "effective area",
    "discharge coefficient",
    "pressure lost per mass flow",
    "time constant",
)
_PERHAPS = ("polytropic", "coefficient of friction", "film coefficient", "damping", "friction")
_CHOSEN = ("filter",)
# What lies in the rubber of a muscle, where no rule reaches: of the fibres, and of the wall.
_OF_FIBRES, _OF_WALLS = (
    ("fibres lie", "fibres and axis"),
    ("wall takes", "bent open", "the muscle pulls"),
)
_GEOMETRY = ("m", "m2", "m3", "kg", "kg.m2", "1", "")
_IN_NAME = re.compile(r"(?<![A-Za-z0-9])(\d+(?:[.,]\d+)?)[ _-]?([A-Za-z]+)(?![A-Za-z])")


@dataclass(frozen=True)
class StatedValue:
    """A value that is known of one recording: as text for the file, and why."""

    value: str
    number: float
    why: str


def text_of(value: float, unit: str) -> str:
    """A value [SI] as ``experiment.toml`` has it, in a unit that is easy to read."""
    number = f"{value * readable_factor(unit):.6g}"
    shown = readable_unit(unit)
    shown = {"mm²": "mm2", "L": "l"}.get(shown, shown)
    return f"{number} {shown}".strip()


def starts(course: MappedRecording, interface: Interface) -> dict[str, StatedValue]:
    """Start values that a recording tells: what is called ``NAME_start`` and is of its kind begins as NAME begins."""
    told = {}
    for name, parameter in interface.parameters.items():
        short = name.rpartition(".")[2]
        meaning = read_variable(short, parameter.description, parameter.unit)
        signal = _signal(short.removesuffix("_start"), meaning, course, interface)
        if not short.endswith("_start") or signal is None:
            continue
        values, unit = course.every[signal], parameter.unit
        rest = course.first_rest
        part = values[rest.start : rest.stop] if rest else values[np.isfinite(values)][:1]
        first, usual = float(np.nanmean(part)), parameter.start or 0.0
        low = -np.inf if parameter.min is None else parameter.min
        if (
            abs(first - usual)
            > max(_C.still * span(values), _C.away * noise_of(course.time, values))
            and first >= low
        ):
            told[name] = StatedValue(text_of(first, unit), first, f"{signal} begins so")
    return told


def _signal(
    name: str, meaning: Meaning | None, course: MappedRecording, interface: Interface
) -> str | None:
    """The recorded signal of that name and meaning: a force is a force, imposed as ``F_load`` or not."""
    variables = {**interface.inputs, **interface.outputs}
    alike = [
        one
        for one, values in course.every.items()
        if name in (one, one.partition("_")[0])
        and meaning is not None
        and meaning == meaning_of(variables[one])
        and np.isfinite(values).any()
    ]
    return alike[0] if alike else None


def recorded(
    columns: Sequence[RecordedColumn], interface: Interface, count: int
) -> list[dict[str, StatedValue]]:
    """Loads and ambient conditions that columns hold, by recording, where one parameter only can be meant."""
    told: list[dict[str, StatedValue]] = [{} for _ in range(count)]
    for column in columns:
        meaning = column.meaning
        if (
            meaning is None
            or not column.unit
            or not (meaning.kind == "mass" or "ambient" in meaning.roles)
        ):
            continue
        unit = UNITS[meaning.kind]
        alike = _parameters_that_mean(meaning, unit, interface)
        if len(alike) != 1:
            continue
        why = f"{column.name} was recorded, and this is its mean"
        for i, values in column.values.items():
            steady = "ambient" in meaning.roles or span(values) == 0.0 or is_constant(values)
            if steady and np.isfinite(values).any():
                mean = float(np.nanmean(convert(values, column.unit, unit)))
                told[i][alike[0]] = StatedValue(text_of(mean, unit), mean, why)
    return told


def _parameters_that_mean(meaning: Meaning, unit: str, interface: Interface) -> list[str]:
    parameters = {name: v for name, v in interface.parameters.items() if v.unit == unit}
    return [
        name
        for name, v in parameters.items()
        if read_variable(name.rpartition(".")[2], v.description, v.unit) == meaning
    ]


def constant_values(mapped: Mapped, recording: int, interface: Interface) -> dict[str, StatedValue]:
    """Inputs that the name of a recording's file tells."""
    told = {}
    for name, entry in mapped.entries.items():
        if recording in entry.held:
            value = entry.held[recording]
            told[name] = StatedValue(
                text_of(value, interface.inputs[name].unit), value, "; ".join(entry.why)
            )
    return told


def stated(own: Mapping[str, str], interface: Interface) -> dict[str, StatedValue]:
    """What the user states of one recording."""
    variables = {**interface.parameters, **interface.inputs}
    return {
        name: StatedValue(
            value, parse_quantity(value, variables[name].unit) if name in variables else 0.0, ""
        )
        for name, value in own.items()
    }


def in_names(files: Sequence[Path], interface: Interface) -> list[dict[str, StatedValue]]:
    """Loads that the names of the files tell, where they differ and one parameter only can be meant."""
    masses = [
        n
        for n, v in interface.parameters.items()
        if v.unit == "kg" and "mass" in v.description.casefold()
    ]
    if len(masses) != 1:
        return [{} for _ in files]
    found = [_mass(file.stem) for file in files]
    if any(one is None for one in found):
        return [{} for _ in files]
    why = "the file's name says so"
    return [
        {masses[0]: StatedValue(one, parse_quantity(one, "kg"), why)}
        for one in found
        if one is not None
    ]


def _mass(stem: str) -> str | None:
    for number, unit in _IN_NAME.findall(stem):
        if unit in ("kg", "g") and fits(unit, "mass"):
            return f"{number.replace(',', '.')} {unit}"
    return None


def to_state(interface: Interface, points: bool = False) -> dict[str, Variable]:
    """Parameters that somebody with a rule and scales can state, of parts that stand in the bench itself.

    Args:
        points: points at rest were recorded, which depend on sizes and loads alone.
    """
    return {
        name: v
        for name, v in interface.parameters.items()
        if v.start is not None
        and name.count(".") <= 1
        and not name.endswith("_start")
        and v.min is not None
        and name not in {*free(interface), *perhaps(interface)}
        and (is_geometry(v) or not points)
        and not any(word in v.description.casefold() for word in _CHOSEN)
    }


def is_geometry(variable: Variable) -> bool:
    """Whether it is of a size, a count or a mass."""
    return variable.unit in _GEOMETRY


def free(interface: Interface, points: bool = False) -> dict[str, Variable]:
    """Parameters that only a fit tells: calibrations, discharge, lag and droop, by what is said of them.

    Args:
        points: points at rest were recorded, which tell what lies in the rubber of a muscle, nothing that takes time.
    """
    return hidden(interface) if points else _told_by_fit(interface, _OPEN)


def perhaps(interface: Interface, points: bool = False) -> dict[str, Variable]:
    """Others that may be left free."""
    told = _told_by_fit(interface, _PERHAPS)
    if points:
        return {n: v for n, v in told.items() if "friction" in v.description.casefold()}
    return {**told, **hidden(interface)}


def hidden(interface: Interface) -> dict[str, Variable]:
    """Measures within the wall of a muscle that has one: where its fibres lie, and what the wall takes of its pull."""
    walls = _inside(interface, _OF_WALLS)
    owners = {name.rpartition(".")[0].rpartition(".")[0] for name in walls}
    fibres = _inside(interface, _OF_FIBRES)
    near = {
        n: _nearby(v)
        for n, v in fibres.items()
        if v.start and n.rpartition(".")[0].rpartition(".")[0] in owners
    }
    return {**near, **walls}


def _inside(interface: Interface, words: Sequence[str]) -> dict[str, Variable]:
    return {
        name: v
        for name, v in interface.parameters.items()
        if name.count(".") == 2
        and v.min is not None
        and v.max is not None
        and any(w in v.description for w in words)
    }


def _nearby(variable: Variable) -> Variable:
    """The variable with bounds about its value: those of a measure that may be zero, not stated, are no help."""
    assert variable.start is not None
    low, high = (
        variable.start * (1.0 - _C.near_data_sheet),
        variable.start * (1.0 + _C.near_data_sheet),
    )
    return replace(variable, min=low, max=high)


def _told_by_fit(interface: Interface, words: Sequence[str]) -> dict[str, Variable]:
    return {
        name: v
        for name, v in interface.parameters.items()
        if v.min is not None
        and v.max is not None
        and v.unit not in _MEASURED
        and name.count(".") == 1
        and any(word in v.description.casefold() for word in words)
        and not any(word in v.description.casefold() for word in _CHOSEN)
    }


def check(stated: Mapping[str, str], interface: Interface) -> None:
    """Raises UnitError where a stated value has a unit that does not fit; names are checked when all is read."""
    for name, value in stated.items():
        variable = {**interface.parameters, **interface.inputs}.get(name)
        if variable is not None:
            try:
                parse_quantity(value, variable.unit)
            except UnitError as error:
                raise UnitError(f"{name}: {error}") from None
