"""Modelica's built-in functions (Modelica 3.6, chapter 3.7 and 10.3)."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.budget import checked_size
from pam_cosim.compiler.evaluation import Environment, Evaluator, Value
from pam_cosim.compiler.instance import Scope
from pam_cosim.compiler.syntax import Call
from pam_cosim.errors import ModelError

Builtin = Callable[[Evaluator, Call, Scope, Environment], Value]


def _scalar(numeric: Callable[..., float], symbolic: Callable[..., Any], count: int = 1) -> Builtin:
    """A mathematical function of ``count`` scalars, applied element by element."""

    def apply(*values: Value) -> Value:
        if any(
            isinstance(value, bool) or not isinstance(value, int | float | ca.SX)
            for value in values
        ):
            raise ModelError("a number is needed as the argument")
        if any(arithmetic.is_symbolic(value) for value in values):
            return symbolic(*values)
        try:
            return numeric(*values)
        except (ValueError, OverflowError, ZeroDivisionError):
            raise ModelError(f"no value for the argument {', '.join(map(str, values))}") from None

    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        return arithmetic.each(apply, *_arguments(evaluator, node, scope, names, count))

    return builtin


def _arguments(
    evaluator: Evaluator, node: Call, scope: Scope, names: Environment, *counts: int
) -> list[Value]:
    if node.named or (counts and len(node.arguments) not in counts):
        wanted = " or ".join(map(str, counts))
        raise ModelError(f"{node.function.text}() takes {wanted} arguments, without names")
    return [evaluator.evaluate(argument, scope, names) for argument in node.arguments]


def _extremum(
    numeric: Callable[[Value, Value], Value], symbolic: Callable[[Value, Value], Value]
) -> Builtin:
    def larger(a: Value, b: Value) -> Value:
        if arithmetic.is_symbolic(a) or arithmetic.is_symbolic(b):
            return symbolic(a, b)
        return numeric(a, b)

    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        if node.iterators:
            values = evaluator.combinations(node, scope, names)
        else:
            values = _arguments(evaluator, node, scope, names, 1, 2)
            if len(values) == 2:
                return arithmetic.each(larger, *values)
        flat = arithmetic.flattened(values)
        if not flat:
            raise ModelError("an array without elements has neither a largest nor a smallest one")
        result = flat[0]
        for value in flat[1:]:
            result = larger(result, value)
        return result

    return builtin


def _sum(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    values = (
        evaluator.combinations(node, scope, names)
        if node.iterators
        else _arguments(evaluator, node, scope, names, 1)
    )
    return arithmetic.total(arithmetic.flattened(values))


def _product(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    values = (
        evaluator.combinations(node, scope, names)
        if node.iterators
        else _arguments(evaluator, node, scope, names, 1)
    )
    result: Value = 1
    for value in arithmetic.flattened(values):
        result = arithmetic.binary("*", result, value)
    return result


def _der(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    return arithmetic.each(evaluator.derivative, *_arguments(evaluator, node, scope, names, 1))


def _delay(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    if scope.definition.kind == "function":
        raise ModelError("delay() cannot be used in a function")
    evaluator.at_start, outside = False, evaluator.at_start
    try:
        value, time, *_ = _arguments(evaluator, node, scope, names, 2, 3)
        evaluator.at_start = True  # second, so that no variable keeps the value of that moment
        start = evaluator.evaluate(node.arguments[0], scope, names)
    finally:
        evaluator.at_start = outside
    if isinstance(time, list):
        raise ModelError("the time of delay() must be a scalar")
    return arithmetic.each(
        lambda now, first: evaluator.delay(now, first, time, scope, node.at), value, start
    )


def _argument(position: int, *counts: int) -> Builtin:
    """A function that returns one of its arguments."""

    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        if len(node.arguments) not in counts and not node.named:
            raise ModelError(
                f"{node.function.text}() takes {' or '.join(map(str, counts))} arguments"
            )
        if node.named and position >= len(node.arguments):
            named = dict(node.named)
            return evaluator.evaluate(next(iter(named.values())), scope, names)
        return evaluator.evaluate(node.arguments[position], scope, names)

    return builtin


def _sizes(value: Value) -> list[int]:
    sizes = []
    while isinstance(value, list):
        sizes.append(len(value))
        value = value[0] if value else None
    return sizes


def _size(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    values = _arguments(evaluator, node, scope, names, 1, 2)
    sizes = _sizes(values[0])
    if len(values) == 1:
        return sizes
    if not 1 <= values[1] <= len(sizes):
        raise ModelError(f"there is no dimension {values[1]}")
    return sizes[values[1] - 1]


def _filled(value: Value, sizes: list[Value]) -> Value:
    if not sizes:
        return value
    if not isinstance(sizes[0], int):
        raise ModelError("a size must be an Integer constant")
    checked_size(math.prod(size for size in sizes if isinstance(size, int)))
    return [_filled(value, sizes[1:]) for _ in range(checked_size(sizes[0]))]


def _fill(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    value, *sizes = _arguments(evaluator, node, scope, names)
    return _filled(value, sizes)


def _constant_array(value: float) -> Builtin:
    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        return _filled(value, _arguments(evaluator, node, scope, names))

    return builtin


def _linspace(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    start, stop, count = _arguments(evaluator, node, scope, names, 3)
    if checked_size(count) < 2:
        raise ModelError("linspace() makes two points at least")
    return [start + (stop - start) * i / (count - 1) for i in range(count)]


def _initial(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    return evaluator.at_start


def _terminal(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    return False


def _integer(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    (value,) = _arguments(evaluator, node, scope, names, 1)
    if arithmetic.is_symbolic(value):
        return ca.floor(value)
    return getattr(value, "number", None) or math.floor(value)


def _string(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    if len(node.arguments) != 1 or {name for name, _ in node.named} - {"significantDigits"}:
        raise ModelError("String() takes one value, and significantDigits")
    value = evaluator.evaluate(node.arguments[0], scope, names)
    digits = 6  # Modelica 3.6, section 3.7.1.1
    for _, option in node.named:
        digits = evaluator.integer(option, scope, names)
    if not 1 <= digits <= 17:
        raise ModelError(f"significantDigits must lie between 1 and 17, not {digits}")
    if arithmetic.is_symbolic(value):
        return arithmetic.Text((arithmetic.PrintedNumber(value, digits),))
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.{digits}g}" if isinstance(value, float) else str(getattr(value, "name", value))


def _refused(name: str) -> Builtin:
    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        raise ModelError(f"{name}() is not supported: this compiler takes continuous models only")

    return builtin


def _truncated_quotient(x: ca.SX, y: ca.SX) -> ca.SX:
    return ca.if_else(x / y < 0, ca.ceil(x / y), ca.floor(x / y))


def _sign(x: float) -> float:
    return float((x > 0) - (x < 0))


BUILTINS: dict[str, Builtin] = {
    "abs": _scalar(abs, ca.fabs),
    "sign": _scalar(_sign, ca.sign),
    "sqrt": _scalar(math.sqrt, ca.sqrt),
    "exp": _scalar(math.exp, ca.exp),
    "log": _scalar(math.log, ca.log),
    "log10": _scalar(math.log10, ca.log10),
    "sin": _scalar(math.sin, ca.sin),
    "cos": _scalar(math.cos, ca.cos),
    "tan": _scalar(math.tan, ca.tan),
    "asin": _scalar(math.asin, ca.asin),
    "acos": _scalar(math.acos, ca.acos),
    "atan": _scalar(math.atan, ca.atan),
    "atan2": _scalar(math.atan2, ca.atan2, 2),
    "sinh": _scalar(math.sinh, ca.sinh),
    "cosh": _scalar(math.cosh, ca.cosh),
    "tanh": _scalar(math.tanh, ca.tanh),
    "floor": _scalar(lambda x: float(math.floor(x)), ca.floor),
    "ceil": _scalar(lambda x: float(math.ceil(x)), ca.ceil),
    "mod": _scalar(lambda x, y: x - math.floor(x / y) * y, lambda x, y: x - ca.floor(x / y) * y, 2),
    "rem": _scalar(math.fmod, ca.fmod, 2),
    "div": _scalar(lambda x, y: math.trunc(x / y), _truncated_quotient, 2),
    "max": _extremum(max, ca.fmax),
    "min": _extremum(min, ca.fmin),
    "sum": _sum,
    "product": _product,
    "der": _der,
    "noEvent": _argument(0, 1),
    "smooth": _argument(1, 2),
    "homotopy": _argument(0, 1, 2),
    "inStream": _refused("inStream"),
    "actualStream": _refused("actualStream"),
    "scalar": lambda e, n, s, v: arithmetic.flattened(_arguments(e, n, s, v, 1))[0],
    "vector": lambda e, n, s, v: arithmetic.flattened(_arguments(e, n, s, v, 1)),
    "transpose": lambda e, n, s, v: [
        list(row) for row in zip(*_arguments(e, n, s, v, 1)[0], strict=True)
    ],
    "size": _size,
    "ndims": lambda e, n, s, v: len(_sizes(_arguments(e, n, s, v, 1)[0])),
    "fill": _fill,
    "zeros": _constant_array(0.0),
    "ones": _constant_array(1.0),
    "linspace": _linspace,
    "initial": _initial,
    "terminal": _terminal,
    "integer": _integer,
    "Integer": _integer,
    "String": _string,
    "getInstanceName": lambda e, n, s, v: s.instance.name if s.instance is not None else "",
    "pre": _refused("pre"),
    "edge": _refused("edge"),
    "change": _refused("change"),
    "sample": _refused("sample"),
    "delay": _delay,
    "reinit": _refused("reinit"),
    "spatialDistribution": _refused("spatialDistribution"),
}
