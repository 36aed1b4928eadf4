"""Modelica's built-in functions (Modelica 3.6, chapter 3.7 and 10.3)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.builtin_arguments import Builtin, argument_at, evaluated_arguments
from pam_cosim.compiler.builtin_arrays import (
    array_sizes,
    constant_array,
    filled_array,
    linspace,
    size_of_array,
)
from pam_cosim.compiler.evaluation import Environment, Evaluator, Value
from pam_cosim.compiler.instance import Scope
from pam_cosim.compiler.syntax import Call
from pam_cosim.errors import ModelError


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
        return arithmetic.each(apply, *evaluated_arguments(evaluator, node, scope, names, count))

    return builtin


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
            values = evaluated_arguments(evaluator, node, scope, names, 1, 2)
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
    return arithmetic.total(_terms(evaluator, node, scope, names))


def _product(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    result: Value = 1
    for value in _terms(evaluator, node, scope, names):
        result = arithmetic.binary("*", result, value)
    return result


def _terms(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Sequence[Value]:
    """Of a sum or a product: elements of an array, or an expression for each value of iterators."""
    values = (
        evaluator.combinations(node, scope, names)
        if node.iterators
        else evaluated_arguments(evaluator, node, scope, names, 1)
    )
    return arithmetic.flattened(values)


def _der(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    return arithmetic.each(
        evaluator.derivative, *evaluated_arguments(evaluator, node, scope, names, 1)
    )


def _delay(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    if scope.definition.kind == "function":
        raise ModelError("delay() cannot be used in a function")
    evaluator.at_start, outside = False, evaluator.at_start
    try:
        value, time, *_ = evaluated_arguments(evaluator, node, scope, names, 2, 3)
        evaluator.at_start = True  # second, so that no variable keeps the value of that moment
        start = evaluator.evaluate(node.arguments[0], scope, names)
    finally:
        evaluator.at_start = outside
    if isinstance(time, list):
        raise ModelError("the time of delay() must be a scalar")
    return arithmetic.each(
        lambda now, first: evaluator.delay(now, first, time, scope, node.at), value, start
    )


def _initial(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    return evaluator.at_start


def _terminal(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    return False


def _integer(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    (value,) = evaluated_arguments(evaluator, node, scope, names, 1)
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


ELEMENTARY = "exp log log10 sqrt sin cos tan asin acos atan sinh cosh tanh".split()  # noqa: SIM905
BUILTINS: dict[str, Builtin] = {
    **{name: _scalar(getattr(math, name), getattr(ca, name)) for name in ELEMENTARY},
    "abs": _scalar(abs, ca.fabs),
    "sign": _scalar(_sign, ca.sign),
    "atan2": _scalar(math.atan2, ca.atan2, 2),
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
    "noEvent": argument_at(0, 1),
    "smooth": argument_at(1, 2),
    "homotopy": argument_at(0, 2, name="actual"),
    "inStream": _refused("inStream"),
    "actualStream": _refused("actualStream"),
    "scalar": lambda e, n, s, v: arithmetic.flattened(evaluated_arguments(e, n, s, v, 1))[0],
    "vector": lambda e, n, s, v: arithmetic.flattened(evaluated_arguments(e, n, s, v, 1)),
    "transpose": lambda e, n, s, v: [
        list(row) for row in zip(*evaluated_arguments(e, n, s, v, 1)[0], strict=True)
    ],
    "size": size_of_array,
    "ndims": lambda e, n, s, v: len(array_sizes(evaluated_arguments(e, n, s, v, 1)[0])),
    "fill": filled_array,
    "zeros": constant_array(0.0),
    "ones": constant_array(1.0),
    "linspace": linspace,
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
