"""Values of parameters that the files tell of a run: start values, loads, ambient conditions."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from pam_cosim.drafting.column_statistics import REST_BAND, is_constant, noise_of, span
from pam_cosim.drafting.feeding import meaning_of
from pam_cosim.drafting.mapped import Mapped, MappedRecording
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.scaling import GRAVITY
from pam_cosim.drafting.stated_value import StatedValue, text_of
from pam_cosim.drafting.vocabulary import Meaning, read_variable
from pam_cosim.drafting.words import UNITS
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import convert, parse_quantity

NONZERO_READING = 5.0  # sd of the noise: a larger reading at rest is not zero

_NUMBER = r"\d+(?:[.,]\d+)?"
_LOAD = re.compile(
    rf"(?<![A-Za-z0-9])(?:(?P<number>{_NUMBER})[ _-]?(?P<unit>[A-Za-z]+)|(?P<first>kg|lbs?)[ _-]?(?P<behind>{_NUMBER}))"
    r"(?![A-Za-z0-9])"
)
_MASSES, _WEIGHTS = ("kg", "g", "lb", "lbs"), ("N", "kN", "lbf")


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
        least = max(REST_BAND * span(values), NONZERO_READING * noise_of(course.time, values))
        if abs(first - usual) > least and first >= low:
            told[name] = StatedValue(text_of(first, unit), first, f"{signal} begins so", True)
    return told


def _signal(
    name: str, meaning: Meaning | None, course: MappedRecording, interface: Interface
) -> str | None:
    """The recorded signal of that name and meaning: a force is a force, imposed as ``F_load`` or not."""
    if meaning is None:
        return None
    variables = {**interface.inputs, **interface.outputs}
    named = [one for one in course.every if name in (one, one.partition("_")[0])]
    alike = [one for one in named if meaning == meaning_of(variables[one])]
    return next((one for one in alike if np.isfinite(course.every[one]).any()), None)


def recorded(
    columns: Sequence[RecordedColumn], interface: Interface, count: int
) -> list[dict[str, StatedValue]]:
    """Loads and ambient conditions that columns hold, by recording, where one parameter only can be meant."""
    told: list[dict[str, StatedValue]] = [{} for _ in range(count)]
    for column in columns:
        meaning = column.meaning
        if meaning is None or not column.unit:
            continue
        is_ambient = "ambient" in meaning.roles
        if meaning.kind != "mass" and not is_ambient:
            continue
        unit = UNITS[meaning.kind]
        alike = _parameters_that_mean(meaning, unit, interface)
        if len(alike) != 1:
            continue
        why = f"{column.name} was recorded, and this is its mean"
        for i, values in column.values.items():
            steady = is_ambient or span(values) == 0.0 or is_constant(values)
            if not steady or not np.isfinite(values).any():
                continue
            mean = float(np.nanmean(convert(values, column.unit, unit)))
            if _is_possible(mean, interface.parameters[alike[0]]):
                told[i][alike[0]] = StatedValue(text_of(mean, unit), mean, why)
    return told


def _is_possible(value: float, parameter: Variable) -> bool:
    """Whether a parameter may have a value: a gauge pressure of the room is none of the atmosphere."""
    low = -np.inf if parameter.min is None else parameter.min
    high = np.inf if parameter.max is None else parameter.max
    return bool(low <= value <= high)


def _parameters_that_mean(meaning: Meaning, unit: str, interface: Interface) -> list[str]:
    """Parameters of a kind; what is around a rig is recorded as it is, and not against itself."""
    same_unit = {name: v for name, v in interface.parameters.items() if v.unit == unit}
    parameters = {n: v for n, v in same_unit.items() if "gauge" not in v.description.casefold()}
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


def in_names(files: Sequence[Path], interface: Interface) -> list[dict[str, StatedValue]]:
    """Loads that the names of the files tell, where one parameter only can be meant.

    Where a force is imposed, a weight is that force and no mass.
    """
    in_kg = {name: v for name, v in interface.parameters.items() if v.unit == "kg"}
    masses = [name for name, v in in_kg.items() if "mass" in v.description.casefold()]
    weights = all(v.unit != "N" for v in interface.inputs.values())
    loads = [_load(file.stem, weights) for file in files]
    stated = [load for load in loads if load is not None]
    if len(masses) != 1 or len(stated) < len(files):
        return [{} for _ in files]
    possible = all(_is_possible(load.number, interface.parameters[masses[0]]) for load in stated)
    return [{masses[0]: load} if possible else {} for load in stated]


def _load(stem: str, weights: bool) -> StatedValue | None:
    """The mass that a name tells, or the ``weights``, as a mass."""
    why = "the file's name says so"
    for match in _LOAD.finditer(stem):
        number = (match["number"] or match["behind"]).replace(",", ".")
        unit = match["unit"] or match["first"]
        said = f"{number} {unit}"
        if unit in _MASSES:
            return StatedValue(said, parse_quantity(said, "kg"), why)
        if unit in _WEIGHTS and weights:
            mass = parse_quantity(said, "N") / parse_quantity(GRAVITY, "m/s2")
            return StatedValue(text_of(mass, "kg"), mass, f"{why}, as a weight of {said}")
    return None
