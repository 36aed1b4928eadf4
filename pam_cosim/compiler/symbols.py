"""Evaluation with a CasADi symbol for every variable and for every parameter that can be set from outside."""

from __future__ import annotations

from functools import cached_property

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.arithmetic import PrintedNumber, Text
from pam_cosim.compiler.assertions import Assertion
from pam_cosim.compiler.definitions import Definitions
from pam_cosim.compiler.delays import DelayCall, check_time, same
from pam_cosim.compiler.evaluation import Evaluator, Value
from pam_cosim.compiler.instance import Instance, Scope
from pam_cosim.compiler.instantiation import Instantiator
from pam_cosim.compiler.start import TimeComparison, comparison
from pam_cosim.errors import ModelError


class SymbolTable(Evaluator):
    """The symbols of a model.

    A Real parameter is free if its value is a number; a final or protected one, or one that is bound to an
    expression of others, is computed. Integer, Boolean, String and enumeration parameters are structure: they
    have the value that the model gives them.

    Attributes:
        unknowns: variables that equations determine, with their symbols.
        inputs: what the model takes from outside.
        free: free parameters with their symbols; ``defaults`` their values.
        derivatives: ``der(x)`` by the name of x.
        delays: calls of ``delay`` by the name of the symbol that stands for the result.
        assertions: what the model states of itself.
        late: parameters that initial equations determine, by name.
        comparisons: of time with them, by the name of the symbol that stands for the result.
    """

    def __init__(self, instantiator: Instantiator, root: Instance) -> None:
        super().__init__(instantiator)
        self.root = root
        self.t = ca.SX.sym("time")
        self.unknowns: dict[Instance, ca.SX] = {}
        self.inputs: dict[Instance, ca.SX] = {}
        self.free: dict[Instance, ca.SX] = {}
        self.defaults: dict[Instance, float] = {}
        self.derivatives: dict[str, ca.SX] = {}
        self.delays: dict[str, DelayCall] = {}
        self.assertions: list[Assertion] = []
        self.late: dict[str, ca.SX] = {}
        self.comparisons: dict[str, TimeComparison] = {}
        self._by_name: dict[str, Instance] = {}

    @cached_property
    def definitions(self) -> Definitions:
        """What determines the variables that are not Real."""
        return Definitions(self, self.root)

    def variable(self, instance: Instance) -> Value:
        """The symbol of a Real variable; a Boolean or Integer one stands for its binding."""
        if instance.primitive != "Real":
            bound = instance.binding or self.definitions.of(instance)
            if bound is None:
                raise self.at_declaration(
                    instance,
                    f"no declaration and no equation gives '{instance.name}' a value: an event does, and 'when', "
                    f"'pre' and inputs of type {instance.primitive} are not supported",
                )
            return self.bound(bound)
        symbol = ca.SX.sym(instance.name)
        is_top = instance.parent is self.root or self._in_top_connector(instance)
        if "input" in instance.prefixes and is_top and instance.binding is None:
            self.inputs[instance] = symbol
        else:
            self.unknowns[instance] = symbol
        self._by_name[instance.name] = instance
        return symbol

    def _in_top_connector(self, instance: Instance) -> bool:
        holder = instance.parent
        return holder is not None and holder.kind == "connector" and holder.parent is self.root

    def parameter(self, instance: Instance) -> Value:
        """The symbol of a free parameter, the expression of a computed one, the value of a structural one."""
        if instance.primitive != "Real":
            return self.instantiator.constants.value(instance)
        if "fixed" in instance.attributes and self.bound(instance.attributes["fixed"]) is False:
            if instance.binding is not None:
                message = f"parameter '{instance.name}' has a value, and fixed=false leaves it to initial equations"
                raise self.at_declaration(instance, message)
            return self.late.setdefault(instance.name, ca.SX.sym(instance.name))
        if self.instantiator.is_structural(instance):
            return self.instantiator.constants.value(instance)
        value = arithmetic.simplified(self.assigned(instance))
        if isinstance(value, ca.SX) or instance.prefixes & {"final", "protected"}:
            return value
        if not isinstance(value, float):
            raise self.at_declaration(
                instance, f"parameter '{instance.name}' has a value that is no number"
            )
        symbol = ca.SX.sym(instance.name)
        self.free[instance], self.defaults[instance] = symbol, value
        return symbol

    def time(self) -> Value:
        """The symbol of time."""
        return self.t

    def delay(self, value: Value, start: Value, time: Value, scope: Scope, at: int) -> Value:
        """A symbol for the delayed value; a value that is known does not change."""
        check_time(time)
        if not isinstance(value, ca.SX) and not isinstance(start, ca.SX) and value == start:
            return value
        value, start, time = ca.SX(value), ca.SX(start), ca.SX(time)
        for call in self.delays.values():
            if same(call.argument, value) and same(call.start, start) and same(call.time, time):
                return call.symbol
        name = f"delay({value})" if value.is_symbolic() else f"delay(...) {len(self.delays) + 1}"
        while name in self.delays:
            name += "'"
        symbol = ca.SX.sym(name)
        self.delays[name] = DelayCall(symbol, value, start, time, scope.definition.source, at)
        return symbol

    def order(self, operator: str, left: Value, right: Value) -> Value:
        """A comparison; one of time with what initial equations determine is kept, for they may make it an event."""
        if (
            isinstance(left, int | float | ca.SX)
            and isinstance(right, int | float | ca.SX)
            and self.late
        ):
            greater = (left, right) if operator[0] == ">" else (right, left)
            timed = comparison(ca.SX(greater[0]), ca.SX(greater[1]), self.t, self.late)
            if timed is not None and self._made_of_parameters(timed[0].length):
                kept, as_it_is = (
                    self.comparisons.setdefault(timed[0].symbol.name(), timed[0]),
                    timed[1],
                )
                return kept.symbol > 0.5 if as_it_is else kept.symbol < 0.5
        return super().order(operator, left, right)

    def _made_of_parameters(self, expression: ca.SX) -> bool:
        free = {symbol.name() for symbol in self.free.values()}
        return all(symbol.name() in free for symbol in ca.symvar(expression))

    def assertion(self, condition: Value, message: Text, is_error: bool, at_start: bool) -> None:
        """Keeps it once, however often a function that makes it is called with the same arguments."""
        new = Assertion(ca.SX(condition), message, is_error, at_start)
        if not any(_alike(new, assertion) for assertion in self.assertions):
            self.assertions.append(new)

    def derivative(self, value: Value) -> Value:
        """The symbol of a variable's derivative, or the chain rule for an expression."""
        if not isinstance(value, ca.SX):
            return 0.0
        if value.is_symbolic():
            return self._derivative_of_symbol(value)
        result = ca.SX(0)
        for symbol in ca.symvar(value):
            rate = self._derivative_of_symbol(symbol)
            if isinstance(rate, ca.SX) or rate != 0.0:
                result += ca.jacobian(value, symbol) * rate
        return result

    def _derivative_of_symbol(self, symbol: ca.SX) -> Value:
        name = symbol.name()
        if name == "time":
            return 1.0
        if name.startswith("der("):
            raise ModelError(
                f"second derivative of '{name}': introduce a variable for the first one"
            )
        if name in self.delays:
            raise ModelError(f"the derivative of the input '{name}' is not known")
        instance = self._by_name.get(name)
        if instance is None:
            return 0.0
        if instance in self.inputs:
            raise ModelError(f"the derivative of the input '{name}' is not known")
        if name not in self.derivatives:
            self.derivatives[name] = ca.SX.sym(f"der({name})")
        return self.derivatives[name]


def _alike(a: Assertion, b: Assertion) -> bool:
    """Whether two assertions have the same message and the same condition."""
    texts = [
        [part if isinstance(part, str) else part.digits for part in assertion.message.parts]
        for assertion in (a, b)
    ]
    numbers = [
        [part.value for part in assertion.message.parts if isinstance(part, PrintedNumber)]
        for assertion in (a, b)
    ]
    same_level = (a.is_error, a.at_start, texts[0]) == (b.is_error, b.at_start, texts[1])
    return same_level and same(a.condition, b.condition) and all(map(same, *numbers))
