"""``assert(condition, message, level)`` (Modelica 3.6, section 8.3.7)."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.arithmetic import Text
from pam_cosim.compiler.evaluation import ENUMERATIONS, Environment, Evaluator
from pam_cosim.compiler.instance import Scope
from pam_cosim.compiler.syntax import Call
from pam_cosim.errors import ModelError

_ARGUMENTS = ("condition", "message", "level")


@dataclass(frozen=True)
class Assertion:
    """A condition that a model states of itself; symbolic, or it would have been decided already.

    Attributes:
        condition: not zero where it holds.
        message: what is said where it does not.
        is_error: whether the model cannot go on then; otherwise it is a warning.
        at_start: it says something of the start alone.
    """

    condition: ca.SX
    message: Text
    is_error: bool
    at_start: bool


def check(
    evaluator: Evaluator, call: Call, scope: Scope, names: Environment, at_start: bool = False
) -> None:
    """Evaluates a call of ``assert``; what is not known to hold is noted by the evaluator.

    Raises:
        ModelError: it is known to fail, or its arguments cannot be used.
    """
    given = dict(zip(_ARGUMENTS, call.arguments, strict=False)) | dict(call.named)
    if (
        len(call.arguments) > len(_ARGUMENTS)
        or set(given) - set(_ARGUMENTS)
        or not set(given) >= {*_ARGUMENTS[:2]}
    ):
        raise ModelError("assert() takes a condition, a message and a level")
    condition = evaluator.evaluate(given["condition"], scope, names)
    if condition is True:
        return
    if not isinstance(condition, bool | ca.SX):
        raise ModelError("the condition of assert() must be a Boolean")
    message = arithmetic.text_of(evaluator.evaluate(given["message"], scope, names))
    if scope.instance is not None and scope.instance.name:
        message = Text((f"{scope.instance.name}: ", *message.parts))
    level = evaluator.evaluate(given["level"], scope, names) if "level" in given else None
    name = "error" if level is None else getattr(level, "name", None)
    if name not in ENUMERATIONS["AssertionLevel"]:
        raise ModelError(
            "the level of assert() must be AssertionLevel.error or AssertionLevel.warning"
        )
    for taken in evaluator.branches:
        condition = arithmetic.binary("or", arithmetic.unary("not", taken), condition)
    if condition is False and name == "error":
        raise ModelError(
            f"assertion fails: {''.join(p if isinstance(p, str) else '...' for p in message.parts)}"
        )
    if condition is not True:
        evaluator.assertion(condition, message, name == "error", at_start)
