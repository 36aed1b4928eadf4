"""What a model shows to the outside: named quantities with units. The vocabulary of every room."""

from __future__ import annotations

from dataclasses import dataclass, field

from pam_cosim.wording import Printed

RECORD_DELAY = "RecordDelay"
"""The quantity of a parameter by which the record of all readings is late against that of the inputs [s]."""


@dataclass(frozen=True)
class Variable:
    """One scalar quantity of a model; all numbers in the unit named by ``unit`` (SI)."""

    name: str
    unit: str = ""
    description: str = ""
    start: float | None = None
    min: float | None = None
    max: float | None = None
    nominal: float | None = None
    display_unit: str = ""
    quantity: str = ""


@dataclass(frozen=True)
class Interface(Printed):
    """The inputs, outputs and parameters of a model, each by name, in a fixed order.

    Attributes:
        model: qualified name of the Modelica class, or the FMU's model name.
        inputs, outputs, parameters, locals: variables by name.
        stop_time: default duration of a simulation [s].
        interval: default distance of output points [s].
        tolerance: default relative tolerance of the solver.
        sensitivities: outputs that are derivatives of outputs with respect to parameters; not among ``outputs``.
        states: names of the continuous states whose start values can be set; they are locals or outputs too.
        rates: names of their derivatives by time.
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
        """Parameters by whose sum the readings are recorded late: what is asked for at t was there that much before."""
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


_SENSITIVITY = "sensitivity."


def sensitivity_name(output: str, parameter: str) -> str:
    """The variable that is the derivative of an output or state with respect to a parameter or a start value."""
    return f"{_SENSITIVITY}{output}.{parameter}"


def is_sensitivity(name: str) -> bool:
    """Whether a variable is such a derivative."""
    return name.startswith(_SENSITIVITY)


def _line(variable: Variable) -> str:
    start = "" if variable.start is None else f" = {variable.start:g}"
    head = f"{variable.name}{start} [{variable.unit or '1'}]{_bounds(variable)}"
    return f"{head}: {variable.description}".rstrip(": ")


def _bounds(variable: Variable) -> str:
    low, high = variable.min, variable.max
    if low is not None and high is not None:
        return f", {low:g} to {high:g}"
    if low is not None:
        return f", at least {low:g}"
    return "" if high is None else f", at most {high:g}"
