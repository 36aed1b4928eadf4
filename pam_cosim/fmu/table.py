"""The variables of an FMU in the order of their value references and of the model description."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import ModelError
from pam_cosim.model.interface import Variable
from pam_cosim.units import quotient


class Kind(Enum):
    """Parts of the table of value references, in the order of ``pam_kind`` in the C runtime."""

    STATE = "state"
    DERIVATIVE = "derivative"
    INPUT = "input"
    OUTPUT = "output"
    PARAMETER = "parameter"
    LOCAL = "local"
    TIME = "time"


@dataclass(frozen=True)
class VariableEntry:
    """One variable of the model description.

    Attributes:
        variable: name, unit and limits.
        reference: value reference.
        kind, index: where it stands in the ODE.
        causality, variability, initial: as FMI 2.0 names them.
        start: start value, where FMI wants one.
        derivative_of: index of the state whose derivative this is.
    """

    variable: Variable
    reference: int
    kind: Kind
    index: int
    causality: str
    variability: str = "continuous"
    initial: str | None = "calculated"
    start: float | None = None
    derivative_of: int | None = None

    @property
    def name(self) -> str:
        """Name of the variable."""
        return self.variable.name


def constant_starts(ode: Ode) -> list[float | None]:
    """Start values of the states that are known beforehand; None for those that depend on parameters or are sought."""
    found = {*ode.resting, *(name for name, _ in ode.following)}
    own = [state.name in found for state in ode.states[: ode.core]]
    sought = [*own, *(rests for rests in own for _ in ode.sensitivities)]
    values = ca.vertsplit(ca.SX(ode.initial))
    return [
        float(x0) if x0.is_constant() and not s else None
        for x0, s in zip(values, sought, strict=True)
    ]


def derivative_name(state: str) -> str:
    """FMI's structured name of a state's derivative."""
    if state.startswith("der(") and state.endswith(")"):
        inner, _, order = state[4:-1].partition(",")
        return f"der({inner},{int(order or 1) + 1})"
    return f"der({state})"


def _derivative(state: Variable) -> Variable:
    rate = quotient(state.unit, "s") if state.unit else ""
    return Variable(derivative_name(state.name), rate, f"Time derivative of {state.name}")


def table(ode: Ode) -> list[VariableEntry]:
    """All variables. Where one name stands in several parts of the ODE the first keeps it.

    An output that is a state, or a state that is another's derivative, is one variable with both roles.

    Raises:
        ModelError: a parameter or input without a usable value, or a name that cannot be merged.
    """
    interface = ode.interface
    starts = constant_starts(ode)
    entries: dict[str, VariableEntry] = {}
    reference = 0
    for kind, variables in (
        (Kind.STATE, ode.states),
        (Kind.DERIVATIVE, [_derivative(state) for state in ode.states]),
        (Kind.INPUT, interface.inputs.values()),
        (Kind.OUTPUT, interface.outputs.values()),
        (Kind.PARAMETER, interface.parameters.values()),
        (Kind.LOCAL, interface.locals.values()),
        (Kind.TIME, [Variable("time", "s", "Simulation time")]),
    ):
        for index, variable in enumerate(variables):
            entry = _entry(kind, index, reference, variable, starts)
            known = entries.get(entry.name)
            entries[entry.name] = entry if known is None else _merge(known, entry)
            reference += 1
    return list(entries.values())


def _entry(
    kind: Kind, index: int, reference: int, variable: Variable, starts: Sequence[float | None]
) -> VariableEntry:
    if kind is Kind.STATE:
        start = starts[index]
        # One that follows from parameters is what the model begins with where nobody sets another value.
        initial, usual = ("approx", variable.start) if start is None else ("exact", start)
        initial = "calculated" if usual is None else initial
        return VariableEntry(
            variable, reference, kind, index, "local", initial=initial, start=usual
        )
    if kind is Kind.DERIVATIVE:
        return VariableEntry(variable, reference, kind, index, "local", derivative_of=index)
    if kind is Kind.INPUT:
        return VariableEntry(
            variable, reference, kind, index, "input", initial=None, start=variable.start or 0.0
        )
    if kind is Kind.PARAMETER:
        if variable.start is None:
            raise ModelError(f"parameter '{variable.name}' has no value")
        return VariableEntry(
            variable, reference, kind, index, "parameter", "fixed", "exact", variable.start
        )
    if kind is Kind.TIME:
        return VariableEntry(variable, reference, kind, index, "independent", initial=None)
    return VariableEntry(variable, reference, kind, index, kind.value)


def _merge(known: VariableEntry, other: VariableEntry) -> VariableEntry:
    """One variable for two parts of the ODE that carry the same name."""
    if other.kind is Kind.LOCAL or (known.kind is Kind.LOCAL and other.kind is Kind.TIME):
        return known
    if other.kind is Kind.OUTPUT and known.causality == "local":
        return replace(
            known, causality="output", variable=_described(known.variable, other.variable)
        )
    if other.kind is Kind.DERIVATIVE and known.kind is Kind.STATE:
        return replace(known, derivative_of=other.index)
    raise ModelError(
        f"'{known.name}' is the name of two variables: {known.kind.value} and {other.kind.value}"
    )


def _described(state: Variable, output: Variable) -> Variable:
    """The output's texts and limits, with the state's nominal value where it has none."""
    nominal = output.nominal if output.nominal is not None else state.nominal
    return replace(output, nominal=nominal, start=None)
