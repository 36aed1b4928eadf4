"""A Modelica expression of arithmetic and elementary functions on arrays of numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from operator import add, mul, neg, pos, pow, sub, truediv
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.compiler.budget import bounded
from pam_cosim.compiler.expression_parser import ExpressionParser
from pam_cosim.compiler.lexer import tokenise
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import Binary, Call, Expression, Literal, Reference, Unary
from pam_cosim.errors import ModelError
from pam_cosim.wording import did_you_mean

_BINARY: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": add,
    "-": sub,
    "*": mul,
    "/": truediv,
    "^": pow,
}
_UNARY: Mapping[str, Callable[[Any], Any]] = {"+": pos, "-": neg}
_NAMES = ("exp", "log", "log10", "sqrt", "sin", "cos", "tan", "sinh", "cosh", "tanh", "abs")
_FUNCTIONS = {name: getattr(np, name) for name in _NAMES}
_FUNCTIONS |= {name: getattr(np, f"arc{name[1:]}") for name in ("asin", "acos", "atan")}

_NOT_ARITHMETIC = "only arithmetic and elementary functions of known names can be evaluated here"


def elementwise(text: str, values: Mapping[str, Array | float]) -> Array:
    """The value of an expression, element by element.

    Args:
        text: Modelica; its names are those of ``values``.
        values: arrays of one shape, or numbers.

    Raises:
        ModelError: the text is no expression, or holds something else than arithmetic and elementary functions.
    """
    return np.asarray(evaluate(text, values), dtype=np.float64)


def evaluate(
    text: str, values: Mapping[str, Any], quantity: Callable[[str], Any] | None = None
) -> Any:
    """The value of an expression of objects with arithmetic, such as arrays with units.

    Args:
        text: Modelica; nothing of it is ever run.
        values: by name.
        quantity: what a text in quotes stands for.

    Raises:
        ModelError: as ``elementwise``.
    """
    return _bounded_value(_parsed(text), _Variables(values, quantity))


def with_place(problem: ModelError) -> str:
    """What is wrong with a single expression, and at which of its characters."""
    return (
        f"{problem.message} (at character {problem.column})" if problem.column else problem.message
    )


@dataclass(frozen=True)
class _Variables:
    values: Mapping[str, Any]
    quantity: Callable[[str], Any] | None


@lru_cache(maxsize=1024)
@bounded
def _parsed(text: str) -> Expression:
    source = SourceText("expression", text)
    parser = ExpressionParser(source, tokenise(source))
    expression = parser.expression()
    if parser.kind != "end of file":
        parser.fail(f"expected an operator, found '{parser.text}'")
    return expression


@bounded
def _bounded_value(node: Expression, variables: _Variables) -> Any:
    return _value(node, variables)


def _value(node: Expression, variables: _Variables) -> Any:
    match node:
        case Literal():
            return _literal_value(node, variables)
        case Reference():
            return _named_value(node.text, variables)
        case Unary(operator=operator) if operator in _UNARY:
            return _UNARY[operator](_value(node.operand, variables))
        case Binary(operator=operator) if operator in _BINARY:
            return _BINARY[operator](_value(node.left, variables), _value(node.right, variables))
        case Call(arguments=[argument]) if node.function.text in _FUNCTIONS:
            return _FUNCTIONS[node.function.text](_value(argument, variables))
    raise ModelError(_NOT_ARITHMETIC)


def _literal_value(literal: Literal, variables: _Variables) -> Any:
    if isinstance(literal.value, int | float):
        return float(literal.value)
    if isinstance(literal.value, str) and variables.quantity is not None:
        return variables.quantity(literal.value)
    raise ModelError(_NOT_ARITHMETIC)


def _named_value(name: str, variables: _Variables) -> Any:
    if name not in variables.values:
        names = (other for other in variables.values if not other.startswith("'"))
        raise ModelError(f"there is no '{name}'; {did_you_mean(name, names)}")
    return variables.values[name]
