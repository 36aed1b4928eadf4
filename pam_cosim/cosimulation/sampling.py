"""One call of a controller that is a function in Python."""

from __future__ import annotations

import math
import traceback
from collections.abc import Mapping
from typing import Any

from pam_cosim.cosimulation.parts import Controller
from pam_cosim.errors import InputError
from pam_cosim.wording import listed, shown


class ControllerError(InputError):
    """A controller raised an exception or did not return its outputs; ``run`` is what was reached, a ``CoupledRun``."""

    run: Any = None


def sampled(
    name: str, controller: Controller, time: float, inputs: Mapping[str, float]
) -> dict[str, float]:
    """What the controller of that name makes of its inputs at a time [s].

    Raises:
        ControllerError: it raised an exception, or did not return a finite number for each of its outputs.
    """
    where = f"controller '{name}' ({controller.model})"
    try:
        answer: Any = controller(time, **inputs)
    except (Exception, SystemExit) as error:  # whatever a user's function raises
        place = traceback.extract_tb(error.__traceback__)[-1]
        what = f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
        at = f"at {time:.6g} s, in line {place.lineno} of {place.filename}"
        raise ControllerError(f"{where} raised {what} {at}") from error
    values = (
        answer
        if isinstance(answer, Mapping)
        else dict.fromkeys(list(controller.outputs)[:1], answer)
    )
    if set(values) != set(controller.outputs):
        given = (
            f"returned {listed(map(str, values))}"
            if isinstance(answer, Mapping)
            else "returned one value"
        )
        raise ControllerError(
            f"{where} {given} at {time:.6g} s; its outputs are {listed(controller.outputs)}"
        )
    numbers = {output: _number(value) for output, value in values.items()}
    for output, number in numbers.items():
        if not math.isfinite(number):
            what = f"returned {output} = {shown(values[output])} at {time:.6g} s"
            raise ControllerError(f"{where} {what}; it must be a finite number")
    return numbers


def _number(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        return math.nan
