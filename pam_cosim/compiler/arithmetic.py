"""Modelica's operators on Python constants, CasADi scalars and nested lists of them.

``if`` and the comparisons of CasADi evaluate both branches. The value of the branch not taken is discarded
whatever it is, but in a derivative 0*inf is NaN: an expression must have finite derivatives on both sides.
The same holds for max and min (fmax, fmin), abs at zero (derivative 0), and sqrt or a power at zero (infinite).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import add, eq, ge, gt, le, lt, mul, ne, sub
from typing import Any

import casadi as ca

from pam_cosim.compiler.budget import checked_number, checked_text, work
from pam_cosim.errors import ModelError

Value = Any
_SYMBOLIC = 20  # steps that an operation of expressions takes


class ArithmeticProblem(ModelError):
    """An operation that has no result; the evaluator adds the place."""


@dataclass(frozen=True)
class PrintedNumber:
    """A number as ``String`` writes it, with so many significant digits."""

    value: ca.SX
    digits: int


@dataclass(frozen=True)
class Text:
    """A String with numbers in it that are known only when the model runs."""

    parts: tuple[str | PrintedNumber, ...]


def text_of(value: Value) -> Text:
    """Any String as a ``Text``.

    Raises:
        ArithmeticProblem: it is no String.
    """
    if isinstance(value, Text):
        return value
    if not isinstance(value, str):
        raise ArithmeticProblem("a String is needed: write String(x) for a number")
    return Text((value,))


def is_symbolic(value: Value) -> bool:
    """Whether a scalar is a CasADi expression."""
    return isinstance(value, ca.SX)


def simplified(value: Value) -> Value:
    """A CasADi expression without symbols as a float."""
    if isinstance(value, ca.SX) and value.is_constant():
        return float(value)
    return value


def each(function: Callable[..., Value], *operands: Value) -> Value:
    """Apply a scalar function element by element; scalars go with every element."""
    sizes = [len(operand) for operand in operands if isinstance(operand, list)]
    if not sizes:
        return function(*operands)
    if any(size != sizes[0] for size in sizes):
        raise ArithmeticProblem(f"arrays of different sizes: {' and '.join(map(str, sizes))}")
    return [
        each(
            function,
            *(operand[i] if isinstance(operand, list) else operand for operand in operands),
        )
        for i in range(sizes[0])
    ]


def unary(operator: str, value: Value) -> Value:
    """``+``, ``-`` or ``not``."""
    if operator == "not":
        return each(_not, value)
    return each(lambda x: -_number(x), value) if operator == "-" else value


def binary(operator: str, left: Value, right: Value) -> Value:
    """Any operation of two operands."""
    if operator in ("*", "/", "^") and (isinstance(left, list) or isinstance(right, list)):
        return _array_operation(operator, left, right)
    if operator in ("+", "-") and isinstance(left, list) != isinstance(right, list):
        raise ArithmeticProblem(f"'{operator}' between an array and a scalar: write '.{operator}'")
    if operator == "+" and isinstance(left, str) and isinstance(right, str):
        return checked_text(left + right)
    if operator == "+" and (isinstance(left, Text) or isinstance(right, Text)):
        return Text(text_of(left).parts + text_of(right).parts)
    return each(_SCALAR[operator.lstrip(".")], left, right)


def _array_operation(operator: str, left: Value, right: Value) -> Value:
    if operator == "*" and isinstance(left, list) and isinstance(right, list):
        return _product(left, right)
    if operator == "*" or (operator == "/" and not isinstance(right, list)):
        return each(_SCALAR[operator], left, right)
    raise ArithmeticProblem(
        f"'{operator}' is not defined between these arrays: write '.{operator}'"
    )


def _product(left: list[Value], right: list[Value]) -> Value:
    """Vector times vector (scalar product), matrix times vector, matrix times matrix."""
    if isinstance(left[0], list):
        return [_product(row, right) for row in left]
    if isinstance(right[0], list):
        return [_product(left, [row[j] for row in right]) for j in range(len(right[0]))]
    work(len(left) * (_SYMBOLIC if is_symbolic(left[0]) or is_symbolic(right[0]) else 1))
    return total(each(_SCALAR["*"], left, right))


def total(values: Sequence[Value]) -> Value:
    """Sum of a flat list."""
    result: Value = 0
    for value in values:
        result = result + value
    return result


def flattened(value: Value) -> list[Value]:
    """All scalars of a nested list, in order."""
    if isinstance(value, list):
        return [scalar for item in value for scalar in flattened(item)]
    return [value]


def _number(value: Value) -> Value:
    if isinstance(value, bool) or not isinstance(value, int | float | ca.SX):
        raise ArithmeticProblem(f"a number is needed, not {_kind(value)}")
    return value


def _kind(value: Value) -> str:
    return {bool: "a Boolean", str: "a String", Text: "a String"}.get(
        type(value), f"'{getattr(value, 'name', value)}'"
    )


def _divide(a: Value, b: Value) -> Value:
    if not is_symbolic(b) and b == 0:
        raise ArithmeticProblem("division by zero")
    return a / b


def _power(a: Value, b: Value) -> Value:
    if is_symbolic(a) or is_symbolic(b):
        return ca.power(a, b)
    try:
        result = math.pow(a, b)
    except (ValueError, ZeroDivisionError, OverflowError):
        raise ArithmeticProblem(f"{a}^{b} has no value") from None
    return result


def _arithmetic(function: Callable[[Value, Value], Value]) -> Callable[[Value, Value], Value]:
    return lambda a, b: checked_number(function(_number(a), _number(b)))


def _comparison(function: Callable[[Value, Value], Value]) -> Callable[[Value, Value], Value]:
    def compare(a: Value, b: Value) -> Value:
        if is_symbolic(a) or is_symbolic(b):
            return _boolean(function(a, b))
        number_a, number_b = getattr(a, "number", a), getattr(b, "number", b)
        return bool(function(number_a, number_b))

    return compare


def _boolean(value: Value) -> Value:
    return bool(float(value)) if isinstance(value, ca.SX) and value.is_constant() else value


def _not(a: Value) -> Value:
    return (not a) if isinstance(a, bool) else ca.logic_not(_condition(a))


def _and(a: Value, b: Value) -> Value:
    if isinstance(a, bool):
        return b if a else False
    if isinstance(b, bool):
        return a if b else False
    return ca.logic_and(_condition(a), _condition(b))


def _or(a: Value, b: Value) -> Value:
    if isinstance(a, bool):
        return True if a else b
    if isinstance(b, bool):
        return True if b else a
    return ca.logic_or(_condition(a), _condition(b))


def _condition(value: Value) -> Value:
    if isinstance(value, bool) or is_symbolic(value):
        return value
    raise ArithmeticProblem(f"a Boolean is needed, not {value!r}")


def only(condition: Value, open_still: Value) -> Value:
    """Whether a branch is the one taken: its condition holds, and ``open_still``, that none of those before it does."""
    return _and(condition, open_still)


def neither(open_still: Value, condition: Value) -> Value:
    """Whether none of the branches so far is taken, nor one of this condition."""
    return _and(open_still, _not(condition))


def select(branches: Sequence[tuple[Value, Value]], otherwise: Value) -> Value:
    """The value of the first branch whose (symbolic) condition holds."""
    result = otherwise
    for condition, value in reversed(branches):
        _condition(condition)
        result = each(
            lambda a, b, c=condition: a if _same(a, b) else ca.if_else(c, a, b), value, result
        )
    return result


def _same(a: Value, b: Value) -> bool:
    if is_symbolic(a) and is_symbolic(b):
        return bool(ca.is_equal(a, b))
    if isinstance(a, bool) or isinstance(b, bool):
        return a is b
    return not is_symbolic(a) and not is_symbolic(b) and a == b


_SCALAR: dict[str, Callable[[Value, Value], Value]] = {
    "+": _arithmetic(add),
    "-": _arithmetic(sub),
    "*": _arithmetic(mul),
    "/": _arithmetic(_divide),
    "^": _arithmetic(_power),
    "<": _comparison(lt),
    "<=": _comparison(le),
    ">": _comparison(gt),
    ">=": _comparison(ge),
    "==": _comparison(eq),
    "<>": _comparison(ne),
    "and": _and,
    "or": _or,
}
