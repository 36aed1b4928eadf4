"""Words of the command line that stand for numbers and inputs."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from pam_cosim.errors import InputError
from pam_cosim.interface import Interface, Variable
from pam_cosim.measurement import UnitError, quantity, read_recording
from pam_cosim.measurement.wording import did_you_mean
from pam_cosim.simulation import Inputs


def parse_settings(settings: Sequence[str], interface: Interface) -> dict[str, float]:
    """``NAME=VALUE`` words to parameters [SI]; a value without a unit is in the model's own unit.

    Raises:
        InputError: not of that form, an unknown parameter, a value out of range or of another dimension.
    """
    values = {}
    for word in settings:
        name, text = _split(word, "NAME=VALUE, such as load.m='5 kg'")
        values[name] = _value(text, _parameter(name, interface), word)
    return values


def parse_variations(words: Sequence[str], interface: Interface) -> dict[str, list[float]]:
    """``NAME=FROM:TO:N`` or ``NAME=A,B,C`` words to lists of parameter values [SI].

    Raises:
        InputError: as ``parse_settings``.
    """
    found: dict[str, list[float]] = {}
    for word in words:
        name, text = _split(word, "NAME=FROM:TO:N or NAME=A,B,C")
        variable = _parameter(name, interface)
        if name in found:
            raise InputError(f"'{name}' is varied twice")
        if ":" in text:
            parts = text.split(":")
            if len(parts) != 3 or not parts[2].strip().isdigit() or int(parts[2]) < 1:
                raise InputError(f"'{word}': write FROM:TO:N, such as load.m=1:10:5")
            low, high = (_value(p, variable, word) for p in parts[:2])
            found[name] = [float(v) for v in np.linspace(low, high, int(parts[2]))]
        else:
            found[name] = [_value(p, variable, word) for p in text.split(",")]
    return found


def read_inputs(file: Path, interface: Interface) -> Inputs:
    """The input columns of a CSV file, as inputs of a model.

    Raises:
        InputError: the file cannot be read or has no input column.
    """
    recording = read_recording(file, interface)
    if not recording.inputs:
        known = ", ".join(interface.inputs) or "none"
        raise InputError(f"has no column of an input; the inputs of {interface.model}: {known}", file, 1)
    return Inputs(recording.time, recording.inputs, "linear")


def _split(word: str, form: str) -> tuple[str, str]:
    name, equals, text = word.partition("=")
    if not equals or not name.strip() or not text.strip():
        raise InputError(f"'{word}': write {form}")
    return name.strip(), text.strip()


def _parameter(name: str, interface: Interface) -> Variable:
    if name not in interface.parameters:
        hint = did_you_mean(name, list(interface.parameters))
        raise InputError(f"{interface.model} has no parameter '{name}'; {hint}")
    return interface.parameters[name]


def _value(text: str, variable: Variable, word: str) -> float:
    try:
        value = float(text)
    except ValueError:
        try:
            value = quantity(text, variable.unit)
        except UnitError as problem:
            raise InputError(f"'{word}': {problem}") from problem
    if not np.isfinite(value):
        raise InputError(f"'{word}': the value must be a finite number")
    low, high = variable.min, variable.max
    if (low is not None and value < low) or (high is not None and value > high):
        unit = "" if variable.unit == "1" else variable.unit
        raise InputError(f"'{word}': must be between {low} and {high} {unit}".rstrip())
    return value
