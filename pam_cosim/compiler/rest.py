"""States that begin at rest: initial equations ``der(x) = 0``, where the model settles when a run begins.

Rates are seldom linear in the states, and who solves for the states at rest needs numbers: the inputs at the start.
So the compiler lists these states and their initial guesses; the runtime finds them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import casadi as ca

from pam_cosim.compiler.flattening import Residual
from pam_cosim.errors import ModelError


def variable_at_rest(residual: Residual, derivative_of: Mapping[str, str]) -> str | None:
    """The variable that an initial equation puts at rest; None: it is another equation."""
    symbols = ca.symvar(residual.expression)
    names = {derivative: name for name, derivative in derivative_of.items()}
    if len(symbols) != 1 or symbols[0].name() not in names:
        return None
    slope = ca.jacobian(residual.expression, symbols[0])
    offset = ca.substitute(residual.expression, symbols[0], ca.SX(0))
    return names[symbols[0].name()] if slope.is_constant() and offset.is_zero() else None


@dataclass
class AtRest:
    """What the equations ``der(x) = 0`` come to.

    Attributes:
        states: names of the states that begin at rest.
        equations: of these states, as they are written.
        guesses: what stands in their place where the rest is still to be found: start values.
        other_equations: equations ``der(x) = 0`` that determine something else.
    """

    states: list[str] = field(default_factory=list)
    equations: list[Residual] = field(default_factory=list)
    guesses: list[Residual] = field(default_factory=list)
    other_equations: list[Residual] = field(default_factory=list)

    def add(self, state: str, equation: Residual, guess: Residual) -> None:
        """One more state that begins at rest."""
        self.states.append(state)
        self.equations.append(equation)
        self.guesses.append(guess)


def at_rest(
    conditions: Sequence[tuple[str, Residual, Residual]],
    states: Sequence[str],
    depends_on: Callable[[str], set[str]],
    is_open: Callable[[Residual], bool],
) -> AtRest:
    """Which states begin at rest.

    A variable that is no state is at rest where the states are that it is made of. If all but one of them are known to
    be, that one is too.

    Args:
        conditions: for each equation the variable, the equation, and "the variable is its start value".
        states: names of all states.
        depends_on: names of what a variable that is no state is made of.
        is_open: whether that start would determine something that nothing else does; it is then kept.
    """
    result = AtRest()
    for name, equation, guess in (condition for condition in conditions if condition[0] in states):
        if is_open(guess):
            result.add(name, equation, guess)
        else:
            result.other_equations.append(equation)
    for name, equation, guess in (
        condition for condition in conditions if condition[0] not in states
    ):
        moving = [
            state for state in states if state in depends_on(name) and state not in result.states
        ]
        if len(moving) == 1 and is_open(guess):
            result.add(moving[0], equation, guess)
        elif moving:
            result.other_equations.append(equation)
    return result


def leans_on(value: ca.SX, resting: Sequence[str]) -> bool:
    """Whether an initial value depends on a state whose value is not known before the model has settled."""
    return any(symbol.name() in resting for symbol in ca.symvar(value))


def refuse_parameters(following: Mapping[str, ca.SX], late: Mapping[str, ca.SX]) -> None:
    """Raises:
    ModelError: a parameter that is not fixed would have to be found with the rest.
    """
    for name in following:
        if name in late:
            raise ModelError(
                f"the parameter '{name}' depends on states that begin at rest, known only when the model has settled"
            )
