"""Initial values of the states as functions of the parameters, and of the inputs as they are at the start."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from pam_cosim.compiler.blocks import solve
from pam_cosim.compiler.flattening import Residual
from pam_cosim.compiler.index_reduction import EquationSystem
from pam_cosim.compiler.matching import Matching
from pam_cosim.errors import ModelError

_CONSISTENT = 1e-9


@dataclass(frozen=True)
class StartAttribute:
    """The start attribute of a variable: a guess, or an equation if ``fixed``."""

    value: ca.SX
    fixed: bool
    place: str


def initial_values(
    system: EquationSystem,
    states: Sequence[str],
    starts: Mapping[str, StartAttribute],
    equations: Sequence[Residual],
    defaults: tuple[ca.SX, ca.SX],
    late: Mapping[str, ca.SX],
    present: frozenset[str] = frozenset(),
) -> tuple[list[ca.SX], dict[str, ca.SX]]:
    """One expression for each state, in terms of parameters and inputs, and one for each parameter that is not fixed.

    At the start all equations of the model hold, and so many more as there are states and parameters that are not
    fixed: the fixed starts, then the initial equations; what these leave open is determined by the starts of states
    that are not fixed. The parameters may depend on time, which is then that of the start.

    Args:
        system: the equations after index reduction.
        states: names of the states.
        starts: the start values, by name, of states and of all variables with a fixed start.
        equations: initial equations.
        defaults: the parameters' symbols and values, to judge superfluous equations.
        late: symbols of the parameters that are not fixed.
        present: inputs on which states may depend, as they are at the start.

    Raises:
        ModelError: initial equations that contradict each other or cannot be solved.
    """
    unknown = {**system.variables, **late}
    fixed = [_start_equation(system, name, start) for name, start in starts.items() if start.fixed]
    free = [_start_equation(system, name, start) for name, start in starts.items() if not start.fixed]
    chosen = list(system.residuals)
    superfluous: list[Residual] = []
    incidence = [_names(residual, unknown) for residual in chosen]
    matching: Matching[str] = Matching()
    for i in range(len(chosen)):
        matching.add(i, incidence.__getitem__)
    for number, equation in enumerate([*fixed, *equations, *free]):
        incidence.append(_names(equation, unknown))
        if len(chosen) < len(unknown) and matching.add(len(chosen), incidence.__getitem__):
            chosen.append(equation)
            continue
        incidence.pop()
        if number < len(fixed) + len(equations):
            superfluous.append(equation)
    wanted = dict.fromkeys([*states, *late, *(name for r in superfluous for name in _names(r, unknown))])
    try:
        solved = solve([_at_start(r, system, late) for r in chosen], list(unknown), unknown, wanted)
    except ModelError as error:
        raise ModelError(f"initial values: {error.message}") from None
    _check_superfluous(superfluous, solved, unknown, defaults)
    for name in (*states, *late):
        refused = system.inputs - present if name in states else system.inputs
        inputs = [symbol.name() for symbol in ca.symvar(solved[name]) if symbol.name() in refused]
        if inputs:
            raise ModelError(f"the initial value of '{name}' depends on the input '{inputs[0]}'")
    values = [ca.substitute(solved[name], system.time, ca.SX(0)) for name in states]
    return values, {name: solved[name] for name in late}


def _at_start(residual: Residual, system: EquationSystem, late: Mapping[str, ca.SX]) -> Residual:
    """The equation at time zero; one that determines a parameter keeps the time, which is that of the start."""
    names = residual.names
    if late.keys() & names or system.time.name() not in names:
        return residual
    return Residual(ca.substitute(residual.expression, system.time, ca.SX(0)), residual.place)


def _start_equation(system: EquationSystem, name: str, start: StartAttribute) -> Residual:
    return Residual(system.variables[name] - start.value, start.place)


def _names(residual: Residual, unknown: Mapping[str, ca.SX]) -> list[str]:
    return [name for name in residual.names if name in unknown]


def _check_superfluous(
    equations: Sequence[Residual],
    solved: Mapping[str, ca.SX],
    unknown: Mapping[str, ca.SX],
    defaults: tuple[ca.SX, ca.SX],
) -> None:
    """An initial equation too many is tolerated if it holds at the default parameters."""
    for equation in equations:
        names = _names(equation, unknown)
        old = ca.vertcat(ca.SX(0, 1), *[unknown[n] for n in names])
        new = ca.vertcat(ca.SX(0, 1), *[solved[n] for n in names])
        rest = ca.substitute(ca.substitute(equation.expression, old, new), *defaults)
        value = float(ca.evalf(rest)) if not ca.symvar(rest) else float("nan")
        if not np.isfinite(value) or abs(value) > _CONSISTENT:
            raise ModelError(f"the initial values are overdetermined: {equation.place} contradicts the others")
