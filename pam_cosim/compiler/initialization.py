"""Initial values of the states as functions of the parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from pam_cosim.compiler.blocks import solve
from pam_cosim.compiler.flattening import Residual
from pam_cosim.errors import ModelError

_CONSISTENT = 1e-9


@dataclass(frozen=True)
class Start:
    """The start attribute of a variable: a guess, or an equation if ``fixed``."""

    value: ca.SX
    fixed: bool
    place: str


def initial_values(
    states: Sequence[str],
    symbols: Mapping[str, ca.SX],
    starts: Mapping[str, Start],
    equations: Sequence[Residual],
    defaults: tuple[ca.SX, ca.SX],
) -> list[ca.SX]:
    """One expression for each state, in terms of parameters.

    Fixed starts of states count first, then the initial equations (fixed starts of other variables among
    them) in turn; a state that they leave open begins at its start value.

    Args:
        states: names of the states.
        symbols: symbols by name.
        starts: start values by name, of the states.
        equations: initial equations in terms of states and parameters (time and algebraic variables put in).
        defaults: the parameters' symbols and values, to judge superfluous equations.

    Raises:
        ModelError: initial equations that contradict each other or cannot be solved.
    """
    known = {name: starts[name].value for name in states if starts[name].fixed}
    pending: list[Residual] = []
    superfluous: list[Residual] = []
    taken: dict[str, int] = {}
    names_of: list[list[str]] = []
    for equation in equations:
        expression = _put_in(equation.expression, known, symbols)
        names = [s.name() for s in ca.symvar(expression) if s.name() in states]
        pending.append(Residual(expression, equation.place))
        names_of.append(names)
        if not _match(len(pending) - 1, names_of, taken, set()):
            superfluous.append(pending.pop())
            names_of.pop()
    for name in states:
        if name not in known and name not in taken:
            known[name] = starts[name].value
    pending = [Residual(_put_in(r.expression, known, symbols), r.place) for r in pending]
    open_names = [name for name in states if name in taken]
    try:
        known |= solve(pending, open_names, symbols)
    except ModelError as error:
        raise ModelError(f"initial values: {error.message}") from None
    _check_superfluous(superfluous, known, symbols, defaults)
    return [known[name] for name in states]


def _match(equation: int, names_of: Sequence[Sequence[str]], taken: dict[str, int], seen: set[str]) -> bool:
    for name in names_of[equation]:
        if name not in seen:
            seen.add(name)
            if name not in taken or _match(taken[name], names_of, taken, seen):
                taken[name] = equation
                return True
    return False


def _put_in(expression: ca.SX, known: Mapping[str, ca.SX], symbols: Mapping[str, ca.SX]) -> ca.SX:
    names = [s.name() for s in ca.symvar(expression) if s.name() in known]
    if not names:
        return expression
    old, new = ca.vertcat(*[symbols[n] for n in names]), ca.vertcat(*[known[n] for n in names])
    return ca.substitute(expression, old, new)


def _check_superfluous(
    equations: Sequence[Residual],
    known: Mapping[str, ca.SX],
    symbols: Mapping[str, ca.SX],
    defaults: tuple[ca.SX, ca.SX],
) -> None:
    """An initial equation too many is tolerated if it holds at the default parameters."""
    for equation in equations:
        rest = ca.substitute(_put_in(equation.expression, known, symbols), *defaults)
        value = float(ca.evalf(rest)) if not ca.symvar(rest) else float("nan")
        if not np.isfinite(value) or abs(value) > _CONSISTENT:
            raise ModelError(f"the initial values are overdetermined: {equation.place} contradicts the others")
