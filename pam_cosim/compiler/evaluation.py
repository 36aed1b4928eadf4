"""Modelica expressions to values: Python constants where everything is known, CasADi SX elsewhere.

A value is a float, int, bool, str, ``Literal`` of an enumeration, SX scalar, a (nested) list of values for an
array, or an ``Instance`` for a record. Branches that constants rule out are never evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Protocol

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.budget import DEFECTS, Budget, checked_size, defect
from pam_cosim.compiler.instance import Bound, Class, Instance, Mod, Scope
from pam_cosim.compiler.modification import bind
from pam_cosim.compiler.names_of_references import (
    AbsentComponent,
    ClassValue,
    EnumerationLiteral,
    Holders,
    first_of,
    member_of,
)
from pam_cosim.compiler.syntax import (
    Argument,
    Array,
    Binary,
    Call,
    Conditional,
    Element,
    Expression,
    FunctionArgument,
    Group,
    Iterator,
    Last,
    Literal,
    Matrix,
    Member,
    Modification,
    Range,
    Reference,
    Unary,
    Whole,
)
from pam_cosim.errors import ModelError

Value = Any
Environment = Mapping[str, Value]
NO_NAMES: Environment = {}
_ORDERS = frozenset(("<", "<=", ">", ">="))


@dataclass(frozen=True)
class Calls:
    """What a call may mean.

    Attributes:
        builtins: the functions of the language, by name.
        function: evaluates a call of a function that is written in Modelica: a tuple of all its results.
    """

    builtins: Mapping[str, Callable[[Evaluator, Call, Scope, Environment], Value]]
    function: Callable[[Evaluator, Class, Call, Scope, Environment], tuple[Value, ...]]


class Components(Holders, Protocol):
    """What evaluation needs from the instantiation."""

    budget: Budget
    calls: Calls

    @property
    def constants(self) -> Evaluator:
        """Values that are known when a model is compiled."""
        ...

    def is_structural(self, instance: Instance) -> bool:
        """Whether the structure of the model follows from the value of a Real parameter."""
        ...

    def function(self, of: Class) -> Instance:
        """A function as a holder of its inputs, outputs and statements."""
        ...

    def record(self, of: Class, name: str, modification: Mod) -> Instance:
        """A record made by its constructor."""
        ...


class Evaluator:
    """Evaluates with constants and parameter values; a subclass puts symbols in their place."""

    def __init__(self, instantiator: Components) -> None:
        self.instantiator = instantiator
        self.lookup = instantiator.lookup
        self._values: dict[Instance, Value] = {}
        self._in_progress: dict[Instance, None] = {}
        self.at_start = False  # what initial() is
        self.depth = 0  # how many functions are being called
        self.branches: list[
            Value
        ] = []  # conditions, known at run time only, of the branches being evaluated

    # ---- what a subclass changes --------------------------------------------------------------------------

    def variable(self, instance: Instance) -> Value:
        """The value of something that is neither constant nor parameter."""
        raise ModelError(
            f"'{instance.name}' is not known before the simulation: a constant is needed here"
        )

    def parameter(self, instance: Instance) -> Value:
        """The value of a parameter."""
        return self.assigned(instance)

    def time(self) -> Value:
        """The value of ``time``."""
        raise ModelError("'time' is not known before the simulation: a constant is needed here")

    def derivative(self, value: Value) -> Value:
        """The value of ``der(...)``."""
        raise ModelError("der() cannot be used here: a constant is needed")

    def delay(self, value: Value, start: Value, time: Value, scope: Scope, at: int) -> Value:
        """The value of ``delay(value, time)``, which stands at ``at``; ``start`` is the value at the start."""
        raise ModelError("delay() cannot be used here: a constant is needed")

    def order(self, operator: str, left: Value, right: Value) -> Value:
        """A comparison by size that is not decided yet."""
        return arithmetic.binary(operator, left, right)

    def assertion(
        self, condition: Value, message: arithmetic.Text, is_error: bool, at_start: bool
    ) -> None:
        """Notes a condition that is not known to hold; where all is known there is none."""

    @contextmanager
    def branch(self, condition: Value) -> Generator[None]:
        """What is evaluated in it counts only while a condition holds."""
        self.branches.append(condition)
        try:
            yield
        finally:
            self.branches.pop()

    # ---- entry points -------------------------------------------------------------------------------------

    def bound(self, bound: Bound, names: Environment = NO_NAMES) -> Value:
        """The value of an expression at its place, where ``names`` have values."""
        return self.evaluate(bound.expression, bound.scope, {**names, **bound.names})

    def integer(self, expression: Expression, scope: Scope, names: Environment = NO_NAMES) -> int:
        """A value that must be an integer constant."""
        value = self.evaluate(expression, scope, names)
        if isinstance(value, float) and value.is_integer():
            value = int(value)
        if isinstance(value, bool) or not isinstance(value, int):
            raise scope.definition.source.error("an Integer constant is needed here", expression.at)
        return value

    def condition(self, expression: Expression, scope: Scope) -> bool:
        """A value that must be a Boolean constant."""
        value = self.evaluate(expression, scope)
        if not isinstance(value, bool):
            raise scope.definition.source.error("a Boolean constant is needed here", expression.at)
        return value

    def evaluate(
        self, expression: Expression, scope: Scope, names: Environment = NO_NAMES
    ) -> Value:
        """The value of an expression.

        Raises:
            ModelError: with the place of the smallest expression that cannot be evaluated.
        """
        budget = self.instantiator.budget
        try:
            budget.enter("expressions and values stand")
            value = _HANDLERS[type(expression)](self, expression, scope, names)
            return budget.values(value) if type(value) is list else value
        except ModelError as error:
            if error.file is None and not isinstance(error, AbsentComponent):
                raise scope.definition.source.error(error.message, expression.at) from None
            raise
        except RecursionError:
            raise
        except DEFECTS as problem:
            raise scope.definition.source.error(defect(problem), expression.at) from None
        finally:
            budget.depth -= 1

    # ---- instances ----------------------------------------------------------------------------------------

    def value(self, instance: Instance) -> Value:
        """The value of a variable, an array of variables (a list) or a record (the instance)."""
        instance = self.instantiator.expand(instance)
        if not instance.present:
            raise AbsentComponent(f"'{instance.name}' is switched off by its condition")
        if instance.elements is not None:
            return [self.value(element) for element in instance.elements]
        if not instance.primitive:
            return instance
        if instance not in self._values:
            if instance in self._in_progress:
                raise ModelError(f"'{instance.name}' depends on itself")
            self._in_progress[instance] = None
            self.branches, outside = (
                [],
                self.branches,
            )  # the value is kept, and used outside of them too
            try:
                self._values[instance] = self._find_value(instance)
            finally:
                del self._in_progress[instance]
                self.branches = outside
        return self._values[instance]

    def _find_value(self, instance: Instance) -> Value:
        if instance.variability == "constant":
            return self.assigned(instance)
        if instance.variability == "parameter":
            return self.parameter(instance)
        return self.variable(instance)

    def assigned(self, instance: Instance) -> Value:
        """The value that a constant or parameter is bound to, or its start value.

        Raises:
            ModelError: it has neither.
        """
        bound = instance.binding or instance.attributes.get("start")
        if bound is None:
            kind = instance.variability or "variable"
            if "fixed" in instance.attributes:
                text = (
                    f"{kind} '{instance.name}' is left to initial equations: only Real ones can be"
                )
                raise self.at_declaration(instance, text)
            raise self.at_declaration(instance, f"{kind} '{instance.name}' has no value")
        value = self.bound(bound)
        if isinstance(value, list):
            raise bound.source.error(
                f"'{instance.name}' is a scalar, its value an array", bound.expression.at
            )
        if instance.primitive == "Real" and isinstance(value, int) and not isinstance(value, bool):
            return float(value)
        return value

    def at_declaration(self, instance: Instance, message: str) -> ModelError:
        """An error at the place where an instance is declared."""
        if instance.scope is None or instance.declaration is None:
            return ModelError(message)
        return instance.scope.definition.source.error(message, instance.declaration.at)

    # ---- references ---------------------------------------------------------------------------------------

    def _reference(self, node: Reference, scope: Scope, names: Environment) -> Value:
        referent = self.locate(node, scope, names)
        if isinstance(referent, Instance | list) and not _is_plain(referent):
            return self._contents(referent)
        return referent

    def _contents(self, referent: Value) -> Value:
        if isinstance(referent, list):
            return [self._contents(item) for item in referent]
        return self.value(referent) if isinstance(referent, Instance) else referent

    def locate(self, node: Reference, scope: Scope, names: Environment = NO_NAMES) -> Value:
        """What a reference names: an instance (or a list of them), or a value.

        Raises:
            ModelError: nothing has that name.
        """
        name, subscripts = node.parts[0]
        if not node.absolute and name in names:
            referent: Value = names[name]
            if referent is None:
                raise ModelError(f"'{name}' has no value yet")
        elif not node.absolute and len(node.parts) == 1 and name == "time":
            return self.time()
        else:
            referent = first_of(self.instantiator, name, scope, node)
        referent = self._subscripted(referent, subscripts, scope, names)
        for name, subscripts in node.parts[1:]:
            referent = self._member_of_each(referent, name, subscripts, node, scope, names)
        if isinstance(referent, ClassValue):
            raise ModelError(f"'{node.text}' is a class, not a variable")
        return referent

    def _member_of_each(
        self,
        holder: Value,
        name: str,
        subscripts: tuple[Expression, ...],
        node: Reference,
        scope: Scope,
        names: Environment,
    ) -> Value:
        """A member with its subscripts, of every element of an array (Modelica 3.6, section 10.5.2)."""
        if isinstance(holder, Instance):
            holder = self.instantiator.expand(holder)
            holder = holder if holder.elements is None else holder.elements
        if isinstance(holder, list):
            return [
                self._member_of_each(element, name, subscripts, node, scope, names)
                for element in holder
            ]
        member = member_of(self.instantiator, holder, name, node)
        return self._subscripted(member, subscripts, scope, names)

    def _subscripted(
        self, array: Value, subscripts: tuple[Expression, ...], scope: Scope, names: Environment
    ) -> Value:
        if not subscripts:
            return array
        if isinstance(array, Instance):
            instance = self.instantiator.expand(array)
            if instance.elements is None:
                raise ModelError(f"'{instance.name}' is not an array")
            array = instance.elements
        if not isinstance(array, list):
            raise ModelError("a scalar has no subscripts")
        return self._pick(array, subscripts, scope, names)

    def _pick(
        self, items: Value, subscripts: tuple[Expression, ...], scope: Scope, names: Environment
    ) -> Value:
        if not subscripts:
            return items
        if isinstance(items, Instance):
            items = items.elements
        if not isinstance(items, list):
            raise ModelError("there are more subscripts than dimensions")
        first, remaining = subscripts[0], subscripts[1:]
        if isinstance(first, Whole):
            return [self._pick(item, remaining, scope, names) for item in items]
        where = self.evaluate(first, scope, {**names, "end": len(items)})
        if isinstance(where, list):
            return [
                self._pick(self._item(items, index), remaining, scope, names) for index in where
            ]
        return self._pick(self._item(items, where), remaining, scope, names)

    def _item(self, items: list[Value], index: Value) -> Value:
        if isinstance(index, EnumerationLiteral):
            index = index.number
        if isinstance(index, bool) or not isinstance(index, int):
            raise ModelError("a subscript must be an Integer constant")
        if not 1 <= index <= len(items):
            raise ModelError(f"subscript {index} is outside 1:{len(items)}")
        return items[index - 1]

    # ---- other expressions --------------------------------------------------------------------------------

    def _literal(self, node: Literal, scope: Scope, names: Environment) -> Value:
        return node.value

    def _last(self, node: Last, scope: Scope, names: Environment) -> Value:
        if "end" not in names:
            raise ModelError("'end' is only a subscript")
        return names["end"]

    def _unary(self, node: Unary, scope: Scope, names: Environment) -> Value:
        return arithmetic.unary(node.operator, self.evaluate(node.operand, scope, names))

    def _binary(self, node: Binary, scope: Scope, names: Environment) -> Value:
        """Operations that stand on the left of one another, as in a long sum, follow without going deeper."""
        following: list[Binary] = []
        while isinstance(node.left, Binary):
            following.append(node)
            node = node.left
        value = self._operation(node, self.evaluate(node.left, scope, names), scope, names)
        for operation in reversed(following):
            self.instantiator.budget.work()
            value = self._operation(operation, value, scope, names)
        return value

    def _operation(self, node: Binary, left: Value, scope: Scope, names: Environment) -> Value:
        if node.operator == "and" and left is False:
            return False
        if node.operator == "or" and left is True:
            return True
        right = self.evaluate(node.right, scope, names)
        if node.operator in _ORDERS and (isinstance(left, ca.SX) or isinstance(right, ca.SX)):
            return self.order(node.operator, left, right)
        return arithmetic.binary(node.operator, left, right)

    def _conditional(self, node: Conditional, scope: Scope, names: Environment) -> Value:
        chosen: list[tuple[Value, Value]] = []
        open_still: Value = True  # none of the conditions so far holds
        for condition, expression in node.branches:
            value = self.evaluate(condition, scope, names)
            if value is False:
                continue
            with self.branch(arithmetic.only(value, open_still)):
                result = self.evaluate(expression, scope, names)
            if value is True:
                return arithmetic.select(chosen, result)
            chosen.append((value, result))
            open_still = arithmetic.neither(open_still, value)
        with self.branch(open_still):
            return arithmetic.select(chosen, self.evaluate(node.otherwise, scope, names))

    def _array(self, node: Array, scope: Scope, names: Environment) -> Value:
        if node.iterators:
            return [
                self.evaluate(node.items[0], scope, point)
                for point in self.points(node.iterators, scope, names)
            ]
        return [self.evaluate(item, scope, names) for item in node.items]

    def _matrix(self, node: Matrix, scope: Scope, names: Environment) -> Value:
        rows = []
        for row in node.rows:
            blocks = [as_matrix(self.evaluate(item, scope, names)) for item in row]
            if len({len(block) for block in blocks}) > 1:
                raise ModelError("the parts of a row of this matrix differ in height")
            rows += [[v for part in parts for v in part] for parts in zip(*blocks, strict=True)]
        if len({len(row) for row in rows}) > 1:
            raise ModelError("the rows of this matrix differ in length")
        return rows

    def _function_argument(self, node: FunctionArgument, scope: Scope, names: Environment) -> Value:
        raise ModelError("a function as an argument is not supported")

    def points(
        self, iterators: tuple[Iterator, ...], scope: Scope, names: Environment
    ) -> list[Environment]:
        """The names with all values of the loop counters, the last counter running fastest."""
        points: list[Environment] = [names]
        for iterator in iterators:
            following: list[Environment] = []
            for point in points:
                if isinstance(iterator.range, Whole):
                    raise ModelError("the range of a loop must be written: 'for i in 1:n loop'")
                values = self.evaluate(iterator.range, scope, point)
                if not isinstance(values, list):
                    raise scope.definition.source.error(
                        "a loop runs over a range or an array", iterator.range.at
                    )
                checked_size(len(following) + len(values))
                self.instantiator.budget.work(len(values))
                following += [{**point, iterator.name: value} for value in values]
            points = following
        return points

    def _range(self, node: Range, scope: Scope, names: Environment) -> Value:
        parts = [node.start, node.step or Literal(node.at, 1), node.stop]
        start, step, stop = (self.evaluate(part, scope, names) for part in parts)
        if not all(isinstance(part, int | float) for part in (start, step, stop)):
            raise ModelError("the ends of a range must be constants")
        if step == 0:
            raise ModelError("the step of a range is zero")
        count = checked_size(math.floor((stop - start) / step + 1e-9) + 1)
        return [start + i * step for i in range(count)]

    def _element(self, node: Element, scope: Scope, names: Environment) -> Value:
        written = _written(node)
        if written is not None:
            return self.evaluate(written, scope, names)
        base = self.evaluate(node.base, scope, names)
        if not isinstance(base, list):
            raise ModelError("a scalar is given for an array: write 'each', or fill(...)")
        if node.index >= len(base):
            raise ModelError(f"an array of {len(base)} elements is given where more are needed")
        return base[node.index]

    def _member(self, node: Member, scope: Scope, names: Environment) -> Value:
        base = self.evaluate(node.base, scope, names)
        return self._contents(
            member_of(self.instantiator, base, node.name, Reference(node.at, ((node.name, ()),)))
        )

    def _group(self, node: Group, scope: Scope, names: Environment) -> Value:
        raise ModelError("several values in parentheses stand only on the left of a call")

    def _whole(self, node: Whole, scope: Scope, names: Environment) -> Value:
        raise ModelError("':' is only a subscript")

    # ---- calls --------------------------------------------------------------------------------------------

    def _call(self, node: Call, scope: Scope, names: Environment) -> Value:
        results = self.results(node, scope, names)
        if isinstance(results, tuple):
            if not results:
                raise ModelError(f"function '{node.function.text}' has no output")
            return results[0]
        return results

    def results(self, node: Call, scope: Scope, names: Environment) -> Value:
        """The value of a call: a tuple of all results for a function that is written in Modelica."""
        name = node.function.text
        called = self._function(node, scope)
        if called is None:
            builtin = self.instantiator.calls.builtins.get(name)
            if builtin is not None:
                return builtin(self, node, scope, names)
            raise ModelError(f"function '{name}' not found in {scope.definition.qualified_name}")
        if called.definition.kind == "function":
            return self.instantiator.calls.function(self, called, node, scope, names)
        return self._construct(called, node, scope, names)

    def _function(self, node: Call, scope: Scope) -> Class | None:
        if len(node.function.parts) == 1:
            return self.lookup.first(scope, node.function.text, node.function.absolute)
        try:
            first = first_of(self.instantiator, node.function.parts[0][0], scope, node.function)
            for name, subscripts in node.function.parts[1:]:
                first = self._subscripted(
                    member_of(self.instantiator, first, name, node.function),
                    subscripts,
                    scope,
                    NO_NAMES,
                )
        except ModelError:
            return None
        return first.of if isinstance(first, ClassValue) else None

    def _construct(self, of: Class, node: Call, scope: Scope, names: Environment) -> Value:
        definition = of.definition
        arguments = [
            Argument(name, value.at, Modification((), value)) for name, value in node.named
        ]
        if node.arguments:
            raise ModelError(
                f"name the members in the constructor: {definition.name}(member=value, ...)"
            )
        if definition.kind != "record" and definition.alias is None:
            raise ModelError(
                f"'{definition.qualified_name}' is a {definition.kind}: it cannot be called"
            )
        modification: Mod = bind(Modification(tuple(arguments)), scope, node.at)
        for entry in modification.entries.values():
            if entry.value is not None:
                entry.value.names = names
        return self.instantiator.record(of, definition.name, modification)

    def combinations(self, node: Call, scope: Scope, names: Environment) -> list[Value]:
        """The values of ``f(e for i in r)`` under the function."""
        return [
            self.evaluate(node.arguments[0], scope, point)
            for point in self.points(node.iterators, scope, names)
        ]


def as_matrix(value: Value) -> list[list[Value]]:
    """A value with two dimensions: a vector is a column (Modelica 3.6, section 10.4.2.1)."""
    items = value if isinstance(value, list) else [value]
    return [item if isinstance(item, list) else [item] for item in items]


def _written(node: Expression) -> Expression | None:
    """The text of an element where an array is written out: the others need not be evaluated for it."""
    if not isinstance(node, Element):
        return node
    base = _written(node.base)
    if isinstance(base, Array) and not base.iterators and node.index < len(base.items):
        return base.items[node.index]
    return None


def _is_plain(referent: Value) -> bool:
    """Whether a list holds values only."""
    if isinstance(referent, list):
        return all(_is_plain(item) for item in referent)
    return not isinstance(referent, Instance)


_HANDLERS: dict[type, Callable[[Evaluator, Any, Scope, Environment], Value]] = {
    Reference: Evaluator._reference,
    Literal: Evaluator._literal,
    Unary: Evaluator._unary,
    Binary: Evaluator._binary,
    Conditional: Evaluator._conditional,
    Call: Evaluator._call,
    Array: Evaluator._array,
    Matrix: Evaluator._matrix,
    FunctionArgument: Evaluator._function_argument,
    Range: Evaluator._range,
    Element: Evaluator._element,
    Member: Evaluator._member,
    Last: Evaluator._last,
    Group: Evaluator._group,
    Whole: Evaluator._whole,
}
