"""A Modelica expression of arithmetic and elementary functions on arrays of numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache
from operator import add, mul, neg, pos, pow, sub, truediv
from typing import Any

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.compiler.expression_parser import ExpressionParser
from pam_cosim.compiler.lexer import tokenise
from pam_cosim.compiler.source import Source
from pam_cosim.compiler.syntax import Binary, Call, Expression, Literal, Reference, Unary
from pam_cosim.errors import ModelError

_BINARY: Mapping[str, Callable[[Any, Any], Any]] = {"+": add, "-": sub, "*": mul, "/": truediv, "^": pow}
_UNARY: Mapping[str, Callable[[Any], Any]] = {"+": pos, "-": neg}
_FUNCTIONS = {name: getattr(np, name) for name in ("exp", "log", "sqrt", "sin", "cos", "tanh")}


def elementwise(text: str, values: Mapping[str, Array | float]) -> Array:
    """The value of an expression, element by element.

    Args:
        text: Modelica; its names are those of ``values``.
        values: arrays of one shape, or numbers.

    Raises:
        ModelError: the text is no expression, or holds something else than arithmetic and elementary functions.
    """
    return np.asarray(_value(_parsed(text), values), dtype=np.float64)


@lru_cache(maxsize=1024)
def _parsed(text: str) -> Expression:
    source = Source("expression", text)
    return ExpressionParser(source, tokenise(source)).expression()


def _value(node: Expression, values: Mapping[str, Array | float]) -> Any:
    if isinstance(node, Literal) and isinstance(node.value, int | float):
        return node.value
    if isinstance(node, Reference) and node.text in values:
        return values[node.text]
    if isinstance(node, Unary) and node.operator in _UNARY:
        return _UNARY[node.operator](_value(node.operand, values))
    if isinstance(node, Binary) and node.operator in _BINARY:
        return _BINARY[node.operator](_value(node.left, values), _value(node.right, values))
    if isinstance(node, Call) and node.function.text in _FUNCTIONS and len(node.arguments) == 1:
        return _FUNCTIONS[node.function.text](_value(node.arguments[0], values))
    raise ModelError("only arithmetic and elementary functions of known names can be evaluated here")
