"""From the tree of components to residual equations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import casadi as ca

from pam_cosim.compiler import arithmetic
from pam_cosim.compiler.assertions import check
from pam_cosim.compiler.connections import Connections, ConnectionSet
from pam_cosim.compiler.evaluation import NO_NAMES, Environment, Value
from pam_cosim.compiler.functions import run
from pam_cosim.compiler.instance import Instance, Scope
from pam_cosim.compiler.instantiation import Instantiator
from pam_cosim.compiler.symbols import SymbolTable
from pam_cosim.compiler.syntax import (
    Assignment,
    Call,
    Connect,
    Equality,
    Equation,
    For,
    Group,
    If,
    Procedure,
    Reference,
    Section,
    Unsupported,
    While,
)
from pam_cosim.errors import ModelError


@dataclass(frozen=True)
class Residual:
    """An expression that must be zero, and where it comes from.

    Attributes:
        place: ``file:line: text`` of the equation, with the component it belongs to.
    """

    expression: ca.SX
    place: str

    @cached_property
    def names(self) -> tuple[str, ...]:
        """Of the symbols in it, each once."""
        return tuple(symbol.name() for symbol in ca.symvar(self.expression))


@dataclass(repr=False)
class FlatModel:
    """Symbols and equations of a model without structure."""

    root: Instance
    symbols: SymbolTable
    residuals: list[Residual] = field(default_factory=list)
    initial: list[Residual] = field(default_factory=list)


def flatten(instantiator: Instantiator, root: Instance) -> FlatModel:
    """All equations of a model: those written, bindings of variables, connections.

    Raises:
        ModelError: with the place of an equation that cannot be used.
    """
    flat = FlatModel(root, SymbolTable(instantiator, root))
    return _Flattener(flat).run()


class _Flattener:
    def __init__(self, flat: FlatModel) -> None:
        self.flat = flat
        self.symbols = flat.symbols
        self.connections = Connections(flat.symbols)

    def run(self) -> FlatModel:
        root = self.flat.root
        for leaf in root.leaves():  # first what the structure follows from
            if leaf.variability == "parameter" and leaf.primitive != "Real":
                self.symbols.value(leaf)
        for leaf in root.leaves():
            if leaf.variability != "constant":
                self.symbols.value(leaf)
        for leaf in root.leaves():
            if leaf in self.symbols.unknowns and leaf.binding is not None:
                self._binding(leaf)
        for initial in (False, True):  # how a model begins has no part in the order of its states
            for node in root.nodes():
                for section, scope in node.sections:
                    if section.initial == initial:
                        self._section(section, scope, node)
        for connected in self.connections.sets(root):
            self._connection_set(connected)
        return self.flat

    def _binding(self, leaf: Instance) -> None:
        assert leaf.binding is not None
        value = self.symbols.bound(leaf.binding)
        place = _place(leaf.binding.scope, leaf.binding.expression.at, leaf.name)
        self._equate(
            self.symbols.unknowns[leaf],
            value,
            place,
            leaf.binding.scope,
            leaf.binding.expression.at,
            False,
        )

    def _section(self, section: Section, scope: Scope, node: Instance) -> None:
        if section.kind == "algorithm":
            self._algorithm(section, scope, node)
        else:
            self._equations(section.equations, scope, NO_NAMES, section.initial)

    # ---- equations ----------------------------------------------------------------------------------------

    def _equations(
        self, equations: Sequence[Equation], scope: Scope, names: Environment, initial: bool
    ) -> None:
        for equation in equations:
            try:
                self._equation(equation, scope, names, initial)
            except ModelError as error:
                if error.file is None:
                    raise scope.definition.source.error(error.message, equation.at) from None
                raise

    def _equation(
        self, equation: Equation, scope: Scope, names: Environment, initial: bool
    ) -> None:
        if isinstance(equation, Equality):
            if self.symbols.definitions.is_definition(equation, scope):
                return
            self._equality(equation, scope, names, initial)
        elif isinstance(equation, Connect):
            if any(condition is not True for condition in self.symbols.branches):
                raise ModelError(
                    "connect() stands in an if-equation whose condition may change: "
                    "make what it depends on final, constant or Boolean"
                )
            self.connections.add(equation, scope, names)
        elif isinstance(equation, For):
            for point in self.symbols.points(equation.iterators, scope, names):
                self._equations(equation.body, scope, point, initial)
        elif isinstance(equation, If):
            self._if(equation, scope, names, initial)
        elif isinstance(equation, Procedure):
            self._procedure(equation, scope, names, initial)
        else:
            what = equation.what if isinstance(equation, Unsupported) else "this equation"
            raise ModelError(
                f"'{what}' is not supported: this compiler takes continuous models only"
            )

    def _equality(
        self, equation: Equality, scope: Scope, names: Environment, initial: bool
    ) -> None:
        place = _place(scope, equation.at)
        left, right = equation.left, equation.right
        if isinstance(left, Group):
            if not isinstance(right, Call):
                raise ModelError("several values on the left need a function call on the right")
            results = self.symbols.results(right, scope, names)
            for target, result in zip(
                left.items, results if isinstance(results, tuple) else (results,), strict=False
            ):
                if target is not None:
                    value = self.symbols.evaluate(target, scope, names)
                    self._equate(value, result, place, scope, equation.at, initial)
            return
        value = self.symbols.evaluate(left, scope, names)
        self._equate(
            value, self.symbols.evaluate(right, scope, names), place, scope, equation.at, initial
        )

    def _equate(
        self, left: Value, right: Value, place: str, scope: Scope, at: int, initial: bool
    ) -> None:
        if isinstance(left, Instance) and isinstance(right, Instance):
            for name, child in left.children.items():
                if name not in right.children:
                    raise scope.definition.source.error(
                        f"'{right.name}' has no member '{name}'", at
                    )
                values = self.symbols.value(child), self.symbols.value(right.children[name])
                self._equate(*values, place, scope, at, initial)
            return
        if isinstance(left, list) != isinstance(right, list) or not _same_shape(left, right):
            raise scope.definition.source.error("the two sides of the equation differ in size", at)
        for a, b in zip(arithmetic.flattened(left), arithmetic.flattened(right), strict=True):
            try:
                residual = arithmetic.binary("-", a, b)
            except arithmetic.ArithmeticProblem as problem:
                raise scope.definition.source.error(problem.message, at) from None
            (self.flat.initial if initial else self.flat.residuals).append(
                Residual(ca.SX(residual), place)
            )

    def _if(self, equation: If, scope: Scope, names: Environment, initial: bool) -> None:
        """A constant condition chooses a branch; else all branches must have as many equations."""
        target = self.flat.initial if initial else self.flat.residuals
        before = len(target)
        branches: list[tuple[Value, list[Residual]]] = []
        open_still: Value = True  # none of the conditions so far holds
        for condition, body in equation.branches:
            value = True if condition is None else self.symbols.evaluate(condition, scope, names)
            if value is False:
                continue
            with self.symbols.branch(arithmetic.only(value, open_still)):
                self._equations(body, scope, names, initial)
            open_still = arithmetic.neither(open_still, value)
            branches.append((value, target[before:]))
            del target[before:]
            if value is True:
                break
        if not branches:
            return
        complete = branches[-1][0] is True
        if not complete:
            branches.append(
                (True, [])
            )  # a missing else has no equations (Modelica 3.6, section 8.3.4)
        *choices, (_, otherwise) = branches
        if not complete and any(residuals for _, residuals in choices):
            raise ModelError(
                "an if-equation with a condition that varies needs an else branch with as many equations"
            )
        if any(len(residuals) != len(otherwise) for _, residuals in choices):
            raise ModelError("the branches of this if-equation have different numbers of equations")
        for i, residual in enumerate(otherwise):
            values = [(value, residuals[i].expression) for value, residuals in choices]
            target.append(
                Residual(ca.SX(arithmetic.select(values, residual.expression)), residual.place)
            )

    def _procedure(
        self, equation: Procedure, scope: Scope, names: Environment, initial: bool
    ) -> None:
        if equation.call.function.text != "assert":
            raise ModelError(f"'{equation.call.function.text}' cannot stand alone as an equation")
        check(self.symbols, equation.call, scope, names, initial)

    def _algorithm(self, section: Section, scope: Scope, node: Instance) -> None:
        """Statements give each assigned variable the value that it has at the end."""
        names = _assigned(section.equations)
        local: dict[str, Value] = {}
        for name in names:
            if name not in scope.components:
                raise scope.definition.source.error(
                    f"'{name}' is not a variable of this model", scope.definition.at
                )
            local[name] = self.symbols.value(node.children[name])
        before = dict(local)
        run(self.symbols, section.equations, scope, local)
        at = section.equations[0].at if section.equations else scope.definition.at
        for name in names:
            self._equate(before[name], local[name], _place(scope, at), scope, at, section.initial)

    # ---- connections --------------------------------------------------------------------------------------

    def _connection_set(self, connected: ConnectionSet) -> None:
        members = connected.members
        if members[0][0].primitive != "Real":
            return  # one of them determines the others
        if connected.is_flow:
            total = ca.SX(0)
            for variable, inside in members:
                value = self._connected_value(variable)
                total = total + (value if inside else -value)
            names = " + ".join(
                f"{'' if inside else '-'}{variable.name}" for variable, inside in members
            )
            self.flat.residuals.append(Residual(total, f"connection: {names} = 0"))
            return
        distinct = list(dict.fromkeys(variable for variable, _ in members))
        first = distinct[0]
        for other in distinct[1:]:
            residual = self._connected_value(first) - self._connected_value(other)
            place = f"connection: {first.name} = {other.name}"
            if not residual.is_zero():
                self.flat.residuals.append(Residual(residual, place))

    def _connected_value(self, variable: Instance) -> ca.SX:
        return ca.SX(self.symbols.value(variable))


def _assigned(statements: Sequence[Equation]) -> list[str]:
    names: list[str] = []
    for statement in statements:
        if isinstance(statement, Assignment):
            items = (
                statement.target.items
                if isinstance(statement.target, Group)
                else (statement.target,)
            )
            names += [item.parts[0][0] for item in items if isinstance(item, Reference)]
        elif isinstance(statement, If):
            for _, body in statement.branches:
                names += _assigned(body)
        elif isinstance(statement, For | While):
            names += _assigned(statement.body)
    return list(dict.fromkeys(names))


def _same_shape(left: Value, right: Value) -> bool:
    if isinstance(left, list) and isinstance(right, list):
        return len(left) == len(right) and all(
            _same_shape(a, b) for a, b in zip(left, right, strict=True)
        )
    return not isinstance(left, list) and not isinstance(right, list)


def _place(scope: Scope, at: int, variable: str = "") -> str:
    source = scope.definition.source
    line, _ = source.position(at)
    owner = variable or (scope.instance.name if scope.instance is not None else "")
    return f"{source.file}:{line}: {source.line(at)}" + (f"  [{owner}]" if owner else "")
