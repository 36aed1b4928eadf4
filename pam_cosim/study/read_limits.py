"""Inputs against the least and the greatest value that the bench allows them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import place_in
from pam_cosim.comparison.plausibility import BEYOND_LIMIT
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.simulation import Inputs
from pam_cosim.units import format_quantity


def check_inputs(data: DataSet, interface: Interface) -> None:
    """Finds out that no recorded input is beyond what the model allows, by more than a sensor's noise or zero.

    Raises:
        InputError: one is; names the file and the first row.
    """
    for run, message in _beyond(data, interface):
        raise InputError(message, run.file)


def inputs_beyond(data: DataSet, interface: Interface) -> tuple[str, ...]:
    """The same as sentences, one for each input of each recording."""
    return tuple(f"{run.file.name}: {message}" for run, message in _beyond(data, interface))


def check_input_series(inputs: Inputs, interface: Interface, file: Path | None = None) -> None:
    """The same of inputs that were not recorded in a data set, in ``file`` if they come from one.

    Raises:
        InputError: one is beyond what the model allows; names the input and the time.
    """
    for name, values in inputs.values.items():
        variable = interface.inputs.get(name)
        message = variable and _message(variable, values, lambda i: f"at {inputs.time[i]:.6g} s")
        if message:
            raise InputError(message, file)


def _beyond(data: DataSet, interface: Interface) -> Iterator[tuple[Run, str]]:
    for run in data.runs:
        for name, values in run.inputs.items():
            variable = interface.inputs.get(name)
            message = variable and _message(variable, values, partial(place_in, run))
            if message:
                yield run, message


def _message(variable: Variable, values: Array, place: Callable[[int], str]) -> str:
    """What is wrong with an input; "" where nothing is."""
    room = BEYOND_LIMIT * float(np.ptp(values))
    limits = (("below the least", variable.min, -1.0), ("above the greatest", variable.max, 1.0))
    for words, limit, sign in limits:
        if limit is None:
            continue
        exceeding = np.flatnonzero(sign * (values - limit) > room)
        if exceeding.size:
            value, end = (
                format_quantity(float(v), variable.unit) for v in (values[exceeding[0]], limit)
            )
            return (
                f"{variable.name} is {value} {place(int(exceeding[0]))}, {words} value {end} that the model "
                "allows: check the sign, the unit and the zero"
            )
    return ""
