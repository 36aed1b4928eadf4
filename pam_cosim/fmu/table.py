"""The variables of an FMU in the order of their value references and of the model description."""

from __future__ import annotations

import math
from collections.abc import Hashable, Sequence, Set
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import ModelError
from pam_cosim.model.interface import Variable
from pam_cosim.units import quotient


class Kind(Enum):
    """Parts of a model, in the order of ``pam_kind`` in the C runtime."""

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
        kind, index: where it stands in the ODE.
        causality, variability, initial: as FMI 2.0 names them.
        start: start value, where FMI requires one.
        derivative_of: index of the state whose derivative this is.
        reference: value reference, from 1; variables that are always equal share one.
        alias: whether an earlier variable has the same reference.
    """

    variable: Variable
    kind: Kind
    index: int
    causality: str
    variability: str = "continuous"
    initial: str | None = "calculated"
    start: float | None = None
    derivative_of: int | None = None
    reference: int = 0
    alias: bool = False

    @property
    def name(self) -> str:
        """Name of the variable."""
        return self.variable.name


def constant_starts(ode: Ode) -> list[float | None]:
    """Start values of the states that are known beforehand; None for those that depend on parameters or are sought."""
    equilibrium_states = {*ode.resting, *(name for name, _ in ode.following)}
    are_sought = [state.name in equilibrium_states for state in ode.states[: ode.core]]
    sought = [*are_sought, *(rests for rests in are_sought for _ in ode.sensitivities)]
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


def table(ode: Ode, fmi: str = "2.0", *, lean: bool = False) -> list[VariableEntry]:
    """All variables. Where one name stands in several parts of the ODE the first keeps it.

    An output that is a state, or a state that is another's derivative, is one variable with both roles. The value
    references are the positions in the list, aliases not counted. FMI 2.0 leaves the time out: some tools take a
    variable of that name for one of their own.

    Args:
        ode: the model.
        fmi: version of the interface: in FMI 3.0 aliases have one causality, so that only locals share a reference.
        lean: without aliases.

    Raises:
        ModelError: a parameter or input without a usable value, or a name that cannot be merged.
    """
    interface = ode.interface
    starts = constant_starts(ode)
    entries: dict[str, VariableEntry] = {}
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
            entry = _entry(kind, index, variable, starts)
            previous = entries.get(entry.name)
            entries[entry.name] = entry if previous is None else _merge(previous, entry)
    merged = [e for e in entries.values() if fmi != "2.0" or e.kind is not Kind.TIME]
    if lean:
        return [replace(entry, reference=i) for i, entry in enumerate(merged, 1)]
    changing = tunable_parameters(ode)
    kinds = _kinds_of_locals(ode, changing, fmi)
    described = [
        replace(entry, variability="tunable")
        if entry.kind is Kind.PARAMETER and entry.index in changing
        else replace(entry, **kinds[entry.index])
        if entry.kind is Kind.LOCAL
        else entry
        for entry in merged
    ]
    return _numbered(described, _keys(ode, described, fmi))


def tunable_parameters(ode: Ode) -> set[int]:
    """Numbers of the parameters that may change in a run: they act on nothing but rates, outputs and locals."""
    before = [ode.initial, *(delay.time for delay in ode.delays)]
    before += [s.condition for s in ode.statements if s.at_start]
    fixed = set(ca.jacobian_sparsity(ca.vertcat(*map(ca.vec, before)), ode.p).get_col())
    names = [*ode.interface.parameters]
    late = {names.index(name) for name in ode.interface.record_delays}
    followed = {names.index(name) for name in ode.sensitivities if name in names}
    return set(range(len(names))) - fixed - late - followed


def _kinds_of_locals(ode: Ode, changing: Set[int], fmi: str) -> list[dict[str, Any]]:
    """Of each local what it has in place of a variable that changes with time: a constant, or made of parameters.

    In FMI 2.0 a constant is a calculated parameter: OpenModelica loses the value of a constant.
    """
    running = ca.vertcat(ode.t, ode.x, ode.u, ode.d)
    varying = set(ca.jacobian_sparsity(ode.locals, running).row())
    pattern = ca.jacobian_sparsity(ode.locals, ode.p)
    by: dict[int, set[int]] = {}
    for row, column in zip(pattern.row(), pattern.get_col(), strict=True):
        by.setdefault(row, set()).add(column)
    attributes: list[dict[str, Any]] = []
    for i, value in enumerate(ca.vertsplit(ca.SX(ode.locals)) if ode.locals.numel() else ()):
        if i in varying:
            attributes.append({})
        elif i in by:
            variability = "tunable" if by[i] & changing else "fixed"
            attributes.append({"causality": "calculatedParameter", "variability": variability})
        elif fmi == "2.0":
            attributes.append({"causality": "calculatedParameter", "variability": "fixed"})
        elif value.is_constant() and math.isfinite(float(value)):
            attributes.append(
                {"variability": "constant", "initial": "exact", "start": float(value)}
            )
        else:
            attributes.append({})
    return attributes


def _keys(ode: Ode, entries: Sequence[VariableEntry], fmi: str) -> list[Hashable]:
    """Of each variable what those that are always equal have in common; it stands in the same unit."""
    parts = {
        Kind.STATE: ode.x,
        Kind.INPUT: ode.u,
        Kind.PARAMETER: ode.p,
        Kind.OUTPUT: ca.densify(ca.SX(ode.outputs)),
        Kind.LOCAL: ca.densify(ca.SX(ode.locals)),
    }
    shared = ca.cse([*parts.values()])
    expressions = {
        kind: ca.vertsplit(expression) if expression.numel() else []
        for kind, expression in zip(parts, shared, strict=True)
    }
    keys: list[Hashable] = []
    for entry in entries:
        alone = fmi != "2.0" and (entry.kind is not Kind.LOCAL or entry.causality != "local")
        if entry.kind not in parts or alone:
            keys.append(entry.name)
            continue
        column = expressions[entry.kind][entry.index]
        value = float(column) if column.is_constant() else column.element_hash()
        keys.append((value, column.is_constant(), entry.variable.unit, entry.variability))
    return keys


def _numbered(entries: Sequence[VariableEntry], keys: Sequence[Hashable]) -> list[VariableEntry]:
    """With references: a local or an output takes that of an equal variable before it."""
    numbers: dict[Hashable, int] = {}
    numbered: list[VariableEntry] = []
    for entry, key in zip(entries, keys, strict=True):
        alias = key in numbers and entry.kind in (Kind.LOCAL, Kind.OUTPUT)
        number = numbers[key] if alias else 1 + sum(not e.alias for e in numbered)
        numbers.setdefault(key, number)
        numbered.append(replace(entry, reference=number, alias=alias))
    return numbered


def _entry(
    kind: Kind, index: int, variable: Variable, starts: Sequence[float | None]
) -> VariableEntry:
    if kind is Kind.STATE:
        start = starts[index]
        # One that follows from parameters is what the model begins with unless another value is set.
        initial, usual = ("approx", variable.start) if start is None else ("exact", start)
        initial = "calculated" if usual is None else initial
        return VariableEntry(variable, kind, index, "local", initial=initial, start=usual)
    if kind is Kind.DERIVATIVE:
        return VariableEntry(variable, kind, index, "local", derivative_of=index)
    if kind is Kind.INPUT:
        return VariableEntry(
            variable, kind, index, "input", initial=None, start=variable.start or 0.0
        )
    if kind is Kind.PARAMETER:
        if variable.start is None:
            raise ModelError(f"parameter '{variable.name}' has no value")
        return VariableEntry(variable, kind, index, "parameter", "fixed", "exact", variable.start)
    if kind is Kind.TIME:
        return VariableEntry(variable, kind, index, "independent", initial=None)
    return VariableEntry(variable, kind, index, kind.value)


def _merge(first: VariableEntry, second: VariableEntry) -> VariableEntry:
    """One variable for two parts of the ODE that carry the same name."""
    if second.kind is Kind.LOCAL or (first.kind is Kind.LOCAL and second.kind is Kind.TIME):
        return first
    if second.kind is Kind.OUTPUT and first.causality == "local":
        return replace(
            first, causality="output", variable=_described(first.variable, second.variable)
        )
    if second.kind is Kind.DERIVATIVE and first.kind is Kind.STATE:
        return replace(first, derivative_of=second.index)
    raise ModelError(
        f"'{first.name}' is the name of two variables: {first.kind.value} and {second.kind.value}"
    )


def _described(state: Variable, output: Variable) -> Variable:
    """The output's texts and limits, with the state's nominal value where it has none."""
    nominal = output.nominal if output.nominal is not None else state.nominal
    return replace(output, nominal=nominal, start=None)
