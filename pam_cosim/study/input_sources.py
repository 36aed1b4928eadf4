"""Inputs of a model from arrays, a file, a frame, functions or formulas of time.

What reads measurements and formulas is loaded where a source needs it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError, ModelError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.settings import value_of
from pam_cosim.simulation import Inputs, Trajectory
from pam_cosim.units import UnitError, convert
from pam_cosim.wording import did_you_mean

# Inputs over time, or a source of them.
Source = Inputs | Trajectory | Path | str | Mapping[str, Any] | Any
_HEADER = re.compile(r"\s*(?P<name>.*?)\s*(?:\[(?P<unit>[^\[\]]*)\])?\s*")


def inputs_of(
    source: Source | None, interface: Interface, times: Callable[[], Array]
) -> Inputs | None:
    """Inputs from any kind of source.

    Args:
        source: ``Inputs``; the name of a CSV file; formulas in time [s] as a text, "u_in = 0.25 + 0.1 * sin(time);
            u_out = 0", in SI; a mapping of names to arrays, functions of time [s] or constants, with "time" [s] where
            there are arrays; a pandas frame or a structured array with "time" as a column, or as the index of the
            frame; an earlier ``Trajectory``. A name may carry a unit, ``p_supply [kPa]``; without one numbers are in
            SI.
        interface: of the model.
        times: (n,) [s] at which functions are evaluated; lines between.

    Raises:
        InputError: an unknown input, a unit that does not fit, numbers that cannot be used or that the model does not
            allow, a function that fails.
    """
    if source is None:
        return None
    if isinstance(source, str) and not source.strip():
        raise InputError("the inputs are an empty text; name a CSV file, or write 'u_in = 0.25'")
    if isinstance(source, (str, Path)) and not is_formulas(str(source)):
        return read_inputs(Path(source), interface)
    from pam_cosim.study.read_limits import check_input_series

    inputs = _unchecked(source, interface, times)
    check_input_series(inputs, interface)
    return inputs


def _unchecked(source: Source, interface: Interface, times: Callable[[], Array]) -> Inputs:
    if isinstance(source, Inputs):
        return source
    if isinstance(source, str):
        return _of_formulas(source, interface, times())
    columns = _columns(source, interface)
    time = _time(columns)
    if time is None:
        time = times()
    columns_by_name = {_named(head, interface): (head, values) for head, values in columns.items()}
    return Inputs(
        time,
        {
            name: _values(name, head, v, time, interface)
            for name, (head, v) in columns_by_name.items()
        },
    )


def is_formulas(text: str) -> bool:
    """Whether a text is formulas of inputs, and not the name of a file."""
    return "=" in text and not os.path.exists(text)


def _of_formulas(text: str, interface: Interface, time: Array) -> Inputs:
    """Inputs that formulas in time [s] give, in SI."""
    from pam_cosim.compiler.elementwise import elementwise, with_place

    values: dict[str, Array] = {}
    for part in filter(str.strip, text.split(";")):
        head, _, formula = part.partition("=")
        name = _named(head, interface)
        if name in values:
            raise InputError(f"the input '{name}' has two formulas")
        try:
            with np.errstate(all="ignore"):
                values[name] = np.array(
                    np.broadcast_to(elementwise(formula, {"time": time}), time.shape)
                )
        except ModelError as problem:
            raise InputError(f"the formula of the input '{name}': {with_place(problem)}") from None
        except (ArithmeticError, RecursionError, TypeError, ValueError) as problem:
            raise InputError(
                f"the formula of the input '{name}' cannot be evaluated: {problem}"
            ) from None
        wrong = time[~np.isfinite(values[name])]
        if wrong.size:
            raise InputError(f"the formula of the input '{name}' is no number at {wrong[0]:g} s")
    return Inputs(time, values, "linear")


def read_inputs(file: Path, interface: Interface) -> Inputs:
    """The input columns of a CSV file, as inputs of a model.

    Raises:
        InputError: the file cannot be read, has no input column, or a value that the model does not allow.
    """
    from pam_cosim.measurement import read_recording
    from pam_cosim.study.read_limits import check_input_series

    recording = read_recording(file, interface)
    if not recording.inputs:
        input_names = ", ".join(interface.inputs) or "none"
        raise InputError(
            f"has no column of an input; the inputs of {interface.model}: {input_names}", file, 1
        )
    inputs = Inputs(recording.time, recording.inputs, "linear")
    check_input_series(inputs, interface, file)
    return inputs


def _columns(source: Any, interface: Interface) -> dict[str, Any]:
    if isinstance(source, Trajectory):
        return {
            "time": source.time,
            **{n: v for n, v in source.values.items() if n in interface.inputs},
        }
    if isinstance(source, Mapping):
        return dict(source)
    if hasattr(source, "columns") and hasattr(source, "index"):
        columns = {str(name): source[name].to_numpy() for name in source.columns}
        return columns if _time_head(columns) else {"time": source.index.to_numpy(), **columns}
    if isinstance(source, np.ndarray) and source.dtype.names:
        return {name: source[name] for name in source.dtype.names}
    raise InputError(
        "inputs are given as pam.Inputs, a CSV file, a mapping of names to arrays or functions, or a pandas frame, "
        f"not as {type(source).__name__}"
    )


def _time_head(columns: Mapping[str, Any]) -> str | None:
    return next((head for head in columns if _split(head)[0] == "time"), None)


def _time(columns: dict[str, Any]) -> Array | None:
    """Takes the times [s] out of the columns."""
    head = _time_head(columns)
    if head is None:
        return None
    values = np.asarray(columns.pop(head))
    if values.dtype.kind == "M":  # times of day
        from pam_cosim.measurement.table import since_first

        return since_first(values)
    if values.dtype.kind == "m":
        return np.asarray(values / np.timedelta64(1, "s"), dtype=float)
    return _converted(head, values, "s")


def _split(head: str) -> tuple[str, str | None]:
    match = _HEADER.fullmatch(head)
    return (match["name"], match["unit"]) if match else (head, None)


def _named(head: str, interface: Interface) -> str:
    name = _split(head)[0]
    if name not in interface.inputs:
        raise InputError(
            f"{interface.model} has no input '{name}'; {did_you_mean(name, interface.inputs)}"
        )
    return name


def _values(name: str, head: str, source: Any, time: Array, interface: Interface) -> Array:
    if isinstance(source, str):
        return np.full(time.shape, _constant(head, source, interface.inputs[name]))
    if callable(source):
        source = [_at(name, source, float(t)) for t in time]
    values = _converted(head, source, interface.inputs[name].unit)
    return np.full(time.shape, values) if values.ndim == 0 else values


def _constant(head: str, text: str, variable: Variable) -> float:
    """A value [SI] in its own unit, or in that of its head where it has none."""
    try:
        number = float(text)
    except ValueError:
        return value_of(text, variable)
    return value_of(float(_converted(head, number, variable.unit)), variable)


def _at(name: str, function: Callable[[float], Any], t: float) -> float:
    try:
        return float(function(t))
    except Exception as problem:  # a function of the user
        raise InputError(
            f"the function of the input '{name}' fails at {t:g} s: {problem!r}"
        ) from problem


def _converted(head: str, values: Any, unit: str) -> Array:
    stated_unit = _split(head)[1]
    try:
        numbers = np.asarray(values, dtype=float)
        return numbers if stated_unit is None else convert(numbers, stated_unit, unit)
    except (UnitError, ValueError, TypeError) as problem:
        raise InputError(f"'{head}': {problem}") from None
