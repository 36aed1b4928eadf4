"""The arguments of Modelica's own functions."""

from __future__ import annotations

from collections.abc import Callable

from pam_cosim.compiler.evaluation import Environment, Evaluator, Value
from pam_cosim.compiler.instance import Scope
from pam_cosim.compiler.syntax import Call
from pam_cosim.errors import ModelError

Builtin = Callable[[Evaluator, Call, Scope, Environment], Value]


def evaluated_arguments(
    evaluator: Evaluator, node: Call, scope: Scope, names: Environment, *counts: int
) -> list[Value]:
    """Values of the arguments, none of which has a name.

    Raises:
        ModelError: there are not as many as one of ``counts``.
    """
    if node.named or (counts and len(node.arguments) not in counts):
        wanted = " or ".join(map(str, counts))
        raise ModelError(f"{node.function.text}() takes {wanted} arguments, without names")
    return [evaluator.evaluate(argument, scope, names) for argument in node.arguments]


def argument_at(position: int, *counts: int, name: str = "") -> Builtin:
    """A function that returns one of its arguments, which may be given by ``name``."""

    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        if len(node.arguments) not in counts and not node.named:
            raise ModelError(
                f"{node.function.text}() takes {' or '.join(map(str, counts))} arguments"
            )
        if node.named and position >= len(node.arguments):
            named = dict(node.named)
            if name not in named:
                raise ModelError(f"{node.function.text}() has no argument '{name}'")
            return evaluator.evaluate(named[name], scope, names)
        return evaluator.evaluate(node.arguments[position], scope, names)

    return builtin
