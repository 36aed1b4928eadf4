"""The explicit ODE of a flat model: states, what is solved for, where it begins, and what it shows."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import casadi as ca

from pam_cosim.compiler import metadata
from pam_cosim.compiler.arithmetic import PrintedNumber, Text
from pam_cosim.compiler.assertions import Assertion
from pam_cosim.compiler.blocks import Loop, solve
from pam_cosim.compiler.budget import check_operations, check_unknowns
from pam_cosim.compiler.delays import DelayedInputs, put
from pam_cosim.compiler.flattening import FlatModel, Residual
from pam_cosim.compiler.index_reduction import EquationSystem, reduce_index, select_states
from pam_cosim.compiler.initialization import (
    InitialProblem,
    InitialValues,
    StartAttribute,
    initial_values,
)
from pam_cosim.compiler.instance import Instance
from pam_cosim.compiler.instantiation import Instantiator
from pam_cosim.compiler.nonlinear import NonlinearLoops
from pam_cosim.compiler.ode import Ode, Statement
from pam_cosim.compiler.part import parts_of
from pam_cosim.compiler.start import beginning
from pam_cosim.errors import ModelError
from pam_cosim.model.interface import Interface, Variable


@dataclass
class Assembly:
    """Puts the explicit ODE of a flat model together."""

    flat: FlatModel
    instantiator: Instantiator

    def ode(self) -> Ode:
        """The product.

        Raises:
            ModelError: the model cannot be brought into this form.
        """
        symbols, root = self.flat.symbols, self.flat.root
        self.system = system = self._system()
        reduce_index(system)
        selection = select_states(system, self._preference)
        loops: list[Loop] = []
        nonlinear = self.nonlinear = NonlinearLoops(self._guess)
        self.solved = solve(
            system.residuals, selection.unknowns, system.variables, None, loops, nonlinear
        )
        self._assert_convergence(at_start=False)
        self.states = selection.states
        self.parameters = [leaf for leaf in root.leaves() if leaf in symbols.free]
        self.p = _column([symbols.free[leaf] for leaf in self.parameters])
        self.p_values = _column([symbols.defaults[leaf] for leaf in self.parameters])
        initial = self._initial()
        self._assert_convergence(at_start=True)
        states = self._state_variables(initial.states)
        self._check_start(states, loops)
        delayed = self._delayed()
        outputs = [leaf for leaf in symbols.unknowns if self._is_output(leaf)]
        local = self._locals(outputs)
        derivatives, values, local_values = _shared(
            delayed.put_in([self._derivative(name) for name in self.states]),
            delayed.put_in([self._value(leaf.name) for leaf in outputs]),
            delayed.put_in([value for _, value in local]),
        )
        return Ode(
            interface=self._interface(outputs, [leaf for leaf, _ in local]),
            states=states,
            t=symbols.t,
            x=_column([system.variables[name] for name in self.states]),
            u=_column(list(symbols.inputs.values())),
            p=self.p,
            derivatives=derivatives,
            outputs=values,
            locals=local_values,
            initial=_column(initial.states),
            description=root.ancestors[0].definition.description,
            d=_column(delayed.delayed),
            delays=tuple(delayed.delays),
            parts=parts_of(root),
            libraries=metadata.libraries(root),
            statements=tuple(
                self._statement(assertion, delayed) for assertion in symbols.assertions
            ),
            resting=initial.resting,
            following=tuple(initial.following.items()),
        )

    def _assert_convergence(self, at_start: bool) -> None:
        """An error of the model where the iterations of a nonlinear loop have not converged."""
        for condition, names in self.nonlinear.conditions:
            text = f"Newton's method finds no solution of the nonlinear loop for {', '.join(names)}"
            self.flat.symbols.assertion(condition, Text((text,)), True, at_start)
        self.nonlinear.conditions.clear()

    # ---- the system of equations --------------------------------------------------------------------------

    def _system(self) -> EquationSystem:
        symbols = self.flat.symbols
        check_unknowns(len(symbols.unknowns))
        check_operations(
            ca.n_nodes(_column([residual.expression for residual in self.flat.residuals]))
        )
        variables = {leaf.name: symbol for leaf, symbol in symbols.unknowns.items()}
        derivative_of = {}
        for name, symbol in symbols.derivatives.items():
            derivative_of[name] = symbol.name()
            variables[symbol.name()] = symbol
        inputs = frozenset(
            [*(leaf.name for leaf in symbols.inputs), *symbols.delays, *symbols.comparisons]
        )
        return EquationSystem(
            variables, derivative_of, list(self.flat.residuals), inputs, symbols.t
        )

    def _preference(self, name: str) -> float:
        leaf = self._leaf(name)
        if leaf is None:
            return 0.0
        return metadata.state_preference(leaf, self.instantiator.constants)

    def _leaf(self, name: str) -> Instance | None:
        return self._leaves.get(name)

    @cached_property
    def _leaves(self) -> dict[str, Instance]:
        return {leaf.name: leaf for leaf in self.flat.symbols.unknowns}

    def _statement(self, assertion: Assertion, delayed: DelayedInputs) -> Statement:
        """An assertion in terms of states, inputs and parameters."""
        parts = (*assertion.message.parts, *([] if assertion.is_error else self._causes(assertion)))
        shown = [part for part in parts if isinstance(part, PrintedNumber)]
        condition, *values = delayed.put_in(
            [self._known(e) for e in (assertion.condition, *(s.value for s in shown))]
        )
        self.beginning.refuse_start_times(ca.vertcat(condition, *values))
        texts = [""]
        for part in parts:
            if isinstance(part, str):
                texts[-1] += part
            else:
                texts.append("")
        fixed = not (_names(condition) - _names(self.p))
        digits = [s.digits for s in shown]
        return Statement(
            condition,
            tuple(texts),
            tuple(zip(values, digits, strict=True)),
            assertion.is_error,
            assertion.at_start or fixed,
        )

    def _causes(self, assertion: Assertion) -> Iterator[str | PrintedNumber]:
        """The parameters that the condition names, with their values; they end the message of a warning."""
        names, separator = _names(assertion.condition), "; "
        for leaf, symbol in self.flat.symbols.free.items():
            if leaf.name in names:
                unit = self._variable(leaf).unit
                yield f"{separator}{leaf.name} = "
                yield PrintedNumber(symbol, 6)
                yield f" {unit}" if unit not in ("", "1") else ""
                separator = ", "

    def _known(self, expression: ca.SX) -> ca.SX:
        return self.beginning.substituted(put(expression, self.system.variables, self.solved))

    # ---- results ------------------------------------------------------------------------------------------

    def _value(self, name: str) -> ca.SX:
        return self.solved[name] if name in self.solved else self.system.variables[name]

    def _derivative(self, name: str) -> ca.SX:
        return self._value(self.system.derivative_of[name])

    def _is_output(self, leaf: Instance) -> bool:
        return (
            "output" in leaf.prefixes
            and leaf.parent is self.flat.root
            and "protected" not in leaf.prefixes
        )

    def _locals(self, outputs: Sequence[Instance]) -> list[tuple[Instance, ca.SX]]:
        """Everything that can be computed and is neither state, output nor free parameter."""
        symbols, taken = self.flat.symbols, set(outputs)
        computable = []
        for leaf in self.flat.root.leaves():
            if leaf in symbols.unknowns:
                if leaf not in taken and leaf.name not in self.states:
                    computable.append((leaf, self._value(leaf.name)))
            elif leaf not in symbols.free and _is_real_parameter(leaf):
                value = self.beginning.substituted(ca.SX(symbols.value(leaf)))
                if not _names(value) & self.beginning.start_times:
                    computable.append((leaf, value))
        return computable

    def _interface(self, outputs: Sequence[Instance], local: Sequence[Instance]) -> Interface:
        root, symbols = self.flat.root, self.flat.symbols
        defaults = symbols.defaults
        return Interface(
            model=root.ancestors[0].definition.qualified_name,
            inputs={leaf.name: self._variable(leaf) for leaf in symbols.inputs},
            outputs={leaf.name: self._variable(leaf) for leaf in outputs},
            parameters={
                leaf.name: self._variable(leaf, defaults[leaf]) for leaf in self.parameters
            },
            locals={leaf.name: self._variable(leaf) for leaf in local},
            **metadata.experiment(root),
        )

    def _variable(self, leaf: Instance, start: float | None = None) -> Variable:
        return metadata.variable(leaf, self.instantiator.constants, start)

    def _state_variables(self, initial: Sequence[ca.SX]) -> tuple[Variable, ...]:
        """The states, each with the value at which it begins as the model is."""
        inputs = self.flat.symbols.inputs
        usual = [self._variable(leaf).start or 0.0 for leaf in inputs]
        symbols = ca.vertcat(self.p, *inputs.values())
        numbers = ca.vertcat(self.p_values, *usual)
        variables = []
        for name, expression in zip(self.states, initial, strict=True):
            value = float(ca.evalf(ca.substitute(expression, symbols, numbers)))
            leaf = self._leaf(name)
            variable = Variable(name, start=value) if leaf is None else self._variable(leaf, value)
            variables.append(variable)
        return tuple(variables)

    def _check_start(self, states: Sequence[Variable], loops: Sequence[Loop]) -> None:
        """Refuses linear loops that are singular where the model begins."""
        inputs = [self._variable(leaf) for leaf in self.flat.symbols.inputs]
        values = {variable.name: variable.start or 0.0 for variable in (*states, *inputs)}
        values |= {leaf.name: float(v) for leaf, v in self.flat.symbols.defaults.items()}
        values[self.flat.symbols.t.name()] = 0.0
        for loop in loops:
            loop.check_at(values)

    # ---- initial values -----------------------------------------------------------------------------------

    def _initial(self) -> InitialValues:
        constants, symbols = self.instantiator.constants, self.flat.symbols
        fixed = [name for name, leaf in self._leaves.items() if metadata.is_fixed(leaf, constants)]
        residuals = [self._not_yet(residual) for residual in self.system.residuals]
        begin = initial_values(
            InitialProblem(
                system=replace(self.system, residuals=residuals),
                states=self.states,
                solved=self.solved,
                start=self._start,
                declared=list(dict.fromkeys([*self.states, *fixed])),
                started=[name for name, leaf in self._leaves.items() if "start" in leaf.attributes],
                equations=[self._not_yet(r) for r in self.flat.initial],
                defaults=(self.p, self.p_values),
                late=symbols.late,
                present=frozenset(leaf.name for leaf in symbols.inputs),
                loops=self.nonlinear,
            )
        )
        self.beginning = beginning(begin.parameters, symbols.late, symbols.comparisons, symbols.t)
        return begin

    def _not_yet(self, residual: Residual) -> Residual:
        """At the start, when no time has passed since the start."""
        comparisons = self.flat.symbols.comparisons
        if not comparisons:
            return residual
        symbols = {name: comparison.symbol for name, comparison in comparisons.items()}
        none = dict.fromkeys(comparisons, ca.SX(0))
        return replace(residual, expression=put(residual.expression, symbols, none))

    def _delayed(self) -> DelayedInputs:
        """Everything is in terms of what is known when a run begins from here on."""
        symbols, substituted = self.flat.symbols, self.beginning.substituted
        if symbols.late:
            self.solved = {name: substituted(value) for name, value in self.solved.items()}
            for value in self.solved.values():
                self.beginning.refuse_start_times(value)
        calls = {
            name: replace(
                c,
                argument=substituted(c.argument),
                start=substituted(c.start),
                time=substituted(c.time),
            )
            for name, c in symbols.delays.items()
        }
        begun = {
            name: (c.symbol, ca.fmax(c.length, 0))
            for name, c in symbols.comparisons.items()
            if c.start in self.beginning.start_times
        }
        inputs = list(symbols.inputs.values())
        return DelayedInputs(calls, self.solved, self.system.variables, inputs, self.p, begun)

    def _guess(self, name: str) -> ca.SX:
        """Where the iterations for a variable begin."""
        value = self._start(name).value
        return ca.SX(value) if not ca.symvar(value) else ca.SX(0)

    def _start(self, name: str) -> StartAttribute:
        leaf = self._leaf(name)
        if leaf is None:
            return StartAttribute(ca.SX(0), False, name, given=False)
        bound = leaf.attributes.get("start")
        value = ca.SX(0) if bound is None else ca.SX(self.flat.symbols.bound(bound))
        for symbol in ca.symvar(value):
            if symbol.name() in self.system.variables or symbol.name() in self.system.inputs:
                raise ModelError(
                    f"the start value of '{name}' depends on the variable '{symbol.name()}'"
                )
        fixed = metadata.is_fixed(leaf, self.instantiator.constants)
        return StartAttribute(value, fixed, f"start value of '{name}'", given=bound is not None)


def _is_real_parameter(leaf: Instance) -> bool:
    return leaf.variability == "parameter" and leaf.primitive == "Real"


def _names(expression: ca.SX) -> set[str]:
    return {symbol.name() for symbol in ca.symvar(expression)}


def _column(values: Sequence[ca.SX | float]) -> ca.SX:
    return ca.vertcat(ca.SX(0, 1), *values)


def _shared(*groups: Sequence[ca.SX]) -> list[ca.SX]:
    """Columns in which equal parts of expressions are computed once."""
    column = ca.cse(_column([value for group in groups for value in group]))
    ends = [0]
    for group in groups:
        ends.append(ends[-1] + len(group))
    return [column[start:end] for start, end in pairwise(ends)]
