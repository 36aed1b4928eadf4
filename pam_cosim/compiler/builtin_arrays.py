"""Modelica's functions that make arrays or return their sizes."""

from __future__ import annotations

import math

from pam_cosim.compiler.budget import checked_size
from pam_cosim.compiler.builtin_arguments import Builtin, evaluated_arguments
from pam_cosim.compiler.evaluation import Environment, Evaluator, Value
from pam_cosim.compiler.instance import Scope
from pam_cosim.compiler.syntax import Call
from pam_cosim.errors import ModelError


def array_sizes(value: Value) -> list[int]:
    """Sizes of all dimensions; of a number there are none."""
    sizes = []
    while isinstance(value, list):
        sizes.append(len(value))
        value = value[0] if value else None
    return sizes


def size_of_array(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    """``size(A)`` and ``size(A, i)``."""
    values = evaluated_arguments(evaluator, node, scope, names, 1, 2)
    sizes = array_sizes(values[0])
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


def filled_array(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    """``fill(value, n1, ...)``."""
    value, *sizes = evaluated_arguments(evaluator, node, scope, names)
    return _filled(value, sizes)


def constant_array(value: float) -> Builtin:
    """``zeros(n1, ...)`` or ``ones(n1, ...)``."""

    def builtin(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
        return _filled(value, evaluated_arguments(evaluator, node, scope, names))

    return builtin


def linspace(evaluator: Evaluator, node: Call, scope: Scope, names: Environment) -> Value:
    """``linspace(start, stop, n)``."""
    start, stop, count = evaluated_arguments(evaluator, node, scope, names, 3)
    if checked_size(count) < 2:
        raise ModelError("linspace() makes two points at least")
    return [start + (stop - start) * i / (count - 1) for i in range(count)]
