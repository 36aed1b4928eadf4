"""What a model shows to the outside: named quantities with units. The vocabulary of every room."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Literal

from pam_cosim.wording import Printed, did_you_mean, shown

RECORD_DELAY = "RecordDelay"
"""The quantity of a parameter by which the record of all readings is late against that of the inputs [s]."""


Pressures = Literal["gauge", "absolute", ""]
Kind = Literal["Real", "Integer", "Boolean", "Enumeration", "String"]

_ON = {
    "on",
    "true",
    "open",
    "high",
    "ein",
    "an",
    "auf",
    "offen",
    "wahr",
    "ouvert",
    "vrai",
    "marche",
}
_OFF = {"off", "false", "closed", "low", "aus", "zu", "geschlossen", "falsch", "fermé", "ferme"}
_OFF |= {"faux", "arrêt"}
SWITCH_WORDS: Mapping[str, float] = MappingProxyType(
    {word: float(word in _ON) for word in sorted(_ON | _OFF)}
)
"""1 or 0 by the word, in small letters, for a state of a switch."""


@dataclass(frozen=True)
class Variable:
    """One scalar quantity of a model; all numbers in the unit named by ``unit`` (SI).

    Attributes:
        kind: type of the values. All but those of a String are numbers; a Boolean is 0 or 1.
        items: of an Enumeration, the numbers of its names.
        text: of a String, the start value.
        span: of an Integer, the least and the greatest number of its type; None: not known.
        is_discrete: the value changes at events alone, and is constant between them.
        pressures: of a pressure, whether it is "gauge" or "absolute"; "": not stated.
    """

    name: str
    unit: str = ""
    description: str = ""
    start: float | None = None
    min: float | None = None
    max: float | None = None
    nominal: float | None = None
    display_unit: str = ""
    quantity: str = ""
    kind: Kind = "Real"
    items: Mapping[str, float] | None = field(default=None, hash=False)
    text: str = ""
    span: tuple[int, int] | None = None
    is_discrete: bool = False
    pressures: Pressures = "gauge"

    @property
    def words(self) -> Mapping[str, float]:
        """Numbers of the words that are values, in small letters."""
        if self.kind == "Boolean":
            return SWITCH_WORDS
        return {name.casefold(): number for name, number in (self.items or {}).items()}

    @property
    def is_foreign(self) -> bool:
        """Whether the model is an FMU of another tool, whose signs and zeros are its own."""
        return not self.pressures

    def allows(self, number: float) -> bool:
        """Whether a number is a value of this kind; ranges are not looked at."""
        if self.kind == "String":
            return True
        if self.kind == "Boolean":
            return number in (0.0, 1.0)
        if self.items is not None:
            return number in self.items.values()
        low, high = self.span or (-math.inf, math.inf)
        return self.kind == "Real" or (number == round(number) and low <= number <= float(high))

    @property
    def values(self) -> str:
        """What values of this kind are, for messages."""
        if self.items is not None:
            return f"one of {', '.join(self.items)}"
        integers = "a whole number" + (
            f" from {self.span[0]} to {self.span[1]}" if self.span else ""
        )
        names = {"Boolean": "0 or 1 (off, on)", "Integer": integers, "String": "a text"}
        return names.get(self.kind, "a number")


@dataclass(frozen=True)
class Interface(Printed):
    """The inputs, outputs and parameters of a model, each by name, in a fixed order.

    Attributes:
        model: qualified name of the Modelica class, or the FMU's model name.
        inputs, outputs, parameters, locals: variables by name.
        start_time: default start of a simulation [s].
        stop_time: its default duration [s].
        interval: default distance of output points [s].
        tolerance: default relative tolerance of the solver.
        sensitivities: outputs that are derivatives of outputs with respect to parameters; not among ``outputs``.
        states: names of the continuous states whose start values can be set; they are locals or outputs too.
        rates: names of their derivatives by time.
        refused: variables of the model that are in none of the groups, and why.
        calculated: names of the parameters that the model computes from others; they are among ``locals``.
    """

    model: str
    inputs: dict[str, Variable] = field(default_factory=dict)
    outputs: dict[str, Variable] = field(default_factory=dict)
    parameters: dict[str, Variable] = field(default_factory=dict)
    locals: dict[str, Variable] = field(default_factory=dict)
    stop_time: float = 1.0
    interval: float = 0.01
    tolerance: float = 1e-6
    sensitivities: dict[str, Variable] = field(default_factory=dict)
    states: tuple[str, ...] = ()
    rates: tuple[str, ...] = ()
    refused: dict[str, str] = field(default_factory=dict)
    calculated: tuple[str, ...] = ()
    start_time: float = 0.0

    def with_pressures(self, pressures: Pressures) -> Interface:
        """The same, where it is stated what the pressures of inputs and outputs are."""
        inputs, outputs = (
            {name: replace(v, pressures=pressures) for name, v in group.items()}
            for group in (self.inputs, self.outputs)
        )
        return replace(self, inputs=inputs, outputs=outputs)

    def __str__(self) -> str:
        """Inputs, outputs and parameters, a line each: name, default, range, unit, meaning."""
        lines = [f"{self.model}, {self.stop_time:g} s in steps of {self.interval:g} s"]
        for title in ("inputs", "outputs", "parameters"):
            lines += [f"{title}:", *(f"  {_line(v)}" for v in getattr(self, title).values())]
        return "\n".join(lines)

    @property
    def variables(self) -> dict[str, Variable]:
        """What can be read of a run: outputs and everything else that changes with time, and parameters."""
        return {
            **self.outputs,
            **self.sensitivities,
            **self.inputs,
            **self.locals,
            **self.parameters,
        }

    @property
    def record_delays(self) -> dict[str, Variable]:
        """Parameters whose sum is the delay of the readings: the reading at t is the value that much earlier."""
        return {name: v for name, v in self.parameters.items() if v.quantity == RECORD_DELAY}

    @property
    def settable(self) -> dict[str, Variable]:
        """What may be given one value for a whole run: parameters, inputs, which are then held, and start values."""
        starts = {
            name: v for name, v in (self.locals | self.outputs).items() if v.start is not None
        }
        return {**self.parameters, **self.inputs, **starts}

    @property
    def start_values(self) -> dict[str, Variable]:
        """The continuous states whose start values can be set."""
        variables = self.locals | self.outputs
        return {name: variables[name] for name in self.states}

    def unknown(self, name: str, role: str, names: Mapping[str, object]) -> str:
        """Why ``name`` cannot be used in a ``role`` such as "input", which has these ``names``."""
        if name in self.refused:
            return f"{shown(name)} of {self.model} cannot be used: {self.refused[name]}"
        if name in self.calculated:
            return (
                f"{shown(name)} is a calculated parameter of {self.model}: it follows from other "
                "parameters, and cannot be set; set those"
            )
        roles = {"input": self.inputs, "output": self.outputs, "parameter": self.parameters}
        for other_role, variables in (*roles.items(), ("variable inside", self.locals)):
            if name in variables and other_role not in role:
                article = "an" if other_role in ("input", "output") else "a"
                is_set = other_role in ("input", "parameter") or role == "output"
                end = f", and no {role}" if is_set else " and cannot be set"
                return f"{shown(name)} is {article} {other_role} of {self.model}{end}"
        hint = did_you_mean(name, names) if names else f"it has no {role}s"
        return f"{self.model} has no {role} {shown(name)}; {hint}"


_SENSITIVITY = "sensitivity."


def sensitivity_name(output: str, parameter: str) -> str:
    """The variable that is the derivative of an output or state with respect to a parameter or a start value."""
    return f"{_SENSITIVITY}{output}.{parameter}"


def is_sensitivity(name: str) -> bool:
    """Whether a variable is such a derivative."""
    return name.startswith(_SENSITIVITY)


def _line(variable: Variable) -> str:
    start = "" if variable.start is None else f" = {variable.start:g}"
    kind = f"[{variable.unit or '1'}]{_bounds(variable)}"
    if variable.kind != "Real":
        kind = f"({variable.kind}{_bounds(variable)}: {variable.values})"
    if variable.kind == "String":
        start = f" = {shown(variable.text)}"
    names = {number: name for name, number in (variable.items or {}).items()}
    if variable.start in names:
        start = f" = {names[variable.start]}"
    head = f"{variable.name}{start} {kind}"
    return f"{head}: {variable.description}".rstrip(": ")


def _bounds(variable: Variable) -> str:
    low, high = variable.min, variable.max
    if low is not None and high is not None:
        return f", {low:g} to {high:g}"
    if low is not None:
        return f", at least {low:g}"
    return "" if high is None else f", at most {high:g}"
