"""``assert(condition, message, level)`` (Modelica 3.6, section 8.3.7)."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.arithmetic import Text
from pam_cosim.compiler.evaluation import Environment, Evaluator
from pam_cosim.compiler.instance import Scope
from pam_cosim.compiler.names_of_references import ENUMERATIONS
from pam_cosim.compiler.syntax import Call, Expression
from pam_cosim.errors import ModelError

_ARGUMENTS = ("condition", "message", "level")


@dataclass(frozen=True)
class Assertion:
    """An assertion whose condition depends on variables: the compiler decides constant ones.

    Attributes:
        condition: not zero where it holds.
        message: printed where it does not.
        is_error: whether a failure ends the simulation; otherwise it is a warning.
        at_start: the condition is checked at the start alone.
    """

    condition: ca.SX
    message: Text
    is_error: bool
    at_start: bool


def check(
    evaluator: Evaluator, call: Call, scope: Scope, names: Environment, at_start: bool = False
) -> None:
    """Evaluates a call of ``assert``; the evaluator keeps a condition that is not constant.

    Raises:
        ModelError: the condition is false for all values, or the arguments cannot be used.
    """
    given = _arguments(call)
    condition = evaluator.evaluate(given["condition"], scope, names)
    if condition is True:
        return
    if not isinstance(condition, bool | ca.SX):
        raise ModelError("the condition of assert() must be a Boolean")
    message = arithmetic.text_of(evaluator.evaluate(given["message"], scope, names))
    if scope.instance is not None and scope.instance.name:
        message = Text((f"{scope.instance.name}: ", *message.parts))
    is_error = _is_error(evaluator, given.get("level"), scope, names)
    for taken in evaluator.branches:
        condition = arithmetic.binary("or", arithmetic.unary("not", taken), condition)
    if condition is False and is_error:
        printed = [part if isinstance(part, str) else "..." for part in message.parts]
        raise ModelError(f"assertion fails: {''.join(printed)}")
    if condition is not True:
        evaluator.assertion(condition, message, is_error, at_start)


def _arguments(call: Call) -> dict[str, Expression]:
    """The arguments of the call by name."""
    given = dict(zip(_ARGUMENTS, call.arguments, strict=False)) | dict(call.named)
    is_complete = set(_ARGUMENTS[:2]) <= given.keys() <= set(_ARGUMENTS)
    if len(call.arguments) > len(_ARGUMENTS) or not is_complete:
        raise ModelError("assert() takes a condition, a message and a level")
    return given


def _is_error(
    evaluator: Evaluator, level: Expression | None, scope: Scope, names: Environment
) -> bool:
    """Whether the level is that of an error, which is the default; otherwise it is that of a warning."""
    if level is None:
        return True
    name = getattr(evaluator.evaluate(level, scope, names), "name", None)
    if name not in ENUMERATIONS["AssertionLevel"]:
        raise ModelError(
            "the level of assert() must be AssertionLevel.error or AssertionLevel.warning"
        )
    return bool(name == "error")
