"""Initial values of the states as functions of the parameters, and of the inputs as they are at the start.

States that begin at rest are the exception: they are found when a run begins, see ``rest.py``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from pam_cosim.compiler.blocks import solve
from pam_cosim.compiler.flattening import Residual
from pam_cosim.compiler.index_reduction import EquationSystem
from pam_cosim.compiler.matching import Matching
from pam_cosim.compiler.nonlinear import NonlinearLoops
from pam_cosim.compiler.rest import AtRest, at_rest, leans_on, refuse_parameters, variable_at_rest
from pam_cosim.errors import ModelError

_CONSISTENT = 1e-9


@dataclass(frozen=True)
class StartAttribute:
    """The start attribute of a variable: a guess, or an equation if ``fixed``; ``given``: it is not the usual zero."""

    value: ca.SX
    fixed: bool
    place: str
    given: bool = True


@dataclass(frozen=True)
class InitialValues:
    """Where states and parameters that are not fixed begin.

    Attributes:
        states: one expression for each state, in terms of parameters and inputs.
        parameters: by name; they may depend on time, which is then that of the start.
        resting: names of the states that begin at rest; their expressions are where the rest is sought from.
        following: of states whose initial values depend on those at rest, by name, in terms of these too.
    """

    states: list[ca.SX]
    parameters: dict[str, ca.SX]
    resting: tuple[str, ...]
    following: dict[str, ca.SX]


@dataclass(frozen=True)
class InitialProblem:
    """What is to be found.

    Attributes:
        system: the equations after index reduction.
        states: names of the states.
        solved: every other unknown as an expression of them.
        start: the start value of a variable.
        declared: names of the states and of all variables with a fixed start.
        started: names of all variables that have a start value.
        equations: initial equations.
        defaults: the parameters' symbols and values, to judge superfluous equations.
        late: symbols of the parameters that are not fixed.
        present: inputs on which states may depend, as they are at the start.
        loops: solves nonlinear equations; None: these are errors.
    """

    system: EquationSystem
    states: Sequence[str]
    solved: Mapping[str, ca.SX]
    start: Callable[[str], StartAttribute]
    declared: Sequence[str]
    started: Sequence[str]
    equations: Sequence[Residual]
    defaults: tuple[ca.SX, ca.SX]
    late: Mapping[str, ca.SX]
    present: frozenset[str] = frozenset()
    loops: NonlinearLoops | None = None

    @property
    def unknown(self) -> dict[str, ca.SX]:
        """Symbols of all that is to be found."""
        return {**self.system.variables, **self.late}


def initial_values(problem: InitialProblem) -> InitialValues:
    """At the start all equations of the model hold, and so many more as there are states and parameters that are not
    fixed: the fixed starts, then the initial equations; what these leave open is determined by the starts of states
    that are not fixed.

    Raises:
        ModelError: initial equations that contradict each other or cannot be solved.
    """
    fixed, free = _start_equations(problem)
    still, other_equations = _equations_of_rest(problem)
    imposed = [*fixed, *other_equations]
    equilibrium = _rest(problem, imposed, still)
    time, following = problem.system.time, dict[str, ca.SX]()
    try:
        equations = [*imposed, *equilibrium.other_equations, *equilibrium.equations]
        loops = None if equilibrium.states else problem.loops  # the runtime seeks states at rest
        values = _solution(problem, equations, free, problem.unknown, loops)
    except ModelError:
        if not equilibrium.states:
            raise
        values, following = _sought(problem, imposed, equilibrium, free)
    _refuse_inputs(problem, values)
    return InitialValues(
        [ca.substitute(values[name], time, ca.SX(0)) for name in problem.states],
        {name: values[name] for name in problem.late},
        tuple(name for name in problem.states if name in equilibrium.states),
        {name: ca.substitute(value, time, ca.SX(0)) for name, value in following.items()},
    )


def _start_equations(problem: InitialProblem) -> tuple[list[Residual], list[Residual]]:
    """The equations of start values: those that are fixed, and those that are a guess."""
    fixed: list[Residual] = []
    free: list[Residual] = []
    for name in problem.declared:
        start = problem.start(name)
        equation = _start_equation(problem.system, name, start)
        (fixed if start.fixed else free).append(equation)
    return fixed, free


def _equations_of_rest(
    problem: InitialProblem,
) -> tuple[list[tuple[str, Residual]], list[Residual]]:
    """The initial equations ``der(x) = 0``, with the variable that is at rest, and the other ones."""
    still: list[tuple[str, Residual]] = []
    other_equations: list[Residual] = []
    for equation in problem.equations:
        name = variable_at_rest(equation, problem.system.derivative_of)
        if name is None:
            other_equations.append(equation)
        else:
            still.append((name, equation))
    return still, other_equations


def _rest(
    problem: InitialProblem, imposed: Sequence[Residual], still: Sequence[tuple[str, Residual]]
) -> AtRest:
    """Which states the equations ``der(x) = 0`` put at rest, given the equations that are imposed."""
    if not still:
        return AtRest()
    chosen = _Chosen(problem.system.residuals, problem.unknown)
    for equation in imposed:
        chosen.add(equation)
    starts = [(name, equation, problem.start(name)) for name, equation in still]
    return at_rest(
        [
            (name, equation, _start_equation(problem.system, name, start))
            for name, equation, start in starts
        ],
        problem.states,
        lambda name: {symbol.name() for symbol in ca.symvar(problem.solved[name])},
        chosen.add,
    )


def _sought(
    problem: InitialProblem,
    imposed: Sequence[Residual],
    equilibrium: AtRest,
    free: Sequence[Residual],
) -> tuple[dict[str, ca.SX], dict[str, ca.SX]]:
    """The values from which the states at rest are sought, those of the others, and what follows the states at rest.

    A state without a start value follows from the start values of other variables, a mass from a temperature.
    """
    moving = {
        name: symbol for name, symbol in problem.unknown.items() if name not in equilibrium.states
    }
    values = _solution(problem, [*imposed, *equilibrium.other_equations], free, moving)
    following = {
        name: value for name, value in values.items() if leans_on(value, equilibrium.states)
    }
    refuse_parameters(following, problem.late)
    stated_guesses = [
        guess
        for name, guess in zip(equilibrium.states, equilibrium.guesses, strict=True)
        if problem.start(name).given
    ]
    other_variables = [] if len(stated_guesses) == len(equilibrium.states) else problem.started
    other_guesses = [
        _start_equation(problem.system, name, problem.start(name)) for name in other_variables
    ]
    guesses = [*stated_guesses, *other_guesses, *equilibrium.guesses, *free]
    guessed = _solution(problem, [*imposed, *equilibrium.other_equations], guesses, problem.unknown)
    return values | {name: guessed[name] for name in (*equilibrium.states, *following)}, following


class _Chosen:
    """Equations that determine the unknowns, each of which adds something to those before it."""

    def __init__(self, equations: Sequence[Residual], unknown: Mapping[str, ca.SX]) -> None:
        self.unknown = unknown
        self.equations = list(equations)
        self._incidence = [_names(equation, unknown) for equation in equations]
        self._matching: Matching[str] = Matching()
        for i in range(len(equations)):
            self._matching.add(i, self._incidence.__getitem__)

    def add(self, equation: Residual) -> bool:
        """Whether it determines something that those before it do not."""
        self._incidence.append(_names(equation, self.unknown))
        is_new = len(self.equations) < len(self.unknown)
        if is_new and self._matching.add(len(self.equations), self._incidence.__getitem__):
            self.equations.append(equation)
            return True
        self._incidence.pop()
        return False


def _solution(
    problem: InitialProblem,
    imposed: Sequence[Residual],
    free: Sequence[Residual],
    unknown: Mapping[str, ca.SX],
    loops: NonlinearLoops | None = None,
) -> dict[str, ca.SX]:
    """The states and parameters among the unknowns, from the imposed equations and, if too few, the free ones."""
    chosen = _Chosen(problem.system.residuals, unknown)
    superfluous = [equation for equation in imposed if not chosen.add(equation)]
    for equation in free:
        chosen.add(equation)
    required = [name for name in (*problem.states, *problem.late) if name in unknown]
    wanted = dict.fromkeys([*required, *(name for r in superfluous for name in _names(r, unknown))])
    try:
        equations = [_at_start(r, problem.system, problem.late) for r in chosen.equations]
        solved = solve(equations, list(unknown), unknown, wanted, None, loops)
    except ModelError as error:
        raise ModelError(f"initial values: {error.message}") from None
    _check_superfluous(superfluous, solved, unknown, problem.defaults)
    return {name: solved[name] for name in required}


def _refuse_inputs(problem: InitialProblem, values: Mapping[str, ca.SX]) -> None:
    for name, value in values.items():
        refused = problem.system.inputs - (
            problem.present if name in problem.states else frozenset()
        )
        inputs = [symbol.name() for symbol in ca.symvar(value) if symbol.name() in refused]
        if inputs:
            raise ModelError(f"the initial value of '{name}' depends on the input '{inputs[0]}'")


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
        residual = ca.substitute(ca.substitute(equation.expression, old, new), *defaults)
        value = float(ca.evalf(residual)) if not ca.symvar(residual) else float("nan")
        if not np.isfinite(value) or abs(value) > _CONSISTENT:
            raise ModelError(
                f"the initial values are overdetermined: {equation.place} contradicts the others"
            )
