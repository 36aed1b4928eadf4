"""Pantelides' algorithm and dummy derivatives: which equations to differentiate, which variables are states.

Sources: C. C. Pantelides, SIAM J. Sci. Stat. Comput. 9 (1988) 213-231; S. E. Mattsson, G. Soderlind,
SIAM J. Sci. Comput. 14 (1993) 677-692. States are chosen so that what is left can be solved: of the
variables that a differentiated equation constrains, one that appears linearly becomes the dummy, and one
that the model prefers as a state (``stateSelect``, ``fixed = true``) does not, if there is a choice.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from pam_cosim.compiler.budget import check_operations
from pam_cosim.compiler.flattening import Residual
from pam_cosim.compiler.matching import Matching
from pam_cosim.errors import ModelError

_FORBIDDEN = 1e9
_NONLINEAR = 1e3
_PREFERENCE = 1e2
_DERIVATIVE = 50.0
_MOST_DIFFERENTIATIONS = 400


@dataclass
class EquationSystem:
    """Equations in variables and their derivatives.

    Attributes:
        variables: all unknown symbols, derivatives included, by name.
        derivative_of: name of the derivative by name of the variable.
        residuals: the equations; those made by differentiation come last.
        differentiated: number of the derived equation by number of the equation.
        inputs: names of the inputs.
        time: the symbol of time.
    """

    variables: dict[str, ca.SX]
    derivative_of: dict[str, str]
    residuals: list[Residual]
    inputs: frozenset[str]
    time: ca.SX
    differentiated: dict[int, int] = field(default_factory=dict)


@dataclass(frozen=True)
class StateSelection:
    """Names of the states, and of everything else that has to be solved for."""

    states: list[str]
    unknowns: list[str]


def reduce_index(system: EquationSystem) -> None:
    """Differentiate equations until every variable of highest order has an equation of its own.

    Raises:
        ModelError: there are too many or too few equations, or an input would have to be differentiated.
    """
    incidence = [_names(residual, system.variables) for residual in system.residuals]
    _check_structure(system, incidence)
    assigned: Matching[str] = Matching()
    most = _MOST_DIFFERENTIATIONS + 3 * len(system.residuals)

    def highest(number: int) -> list[str]:
        return [name for name in incidence[number] if name not in system.derivative_of]

    for start in range(len(system.residuals)):
        equation = start
        while not assigned.add(equation, highest):
            equations, names = sorted(assigned.seen_equations), assigned.seen_variables
            if len(system.residuals) > most:
                raise ModelError(
                    "the equations do not determine the variables: index reduction finds no end"
                )
            for name in names:
                _add_derivative(system, name)
            for number in equations:
                system.residuals.append(_differentiate(system, system.residuals[number]))
                incidence.append(_names(system.residuals[-1], system.variables))
                system.differentiated[number] = len(system.residuals) - 1
            for name in names:
                assigned[system.derivative_of[name]] = system.differentiated[assigned[name]]
            equation = system.differentiated[equation]


def _names(residual: Residual, variables: Mapping[str, ca.SX]) -> list[str]:
    return [name for name in residual.names if name in variables]


def _add_derivative(system: EquationSystem, name: str) -> None:
    if name not in system.derivative_of:
        derivative = f"der({name})"
        system.derivative_of[name] = derivative
        system.variables[derivative] = ca.SX.sym(derivative)


def _differentiate(system: EquationSystem, residual: Residual) -> Residual:
    """Total derivative of an equation with respect to time."""
    symbols = ca.symvar(residual.expression)
    varying = []
    for symbol in symbols:
        name = symbol.name()
        if name in system.inputs:
            raise ModelError(
                f"this model needs the derivative of its input '{name}', because of {residual.place}. "
                "Pass the input through a first-order lag, or make its derivative an input"
            )
        if name in system.variables:
            _add_derivative(system, name)
            varying.append((symbol, system.variables[system.derivative_of[name]]))
        elif name == system.time.name():
            varying.append((symbol, ca.SX(1)))
    if not varying:
        raise ModelError(f"this equation holds parameters only: {residual.place}")
    arguments = ca.vertcat(*[symbol for symbol, _ in varying])
    direction = ca.vertcat(*[rate for _, rate in varying])
    derivative = ca.jtimes(residual.expression, arguments, direction)
    check_operations(ca.n_nodes(derivative))
    return Residual(derivative, f"derivative of {residual.place}")


def _check_structure(system: EquationSystem, incidence: Sequence[Sequence[str]]) -> None:
    """Every equation and every variable must find a partner when x and der(x) count as one."""
    base = {derivative: name for name, derivative in system.derivative_of.items()}
    merged = [list(dict.fromkeys(base.get(name, name) for name in names)) for names in incidence]
    assigned: Matching[str] = Matching()
    unmatched = [i for i in range(len(merged)) if not assigned.add(i, merged.__getitem__)]
    free = [name for name in system.variables if name not in base and name not in assigned]
    if unmatched or free:
        raise ModelError(_imbalance(system, unmatched, free, len(system.variables) - len(base)))


def _imbalance(
    system: EquationSystem, unmatched: Sequence[int], free: Sequence[str], count: int
) -> str:
    text = f"the model has {len(system.residuals)} equations for {count} variables"
    if free:
        text += f"; no equation determines {_listed([f'{name!r}' for name in free])}"
    if unmatched:
        text += f"; superfluous: {_listed([system.residuals[i].place for i in unmatched])}"
    return text


def _listed(items: Sequence[str], most: int = 8) -> str:
    shown = "; ".join(items[:most])
    return shown + (f" and {len(items) - most} more" if len(items) > most else "")


def select_states(system: EquationSystem, preference: Callable[[str], float]) -> StateSelection:
    """Choose the states.

    Args:
        system: after index reduction.
        preference: how strongly a variable is preferred as a state; 0 is neutral.
    """
    candidates = list(system.derivative_of)
    constraints = sorted(system.differentiated)
    dummies: set[str] = set()
    if constraints:
        costs = np.full((len(constraints), len(candidates)), _FORBIDDEN)
        position = {name: j for j, name in enumerate(candidates)}
        for i, number in enumerate(constraints):
            expression = system.residuals[number].expression
            for name in _names(system.residuals[number], system.variables):
                if name in position:
                    j = position[name]
                    costs[i, j] = _dummy_cost(expression, system.variables[name], name, preference)
                    costs[i, j] -= 1e-3 * j
        from scipy.optimize import (
            linear_sum_assignment,
        )  # a third of a second, which no model from the cache needs

        rows, columns = linear_sum_assignment(costs)
        if len(rows) < len(constraints) or costs[rows, columns].max() >= _FORBIDDEN / 2:
            raise ModelError(
                "index reduction finds no set of states: the constraints contradict each other"
            )
        dummies = {candidates[j] for j in columns}
    states = [name for name in candidates if name not in dummies]
    unknowns = [name for name in system.variables if name not in states]
    return StateSelection(states, unknowns)


def _dummy_cost(
    expression: ca.SX, symbol: ca.SX, name: str, preference: Callable[[str], float]
) -> float:
    """How bad it is to compute this variable from this equation instead of integrating it."""
    slope = ca.jacobian(expression, symbol)
    cost = _PREFERENCE * preference(name)
    if ca.depends_on(slope, symbol):
        cost += _NONLINEAR
    elif not slope.is_constant():
        cost += 10.0
    return cost - (_DERIVATIVE if name.startswith("der(") else 0.0)
