"""One number of a run: "max(T)", "time_to(p, 90 %)"."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Trajectory
from pam_cosim.units import UnitError, parse_quantity, product
from pam_cosim.wording import did_you_mean, shown

_STEADY_PART = 0.1  # last part of a run, over which a steady value is averaged
_SETTLED_CHANGE = 0.002  # of the whole change: what moves more in the last part has not settled

_FORM = re.compile(
    r"\s*(?P<function>\w+)\s*\(\s*(?P<variable>[^()]+(?:\([^()]*\))?[^()]*?)\s*\)\s*"
)


@dataclass(frozen=True)
class _Function:
    """Of times (n,) [s], values (n,) and a number; ``unit`` of its result by that of the variable."""

    evaluate: Callable[[Array, Array, float], float]
    meaning: str
    unit: Callable[[str], str] = lambda unit: unit
    argument: float | None = None  # the number, where it is left out; None: there is none


def _settled(t: Array, y: Array) -> bool:
    """Whether a variable has settled, by the last part of a run."""
    last = y[t >= t[-1] - _STEADY_PART * (t[-1] - t[0])]
    return bool(np.ptp(last) <= _SETTLED_CHANGE * abs(y[-1] - y[0]))


def _time_to(t: Array, y: Array, share: float) -> float:
    """NaN where the run has not settled: the whole change is not known then."""
    if not _settled(t, y):
        return float("nan")
    level = y[0] + share * (y[-1] - y[0])
    there = y >= level if y[-1] >= y[0] else y <= level
    i = int(np.argmax(there))
    if not there[i] or i == 0 or y[i] == y[i - 1]:
        return float(t[i] - t[0]) if there[i] else float("nan")
    return float(t[i - 1] + (level - y[i - 1]) / (y[i] - y[i - 1]) * (t[i] - t[i - 1]) - t[0])


def _steady(t: Array, y: Array, share: float) -> float:
    last = t >= t[-1] - share * (t[-1] - t[0])
    return float(np.mean(y[last]))


def _integral(t: Array, y: Array, _: float) -> float:
    from scipy.integrate import trapezoid  # a fifth of a second, which few need

    return float(trapezoid(y, t))


def _mean(t: Array, y: Array, _: float) -> float:
    return _integral(t, y, 0.0) / float(t[-1] - t[0]) if t[-1] > t[0] else float(y[0])


def _seconds(unit: str) -> str:
    return "s"


FUNCTIONS: dict[str, _Function] = {
    "initial": _Function(lambda t, y, a: float(y[0]), "the first value"),
    "final": _Function(lambda t, y, a: float(y[-1]), "the last value"),
    "steady": _Function(
        _steady,
        "the mean over the last part of the run (default: 10 %)",
        argument=_STEADY_PART,
    ),
    "min": _Function(lambda t, y, a: float(y.min()), "the lowest value"),
    "max": _Function(lambda t, y, a: float(y.max()), "the highest value"),
    "range": _Function(lambda t, y, a: float(np.ptp(y)), "highest less lowest value"),
    "mean": _Function(_mean, "the mean over time"),
    "integral": _Function(_integral, "the integral over time", lambda unit: product(unit, "s")),
    "time_to": _Function(
        _time_to,
        "time from the start to a part of the total change (default: 90 %); none where the run has not "
        "settled",
        _seconds,
        0.9,
    ),
    "time_of_max": _Function(
        lambda t, y, a: float(t[np.argmax(y)] - t[0]),
        "time from the start to the highest value",
        _seconds,
    ),
    "time_of_min": _Function(
        lambda t, y, a: float(t[np.argmin(y)] - t[0]),
        "time from the start to the lowest value",
        _seconds,
    ),
}


@dataclass(frozen=True)
class Scalar:
    """One number of a run.

    Attributes:
        name: under which it stands in results.
        function: one of ``FUNCTIONS``.
        variable: of the model.
        argument: the number after the variable, a share such as 0.9.
        unit: of the result.
    """

    name: str
    function: str
    variable: str
    argument: float
    unit: str

    def of(self, run: Trajectory) -> float:
        """Its value [``unit``] in one run."""
        return FUNCTIONS[self.function].evaluate(
            run.time, np.asarray(run[self.variable]), self.argument
        )


def read_scalars(
    scalar_texts: Mapping[str, str] | Sequence[str], interface: Interface
) -> tuple[Scalar, ...]:
    """Scalars from texts such as "max(T)", "time_to(p, 90 %)", by name or each under its own text.

    Raises:
        InputError: another form, an unknown function or variable, a name twice.
    """
    pairs = (
        list(scalar_texts.items())
        if isinstance(scalar_texts, Mapping)
        else [(text.strip(), text) for text in scalar_texts]
    )
    scalars = tuple(_read(name, text, interface) for name, text in pairs)
    for i, scalar in enumerate(scalars):
        if scalar.name in [other.name for other in scalars[:i]]:
            raise InputError(f"the scalar '{scalar.name}' is asked for twice")
    return scalars


def _read(name: str, text: str, interface: Interface) -> Scalar:
    match = _FORM.fullmatch(text)
    if match is None:
        raise InputError(
            f"{shown(text)}: write FUNCTION(VARIABLE), such as max(T) or time_to(p, 90 %)"
        )
    if match["function"] not in FUNCTIONS:
        raise InputError(
            f"{shown(text)}: there is no function of that name; {did_you_mean(match['function'], FUNCTIONS)}"
        )
    function, variables = FUNCTIONS[match["function"]], interface.variables
    variable, argument = match["variable"], function.argument
    if variable not in variables and "," in variable and argument is not None:
        variable, _, number = (part.strip() for part in variable.rpartition(","))
        argument = _part(number, text)
    if variable not in variables:
        raise InputError(
            f"{shown(text)}: {interface.model} has no variable '{variable}'; {did_you_mean(variable, variables)}"
        )
    return Scalar(
        name,
        match["function"],
        variable,
        argument or 0.0,
        function.unit(variables[variable].unit or "1"),
    )


def _part(number: str, text: str) -> float:
    try:
        part = parse_quantity(number, "1")
    except UnitError as problem:
        raise InputError(f"{shown(text)}: {problem}") from None
    if not 0.0 < part <= 1.0:
        raise InputError(f"{shown(text)}: a fraction must be above 0 and at most 1")
    return part
