"""Which variable depends on which, from the exact sparsity of the expressions."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.fmu.table import Entry, Kind

Dependencies = dict[int, list[int]]


def _rows(expression: ca.SX, knowns: Sequence[tuple[ca.SX, Sequence[int | None]]]) -> list[list[int]]:
    """For each row of ``expression`` the positions of the variables it depends on, ascending."""
    rows: list[list[int]] = [[] for _ in range(expression.numel())]
    for symbols, positions in knowns:
        if not symbols.numel() or not expression.numel():
            continue
        pattern = ca.jacobian_sparsity(expression, symbols)
        for row, column in zip(pattern.row(), pattern.get_col(), strict=True):
            position = positions[column]
            if position is not None:
                rows[row].append(position)
    return [sorted(row) for row in rows]


def _positions(entries: Sequence[Entry], kind: Kind, count: int) -> list[int | None]:
    """Index (from 1) in the model description of every variable of a kind."""
    found = {entry.index: i for i, entry in enumerate(entries, 1) if entry.kind is kind}
    return [found.get(index) for index in range(count)]


def continuous_dependencies(ode: Ode, entries: Sequence[Entry]) -> Dependencies:
    """Dependencies of outputs and derivatives on states, inputs and time, by index from 1."""
    knowns = [
        (ode.x, _positions(entries, Kind.STATE, len(ode.states))),
        (ode.u, _positions(entries, Kind.INPUT, ode.u.numel())),
        (ode.t, _positions(entries, Kind.TIME, 1)),
    ]
    derivatives, outputs = _undelayed(ode)
    return _assign(entries, {Kind.DERIVATIVE: derivatives, Kind.OUTPUT: outputs, Kind.STATE: ode.x}, knowns)


def initial_dependencies(ode: Ode, entries: Sequence[Entry]) -> Dependencies:
    """The same at initialization, where calculated states follow from the parameters."""
    exact = {e.index for e in entries if e.kind is Kind.STATE and e.initial == "exact"}
    initial = ca.vertsplit(ca.SX(ode.initial)) if ode.states else []
    start = ca.vertcat(*[ode.x[i] if i in exact else initial[i] for i in range(len(initial))])
    derivatives, outputs = ca.substitute(_undelayed(ode), [ode.x], [ca.SX(start)])
    knowns = [
        (ode.x, _positions(entries, Kind.STATE, len(ode.states))),
        (ode.u, _positions(entries, Kind.INPUT, ode.u.numel())),
        (ode.p, _positions(entries, Kind.PARAMETER, ode.p.numel())),
        (ode.t, _positions(entries, Kind.TIME, 1)),
    ]
    return _assign(entries, {Kind.DERIVATIVE: derivatives, Kind.OUTPUT: outputs, Kind.STATE: ca.SX(start)}, knowns)


def _undelayed(ode: Ode) -> list[ca.SX]:
    """Derivatives and outputs as they are at the start, or where a delay is zero: the inputs act at once."""
    pairs = zip(ode.delays, ca.vertsplit(ode.d), strict=True) if ode.delays else ()
    now = ca.vertcat(ca.SX(0, 1), *[d if delay.input is None else ode.u[delay.input] for delay, d in pairs])
    return list(ca.substitute([ode.derivatives, ode.outputs], [ode.d], [now]))


def _assign(
    entries: Sequence[Entry],
    expressions: dict[Kind, ca.SX],
    knowns: Sequence[tuple[ca.SX, Sequence[int | None]]],
) -> Dependencies:
    rows = {kind: _rows(expression, knowns) for kind, expression in expressions.items()}
    return {i: rows[e.kind][e.index] for i, e in enumerate(entries, 1) if e.kind in rows}
