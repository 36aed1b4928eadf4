"""Nonlinear algebraic loops: torn, and solved by a fixed number of Newton steps that become part of the equations."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca

_ITERATIONS = 20
_SHARES = (0.5, 0.2, 0.05)  # of a Newton step that does not make the residual smaller
_LARGEST = 4  # unknowns that are iterated
_CONVERGED = 1e-6  # of the size of an unknown: the last step is not longer


@dataclass
class NonlinearLoops:
    """Solves blocks, from the start values of their variables.

    The last step is a whole Newton step: its derivatives are those of the exact solution.

    Attributes:
        start: the start value of a variable, by name.
        conditions: what holds where the iterations have converged, with the names of the unknowns.
    """

    start: Callable[[str], ca.SX]
    conditions: list[tuple[ca.SX, tuple[str, ...]]] = field(default_factory=list)

    def solve(
        self, system: ca.SX, variables: ca.SX, names: Sequence[str]
    ) -> dict[str, ca.SX] | None:
        """The variables as expressions of what else is in the system; None: too many must be iterated."""
        torn, assigned, implicit = _tear(system, variables, names)
        if len(torn) > _LARGEST:
            return None
        symbols = {name: variables[i] for i, name in enumerate(names)}
        unknown = ca.vertcat(*[symbols[name] for name in torn])
        values: dict[str, ca.SX] = {}
        for name, expression in assigned:
            values[name] = _put(expression, values, symbols)
        residual = _put(ca.vertcat(*implicit), values, symbols)
        external = ca.vertcat(
            ca.SX(0, 1),
            *[s for s in ca.symvar(ca.vertcat(residual, *values.values())) if s.name() not in torn],
        )
        at = ca.Function("residual", [unknown, external], [residual])
        step = ca.Function("step", [unknown, external], [-_solved(residual, unknown)])
        point = ca.vertcat(*[self.start(name) for name in torn])
        for _ in range(_ITERATIONS):
            full_step, before = step(point, external), ca.sumsqr(at(point, external))
            chosen = point + _SHARES[-1] * full_step
            for share in (*reversed(_SHARES[:-1]), 1.0):
                trial = point + share * full_step
                is_better = ca.sumsqr(at(trial, external)) <= before
                chosen = _either(is_better, trial, chosen)
            point = chosen
        last = step(point, external)
        solution = point + last
        size = ca.fmax(ca.fabs(solution), 1e-3)
        self.conditions.append((ca.mmax(ca.fabs(last) / size) <= _CONVERGED, tuple(torn)))
        exact = {name: solution[i] for i, name in enumerate(torn)}
        inner = ca.Function("inner", [unknown, external], list(values.values()) or [ca.SX(0)])
        results = inner.call([solution, external])
        return exact | dict(zip(values, results, strict=False))


def _tear(
    system: ca.SX, variables: ca.SX, names: Sequence[str]
) -> tuple[list[str], list[tuple[str, ca.SX]], list[ca.SX]]:
    """Unknowns that are iterated, those that follow from them in this order, and the equations that are left."""
    open_equations = {i: system[i] for i in range(system.numel())}
    symbols = {name: variables[i] for i, name in enumerate(names)}
    held = {i: {s.name() for s in ca.symvar(e)} & symbols.keys() for i, e in open_equations.items()}
    waiting, torn = list(names), list[str]()
    assigned: list[tuple[str, ca.SX]] = []
    while waiting:
        for i, equation in open_equations.items():
            unsolved = [name for name in waiting if name in held[i]]
            side = _explicit(equation, symbols[unsolved[0]]) if len(unsolved) == 1 else None
            if side is not None:
                assigned.append((unsolved[0], side))
                waiting.remove(unsolved[0])
                del open_equations[i]
                break
        else:
            counts = {n: sum(n in held[i] for i in open_equations) for n in waiting}
            most = max(waiting, key=lambda name: counts[name])
            torn.append(most)
            waiting.remove(most)
    return torn, assigned, list(open_equations.values())


def _explicit(equation: ca.SX, unknown: ca.SX) -> ca.SX | None:
    """The unknown, where the equation is linear in it with a factor that is a number."""
    factor = ca.jacobian(equation, unknown)
    if not factor.is_constant() or factor.is_zero():
        return None
    return -ca.substitute(equation, unknown, ca.SX(0)) / factor


def _put(expression: ca.SX, values: Mapping[str, ca.SX], symbols: Mapping[str, ca.SX]) -> ca.SX:
    if not values:
        return expression
    return ca.substitute(
        expression,
        ca.vertcat(*[symbols[name] for name in values]),
        ca.vertcat(*values.values()),
    )


def _solved(residual: ca.SX, unknown: ca.SX) -> ca.SX:
    """The inverse of the Jacobian times the residual."""
    matrix = ca.densify(ca.jacobian(residual, unknown))
    if matrix.numel() == 1:
        return residual / matrix
    return ca.mtimes(ca.inv_minor(matrix), residual)


def _either(condition: ca.SX, first: ca.SX, second: ca.SX) -> ca.SX:
    return ca.vertcat(*[ca.if_else(condition, first[i], second[i]) for i in range(first.numel())])
