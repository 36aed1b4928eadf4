"""Which variable depends on which and how, from the exact sparsity of the expressions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.table import Kind, VariableEntry


@dataclass(frozen=True)
class Dependency:
    """One known variable that an unknown depends on.

    Attributes:
        position: index (from 1) in the model description.
        kind: FMI's ``dependenciesKind``: "constant" where the known enters with a constant factor, "fixed" where
            the factor follows from parameters, else "dependent".
    """

    position: int
    kind: str


Dependencies = dict[int, list[Dependency]]
_Knowns = Sequence[tuple[ca.SX, Sequence[int | None]]]


def continuous_dependencies(ode: Ode, entries: Sequence[VariableEntry]) -> Dependencies:
    """Dependencies of outputs and derivatives on states, inputs and time, by index from 1."""
    knowns = [
        (ode.x, _positions(entries, Kind.STATE, len(ode.states))),
        (ode.u, _positions(entries, Kind.INPUT, ode.u.numel())),
        (ode.t, _positions(entries, Kind.TIME, 1)),
    ]
    derivatives, outputs = _undelayed(ode)
    unknowns = {Kind.DERIVATIVE: derivatives, Kind.OUTPUT: outputs, Kind.STATE: ode.x}
    return _assign(ode, entries, unknowns, knowns, ode.p)


def initial_dependencies(ode: Ode, entries: Sequence[VariableEntry]) -> Dependencies:
    """The same at initialization, where calculated states follow from the parameters, which are known variables.

    Where states begin at rest, each unknown depends on everything.
    """
    knowns = [
        (ode.x, _positions(entries, Kind.STATE, len(ode.states))),
        (ode.u, _positions(entries, Kind.INPUT, ode.u.numel())),
        (ode.p, _positions(entries, Kind.PARAMETER, ode.p.numel())),
        (ode.t, _positions(entries, Kind.TIME, 1)),
    ]
    if ode.resting:
        all_knowns = [
            Dependency(i, "dependent") for _, part in knowns for i in part if i is not None
        ]
        return dict.fromkeys(
            range(1, len(entries) + 1), sorted(all_knowns, key=lambda d: d.position)
        )
    exact = {e.index for e in entries if e.kind is Kind.STATE and e.initial == "exact"}
    initial = ca.vertsplit(ca.SX(ode.initial)) if ode.states else []
    start = ca.vertcat(*[ode.x[i] if i in exact else initial[i] for i in range(len(initial))])
    derivatives, outputs = ca.substitute(_undelayed(ode), [ode.x], [ca.SX(start)])
    calculated = {e.index for e in entries if e.causality == "calculatedParameter"}
    local = ca.SX(ode.locals)
    calculated_values = [local[i] if i in calculated else ca.SX(0) for i in range(local.numel())]
    unknowns = {
        Kind.DERIVATIVE: derivatives,
        Kind.OUTPUT: outputs,
        Kind.STATE: ca.SX(start),
        Kind.LOCAL: ca.vertcat(ca.SX(0, 1), *calculated_values),
    }
    return _assign(ode, entries, unknowns, knowns, ca.SX(0, 1))


def _positions(entries: Sequence[VariableEntry], kind: Kind, count: int) -> list[int | None]:
    """Index (from 1) in the model description of every variable of a kind."""
    positions = {entry.index: i for i, entry in enumerate(entries, 1) if entry.kind is kind}
    return [positions.get(index) for index in range(count)]


def _undelayed(ode: Ode) -> list[ca.SX]:
    """Derivatives and outputs as they are at the start, or where a delay is zero: the inputs act at once."""
    pairs = zip(ode.delays, ca.vertsplit(ode.d), strict=True) if ode.delays else ()
    inputs = ca.vertcat(
        ca.SX(0, 1), *[d if delay.input is None else ode.u[delay.input] for delay, d in pairs]
    )
    return list(ca.substitute([ode.derivatives, ode.outputs], [ode.d], [inputs]))


def _assign(
    ode: Ode,
    entries: Sequence[VariableEntry],
    unknowns: dict[Kind, ca.SX],
    knowns: _Knowns,
    fixed: ca.SX,
) -> Dependencies:
    # What acts late does not act with a factor.
    exact = not ode.delays
    rows = {kind: _rows(expression, knowns, fixed, exact) for kind, expression in unknowns.items()}
    return {i: rows[e.kind][e.index] for i, e in enumerate(entries, 1) if e.kind in rows}


def _rows(expression: ca.SX, knowns: _Knowns, fixed: ca.SX, exact: bool) -> list[list[Dependency]]:
    """For each row of ``expression`` the variables it depends on, ascending."""
    symbols = ca.vertcat(*[symbols for symbols, _ in knowns])
    positions = [position for _, part in knowns for position in part]
    rows: list[list[Dependency]] = [[] for _ in range(expression.numel())]
    pattern = ca.jacobian_sparsity(expression, symbols)
    kinds = _kinds(expression, symbols, fixed) if exact else {}
    for row, column in zip(pattern.row(), pattern.get_col(), strict=True):
        position = positions[column]
        if position is not None:
            rows[row].append(Dependency(position, kinds.get((row, column), "dependent")))
    return [sorted(row, key=lambda d: d.position) for row in rows]


def _kinds(expression: ca.SX, symbols: ca.SX, fixed: ca.SX) -> dict[tuple[int, int], str]:
    """What the factors depend on, which are the entries of the Jacobian."""
    jacobian = ca.jacobian(_without_conditions(expression), symbols)
    factors = jacobian.nz[:]
    varying = set(ca.jacobian_sparsity(factors, symbols).row())
    set_before = set(ca.jacobian_sparsity(factors, fixed).row())
    places = zip(jacobian.sparsity().row(), jacobian.sparsity().get_col(), strict=True)
    return {
        place: "dependent" if i in varying else "fixed" if i in set_before else "constant"
        for i, place in enumerate(places)
    }


# Operations whose derivatives do not show how the result depends on the operands.
_STEPS = frozenset(
    (
        ca.OP_LT,
        ca.OP_LE,
        ca.OP_EQ,
        ca.OP_NE,
        ca.OP_NOT,
        ca.OP_AND,
        ca.OP_OR,
        ca.OP_IF_ELSE_ZERO,
        ca.OP_SIGN,
        ca.OP_FLOOR,
        ca.OP_CEIL,
        ca.OP_FMOD,
        ca.OP_REMAINDER,
        ca.OP_COPYSIGN,
    )
)


def _without_conditions(expression: ca.SX) -> ca.SX:
    """An expression of the same dependencies whose derivatives show them: a curve in place of every condition."""
    symbols = ca.vertcat(*ca.symvar(expression)) if ca.symvar(expression) else ca.SX(0, 1)
    function = ca.Function("f", [symbols], [ca.densify(expression)])
    work = [ca.SX(0)] * max(1, function.sz_w())
    result = ca.SX(expression.shape[0], 1)
    for k in range(function.n_instructions()):
        code, reads, writes = (
            function.instruction_id(k),
            function.instruction_input(k),
            function.instruction_output(k),
        )
        if code == ca.OP_OUTPUT:
            result[writes[1]] = work[reads[0]]
        elif code == ca.OP_INPUT:
            work[writes[0]] = symbols[reads[1]]
        elif code == ca.OP_CONST:
            work[writes[0]] = ca.SX(function.instruction_constant(k))
        else:
            work[writes[0]] = _operation(code, [work[i] for i in reads])
    return result


def _operation(code: int, operands: Sequence[ca.SX]) -> ca.SX:
    if code in _STEPS:
        return ca.sin(sum(operands, ca.SX(0)))
    return ca.SX.unary(code, operands[0]) if len(operands) == 1 else ca.SX.binary(code, *operands)
